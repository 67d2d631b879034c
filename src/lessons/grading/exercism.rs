//! `results.json` of Exercism's test runner interface, version 3: one for each lesson.

use serde_json::{Value, json};

use super::{LessonGrade, StageGrade, Verdict, indented, shortened};

/// A lesson's grade as Exercism reads it: the stages are the tests, and their numbers the tasks.
pub fn to_exercism(lesson: &LessonGrade) -> String {
    let status = match lesson.first_open() {
        None => "pass",
        Some(stage) if matches!(stage.verdict, Verdict::NotBuilt | Verdict::Missing) => "error",
        Some(_) => "fail",
    };
    let message = (status == "error").then(|| match &lesson.not_built {
        Some(not_built) => not_built.text.clone(),
        None => format!("There is no {}/exercise.rs in the submission.", lesson.folder),
    });
    // Nobody knows which stage printed what: it stands with the first that needs a look.
    let shown = lesson.stages.iter().position(|stage| stage.verdict != Verdict::Right).unwrap_or(0);
    let tests = lesson.stages.iter().enumerate().map(|(i, stage)| {
        let mut test = json!({
            "name": stage.title(),
            "status": match stage.verdict {
                Verdict::Right => "pass",
                verdict if verdict.is_error() => "error",
                _ => "fail",
            },
            "message": stage.message,
            "test_code": code(stage),
            "task_id": i + 1,
        });
        if i == shown && !lesson.output.is_empty() {
            // The interface allows 500 characters.
            test["output"] = shortened(&lesson.output, 490).into();
        }
        test
    });
    let tests: Vec<Value> = if status == "error" { Vec::new() } else { tests.collect() };
    indented(&json!({ "version": 3, "status": status, "message": message, "tests": tests }))
}

/// What is tested: the case that failed, or how many there are.
fn code(stage: &StageGrade) -> String {
    match &stage.failure {
        Some(failure) => format!("{}\n{}", stage.function, failure.given.join("\n")),
        None => format!("{}, {} cases", stage.function, stage.cases),
    }
}
