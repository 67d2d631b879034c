//! `raytree grade`: a folder of twelve submissions, the formats of the results, what code may do to the grader, the page.

mod formats;
mod page;
mod rough;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use raytree::lessons::grading::{Cohort, Grade, Verdict};

/// `raytree grade` with these words; cargo needs no network for it.
fn grade(words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.arg("grade").args(words).env("CARGO", env!("CARGO")).env("CARGO_NET_OFFLINE", "true");
    command.output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The course's own solution of a lesson, or its exercise.
fn handed_out(lesson: &str, file: &str) -> String {
    fs::read_to_string(format!("lessons/{lesson}/{file}.rs")).unwrap()
}

/// Its solution with one place changed.
fn changed(lesson: &str, from: &str, to: &str) -> String {
    let solution = handed_out(lesson, "solution");
    assert_eq!(solution.matches(from).count(), 1, "{lesson}: {from}");
    solution.replace(from, to)
}

/// Its solution with a function's body replaced.
fn with_body(lesson: &str, function: &str, body: &str) -> String {
    let solution = handed_out(lesson, "solution");
    let (before, rest) = solution.split_once(&format!("pub fn {function}(")).unwrap();
    let (head, rest) = rest.split_once(" {\n").unwrap();
    let (_, after) = rest.split_once("\n}\n").unwrap();
    format!("{before}pub fn {function}({head} {{\n    {body}\n}}\n{after}")
}

fn hand_in(folder: &Path, name: &str, lesson: &str, source: &str) {
    let folder = folder.join(name).join(lesson);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("exercise.rs"), source).unwrap();
}

/// A submission: its name, its files, what a tutor expects of it.
struct Sample {
    name: &'static str,
    files: Vec<(&'static str, String)>,
    points: u32,
    /// The first stage that is not right: the function, the verdict, the mistake.
    wrong: Option<(&'static str, Verdict, Option<&'static str>)>,
}

/// From lesson 06 on the functions run in the scenes of the course. What checks all of them together is worth nothing where
/// none of them is written.
#[test]
fn lessons_that_read_scenes() {
    let folder = tempfile::tempdir().unwrap();
    for (name, file) in [("open", "exercise"), ("solved", "solution")] {
        hand_in(folder.path(), name, "08-shadows", &handed_out("08-shadows", file));
    }
    let results = folder.path().join("results");
    let (from, to) = (folder.path().display().to_string(), results.display().to_string());
    let output = grade(&["--cohort", &from, "-o", &to, "--lessons", "8"]);
    assert_eq!(text(&output.stdout), "open: 0 of 7 points\nsolved: 7 of 7 points\n", "{}", text(&output.stderr));
}

fn samples() -> Vec<Sample> {
    let sample = |name, lesson, source, points, function, verdict, mistake| Sample {
        name,
        files: vec![(lesson, source)],
        points,
        wrong: Some((function, verdict, mistake)),
    };
    let (plane, triangle, slabs, sphere) = ("02-plane", "03-triangle", "04-box", "05-sphere");
    let fault = |name, lesson, source, points, function, mistake| {
        sample(name, lesson, source, points, function, Verdict::Wrong, Some(mistake))
    };
    vec![
        Sample {
            name: "ada-right",
            files: vec![(plane, handed_out(plane, "solution")), (sphere, handed_out(sphere, "solution"))],
            points: 20,
            wrong: None,
        },
        sample("ben-unsolved", plane, handed_out(plane, "exercise"), 0, "plane_from", Verdict::Unwritten, None),
        sample(
            "cleo-does-not-compile",
            plane,
            changed(plane, "point.dot(plane.normal) - plane.distance", "point.dot(plane.normall) - plane.distance"),
            0,
            "plane_from",
            Verdict::NotBuilt,
            None,
        ),
        sample(
            "dan-endless-loop",
            plane,
            with_body(plane, "signed_distance", "loop {\n        std::hint::black_box(point);\n    }"),
            8,
            "signed_distance",
            Verdict::TimedOut,
            None,
        ),
        sample(
            "eve-memory-eater",
            plane,
            with_body(
                plane,
                "signed_distance",
                "let mut kept = Vec::new();\n    loop {\n        kept.push(vec![point; 1 << 16]);\n    }",
            ),
            8,
            "signed_distance",
            Verdict::OutOfMemory,
            None,
        ),
        sample(
            "finn-panic",
            plane,
            with_body(plane, "signed_distance", "[point.x, point.y][plane.normal.x.abs() as usize + 2]"),
            8,
            "signed_distance",
            Verdict::Panicked,
            None,
        ),
        fault(
            "gus-d-sign",
            plane,
            changed(plane, "distance: point.dot(normal)", "distance: -point.dot(normal)"),
            7,
            "plane_from",
            "plane-d-sign",
        ),
        fault(
            "hana-exchanged",
            triangle,
            changed(triangle, "[a, b, 1.0 - a - b]\n", "[b, a, 1.0 - a - b]\n"),
            7,
            "weights",
            "barycentrics-a-b-exchanged",
        ),
        fault(
            "ivo-b-above-one",
            triangle,
            changed(triangle, "a + b <= 1.0", "b <= 1.0"),
            8,
            "is_inside",
            "b-above-one",
        ),
        fault(
            "juri-slab",
            slabs,
            changed(slabs, "t_in: t_low.min(t_high), t_out: t_low.max(t_high)", "t_in: t_low, t_out: t_high"),
            8,
            "slab",
            "slab-unsorted",
        ),
        fault(
            "kim-brackets",
            sphere,
            handed_out(sphere, "solution").replace("/ (2.0 * a)", "/ 2.0 * a"),
            7,
            "roots",
            "quadratic-times-a",
        ),
        fault(
            "lea-normal",
            sphere,
            changed(sphere, "if outward.dot(ray.direction) > 0.0 { -outward } else { outward }", "outward"),
            8,
            "normal",
            "normal-not-flipped",
        ),
    ]
}

/// The twelve, graded once for all tests that look at the results.
static TWELVE: LazyLock<(PathBuf, Output)> = LazyLock::new(|| {
    // Nothing drops a static: the folder is one that the next run takes again.
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("grade-twelve");
    fs::remove_dir_all(&folder).ok();
    let (submissions, results) = (folder.join("submissions"), folder.join("results"));
    for sample in samples() {
        for (lesson, source) in &sample.files {
            hand_in(&submissions, sample.name, lesson, source);
        }
    }
    // A file among the folders is nobody's submission.
    fs::write(submissions.join("list.txt"), "ada, ben, ...").unwrap();
    let [from, to] = [&submissions, &results].map(|path| path.to_str().unwrap());
    let words = ["--lessons", "2,3,4,5", "--time-limit", "2", "--memory-limit", "256", "--threads", "2"];
    let output = grade(&[&["--cohort", from, "-o", to], &words[..]].concat());
    (results, output)
});

/// A file of the results of the twelve.
fn result(file: &str) -> String {
    let (results, output) = &*TWELVE;
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    fs::read_to_string(results.join(file)).unwrap()
}

fn grade_of(name: &str) -> Grade {
    serde_json::from_str(&result(&format!("{name}/grade.json"))).unwrap()
}

#[test]
fn twelve_submissions_are_graded_in_one_command() {
    let lines = samples().into_iter().map(|sample| format!("{}: {} of 40 points\n", sample.name, sample.points));
    assert_eq!(text(&TWELVE.1.stdout), lines.collect::<String>());
    for sample in samples() {
        let grade = grade_of(sample.name);
        assert_eq!((grade.submission.as_str(), grade.lessons.len(), grade.of), (sample.name, 4, 40), "{}", sample.name);
        for lesson in &grade.lessons {
            let is_there = sample.files.iter().any(|(folder, _)| *folder == lesson.folder);
            let first = lesson.stages.iter().find(|stage| stage.verdict != Verdict::Right);
            match (is_there, sample.wrong) {
                (false, _) => assert!(lesson.stages.iter().all(|stage| stage.verdict == Verdict::Missing)),
                (true, None) => assert_eq!(first, None),
                (true, Some((function, verdict, mistake))) => {
                    let first = first.unwrap();
                    let named = first.mistake().map(|mistake| mistake.id.as_str());
                    assert_eq!((first.function.as_str(), first.verdict, named), (function, verdict, mistake));
                }
            }
        }
        assert_eq!(grade.points, sample.points, "{}", grade.to_markdown());
    }
}

/// What a student reads of what went wrong.
#[test]
fn messages_name_the_place() {
    let not_built = grade_of("cleo-does-not-compile").lessons.swap_remove(0).not_built.unwrap();
    let line = handed_out("02-plane", "solution").lines().position(|l| l.contains("- plane.distance")).unwrap() + 1;
    let place = format!("lessons/02-plane/exercise.rs:{line}:");
    assert!(not_built.place.as_ref().unwrap().starts_with(&place), "{not_built:?}");
    assert!(not_built.message.contains("no field `normall`") && not_built.errors == 1, "{not_built:?}");
    assert!(not_built.text.contains("point.dot(plane.normall)"), "{not_built:?}");
    let message = |name: &str, stage: usize| grade_of(name).lessons[0].stages[stage].message.clone().unwrap();
    assert_eq!(message("dan-endless-loop", 1), "It ran longer than 2 s.");
    assert_eq!(message("eve-memory-eater", 1), "It asked for more than 256 MiB of memory.");
    let finn = message("finn-panic", 1);
    assert!(finn.contains("a panic at lessons/02-plane/exercise.rs:") && finn.contains("out of bounds"), "{finn}");
    assert!(message("gus-d-sign", 0).contains("the mistake: D has the wrong sign"));
    assert_eq!(message("hana-exchanged", 0), "There is no such file in the submission.");
    assert!(message("ben-unsolved", 0).starts_with("`plane_from` is not written yet: lessons/02-plane/exercise.rs:"));
}

/// What does not build on a wrong function keeps its points, and what does is checked with a right one.
#[test]
fn one_mistake_does_not_take_the_rest() {
    use Verdict::{OutOfMemory, Panicked, Right, TimedOut, Wrong};
    let stages = |name: &str, lesson: usize| grade_of(name).lessons.swap_remove(lesson).stages;
    let verdicts = |name: &str, lesson| stages(name, lesson).iter().map(|stage| stage.verdict).collect::<Vec<_>>();
    for (name, second) in [("dan-endless-loop", TimedOut), ("eve-memory-eater", OutOfMemory), ("finn-panic", Panicked)]
    {
        assert_eq!(verdicts(name, 0), [Right, second, Right, Right], "{name}");
        assert!(stages(name, 0).iter().all(|stage| stage.checked_with.is_empty()), "{name}");
    }
    for (name, lesson, wrong, with) in [
        ("hana-exchanged", 1, [Right, Wrong, Right, Right], ["", "", "", "weights"]),
        ("ivo-b-above-one", 1, [Right, Right, Wrong, Right], ["", "", "", "is_inside"]),
        ("juri-slab", 2, [Wrong, Right, Right, Right], ["", "slab", "slab", "slab"]),
        ("kim-brackets", 3, [Right, Wrong, Right, Right], ["", "", "roots", ""]),
        ("lea-normal", 3, [Right, Right, Right, Wrong], [""; 4]),
    ] {
        assert_eq!(verdicts(name, lesson), wrong, "{name}");
        let checked: Vec<String> = stages(name, lesson).iter().map(|stage| stage.checked_with.concat()).collect();
        assert_eq!(checked, with, "{name}");
    }
}

#[test]
fn a_cohort_counts_what_went_wrong() {
    let cohort: Cohort = serde_json::from_str(&result("cohort.json")).unwrap();
    assert_eq!(cohort.format, "raytree-cohort/1");
    let names: Vec<&str> = cohort.submissions.iter().map(|standing| standing.submission.as_str()).collect();
    assert_eq!(names, samples().iter().map(|sample| sample.name).collect::<Vec<_>>());
    let ids: Vec<&str> = cohort.mistakes.iter().map(|mistake| mistake.id.as_str()).collect();
    let planted: Vec<&str> = samples().iter().filter_map(|sample| sample.wrong?.2).collect();
    assert_eq!(ids, planted);
    assert!(cohort.mistakes.iter().all(|mistake| mistake.submissions.len() == 1 && !mistake.why.is_empty()));
    let distance = cohort.stages.iter().find(|stage| stage.function == "signed_distance").unwrap();
    assert_eq!(distance.verdicts.values().sum::<usize>(), 12);
    for (verdict, count) in [
        (Verdict::Right, 2),
        (Verdict::TimedOut, 1),
        (Verdict::OutOfMemory, 1),
        (Verdict::Panicked, 1),
        (Verdict::NotBuilt, 1),
        (Verdict::Unwritten, 1),
        (Verdict::Missing, 5),
    ] {
        assert_eq!(distance.count(verdict), count, "{verdict:?}");
    }
    // Two who make the same mistake are counted together, and before the others.
    let twins = ["gus-d-sign", "lea-normal", "lea-normal"].map(grade_of);
    let twins =
        Cohort::of(&[twins[0].clone(), twins[1].clone(), Grade { submission: "mia".into(), ..twins[2].clone() }]);
    let counted: Vec<(&str, usize)> = twins.mistakes.iter().map(|m| (m.id.as_str(), m.submissions.len())).collect();
    assert_eq!(counted, [("normal-not-flipped", 2), ("plane-d-sign", 1)]);
}
