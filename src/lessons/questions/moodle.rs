//! Questions as Moodle XML: a numerical question for each number that is asked for.

use std::fmt::Write;

use super::{Question, TOLERANCE};
use crate::pictures::drawing::escape;

/// The questions with their answers, in a category of their own.
pub fn to_moodle(questions: &[Question], title: &str) -> String {
    let mut xml = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n");
    let category = escape(&format!("$course$/{title}"));
    writeln!(xml, "  <question type=\"category\">\n    <category><text>{category}</text></category>\n  </question>")
        .ok();
    for (i, question) in questions.iter().enumerate() {
        for (letter, part) in ('a'..).zip(&question.parts) {
            let name = escape(&format!("{}{letter} {}", i + 1, question.kind.title()));
            let text = format!("<p>{}</p><p>What is {}?</p>", html(&question.given), html(&part.asked));
            write!(
                xml,
                "  <question type=\"numerical\">
    <name><text>{name}</text></name>
    <questiontext format=\"html\"><text>{}</text></questiontext>
    <generalfeedback format=\"html\"><text></text></generalfeedback>
    <defaultgrade>1</defaultgrade>
    <penalty>0.3333333</penalty>
    <hidden>0</hidden>
    <answer fraction=\"100\" format=\"moodle_auto_format\">
      <text>{}</text>
      <feedback format=\"html\"><text></text></feedback>
      <tolerance>{TOLERANCE}</tolerance>
    </answer>
    <unitgradingtype>0</unitgradingtype>
    <unitpenalty>0.1</unitpenalty>
    <showunits>3</showunits>
    <unitsleft>0</unitsleft>
  </question>
",
                escape(&text),
                part.answer_text()
            )
            .ok();
        }
    }
    xml + "</quiz>\n"
}

/// A text with formulas between dollar signs as HTML, where Moodle's filter for formulas finds them.
fn html(text: &str) -> String {
    let pieces = text.split('$').enumerate().map(|(i, piece)| match i % 2 {
        0 => escape(piece),
        _ => format!("\\({}\\)", escape(piece)),
    });
    pieces.collect()
}
