//! `docs/grading.md`: what it shows is what the grader writes.

use super::{result, samples};
use crate::commands::good;
use crate::pages::{refreshed, require};

fn content(comment: &str) -> String {
    match comment {
        "output: cohort.md" => result("cohort.md"),
        "output: gus-d-sign/results.json, the first test" => {
            let json: serde_json::Value = serde_json::from_str(&result("gus-d-sign/results.json")).unwrap();
            format!("{:#}", json["tests"][0])
        }
        "output: juri-slab/junit.xml, the third suite" => {
            let xml = result("juri-slab/junit.xml");
            let suite = xml.split("  <testsuite ").nth(3).unwrap();
            format!("<testsuite {suite}")
        }
        _ => match comment.strip_prefix("output: raytree ") {
            Some(line) => good(line),
            None => panic!("nobody knows what belongs below `{comment}`"),
        },
    }
}

#[test]
fn the_page_on_grading_is_up_to_date() {
    let file = "docs/grading.md";
    let page = refreshed(&std::fs::read_to_string(file).unwrap(), content);
    require(file, page.as_bytes());
    assert!(page.contains("no sandbox") && page.contains("bwrap ") && page.contains("--network none"));
    for sample in samples() {
        assert!(page.contains(sample.name));
    }
}
