//! The pages of the course: what they show is what the programs print and draw, links lead somewhere, formulas can be set.

use std::collections::BTreeSet;
use std::path::Path;

use raytree::lessons::Lesson;
use raytree::pictures::drawing::{Drawing, Formulas};
use raytree::scene;

use super::COURSE;
use crate::pages::{raytree, refreshed, require};

/// The words of a command line, those in double quotes kept together.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (i, part) in line.split('"').enumerate() {
        match i % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    words
}

fn run(line: &str) -> (String, String) {
    let words = words(line);
    raytree(&words.iter().map(String::as_str).collect::<Vec<_>>())
}

/// Every page with the lesson it belongs to.
fn pages() -> Vec<(String, Option<Lesson>)> {
    let mut pages = vec![("lessons/README.md".to_owned(), None)];
    pages.extend(COURSE.iter().map(|course| (format!("{}/README.md", course.folder), Some((course.solved)()))));
    pages
}

/// What belongs into the block below a comment.
fn content(lesson: Option<&Lesson>, comment: &str) -> String {
    if let Some(line) = comment.strip_prefix("output: raytree ") {
        let (out, error) = run(line);
        assert_eq!(error, "", "{comment}");
        return out;
    }
    let planted = comment.strip_prefix("output: mistake ").and_then(|id| {
        let stages = &lesson?.stages;
        stages.iter().find_map(|stage| Some((stage, stage.with_mistake(id)?.failure?)))
    });
    let (stage, failure) = planted.unwrap_or_else(|| panic!("nobody knows what belongs below `{comment}`"));
    failure.to_text(stage.function, stage.cases)
}

/// The drawing that a `picture` comment asks for: `STAGE, CASE` or `mistake ID`.
fn picture(lesson: &Lesson, words: &str) -> Option<Drawing> {
    if let Some(id) = words.strip_prefix("mistake ") {
        return lesson.stages.iter().find_map(|stage| Some(stage.with_mistake(id)?.picture));
    }
    lesson.stages.iter().find_map(|stage| {
        let case = words.strip_prefix(stage.name)?.strip_prefix(", ")?;
        stage.picture(case)
    })
}

#[test]
fn every_block_and_diagram_of_the_course_is_up_to_date() {
    let folder = tempfile::tempdir().unwrap();
    let made = folder.path().join("diagram.svg");
    let mut named = BTreeSet::new();
    for (file, lesson) in pages() {
        let page = std::fs::read_to_string(&file).unwrap();
        let page = refreshed(&page, |comment| content(lesson.as_ref(), comment));
        require(&file, page.as_bytes());
        let lines: Vec<&str> = page.lines().collect();
        for (comment, image) in lines.iter().zip(lines.iter().skip(1)) {
            let Some(image) = image.strip_prefix("![") else { continue };
            let (alt, name) = image.strip_suffix(')').unwrap().split_once("](").unwrap();
            assert!(alt.len() > 20, "{file}: {name} says too little to those who do not see it");
            let comment = comment.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->")).unwrap();
            let svg = if let Some(line) = comment.strip_prefix("diagram: ") {
                let (_, error) = run(&format!("diagram {line} -o \"{}\"", made.display()));
                assert_eq!(error, "", "{comment}");
                std::fs::read(&made).unwrap()
            } else {
                let words = comment.strip_prefix("picture: ").unwrap();
                let drawing = picture(lesson.as_ref().unwrap(), words);
                drawing.unwrap_or_else(|| panic!("{file}: no {comment}")).to_svg().unwrap().into_bytes()
            };
            let target = Path::new(&file).with_file_name(name);
            require(target.to_str().unwrap(), &svg);
            named.insert(target);
        }
    }
    // No picture is left over.
    for course in COURSE {
        for entry in std::fs::read_dir(course.folder).unwrap() {
            let path = entry.unwrap().path();
            assert!(path.extension().is_none_or(|e| e != "svg") || named.contains(&path), "{path:?} is on no page");
        }
    }
}

/// The formulas of a page, those within a line and those on one of their own; code aside.
fn formulas(page: &str) -> Vec<(String, bool)> {
    let mut found = Vec::new();
    let mut is_code = false;
    for line in page.lines() {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            let prose: String = line.split('`').step_by(2).collect::<Vec<_>>().join(" ");
            for (i, part) in prose.split("$$").enumerate() {
                match i % 2 {
                    1 => found.push((part.to_owned(), true)),
                    _ => found.extend(part.split('$').skip(1).step_by(2).map(|tex| (tex.to_owned(), false))),
                }
            }
        }
    }
    found
}

#[test]
fn every_formula_of_the_course_can_be_set_and_survives_markdown() {
    let mut count = 0;
    for (file, _) in pages() {
        let page = std::fs::read_to_string(&file).unwrap();
        let mut set = Formulas::default();
        for (tex, is_display) in formulas(&page) {
            let made = if is_display { set.display(&tex) } else { set.inline(&tex) };
            made.unwrap_or_else(|why| panic!("{file}: {why}"));
            // Code hosts take a backslash before a sign for an escape, and asterisks for emphasis.
            let escapes = tex.match_indices('\\').any(|(i, _)| !tex[i + 1..].starts_with(|c: char| c.is_alphabetic()));
            assert!(!escapes && !tex.contains('*') && tex.trim() == tex, "{file}: {tex}");
            count += 1;
        }
        assert_eq!(page.matches('$').count() % 2, 0, "{file}");
    }
    assert!(count > 150, "{count}");
}

#[test]
fn links_and_commands_of_the_course_lead_somewhere() {
    let manifest = std::fs::read_to_string("Cargo.toml").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let mut files: Vec<String> = pages().into_iter().map(|(file, _)| file).collect();
    files.push("lessons/SUMMARY.md".to_owned());
    for file in files {
        let page = std::fs::read_to_string(&file).unwrap();
        for link in page.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            if !link.contains("://") {
                assert!(Path::new(&file).with_file_name(link).exists(), "{file} links to {link}");
            }
        }
        let commands = page.split("```sh\n").skip(1).filter_map(|rest| rest.split("```").next()).flat_map(str::lines);
        for line in commands {
            let line = line.split(" #").next().unwrap();
            let words = words(line);
            match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
                ["cargo", "run", "--example", example, ..] => {
                    assert!(manifest.contains(&format!("name = \"{example}\"")), "{file}: {line}");
                }
                ["raytree", "diagram", rest @ ..] => {
                    let (output, rest) = rest.split_last().unwrap();
                    let (dash_o, rest) = rest.split_last().unwrap();
                    assert_eq!(*dash_o, "-o", "{file}: {line}");
                    let output = folder.path().join(output);
                    let args = ["diagram"].iter().chain(rest).chain([dash_o]).copied().chain(output.to_str());
                    let (_, error) = raytree(&args.collect::<Vec<_>>());
                    assert!(error.is_empty() && output.exists(), "{file}: {line}: {error}");
                }
                ["raytree", "step" | "inspect", scene, pixel @ ..] => {
                    let loaded = scene::load_file(scene).unwrap();
                    let known = |pixel: &&str| loaded.scene.pixels.iter().any(|(name, _)| name == pixel);
                    assert!(pixel.iter().all(known), "{file}: {line}");
                }
                // A report takes seconds: that one is written is tested elsewhere.
                ["raytree", "accuracy", rest @ ..] => {
                    let (help, _) = raytree(&["accuracy", "--help"]);
                    let is_known = |word: &&str| word.starts_with("--") && help.contains(*word);
                    assert!(rest.ends_with(&["-o", "report"]), "{file}: {line}");
                    let given = &rest[..rest.len() - 2];
                    assert!(given.iter().all(|word| is_known(word) || Path::new(word).exists()), "{file}: {line}");
                }
                ["git" | "mdbook", ..] => {}
                other => panic!("{file}: nobody has looked at {other:?}"),
            }
        }
        // The pixels that are named for clicking are there.
        for line in page.lines().filter(|line| line.contains("raytree inspect")) {
            let words = words(line);
            let loaded = scene::load_file(&words[2]).unwrap();
            for (i, part) in line.split('"').enumerate().filter(|(i, _)| i % 2 == 1) {
                assert!(loaded.scene.pixels.iter().any(|(name, _)| name == part), "{file}: {part} ({i})");
            }
        }
    }
}

/// What a solved lesson tells to look at is there.
#[test]
fn what_to_notice_works() {
    let folder = tempfile::tempdir().unwrap();
    for course in COURSE {
        let lesson = (course.solved)();
        let (_, command) = lesson.notice.split_once("raytree ").unwrap();
        let (command, file) = command.split_once(" -o ").unwrap();
        let (_, error) = run(&format!("{command} -o \"{}\"", folder.path().join(file).display()));
        assert_eq!(error, "", "{}", lesson.notice);
    }
}

/// The table, the book's summary and the folders are the same lessons.
#[test]
fn the_contents_are_complete() {
    let front = std::fs::read_to_string("lessons/README.md").unwrap();
    let summary = std::fs::read_to_string("lessons/SUMMARY.md").unwrap();
    let mut folders = BTreeSet::new();
    for entry in std::fs::read_dir("lessons").unwrap() {
        let path = entry.unwrap().path();
        if path.join("exercise.rs").exists() {
            folders.insert(path.to_str().unwrap().to_owned());
        }
    }
    assert_eq!(folders, COURSE.iter().map(|course| course.folder.to_owned()).collect());
    assert!(COURSE.is_sorted_by_key(|course| course.folder));
    for course in COURSE {
        let name = course.folder.strip_prefix("lessons/").unwrap();
        assert!(
            front.contains(&format!("| {} | ", &name[..2])) && front.contains(&format!("[{name}]({name}/README.md)"))
        );
        assert!(summary.contains(&format!("({name}/README.md)")));
        let page = std::fs::read_to_string(format!("{}/README.md", course.folder)).unwrap();
        let parts = ["## The idea", "## Write", "## Notice", "## Questions", "## In the tracer"];
        let places: Vec<_> = parts.iter().map(|part| page.find(part).expect(part)).collect();
        assert!(places.is_sorted(), "{name}");
        assert!(
            page.matches("<details>").count() >= 3
                && page.matches("<details>").count() == page.matches("</details>").count()
        );
    }
}
