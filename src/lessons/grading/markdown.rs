//! The grade as a page: a table, and below it what went wrong.

use std::fmt::Write;

use super::{Cohort, Grade, LessonGrade, NO_SANDBOX, Verdict, clean};
use crate::input::printable;

impl Grade {
    /// The grade for a reader.
    pub fn to_markdown(&self) -> String {
        let mut page = format!("# {}: {} of {} points\n\n", inline(&self.submission), self.points, self.of);
        page += "| lesson | function | stage | | points |\n|---|---|---|---|---|\n";
        for lesson in &self.lessons {
            for stage in &lesson.stages {
                let (folder, verdict) = (inline(&lesson.folder), inline(&stage.verdict_words()));
                let (function, name) = (&stage.function, &stage.name);
                writeln!(page, "| {folder} | `{function}` | {name} | {verdict} | {} of {} |", stage.points, stage.of)
                    .ok();
            }
        }
        for note in &self.notes {
            write!(page, "\nNote: {}.\n", inline(note)).ok();
        }
        // Of what is missing the table says enough.
        let is_told = |lesson: &&LessonGrade| {
            let first = lesson.first_open().filter(|stage| stage.verdict != Verdict::Missing);
            first.is_some() || !lesson.notes.is_empty()
        };
        for lesson in self.lessons.iter().filter(is_told) {
            write!(page, "\n## {}: {} of {} points\n", inline(&lesson.folder), lesson.points, lesson.of).ok();
            page += &lesson.words();
        }
        write!(page, "\n{NO_SANDBOX}\n").ok();
        page
    }
}

impl LessonGrade {
    /// What went wrong, and what there is to look at.
    fn words(&self) -> String {
        let mut page = String::new();
        for note in &self.notes {
            write!(page, "\nTo look at: {}.\n", inline(note)).ok();
        }
        if let Some(not_built) = &self.not_built {
            let more = match not_built.errors {
                0 | 1 => String::new(),
                errors => format!(" The first of {errors} errors:"),
            };
            page += &format!("\nIt does not compile.{more}\n\n{}", fenced(&not_built.text));
        } else {
            for stage in self.stages.iter().filter(|stage| stage.verdict != Verdict::Right) {
                let message = stage.message.as_deref().unwrap_or_default();
                write!(page, "\n`{}`, {}: {}\n", stage.function, stage.name, inline(&stage.verdict_words())).ok();
                write!(page, "\n{}", fenced(message)).ok();
            }
        }
        if !self.output.is_empty() {
            page += &format!("\nIt printed:\n\n{}", fenced(&self.output));
        }
        page
    }
}

impl Cohort {
    /// The cohort for a reader.
    pub fn to_markdown(&self) -> String {
        let mut page = format!("# {} submissions\n\n| submission |", self.submissions.len());
        for lesson in &self.lessons {
            write!(page, " {} |", inline(lesson)).ok();
        }
        page += " points |\n|---|";
        page += &"---|".repeat(self.lessons.len() + 1);
        page.push('\n');
        for standing in &self.submissions {
            write!(page, "| {} |", inline(&standing.submission)).ok();
            for (points, of) in standing.lessons.iter().zip(&self.of) {
                write!(page, " {points} of {of} |").ok();
            }
            writeln!(page, " {} of {} |", standing.points, self.of.iter().sum::<u32>()).ok();
        }
        page += "\n## Mistakes\n\n";
        if self.mistakes.is_empty() {
            page += "No known mistake was found.\n";
        } else {
            page += "| how often | lesson | function | mistake | who |\n|---|---|---|---|---|\n";
        }
        for mistake in &self.mistakes {
            let who = mistake.submissions.iter().map(|name| inline(name)).collect::<Vec<_>>().join(", ");
            let (count, lesson, function) = (mistake.submissions.len(), inline(&mistake.lesson), &mistake.function);
            writeln!(page, "| {count} | {lesson} | `{function}` | {} | {who} |", inline(&mistake.name)).ok();
        }
        page += "\n## Stages\n\n| lesson | function | stage | right |";
        let seen: Vec<Verdict> = Verdict::ALL[1..].iter().copied().filter(|v| self.count(*v) > 0).collect();
        for verdict in &seen {
            write!(page, " {} |", verdict.words()).ok();
        }
        writeln!(page, "\n|---|---|---|---|{}", "---|".repeat(seen.len())).ok();
        for stage in &self.stages {
            let (lesson, function, name) = (inline(&stage.lesson), &stage.function, &stage.name);
            write!(page, "| {lesson} | `{function}` | {name} | {} |", stage.count(Verdict::Right)).ok();
            for verdict in &seen {
                match stage.count(*verdict) {
                    0 => page += " |",
                    count => page += &format!(" {count} |"),
                }
            }
            page.push('\n');
        }
        for standing in self.submissions.iter().filter(|standing| !standing.notes.is_empty()) {
            write!(page, "\n{}: {}.\n", inline(&standing.submission), inline(&standing.notes.join("; "))).ok();
        }
        write!(page, "\n{NO_SANDBOX}\n").ok();
        page
    }
}

/// Words of others in a line or a cell of a table, where they mean nothing but themselves.
fn inline(words: &str) -> String {
    let special = |c: char| "\\`*_[]<|~&$".contains(c);
    printable(words).chars().flat_map(|c| special(c).then_some('\\').into_iter().chain([c])).collect()
}

/// A block of text, between fences that are longer than any in it.
fn fenced(text: &str) -> String {
    let text = clean(text);
    let mut longest = 0;
    let mut run = 0;
    for c in text.chars() {
        run = if c == '`' { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    let fence = "`".repeat(3.max(longest + 1));
    format!("{fence}text\n{}\n{fence}\n", text)
}
