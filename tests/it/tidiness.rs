//! The house rules that a machine can hold: the floors, who may print, what the core depends on.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

fn sources(folder: &str) -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    let mut open = vec![PathBuf::from(folder)];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                files.push((path.clone(), std::fs::read_to_string(path).unwrap()));
            }
        }
    }
    files.sort();
    files
}

/// The floor of each module, from the table in ARCHITECTURE.md: rows that begin with `| 3 | `hits` |`.
fn floors() -> BTreeMap<String, u32> {
    let page = std::fs::read_to_string("ARCHITECTURE.md").unwrap();
    let mut floors = BTreeMap::new();
    for row in page.lines() {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        if let ["", floor, modules, ..] = cells.as_slice()
            && let Ok(floor) = floor.parse::<u32>()
        {
            for module in modules.split(',').map(|m| m.trim().trim_matches('`')) {
                floors.insert(module.to_owned(), floor);
            }
        }
    }
    floors
}

/// The modules that a source names behind `crate::`, comments and text aside.
fn imports(source: &str) -> BTreeSet<String> {
    let code = source.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code = code.collect::<Vec<_>>().join("\n");
    let after = code.split("crate::").skip(1);
    after.map(|rest| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()).collect()
}

#[test]
fn every_file_imports_from_its_own_floor_or_below() {
    let floors = floors();
    let mut seen = BTreeSet::new();
    for (path, source) in sources("src") {
        let parts: Vec<_> = path.iter().map(|part| part.to_str().unwrap()).collect();
        let [_, module, ..] = parts.as_slice() else { panic!("{path:?}") };
        if matches!(*module, "lib.rs" | "main.rs") {
            continue;
        }
        let own = *floors.get(*module).unwrap_or_else(|| panic!("ARCHITECTURE.md has no floor for {module}"));
        seen.insert((*module).to_owned());
        for import in imports(&source) {
            let other = *floors.get(&import).unwrap_or_else(|| panic!("{path:?} imports {import}, which has no floor"));
            assert!(other <= own, "{path:?} (floor {own}) imports {import} (floor {other})");
        }
    }
    assert_eq!(seen, floors.keys().cloned().collect(), "the map and the folders");
}

#[test]
fn only_the_film_names_image_only_the_canvas_tiny_skia_and_only_commands_print() {
    for (path, source) in sources("src") {
        let in_commands = path.starts_with("src/commands") || path.ends_with("main.rs");
        let code = || source.lines().filter(|line| !line.trim_start().starts_with("//"));
        for line in code() {
            let names_image = ["use image", "image::"].iter().any(|word| line.trim_start().starts_with(word));
            assert!(!names_image || path.ends_with("film.rs"), "{path:?}: {line}");
            let names_skia = line.contains("tiny_skia");
            assert!(!names_skia || path.ends_with("drawing/canvas.rs"), "{path:?}: {line}");
            let prints = ["print!", "println!", "eprint!", "eprintln!", "dbg!"].iter().any(|word| line.contains(word));
            assert!(!prints, "{path:?}: {line}");
            let streams = ["stdout()", "stderr()", "stdin()"].iter().any(|word| line.contains(word));
            assert!(!streams || in_commands, "{path:?}: {line}");
            assert!(!line.contains("process::exit") || path.ends_with("commands/failure.rs"), "{path:?}: {line}");
            let opens = ["File::open", "fs::read"].iter().any(|word| line.contains(word));
            assert!(!opens || in_commands || path.ends_with("scene/files.rs"), "{path:?}: {line}");
        }
    }
}

#[test]
fn nothing_is_left_unfinished() {
    for (path, source) in sources("src") {
        for word in ["todo!(", "unimplemented!(", "FIXME", "XXX", "#[ignore", "dyn Shape"] {
            assert!(!source.contains(word), "{path:?} contains {word}");
        }
        let long = source.lines().position(|line| line.chars().count() > 130);
        assert_eq!(long, None, "{path:?} has a line that nobody can read");
    }
}

#[test]
fn the_course_is_finished_but_for_what_students_write() {
    for (path, source) in sources("lessons") {
        let is_exercise = path.ends_with("exercise.rs");
        for word in ["todo!(", "unimplemented!(", "FIXME", "XXX"] {
            assert!(!source.contains(word) || (is_exercise && word == "todo!("), "{path:?} contains {word}");
        }
        let long = source.lines().position(|line| line.chars().count() > 130);
        assert_eq!(long, None, "{path:?} has a line that nobody can read");
    }
}

#[test]
fn platform_mathematics_stays_out() {
    // sqrt is rounded correctly everywhere; the rest comes from libm.
    let functions = [
        "sin", "cos", "tan", "powf", "powi", "exp", "ln", "log2", "log10", "acos", "asin", "atan", "atan2", "hypot",
        "cbrt", "sin_cos", "mul_add",
    ];
    for (path, source) in sources("src") {
        for line in source.lines().filter(|line| !line.trim_start().starts_with("//")) {
            for function in functions {
                let call = format!(".{function}(");
                let angle = line.contains(&call) && !line.contains("libm");
                assert!(!angle, "{path:?}: {line}");
            }
        }
    }
}

#[test]
fn the_core_needs_no_threads_no_servers_and_no_c() {
    let tree = Command::new(env!("CARGO"))
        .args([
            "tree",
            "--offline",
            "--no-default-features",
            "--edges",
            "normal,build",
            "--prefix",
            "none",
            "--format",
            "{p}",
        ])
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let crates: BTreeSet<String> = String::from_utf8(tree.stdout)
        .unwrap()
        .lines()
        .filter_map(|line| line.split_whitespace().next().map(str::to_owned))
        .collect();
    assert!(crates.contains("glam") && crates.contains("serde_json"));
    for name in [
        "rayon",
        "rayon-core",
        "crossbeam-utils",
        "image",
        "png",
        "exr",
        "zstd",
        "axum",
        "hyper",
        "tokio",
        "flate2",
        "clap",
        "cc",
        "ctrlc",
        "tempfile",
        "indicatif",
        "tiny-skia",
        "ttf-parser",
        "ratex-layout",
    ] {
        assert!(!crates.contains(name), "the core depends on {name}");
    }
    assert!(!crates.iter().any(|name| name.ends_with("-sys")), "the core depends on C: {crates:?}");
}

#[test]
fn the_pages_are_there_and_name_no_place_that_is_not() {
    for page in ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"] {
        let text = std::fs::read_to_string(page).unwrap();
        // A relative link leads somewhere.
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let target = link.split('#').next().unwrap();
            if !target.is_empty() && !target.contains("://") {
                assert!(Path::new(target).exists(), "{page} links to {link}");
            }
        }
    }
}
