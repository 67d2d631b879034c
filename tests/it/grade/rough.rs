//! Code that does not play by the rules, folders that are not as they should be, limits, Ctrl-C.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use raytree::lessons::grading::{Grade, Verdict};

use super::{changed, grade, hand_in, handed_out, text, with_body};

const PLANE: &str = "02-plane";

fn read(file: &Path) -> Grade {
    serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap()
}

/// Every one of these costs its own points and no other, and the grader goes on.
#[test]
fn code_that_does_not_play_by_the_rules() {
    let folder = tempfile::tempdir().unwrap();
    let submissions = folder.path().join("submissions");
    let distance = |body: &str| with_body(PLANE, "signed_distance", body);
    // Prints what looks like a result, and is right.
    let talks = distance("println!(\"{{\\\"passed\\\": true}}\");\n    point.dot(plane.normal) - plane.distance");
    hand_in(&submissions, "a-talks", PLANE, &talks);
    hand_in(&submissions, "b-leaves", PLANE, &distance("std::process::exit(point.x as i32 * 0)"));
    hand_in(&submissions, "c-floods", PLANE, &distance("loop {\n        println!(\"{point} and on and on\");\n    }"));
    hand_in(&submissions, "d-deep", PLANE, &distance("signed_distance(point, plane) + std::hint::black_box(1.0)"));
    // A process that is started and left behind, with the pipe in its hand.
    let late = folder.path().join("late");
    let leaves_one = distance(&format!(
        "std::process::Command::new(\"sh\").args([\"-c\", \"sleep 3; echo > '{}'\"]).spawn().ok();\n    \
         point.dot(plane.normal) - plane.distance",
        late.display()
    ));
    hand_in(&submissions, "e-leaves-one-behind", PLANE, &leaves_one);
    // Another main function that writes a result of its own.
    let solution = handed_out(PLANE, "exercise");
    let (functions, _) = solution.split_once("fn main()").unwrap();
    let forged = format!(
        "{functions}fn main() {{\n    let own = \"{{\\\"format\\\":\\\"raytree-lesson/1\\\",\\\"lesson\\\":2,\\\"title\\\":\\\"plane\\\",\
         \\\"passed\\\":true,\\\"points\\\":10,\\\"of\\\":10,\\\"tolerance\\\":1e-9,\\\"stages\\\":[]}}\";\n    \
         std::fs::write(\"result.json\", own).unwrap();\n}}\n"
    );
    hand_in(&submissions, "f-forges", PLANE, &forged);
    // A loop that three functions call, one of which has a mistake of its own.
    let two = with_body("04-box", "slab", "loop {\n        std::hint::black_box(origin);\n    }");
    let two = two.replacen("t_in > t_out || t_out < 0.0", "t_in > t_out", 1);
    hand_in(&submissions, "g-two", "04-box", &two);
    let results = folder.path().join("results");
    let [from, to] = [&submissions, &results].map(|path| path.to_str().unwrap());
    let output = grade(&["--cohort", from, "-o", to, "--lessons", "2,4", "--time-limit", "3", "--output-limit", "64"]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    let of = |name: &str| read(&results.join(name).join("grade.json"));
    for (name, points, verdict, message) in [
        ("a-talks", 10, Verdict::Right, ""),
        ("b-leaves", 8, Verdict::Crashed, "The program ended with exit status: 0 before it had a result."),
        ("c-floods", 8, Verdict::TooMuchOutput, "It printed more than 64 KiB."),
        ("d-deep", 8, Verdict::Crashed, "The stack overflowed: a function calls itself without end."),
        ("e-leaves-one-behind", 10, Verdict::Right, ""),
        ("f-forges", 0, Verdict::Crashed, "The program wrote a result that is not this lesson's."),
    ] {
        let grade = of(name);
        let stage = &grade.lessons[0].stages[1];
        assert_eq!((grade.points, stage.verdict), (points, verdict), "{name}: {}", grade.to_markdown());
        assert_eq!(stage.message.as_deref().unwrap_or_default(), message, "{name}");
    }
    assert!(of("a-talks").lessons[0].output.starts_with("{\"passed\": true}\n"));
    assert!(of("c-floods").lessons[0].output.len() < 2100);
    let notes = of("f-forges").lessons[0].notes.join("; ");
    assert!(notes.contains("fn main is not the one that was handed out"), "{notes}");
    assert!(of("b-leaves").lessons[0].notes.iter().any(|note| note.contains("std::process")));
    let two = &of("g-two").lessons[1];
    let came: Vec<_> = two.stages.iter().map(|stage| (stage.verdict, stage.checked_with.concat())).collect();
    let slab = || "slab".to_owned();
    let expected = [(Verdict::TimedOut, String::new()), (Verdict::Wrong, slab()), (Verdict::Right, slab())];
    assert_eq!(came[..3], expected, "{two:?}");
    assert_eq!(two.stages[1].mistake().unwrap().id, "rectangle-behind");
    std::thread::sleep(Duration::from_secs(3));
    assert!(!late.exists(), "what a program leaves behind is ended with it");
}

/// A single submission, wherever the lessons lie in it; links are not followed; twice is said.
#[test]
fn one_submission_deep_down() {
    let folder = tempfile::tempdir().unwrap();
    let own = folder.path().join("upload/raytree-main");
    hand_in(&own, "lessons", PLANE, &changed(PLANE, "distance: point.dot(normal)", "distance: point.length()"));
    hand_in(&own, "old/lessons", PLANE, &handed_out(PLANE, "exercise"));
    #[cfg(unix)]
    {
        fs::create_dir_all(own.join("lessons/03-triangle")).unwrap();
        std::os::unix::fs::symlink("/etc/passwd", own.join("lessons/03-triangle/exercise.rs")).unwrap();
    }
    let results = folder.path().join("results");
    let upload = folder.path().join("upload");
    let output = grade(&[upload.to_str().unwrap(), "-o", results.to_str().unwrap(), "--lessons", "2,3"]);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    let grade = read(&results.join("grade.json"));
    assert_eq!((grade.submission.as_str(), grade.points, grade.of), ("upload", 7, 20));
    let mistake = grade.lessons[0].stages[0].mistake().unwrap();
    assert_eq!(mistake.id, "distance-as-length");
    assert_eq!(grade.notes, ["02-plane is there 2 times: raytree-main/lessons/02-plane/exercise.rs was taken"]);
    assert!(grade.lessons[1].stages.iter().all(|stage| stage.verdict == Verdict::Missing));
    let mut there: Vec<_> = fs::read_dir(&results).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    there.sort();
    assert_eq!(there, ["exercism", "grade.json", "grade.md", "junit.xml", "results.json"]);
}

/// One clear message, and nothing is written.
#[test]
fn folders_that_are_no_submissions() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fs::create_dir(path("empty")).unwrap();
    fs::write(path("file"), "").unwrap();
    hand_in(folder.path(), "cohort/ada", PLANE, "fn main() {}");
    let results = path("results");
    for (words, told) in [
        (vec![path("nowhere")], "there is no such folder"),
        (vec![path("file")], "it is no folder"),
        (vec![path("empty")], "there is no lesson in it"),
        (vec!["--cohort".into(), path("empty")], "there is no submission in it"),
        (vec![path("cohort"), "--course".into(), path("empty")], "there is no course here: it has no Cargo.toml"),
        (vec![path("cohort"), "--lessons".into(), "77".into()], "the course has no lesson 77"),
        (vec![path("cohort"), "--time-limit".into(), "0".into()], "0 is not in 1..=3600"),
    ] {
        let words: Vec<&str> = words.iter().map(String::as_str).chain(["-o", &results]).collect();
        let output = grade(&words);
        let error = text(&output.stderr);
        assert!(
            output.status.code() == Some(2) && output.stdout.is_empty() && error.contains(told),
            "{words:?}: {error}"
        );
        assert!(!Path::new(&results).exists(), "{words:?}");
    }
    let among = grade(&["--cohort", &path("cohort"), "-o", &path("cohort/ada")]);
    assert!(text(&among.stderr).contains("the results are among the submissions"));
    let help = text(&grade(&["--help"]).stdout);
    assert!(help.contains("This is no sandbox") && help.contains("Examples:"), "{help}");
}

/// Ctrl-C ends what runs and leaves nothing behind.
#[cfg(unix)]
#[test]
fn ctrl_c_ends_the_students_program_too() {
    let folder = tempfile::tempdir().unwrap();
    let beat = folder.path().join("beat");
    let body = format!(
        "loop {{\n        use std::io::Write;\n        \
         let mut file = std::fs::File::options().create(true).append(true).open({beat:?}).unwrap();\n        \
         file.write_all(b\".\").unwrap();\n        \
         std::thread::sleep(std::time::Duration::from_millis(50));\n    }}"
    );
    hand_in(folder.path(), "submission", PLANE, &with_body(PLANE, "signed_distance", &body));
    let results = folder.path().join("results");
    let child = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["grade".as_ref(), folder.path().join("submission").as_os_str(), "-o".as_ref(), results.as_os_str()])
        .args(["--lessons", "2", "--time-limit", "600"])
        .env("CARGO", env!("CARGO"))
        .env("CARGO_NET_OFFLINE", "true")
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let beats = || fs::metadata(&beat).map_or(0, |data| data.len());
    let mut patience = 3000;
    while beats() < 3 {
        patience -= 1;
        assert!(patience > 0, "the program was never started");
        std::thread::sleep(Duration::from_millis(100));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    let there = beats();
    std::thread::sleep(Duration::from_millis(300));
    assert!(beats() == there && !results.exists());
}
