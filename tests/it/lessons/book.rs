//! The course as an mdBook: `raytree typeset` as mdbook runs it.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};

fn typeset(args: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .arg("typeset")
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A question is answered without reading.
    child.stdin.take().unwrap().write_all(input.as_bytes()).ok();
    child.wait_with_output().unwrap()
}

/// A book of one chapter with a chapter below it, as mdbook hands it over.
fn book(content: &str) -> String {
    let inner = json!({ "Chapter": { "name": "below", "content": content, "sub_items": [] } });
    let outer = json!({ "Chapter": { "name": "above", "content": "none", "sub_items": [inner] } });
    json!([{ "root": "/", "renderer": "html" }, { "items": [outer, "Separator"] }]).to_string()
}

/// The content of the chapter below.
fn set(content: &str) -> String {
    let output = typeset(&[], &book(content));
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), b"".as_slice()));
    let book: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(book["items"][0]["Chapter"]["content"], "none");
    assert_eq!(book["items"][1], "Separator");
    book["items"][0]["Chapter"]["sub_items"][0]["Chapter"]["content"].as_str().unwrap().to_owned()
}

#[test]
fn formulas_become_pictures_and_code_stays() {
    let page = set("a $x^2$ and `$code$`\n\n```sh\necho $HOME $x\n```\n\n$$\\frac{a}{b}$$\n");
    assert_eq!(page.matches("class=\"formula\"").count(), 2, "{page}");
    assert!(page.starts_with("a <svg ") && page.contains("</svg> and `$code$`\n"), "{page}");
    assert!(page.contains("```sh\necho $HOME $x\n```\n"), "{page}");
    assert!(page.contains("<span class=\"display\"><svg ") && page.contains("aria-label=\"\\frac{a}{b}\""), "{page}");
    // Every glyph that is used is defined, once.
    for used in page.split("href=\"#").skip(1).filter_map(|rest| rest.split('"').next()) {
        assert_eq!(page.matches(&format!("id=\"{used}\"")).count(), 1, "{used}");
    }
    // An HTML block ends at a blank line: there is none within a formula.
    assert!(page.split("<svg").skip(1).all(|svg| !svg.split("</svg>").next().unwrap().contains('\n')));
    assert_eq!(set("nothing to set"), "nothing to set");
    assert_eq!(set("[next](../02-plane/README.md) `../README.md`"), "[next](../02-plane/index.md) `../README.md`");
}

#[test]
fn every_page_of_the_course_is_set() {
    let summary = std::fs::read_to_string("lessons/SUMMARY.md").unwrap();
    for file in summary.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        let page = set(&std::fs::read_to_string(format!("lessons/{file}")).unwrap());
        assert!(page.contains("class=\"formula\"") && !page.contains('$'), "{file}");
        assert!(!page.contains("/README.md)"), "{file}");
    }
}

#[test]
fn what_mdbook_asks_and_what_is_no_book() {
    assert_eq!(typeset(&["supports", "html"], "").status.code(), Some(0));
    assert_eq!(typeset(&["supports", "epub"], "").status.code(), Some(1));
    for (input, message) in [
        ("", "it is no JSON"),
        ("{}", "it is no book"),
        ("[1]", "it is no book"),
        (book(r"$\nonsense$").as_str(), r"the formula \nonsense cannot be set"),
    ] {
        let output = typeset(&[], input);
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty() && told.contains(message), "{told}");
    }
    assert_eq!(typeset(&["html"], "").status.code(), Some(2));
}

/// The real thing, where mdbook is installed.
#[test]
fn the_book_builds() {
    let folder = tempfile::tempdir().unwrap();
    let built = Command::new("mdbook")
        .args(["build", "lessons", "--dest-dir"])
        .arg(folder.path())
        .env("MDBOOK_PREPROCESSOR__TYPESET__COMMAND", format!("{} typeset", env!("CARGO_BIN_EXE_raytree")))
        .output();
    // Nobody needs it to work on the course; .ci/run has it.
    let Ok(built) = built else { return eprintln!("mdbook is not installed: the book was not built") };
    let told = String::from_utf8_lossy(&built.stderr);
    assert!(built.status.success() && !told.contains("ERROR"), "{told}");
    let summary = std::fs::read_to_string("lessons/SUMMARY.md").unwrap();
    for file in summary.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        let page = std::fs::read_to_string(folder.path().join(file.replace("README.md", "index.html"))).unwrap();
        let set = page.matches("class=\"formula\"").count();
        assert!(set > 0 && !page.contains("$$"), "{file}: {set} formulas");
    }
}
