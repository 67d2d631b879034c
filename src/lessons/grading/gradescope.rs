//! `results.json` of Gradescope: a test for each stage.
//!
//! The format is that of Gradescope's autograder specification.

use serde_json::json;

use super::{Grade, NO_SANDBOX, StageGrade, Verdict, indented};

/// The grade as Gradescope reads it. The score is the sum of the tests' scores.
pub fn to_gradescope(grade: &Grade) -> String {
    let tests: Vec<_> = grade
        .lessons
        .iter()
        .flat_map(|lesson| {
            lesson.stages.iter().enumerate().map(move |(i, stage)| {
                json!({
                    "number": format!("{}.{}", lesson.lesson, i + 1),
                    "name": format!("{}, {}", lesson.folder, stage.title()),
                    "score": stage.points,
                    "max_score": stage.of,
                    "status": if stage.verdict == Verdict::Right { "passed" } else { "failed" },
                    "output": stage.message.clone().unwrap_or_else(|| right(stage)),
                    "output_format": "text",
                    "visibility": "visible",
                    "extra_data": {
                        "verdict": stage.verdict.word(),
                        "mistake": stage.mistake().map(|mistake| mistake.id.clone()),
                    },
                })
            })
        })
        .collect();
    let words: Vec<String> =
        [format!("{} of {} points", grade.points, grade.of)].into_iter().chain(grade.notes.iter().cloned()).collect();
    indented(&json!({
        "output": words.join("\n"),
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": { "submission": grade.submission, "notice": NO_SANDBOX },
        "tests": tests,
    }))
}

/// What there is to say of a stage that nothing is wrong with.
fn right(stage: &StageGrade) -> String {
    format!("{}: {} cases", stage.verdict_words(), stage.cases)
}
