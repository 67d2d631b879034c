//! The page for people who write trees from other languages: complete, and its examples valid.

use std::collections::BTreeSet;

use raytree::tree::RayTree;
use raytree::tree::check::read_tree;
use raytree::tree::diff::{Tolerances, diff};
use serde_json::Value;

fn page() -> String {
    std::fs::read_to_string("docs/trees.md").unwrap()
}

/// The keys and the words that a schema allows.
fn collect(schema: &Value, into: &mut BTreeSet<String>) {
    match schema {
        Value::Object(object) => {
            if let Some(Value::Object(properties)) = object.get("properties") {
                into.extend(properties.keys().cloned());
            }
            into.extend(object.get("const").and_then(Value::as_str).map(str::to_owned));
            for word in object.get("enum").and_then(Value::as_array).into_iter().flatten() {
                into.extend(word.as_str().map(str::to_owned));
            }
            object.values().for_each(|value| collect(value, into));
        }
        Value::Array(values) => values.iter().for_each(|value| collect(value, into)),
        _ => {}
    }
}

#[test]
fn every_key_and_every_word_of_the_format_is_on_the_page() {
    let mut words = BTreeSet::new();
    collect(RayTree::schema().as_value(), &mut words);
    assert!(words.len() > 70, "{words:?}");
    let page = page();
    let missing: Vec<&String> = words
        .iter()
        .filter(|word| !["`{}`", "`\"{}\"`", "\"{}\""].iter().any(|quotes| page.contains(&quotes.replace("{}", word))))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn every_example_on_the_page_is_a_valid_tree() {
    let page = page();
    let examples: Vec<&str> = page.split("```json\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(examples.len(), 2);
    for example in examples {
        let tree = read_tree("docs/trees.md", example).unwrap_or_else(|problem| panic!("{problem}"));
        assert!(diff(&tree, &tree, &Tolerances::default()).is_same());
        // Each breaks where it should.
        assert!(read_tree("docs/trees.md", &example.replace("\"rays\": ", "\"rays\": 1")).is_err());
    }
}
