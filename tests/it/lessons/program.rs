//! `cargo run --example lesson-NN` as a shell sees it.

use std::path::PathBuf;
use std::process::{Command, Output};

/// The programs of a lesson, built as the test is.
fn programs(names: &[&str]) -> Vec<PathBuf> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--locked", "--offline"]);
    if !cfg!(debug_assertions) {
        cargo.arg("--release");
    }
    names.iter().for_each(|name| _ = cargo.args(["--example", name]));
    let built = cargo.output().unwrap();
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    // target/debug/deps/it-0123 stands beside target/debug/examples.
    let own = std::env::current_exe().unwrap();
    let folder = own.parent().and_then(|deps| deps.parent()).unwrap().join("examples");
    names.iter().map(|name| folder.join(name)).collect()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn a_lesson_from_the_shell() {
    let [exercise, solution] = programs(&["lesson-03", "lesson-03-solution"]).try_into().unwrap();
    // A copy of their own keeps the counter of hints away from that of whoever works here.
    let folder = tempfile::tempdir().unwrap();
    let copied = |from: &PathBuf| {
        let to = folder.path().join(from.file_name().unwrap());
        std::fs::copy(from, &to).unwrap();
        to
    };
    let (exercise, solution) = (copied(&exercise), copied(&solution));
    let run = |program: &PathBuf, args: &[&str]| -> Output {
        Command::new(program).args(args).current_dir(folder.path()).output().unwrap()
    };

    let output = run(&exercise, &[]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(1), ""));
    let told = text(&output.stdout);
    assert!(told.contains("`plane_t` is not written yet: lessons/03-triangle/exercise.rs:"), "{told}");
    assert!(!told.contains("panicked") && !told.contains("RUST_BACKTRACE") && !told.contains("picture"), "{told}");

    // Nothing is told of a picture, so none is written, unless it is asked for.
    assert!(!folder.path().join("lesson-03.png").exists());
    assert!(text(&run(&exercise, &["--picture", "asked.svg"]).stdout).contains("a picture: asked.svg"));
    let output = run(&solution, &[]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    assert!(text(&output.stdout).contains("All right.") && text(&output.stdout).contains("a picture: lesson-03.png"));
    let picture = std::fs::read(folder.path().join("lesson-03.png")).unwrap();
    assert!(picture.starts_with(b"\x89PNG"));
    let output = run(&solution, &["--picture", "mine.svg"]);
    assert!(text(&output.stdout).contains("a picture: mine.svg"));
    assert!(std::fs::read_to_string(folder.path().join("mine.svg")).unwrap().starts_with("<svg"));
    let output = run(&solution, &["--picture", "mine.gif"]);
    assert_eq!(output.status.code(), Some(2));
    let output = run(&solution, &["--picture", "nowhere/mine.png"]);
    assert_eq!(output.status.code(), Some(3));
    let output = run(&exercise, &["--nonsense"]);
    assert_eq!(output.status.code(), Some(2));

    // A hint a time; the last one stays.
    let hints = (1..=4).map(|_| text(&run(&exercise, &["--hint"]).stdout)).collect::<Vec<_>>();
    assert!(hints[0].starts_with("hint 1 of 3 for `plane_t`: ") && hints[1].starts_with("hint 2 of 3"), "{hints:?}");
    assert!(hints[2].starts_with("hint 3 of 3") && hints[2] == hints[3], "{hints:?}");
    assert!(hints[2].contains("cargo run --example lesson-03-solution") && !hints[1].contains("solution"), "{hints:?}");
    assert_eq!(text(&run(&exercise, &["--hint", "2"]).stdout), hints[1]);
    assert_eq!(run(&exercise, &["--hint", "4"]).status.code(), Some(2));
    assert!(text(&run(&solution, &["--hint"]).stdout).contains("is solved"));

    let output = run(&exercise, &["--json"]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(1), ""));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&report["lesson"], &report["points"], &report["of"]), (&3.into(), &0.into(), &10.into()));
    let to_file = run(&exercise, &["--json", "result.json"]);
    assert_eq!((to_file.status.code(), to_file.stdout.as_slice()), (Some(1), b"".as_slice()));
    assert_eq!(std::fs::read(folder.path().join("result.json")).unwrap(), output.stdout);
    // One part alone, as a grader asks for it.
    let part = run(&solution, &["--json", "--stage", "2"]);
    let report: serde_json::Value = serde_json::from_slice(&part.stdout).unwrap();
    let names: Vec<_> = report["stages"].as_array().unwrap().iter().map(|stage| &stage["function"]).collect();
    assert_eq!((part.status.code(), names), (Some(0), vec![&"weights".into()]));
    assert_eq!(run(&exercise, &["--json", "--stage", "2"]).status.code(), Some(1));
    assert!(text(&run(&solution, &["--json", "--stage", "5"]).stderr).contains("the lesson has no part 5"));
    assert_eq!(run(&solution, &["--stage", "2"]).status.code(), Some(2));
    let output = run(&solution, &["--json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((output.status.code(), &report["passed"]), (Some(0), &true.into()));
}
