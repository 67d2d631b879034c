//! Questions as Markdown, formulas between dollar signs.

use std::fmt::Write;

use super::{Question, TOLERANCE};

/// The questions, numbered, without their answers.
pub fn to_markdown(questions: &[Question], title: &str) -> String {
    let mut page = format!("# {title}\n");
    for (i, question) in questions.iter().enumerate() {
        write!(page, "\n## {}. {}\n\n{}\n\n", i + 1, question.kind.title(), question.given).ok();
        for (letter, part) in ('a'..).zip(&question.parts) {
            writeln!(page, "- ({letter}) {}: ____", part.asked).ok();
        }
    }
    page
}

/// The answers alone.
pub fn to_markdown_answers(questions: &[Question], title: &str) -> String {
    let mut page = format!("# {title}: answers\n\nAn answer counts if it is within {TOLERANCE} of the one here.\n\n");
    page += "| question | | answer |\n|---|---|---|\n";
    for (i, question) in questions.iter().enumerate() {
        for (letter, part) in ('a'..).zip(&question.parts) {
            writeln!(page, "| {} ({letter}) | {} | {} |", i + 1, part.asked, part.answer_text()).ok();
        }
    }
    page
}
