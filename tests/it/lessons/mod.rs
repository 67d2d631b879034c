//! The course: every exercise fails in a friendly way, every solution passes, known mistakes are named and drawn; the pages.

#[macro_use]
mod planted;

mod aabb;
mod book;
mod camera;
mod cost;
mod fast;
mod pages;
mod plane;
mod program;
mod reflection;
mod refraction;
mod rounding;
mod shadows;
mod sphere;
mod trace;
mod traced;
mod triangle;
mod update;
mod vectors;
mod worked;

use std::collections::BTreeSet;

use raytree::lessons::{
    Answer, Case, Failure, FailureKind, Fault, Lesson, Outcome, Report, Stage, Task, pictures, shown,
};

use crate::diagrams::check_labels;

/// A lesson's folder, the lesson as it is committed, solved, and solved wrongly.
struct Course {
    folder: &'static str,
    unsolved: fn() -> Lesson,
    solved: fn() -> Lesson,
    wrong: fn() -> Vec<(&'static str, Lesson)>,
}

const COURSE: [Course; 13] = [
    Course {
        folder: "lessons/01-vectors",
        unsolved: vectors::unsolved,
        solved: vectors::solved,
        wrong: vectors::wrong,
    },
    Course { folder: "lessons/02-plane", unsolved: plane::unsolved, solved: plane::solved, wrong: plane::wrong },
    Course {
        folder: "lessons/03-triangle",
        unsolved: triangle::unsolved,
        solved: triangle::solved,
        wrong: triangle::wrong,
    },
    Course { folder: "lessons/04-box", unsolved: aabb::unsolved, solved: aabb::solved, wrong: aabb::wrong },
    Course { folder: "lessons/05-sphere", unsolved: sphere::unsolved, solved: sphere::solved, wrong: sphere::wrong },
    Course { folder: "lessons/06-camera", unsolved: camera::unsolved, solved: camera::solved, wrong: camera::wrong },
    Course { folder: "lessons/07-trace", unsolved: trace::unsolved, solved: trace::solved, wrong: trace::wrong },
    Course {
        folder: "lessons/08-shadows",
        unsolved: shadows::unsolved,
        solved: shadows::solved,
        wrong: shadows::wrong,
    },
    Course {
        folder: "lessons/09-reflection",
        unsolved: reflection::unsolved,
        solved: reflection::solved,
        wrong: reflection::wrong,
    },
    Course {
        folder: "lessons/10-refraction",
        unsolved: refraction::unsolved,
        solved: refraction::solved,
        wrong: refraction::wrong,
    },
    Course {
        folder: "lessons/11-numbers",
        unsolved: rounding::unsolved,
        solved: rounding::solved,
        wrong: rounding::wrong,
    },
    Course { folder: "lessons/12-fast", unsolved: fast::unsolved, solved: fast::solved, wrong: fast::wrong },
    Course { folder: "lessons/13-cost", unsolved: cost::unsolved, solved: cost::solved, wrong: cost::wrong },
];

fn failure(report: &Report) -> &Failure {
    report.first_open().and_then(|(_, stage)| stage.failure.as_ref()).expect("a stage fails")
}

#[test]
fn every_exercise_fails_in_one_friendly_line() {
    for course in COURSE {
        let lesson = (course.unsolved)();
        let (report, _) = lesson.check();
        assert_eq!((report.passed, report.points), (false, 0), "{}", course.folder);
        for stage in &report.stages {
            assert_ne!(stage.outcome, Outcome::Passed, "{}: {}", course.folder, stage.function);
        }
        assert_eq!(failure(&report).kind, FailureKind::Unwritten);
        let text = report.to_text("run");
        let place = format!("{}/exercise.rs:", course.folder);
        let told: Vec<&str> = text.lines().filter(|line| line.contains(&place)).collect();
        let first = format!("`{}` is not written yet: ", lesson.stages[0].function);
        assert!(told.len() == 1 && told[0].starts_with(&first), "{text}");
        assert!(!text.contains("panicked"), "{text}");
    }
}

#[test]
fn every_solution_passes() {
    let mut cases = 0;
    for course in COURSE {
        let lesson = (course.solved)();
        let (report, picture) = lesson.check();
        assert!(report.passed && report.points == report.of, "{}", report.to_text("run"));
        assert!(course.folder.contains(&format!("/{:02}-", report.lesson)), "{}", course.folder);
        check_labels(course.folder, &picture.unwrap());
        // What is asked of a whole picture or of a whole table is asked once or twice.
        let is_whole = |stage: &Stage| stage.name.starts_with("the picture") || stage.name.starts_with("the table");
        for stage in &lesson.stages {
            assert!((stage.cases >= 40 || is_whole(stage)) && !stage.hints.is_empty(), "{}", stage.name);
        }
        cases += lesson.stages.iter().map(|stage| stage.cases).sum::<usize>();
    }
    assert!(cases > 900, "{cases}");
}

#[test]
fn mistakes_that_students_make_are_named() {
    let mut named = 0;
    for course in COURSE {
        for (id, lesson) in (course.wrong)() {
            let (report, picture) = lesson.check();
            let wrong = failure(&report);
            let found = wrong.mistake.as_ref().map(|mistake| mistake.id.as_str());
            assert_eq!(found, Some(id), "{}", report.to_text("run"));
            let text = report.to_text("run");
            assert!(text.contains("expected") && text.contains("got") && text.contains("the mistake: "), "{text}");
            check_labels(id, &picture.unwrap());
            named += 1;
        }
    }
    assert!(named >= 40, "{named}");
}

/// Every fault in the lists answers otherwise than the truth, is told apart from those before it, and has a picture.
#[test]
fn every_listed_mistake_is_found_and_drawn() {
    let mut ids = BTreeSet::new();
    for course in COURSE {
        for stage in (course.solved)().stages {
            let again: BTreeSet<&str> = stage.mistakes.iter().map(|mistake| mistake.name.as_str()).collect();
            for mistake in &stage.mistakes {
                assert!(ids.insert(mistake.id.clone()), "{} twice", mistake.id);
                let checked = stage.with_mistake(&mistake.id).unwrap();
                let failure = checked.failure.unwrap_or_else(|| panic!("{} is no mistake", mistake.id));
                assert_eq!(failure.mistake.as_ref(), Some(mistake), "another mistake answers like it");
                assert!(mistake.why.ends_with(['.', ')']) && !mistake.name.ends_with('.'), "{}", mistake.id);
                check_labels(&mistake.id, &checked.picture);
                checked.picture.to_svg().unwrap();
                assert!(checked.picture.description().contains("yours: "), "{}", mistake.id);
            }
            // Where all functions run together, the mistakes are those of the functions.
            assert!(!again.is_empty() || stage.function == "the program");
        }
    }
    assert!(ids.len() >= 100, "{}", ids.len());
}

/// A mistake in one stage costs that stage, those that build on it only where they are wrong themselves, and no other.
#[test]
fn an_early_mistake_does_not_take_the_rest() {
    let (_, lesson) = triangle::wrong().into_iter().find(|(id, _)| *id == "b-above-one").unwrap();
    let (report, _) = lesson.check();
    let outcomes: Vec<Outcome> = report.stages.iter().map(|stage| stage.outcome).collect();
    assert_eq!(outcomes, [Outcome::Passed, Outcome::Passed, Outcome::Failed, Outcome::Passed]);
    assert_eq!((report.points, report.of), (8, 10));
    let (report, _) = triangle::unsolved().check();
    assert_eq!(report.stages[3].outcome, Outcome::NotReached);
    assert_eq!(report.stages[3].waits_for, ["plane_t", "weights", "is_inside"]);
    assert!(report.stages[3].failure.is_none());
}

#[test]
fn a_report_is_read_back_from_json() {
    for (_, lesson) in sphere::wrong() {
        let (report, _) = lesson.check();
        let json = serde_json::to_string(&report).unwrap();
        assert_eq!(serde_json::from_str::<Report>(&json).unwrap(), report);
    }
    let (report, _) = sphere::unsolved().check();
    let json = serde_json::to_value(&report).unwrap();
    assert_eq!(json["format"], "raytree-lesson/1");
    assert_eq!(json["stages"][0]["outcome"], "failed");
    assert_eq!(json["stages"][0]["failure"]["kind"], "unwritten");
    assert_eq!(json["stages"][2]["outcome"], "not_reached");
    assert!(json["stages"][0].get("waits_for").is_none());
}

/// A task of one number, to look at the frame alone.
fn doubling(faults: &'static [Fault<f64>]) -> Task<f64> {
    Task {
        name: "doubling",
        function: "double",
        points: 1,
        after: &[],
        cases: [1.0, 2.0, 3.0].map(|x| Case::new(&format!("of {x}"), x)).into(),
        given: |x| vec![format!("x = {}", shown(*x))],
        truth: |x| Answer::of("length", 2.0 * x),
        faults,
        picture: |x, what, _| pictures::length(glam::DVec3::new(*x, 0.0, 0.0), what),
        hints: &["twice"],
    }
}

#[test]
fn a_panic_is_an_answer() {
    let stage = doubling(&[]).stage(|x| Answer::of("length", [2.0, 4.0][*x as usize - 1]));
    let failure = stage.run().failure.unwrap();
    assert_eq!((failure.kind, failure.case, failure.got.as_deref()), (FailureKind::Panicked, 3, None));
    let broken = failure.broken.as_ref().unwrap();
    assert!(broken.place.starts_with("tests/it/lessons/mod.rs:"), "{broken:?}");
    assert!(broken.message.contains("out of bounds"), "{broken:?}");
    assert!(failure.to_text("double", 3).contains("got       a panic at tests/it/lessons/mod.rs:"));
}

#[test]
fn answers_are_compared_within_the_tolerance_and_told_apart() {
    let run = |answer: fn(f64) -> f64| doubling(&[]).stage(move |x| Answer::of("length", answer(*x))).run().failure;
    assert!(run(|x| 2.0 * x + 5e-10).is_none());
    let endless = |x: f64| Answer::of("t", x);
    assert!(endless(f64::INFINITY).agrees(&endless(f64::INFINITY)));
    assert!(
        !endless(f64::INFINITY).agrees(&endless(f64::NEG_INFINITY)) && !endless(0.0).agrees(&endless(f64::INFINITY))
    );
    let failure = run(|x| 2.0 * x + 3e-9).unwrap();
    assert_eq!((failure.expected.as_str(), failure.got.as_deref()), ("length = 2", Some("length = 2.000000003")));
    // Nothing is near an infinity but itself.
    let endless = Answer::of("t", f64::INFINITY);
    assert!(
        endless.agrees(&endless) && !Answer::of("t", 5.0).agrees(&endless) && !endless.agrees(&Answer::of("t", 5.0))
    );
    // 1/3 reads the same with six digits, so that all are told.
    assert_eq!(shown(1.0 / 3.0), "0.333333");
    for wild in [f64::NAN, f64::INFINITY, -1e300, 1e-300] {
        let stage = doubling(&[]).stage(move |_| Answer::of("length", wild));
        let checked = stage.run();
        assert!(checked.failure.unwrap().got.unwrap().contains(&shown(wild)));
        check_labels("wild", &checked.picture);
    }
}

/// Whatever a student's function answers, there is a picture.
#[test]
fn wild_answers_have_pictures() {
    use raytree::lessons::{Aabb, Plane, Span, TriangleHit};
    for wild in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e5, 1e-300, 0.0] {
        let v = glam::DVec3::new(wild, 1.0, -wild);
        let span = Span { t_in: wild, t_out: -wild };
        let w = [wild, wild, 1.0];
        let lessons = [
            vectors::answering(wild, v),
            plane::answering(Plane { normal: v, distance: wild }, wild),
            triangle::answering(wild, w, TriangleHit { t: wild, barycentrics: w }),
            aabb::answering(span, wild),
            sphere::answering(w, span, wild, v),
            trace::answering(v),
            shadows::answering(v, wild),
            reflection::answering(v),
            refraction::answering(v),
            camera::answering(wild, v),
            rounding::answering(span, v, if wild > 0.0 { i32::MAX } else { i32::MIN }),
            fast::answering(Aabb { min: v, max: -v }, wild),
            cost::answering(wild),
        ];
        for lesson in lessons {
            for stage in lesson.stages {
                let what = format!("{} answers {wild}", stage.function);
                let checked = stage.run();
                check_labels(&what, &checked.picture);
                checked.picture.to_svg().unwrap_or_else(|unfit| panic!("{what}: {unfit}"));
            }
        }
    }
}
