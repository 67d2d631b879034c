//! JUnit XML: a suite for each lesson, a case for each stage.

use std::fmt::Write;

use super::{Grade, StageGrade, Verdict};
use crate::pictures::drawing::escape;

/// The grade as JUnit XML. A wrong answer is a failure, code that did not answer an error, a stage that was not reached
/// skipped. Points are properties.
pub fn to_junit(grade: &Grade) -> String {
    let all = || grade.lessons.iter().flat_map(|lesson| &lesson.stages);
    let mut xml = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let name = attribute(&grade.submission);
    writeln!(xml, "<testsuites name=\"{name}\" {}>", counts(all())).ok();
    for lesson in &grade.lessons {
        let folder = attribute(&lesson.folder);
        writeln!(xml, "  <testsuite name=\"{folder}\" {}>", counts(lesson.stages.iter())).ok();
        xml += "    <properties>\n";
        let points = [("points", lesson.points.to_string()), ("of", lesson.of.to_string())];
        for (name, value) in points.into_iter().chain(lesson.notes.iter().map(|note| ("note", note.clone()))) {
            writeln!(xml, "      <property name=\"{name}\" value=\"{}\"/>", attribute(&value)).ok();
        }
        xml += "    </properties>\n";
        for stage in &lesson.stages {
            case(&mut xml, &folder, stage);
        }
        if !lesson.output.is_empty() {
            writeln!(xml, "    <system-out>{}</system-out>", text(&lesson.output)).ok();
        }
        xml += "  </testsuite>\n";
    }
    xml + "</testsuites>\n"
}

fn case(xml: &mut String, class: &str, stage: &StageGrade) {
    write!(xml, "    <testcase classname=\"{class}\" name=\"{}\"", attribute(&stage.title())).ok();
    let message = stage.message.as_deref().unwrap_or_default();
    let first = attribute(message.lines().next().unwrap_or_default());
    let element = match element(stage.verdict) {
        None => return xml.push_str("/>\n"),
        Some("skipped") => format!("<skipped message=\"{first}\"/>"),
        Some(element) => {
            let kind = stage.mistake().map_or(stage.verdict.word(), |mistake| &mistake.id);
            format!("<{element} type=\"{}\" message=\"{first}\">{}</{element}>", attribute(kind), text(message))
        }
    };
    writeln!(xml, ">\n      {element}\n    </testcase>").ok();
}

/// What stands in the case of a stage.
fn element(verdict: Verdict) -> Option<&'static str> {
    match verdict {
        Verdict::Right => None,
        Verdict::NotReached => Some("skipped"),
        verdict if verdict.is_error() => Some("error"),
        _ => Some("failure"),
    }
}

fn counts<'a>(stages: impl Iterator<Item = &'a StageGrade>) -> String {
    let elements: Vec<Option<&str>> = stages.map(|stage| element(stage.verdict)).collect();
    let count = |word| elements.iter().filter(|element| **element == Some(word)).count();
    let [failures, errors, skipped] = ["failure", "error", "skipped"].map(count);
    format!("tests=\"{}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"{skipped}\"", elements.len())
}

/// Text as XML 1.0 can hold it: it has no place for most control characters, escaped or not.
fn text(words: &str) -> String {
    let fits = |c: char| c == '\n' || c == '\t' || !(c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'));
    escape(&words.chars().map(|c| if fits(c) { c } else { '\u{fffd}' }).collect::<String>())
}

/// Text in an attribute, where a line break would become a blank.
fn attribute(words: &str) -> String {
    text(words).replace('\n', "&#10;").replace('\t', "&#9;")
}
