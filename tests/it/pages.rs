//! The pages show what the program prints: each block below an `output` or `code` comment is made by it.
//!
//! `UPDATE_PAGES=1 cargo test pages` writes them anew.

use std::io::Write;
use std::process::{Command, Stdio};

pub(crate) fn raytree(args: &[&str]) -> (String, String) {
    raytree_with(args, "")
}

/// What the program prints when it reads `input`.
fn raytree_with(args: &[&str], input: &str) -> (String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// What belongs into the block below a comment.
fn content(comment: &str) -> String {
    match comment {
        "output: pixel scenes/whitted.json \"mirrored glass ball\"" => {
            raytree(&["pixel", "scenes/whitted.json", "mirrored glass ball"]).0
        }
        "output: step scenes/plane.json floor" => {
            raytree_with(&["step", "scenes/plane.json", "floor"], "until object floor\n").0
        }
        "output: check of a misspelt scene" => {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("ball.json");
            let scene = std::fs::read_to_string("scenes/first-hit.json").unwrap();
            std::fs::write(&file, scene.replacen("\"radius\"", "\"radus\"", 1)).unwrap();
            let file = file.to_str().unwrap();
            raytree(&["check", file]).1.replace(file, "ball.json")
        }
        "code: tests/it/users_snapshot.rs" => {
            let source = std::fs::read_to_string("tests/it/users_snapshot.rs").unwrap();
            source.split("// [the example]\n").nth(1).unwrap().to_owned()
        }
        other => panic!("nobody knows what belongs below `{other}`"),
    }
}

/// Whether pages are written anew.
pub(crate) fn is_updating() -> bool {
    std::env::var_os("UPDATE_PAGES").is_some()
}

/// A page with each block below an `output` or `code` comment made anew by `content`.
pub(crate) fn refreshed(page: &str, content: impl Fn(&str) -> String) -> String {
    let mut made = String::new();
    let mut lines = page.lines().peekable();
    while let Some(line) = lines.next() {
        made += &format!("{line}\n");
        let comment = line.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->"));
        if let Some(comment) = comment.filter(|c| c.starts_with("output: ") || c.starts_with("code: ")) {
            made += &format!("{}\n", lines.next().unwrap());
            for line in content(comment).lines() {
                made += &format!("{}\n", line.trim_end());
            }
            lines.find(|line| *line == "```").unwrap();
            made += "```\n";
        }
    }
    made
}

/// Requires that a file holds these bytes, or writes them.
pub(crate) fn require(file: &str, made: &[u8]) {
    if is_updating() {
        std::fs::write(file, made).unwrap();
    }
    assert!(std::fs::read(file).is_ok_and(|there| there == made), "{file}: UPDATE_PAGES=1 cargo test pages");
}

#[test]
fn every_block_is_up_to_date() {
    let page = std::fs::read_to_string("README.md").unwrap();
    require("README.md", refreshed(&page, content).as_bytes());
}

/// The page's picture is what its first command writes.
#[test]
fn the_first_picture_is_up_to_date() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("sheet.png");
    let (tree, _) = raytree(&["sheet", "scenes/whitted.json", "mirrored glass ball", "-o", file.to_str().unwrap()]);
    assert_eq!(tree, raytree(&["pixel", "scenes/whitted.json", "mirrored glass ball"]).0);
    require("docs/sheet.png", &std::fs::read(&file).unwrap());
}
