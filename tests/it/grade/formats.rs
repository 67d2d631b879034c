//! The shapes of the results.

use raytree::lessons::grading::{Verdict, to_junit};
use resvg::usvg::roxmltree::Document;
use serde_json::Value;

use super::{grade_of, result, samples};

/// Holds a value against a schema.
fn require(schema: Value, value: &Value, what: &str) {
    let validator = jsonschema::validator_for(&schema).unwrap();
    let errors: Vec<String> = validator.iter_errors(value).map(|error| error.to_string()).collect();
    assert!(errors.is_empty(), "{what}: {errors:?}");
}

/// After Gradescope's autograder specification: the keys that we write, and no other.
#[test]
fn gradescope() {
    let test = serde_json::json!({
        "type": "object", "additionalProperties": false,
        "required": ["score", "max_score", "status", "name", "number", "output", "output_format", "visibility"],
        "properties": {
            "score": { "type": "number", "minimum": 0 }, "max_score": { "type": "number", "exclusiveMinimum": 0 },
            "status": { "enum": ["passed", "failed"] }, "name": { "type": "string" }, "number": { "type": "string" },
            "output": { "type": "string" }, "output_format": { "enum": ["text", "html", "simple_format", "md", "ansi"] },
            "visibility": { "enum": ["hidden", "after_due_date", "after_published", "visible"] },
            "extra_data": { "type": "object" },
        },
    });
    let schema = serde_json::json!({
        "type": "object", "additionalProperties": false, "required": ["tests"],
        "properties": {
            "output": { "type": "string" }, "output_format": { "type": "string" }, "extra_data": { "type": "object" },
            "visibility": { "enum": ["hidden", "after_due_date", "after_published", "visible"] },
            "stdout_visibility": { "enum": ["hidden", "after_due_date", "after_published", "visible"] },
            "tests": { "type": "array", "items": test },
        },
    });
    for sample in samples() {
        let json: Value = serde_json::from_str(&result(&format!("{}/results.json", sample.name))).unwrap();
        require(schema.clone(), &json, sample.name);
        let tests = json["tests"].as_array().unwrap();
        let sum = |key: &str| tests.iter().map(|test| test[key].as_u64().unwrap()).sum::<u64>();
        assert_eq!(
            (sum("score"), sum("max_score"), tests.len()),
            (u64::from(sample.points), 40, 16),
            "{}",
            sample.name
        );
        for test in tests {
            assert_eq!(test["status"] == "passed", test["score"] == test["max_score"]);
        }
        assert!(json["extra_data"]["notice"].as_str().unwrap().contains("no sandbox"));
    }
}

/// After Exercism's test runner interface, version 3.
#[test]
fn exercism() {
    let schema = serde_json::json!({
        "type": "object", "additionalProperties": false, "required": ["version", "status", "message", "tests"],
        "properties": {
            "version": { "const": 3 }, "status": { "enum": ["pass", "fail", "error"] },
            "message": { "type": ["string", "null"], "maxLength": 65535 },
            "tests": { "type": "array", "items": {
                "type": "object", "additionalProperties": false, "required": ["name", "status", "test_code", "task_id"],
                "properties": {
                    "name": { "type": "string" }, "status": { "enum": ["pass", "fail", "error"] },
                    "message": { "type": ["string", "null"] }, "output": { "type": "string", "maxLength": 500 },
                    "test_code": { "type": "string" }, "task_id": { "type": "integer", "minimum": 1 },
                },
            } },
        },
    });
    let read = |name: &str, lesson: &str| {
        let json: Value = serde_json::from_str(&result(&format!("{name}/exercism/{lesson}/results.json"))).unwrap();
        require(schema.clone(), &json, name);
        json
    };
    for sample in samples() {
        for lesson in ["02-plane", "03-triangle", "04-box", "05-sphere"] {
            let json = read(sample.name, lesson);
            let is_there = sample.files.iter().any(|(folder, _)| *folder == lesson);
            let expected = match (is_there, sample.wrong) {
                (false, _) | (_, Some((_, Verdict::NotBuilt, _))) => "error",
                (_, None) => "pass",
                _ => "fail",
            };
            assert_eq!(json["status"], expected, "{} {lesson}", sample.name);
            assert_eq!(json["message"].is_string(), expected == "error");
            assert_eq!(json["tests"].as_array().unwrap().len(), if expected == "error" { 0 } else { 4 });
        }
    }
    let gus = read("gus-d-sign", "02-plane");
    let first = &gus["tests"][0];
    assert_eq!((&first["status"], &first["task_id"]), (&"fail".into(), &1.into()));
    assert!(first["test_code"].as_str().unwrap().starts_with("plane_from\npoint = ("), "{first}");
    assert!(first["message"].as_str().unwrap().contains("expected  n = "), "{first}");
    assert_eq!(read("dan-endless-loop", "02-plane")["tests"][1]["status"], "error");
    let cleo = read("cleo-does-not-compile", "02-plane");
    assert!(cleo["message"].as_str().unwrap().contains("--> lessons/02-plane/exercise.rs:"), "{cleo}");
}

/// Well-formed, and the counts are those of the elements.
#[test]
fn junit() {
    for sample in samples() {
        let xml = result(&format!("{}/junit.xml", sample.name));
        let page = Document::parse(&xml).unwrap();
        let root = page.root_element();
        assert_eq!((root.tag_name().name(), root.attribute("name")), ("testsuites", Some(sample.name)));
        let suites: Vec<_> = root.children().filter(|node| node.is_element()).collect();
        assert_eq!(suites.len(), 4);
        for node in suites.iter().chain([&root]) {
            let count = |name: &str| node.descendants().filter(|node| node.has_tag_name(name)).count().to_string();
            for (attribute, element) in
                [("tests", "testcase"), ("failures", "failure"), ("errors", "error"), ("skipped", "skipped")]
            {
                assert_eq!(node.attribute(attribute), Some(count(element).as_str()), "{xml}");
            }
        }
        for suite in suites {
            let cases = suite.children().filter(|node| node.has_tag_name("testcase"));
            for case in cases {
                assert!(case.attribute("name").unwrap().contains(": "));
                assert_eq!(case.attribute("classname"), suite.attribute("name"));
                assert!(case.children().filter(|node| node.is_element()).count() <= 1);
            }
        }
    }
    let xml = result("kim-brackets/junit.xml");
    assert!(xml.contains("<failure type=\"quadratic-times-a\" message=\"roots, case "), "{xml}");
}

/// What others write is text and nothing else, in every format.
#[test]
fn hostile_words_stay_words() {
    let mut grade = grade_of("gus-d-sign");
    let words = "]]></failure>\u{1b}[31m & <b> \"x\" | `` ``` \u{0} $& \\";
    grade.submission = words.to_owned();
    grade.lessons[0].output = words.to_owned();
    grade.lessons[0].notes = vec![words.to_owned()];
    grade.lessons[0].stages[0].message = Some(format!("{words}\n```\n# heading"));
    let xml = to_junit(&grade);
    let page = Document::parse(&xml).unwrap();
    let failure = page.descendants().find(|node| node.has_tag_name("failure")).unwrap();
    assert!(failure.text().unwrap().contains("]]></failure>") && !xml.contains('\u{1b}'), "{xml}");
    let page = grade.to_markdown();
    assert!(page.contains("\n````text\n") && page.contains("\n````\n") && !page.contains('\u{1b}'), "{page}");
    assert!(page.starts_with("# \\]\\]>\\</failure>"), "{page}");
}

#[test]
fn markdown_has_a_row_for_each_stage_and_the_messages() {
    let page = result("finn-panic/grade.md");
    assert!(page.starts_with("# finn-panic: 8 of 40 points\n"), "{page}");
    assert_eq!(page.lines().filter(|line| line.starts_with("| 0")).count(), 16, "{page}");
    assert!(page.contains("| 02-plane | `signed_distance` | signed distance | panicked | 0 of 2 |"), "{page}");
    assert!(page.contains("got       a panic at lessons/02-plane/exercise.rs:"), "{page}");
    assert!(page.contains("It is no sandbox"), "{page}");
    let page = result("juri-slab/grade.md");
    assert!(page.contains("right, with the course's slab"), "{page}");
}
