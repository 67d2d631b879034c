//! What came of checking a lesson: one model for the text, for JSON, and for a grader.

use serde::{Deserialize, Serialize};

use super::TOLERANCE;
use super::task::{Checked, Fault, Stage};
use crate::pictures::drawing::Drawing;

/// A lesson with a student's functions.
#[derive(Debug)]
pub struct Lesson {
    /// Its number.
    pub number: u32,
    /// Its title.
    pub title: &'static str,
    /// What there is to write, in order.
    pub stages: Vec<Stage>,
    /// What to look at once all is right.
    pub notice: &'static str,
}

/// What came of checking a lesson.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// `raytree-lesson/1`.
    pub format: String,
    /// The lesson's number.
    pub lesson: u32,
    /// Its title.
    pub title: String,
    /// Whether every stage passed.
    pub passed: bool,
    /// The points of the stages that passed.
    pub points: u32,
    /// The points of all.
    pub of: u32,
    /// The tolerance of numbers: absolute, relative to the expected one where that is larger than 1.
    pub tolerance: f64,
    /// The stages in order.
    pub stages: Vec<StageReport>,
}

/// What came of a stage.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StageReport {
    /// What it is about.
    pub name: String,
    /// The function.
    pub function: String,
    /// Its points if it passed, else 0.
    pub points: u32,
    /// What it is worth.
    pub of: u32,
    /// How many cases it has.
    pub cases: usize,
    /// What came of it.
    pub outcome: Outcome,
    /// The functions of the same lesson that it builds on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub after: Vec<String>,
    /// The functions that have to be right first, of a stage that was not reached.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub waits_for: Vec<String>,
    /// The first failing case, of a stage that failed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
}

/// What came of a stage, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Every case is right.
    Passed,
    /// A case is wrong.
    Failed,
    /// A case is wrong, and so is a stage that this one builds on: nobody can tell whose fault it is.
    NotReached,
}

/// The first failing case of a stage.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// In what way it failed.
    pub kind: FailureKind,
    /// Its number, from 1.
    pub case: usize,
    /// Its name.
    pub case_name: String,
    /// The input, a line for each part.
    pub given: Vec<String>,
    /// The right answer.
    pub expected: String,
    /// The student's, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub got: Option<String>,
    /// How the student's code ended, if it did not answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub broken: Option<Broken>,
    /// The mistake, where it is a known one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<Mistake>,
}

/// In what way a case failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FailureKind {
    /// The answer is wrong.
    Wrong,
    /// The function is still to be written.
    Unwritten,
    /// The code panicked.
    Panicked,
}

/// How code ended that did not answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Broken {
    /// The panic's message.
    pub message: String,
    /// `file:line`.
    pub place: String,
}

/// A known mistake.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Mistake {
    /// A name for programs.
    pub id: String,
    /// What is wrong.
    pub name: String,
    /// Why it happens, or what it does.
    pub why: String,
}

impl Mistake {
    /// What there is to say of a fault.
    pub(super) fn of<C>(fault: &Fault<C>) -> Self {
        Mistake { id: fault.id.to_owned(), name: fault.name.to_owned(), why: fault.why.to_owned() }
    }
}

impl Lesson {
    /// Runs every stage. Returns what came of it, and the picture of the first failing case; where all is right, of the last
    /// stage's first.
    pub fn check(&self) -> (Report, Option<Drawing>) {
        let mut stages: Vec<StageReport> = Vec::new();
        let mut picture = None;
        let mut is_failed = false;
        for stage in &self.stages {
            let Checked { failure, picture: drawing } = stage.run();
            let is_open = |name: &&str| stages.iter().any(|s| s.function == **name && s.outcome != Outcome::Passed);
            let waits_for: Vec<String> = match failure {
                Some(_) => stage.after.iter().filter(|name| is_open(name)).map(|name| (*name).to_owned()).collect(),
                None => Vec::new(),
            };
            let outcome = match &failure {
                None => Outcome::Passed,
                Some(_) if waits_for.is_empty() => Outcome::Failed,
                Some(_) => Outcome::NotReached,
            };
            if !is_failed {
                picture = Some(drawing);
            }
            is_failed |= outcome != Outcome::Passed;
            stages.push(stage.report(outcome, waits_for, failure));
        }
        (self.report(stages), picture)
    }

    /// Runs the stage with this number, from 1, and no other; nothing where there is none. Whether what it builds on is right
    /// is not looked at.
    pub fn check_stage(&self, number: usize) -> Option<Report> {
        let stage = self.stages.get(number.checked_sub(1)?)?;
        let failure = stage.run().failure;
        let outcome = if failure.is_none() { Outcome::Passed } else { Outcome::Failed };
        Some(self.report(vec![stage.report(outcome, Vec::new(), failure)]))
    }

    fn report(&self, stages: Vec<StageReport>) -> Report {
        Report {
            format: "raytree-lesson/1".to_owned(),
            lesson: self.number,
            title: self.title.to_owned(),
            passed: stages.iter().all(|stage| stage.outcome == Outcome::Passed),
            points: stages.iter().map(|stage| stage.points).sum(),
            of: stages.iter().map(|stage| stage.of).sum(),
            tolerance: TOLERANCE,
            stages,
        }
    }
}

impl Stage {
    fn report(&self, outcome: Outcome, waits_for: Vec<String>, failure: Option<Failure>) -> StageReport {
        StageReport {
            name: self.name.to_owned(),
            function: self.function.to_owned(),
            points: if outcome == Outcome::Passed { self.points } else { 0 },
            of: self.points,
            cases: self.cases,
            outcome,
            after: self.after.iter().map(|name| (*name).to_owned()).collect(),
            waits_for,
            failure: failure.filter(|_| outcome == Outcome::Failed),
        }
    }
}

impl Report {
    /// The first stage that is not right, with its place.
    pub fn first_open(&self) -> Option<(usize, &StageReport)> {
        self.stages.iter().enumerate().find(|(_, stage)| stage.outcome != Outcome::Passed)
    }

    /// The report for a reader. `command` is what runs the lesson.
    pub fn to_text(&self, command: &str) -> String {
        use std::fmt::Write;
        let mut text = format!("lesson {:02}, {}: {} of {} points\n\n", self.lesson, self.title, self.points, self.of);
        let widest = |of: fn(&StageReport) -> &str| self.stages.iter().map(|s| of(s).len()).max().unwrap_or_default();
        let (function_width, name_width) = (widest(|s| &s.function), widest(|s| &s.name));
        for stage in &self.stages {
            let is_unwritten = stage.failure.as_ref().is_some_and(|f| f.kind == FailureKind::Unwritten);
            let mark = match stage.outcome {
                Outcome::Passed => "right",
                Outcome::Failed if is_unwritten => "open ",
                Outcome::Failed => "WRONG",
                Outcome::NotReached => "  -  ",
            };
            let came = match (stage.outcome, &stage.failure) {
                (Outcome::Passed, _) => format!("{} of {} points, {} cases", stage.points, stage.of, stage.cases),
                (Outcome::NotReached, _) => format!("waits for {}", listed(&stage.waits_for)),
                (_, Some(Failure { kind: FailureKind::Unwritten, .. })) => "not written yet".to_owned(),
                (_, Some(Failure { kind: FailureKind::Panicked, .. })) => "panicked".to_owned(),
                (_, failure) => {
                    let case = failure.as_ref().map_or(1, |failure| failure.case);
                    format!("case {case} of {}", stage.cases)
                }
            };
            let (function, name) = (&stage.function, &stage.name);
            writeln!(text, "  {mark}  {function:<function_width$}  {name:<name_width$}  {came}").ok();
        }
        let Some((_, stage)) = self.first_open() else { return text };
        let Some(failure) = &stage.failure else { return text };
        text.push('\n');
        text.push_str(&failure.to_text(&stage.function, stage.cases));
        writeln!(text, "\na hint: {command} -- --hint").ok();
        text
    }
}

impl Failure {
    /// The failure for a reader.
    pub fn to_text(&self, function: &str, cases: usize) -> String {
        let unnamed = Broken { message: String::new(), place: String::new() };
        let broken = self.broken.as_ref().unwrap_or(&unnamed);
        if self.kind == FailureKind::Unwritten {
            return format!("`{function}` is not written yet: {}\n", broken.place);
        }
        let mut text = format!("{function}, case {} of {cases}: {}\n", self.case, self.case_name);
        for line in &self.given {
            text += &format!("  {line}\n");
        }
        text += &format!("  expected  {}\n", self.expected);
        text += &match &self.got {
            Some(got) => format!("  got       {got}\n"),
            None => format!("  got       a panic at {}: {}\n", broken.place, broken.message.replace('\n', " ")),
        };
        if let Some(Mistake { name, why, .. }) = &self.mistake {
            text += &format!("\nthe mistake: {name}\n{}", indented(why));
        }
        text
    }
}

/// Names in a sentence: `a, b and c`.
pub(super) fn listed(names: &[String]) -> String {
    match names {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => names.concat(),
    }
}

/// A text in lines of at most eighty letters, indented.
fn indented(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < 80 => *line += &format!(" {word}"),
            _ => lines.push(format!("  {word}")),
        }
    }
    lines.join("\n") + "\n"
}
