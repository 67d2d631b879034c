//! Lesson 13, what accuracy costs: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use raytree::lessons::{Lesson, Reading};

#[path = "../../../lessons/13-cost/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/13-cost/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/13-cost/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(speedup, break_even, beats, pareto, choose, reading);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "speedup-inverted": speedup = |before, after| after / before,
        "speedup-difference": speedup = |before, after| before - after,
        "even-unchecked": break_even = |build, slow, fast| Some(build / (slow - fast)),
        "even-without-fast": break_even = |build, slow, fast| if fast < slow { Some(build / slow) } else { None },
        "beats-equals": beats = |a, b| a.cost <= b.cost && a.error <= b.error,
        "beats-in-one": beats = |a, b| a.cost < b.cost || a.error < b.error,
        "pareto-empty": pareto = |choices| {
            let beats = |a: &raytree::lessons::Choice, b: &raytree::lessons::Choice| a.cost <= b.cost && a.error <= b.error;
            (0..choices.len()).filter(|i| choices.iter().all(|other| !beats(other, &choices[*i]))).collect()
        },
        "pareto-strict": pareto = |choices| {
            let mut front = Vec::new();
            for i in 0..choices.len() {
                let better = |j: usize| choices[j].cost < choices[i].cost && choices[j].error < choices[i].error;
                if !(0..choices.len()).any(better) {
                    front.push(i);
                }
            }
            front
        },
        "choose-cheapest": choose = |choices, _| {
            (0..choices.len()).reduce(|a, b| if choices[b].cost < choices[a].cost { b } else { a })
        },
        "choose-first": choose = |choices, budget| choices.iter().position(|choice| choice.error <= budget),
        "choose-below": choose = |choices, budget| {
            let enough = (0..choices.len()).filter(|i| choices[*i].error < budget);
            enough.reduce(|a, b| if choices[b].cost < choices[a].cost { b } else { a })
        },
        "reading-false-hits": reading = || Reading {
            lecture_wrong: 341,
            lecture_over_watertight: 341.0 / 278.0,
            ..solution::reading()
        },
        "reading-upside-down": reading = || Reading {
            lecture_over_watertight: 563.0 / 685.0,
            ..solution::reading()
        },
        "reading-percent": reading = || Reading { filter_share: 94.65, ..solution::reading() },
    ]
}

/// What the lesson asks to be read is what the command writes, in the rows and columns that it names.
#[test]
fn the_table_says_what_the_solution_has_read() {
    use raytree::accuracy::export;
    use raytree::accuracy::report::{Plan, Progress, Report};
    struct Silent;
    impl Progress for Silent {
        fn begin(&self, _: &str, _: u64) {}
        fn step(&self, _: u64) {}
    }
    // The counts hang on the seed and on the number of cases alone: the rest is made as small as can be.
    let small = Plan { leaks: 2, spawned: 1, chains: 1, sample: 1, timed: 1, rounds: 1, ..Plan::QUICK };
    let report = Report::measure(small, None, &Silent, &false.into()).unwrap().unwrap();
    let table = export::tables(&report).into_iter().find(|table| table.file == "verdicts").unwrap();
    let column = |name: &str| table.columns.iter().position(|c| c == name).unwrap();
    let number = |set: &str, form: &str, name: &str| -> f64 {
        let is_it = |row: &&Vec<String>| row[..3] == ["triangle", set, "f32"] && row[column("form")] == form;
        table.rows.iter().find(is_it).unwrap()[column(name)].parse().unwrap()
    };
    let wrong = |set: &str, form: &str| number(set, form, "false_hits") + number(set, form, "false_misses");
    let read = solution::reading();
    assert_eq!(read.lecture_wrong as f64, wrong("aimed at edges", "lecture"));
    let ratio = wrong("aimed at edges", "lecture") / wrong("aimed at edges", "watertight");
    assert_eq!(read.lecture_over_watertight, ratio);
    assert_eq!(read.watertight_random as f64, wrong("random", "watertight"));
    let sets = ["random", "aimed at edges", "aimed at vertices"];
    assert_eq!(read.certified_wrong as f64, sets.iter().map(|set| wrong(set, "certified")).sum::<f64>());
    let vertices = |name: &str| number("aimed at vertices", "certified", name);
    assert_eq!(read.filter_share, vertices("filter") / vertices("cases"));
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(x: f64) -> Lesson {
    X.set(x);
    check::lesson(check::Student {
        speedup: |_, _| X.get(),
        break_even: |_, _, _| Some(X.get()),
        beats: |_, _| X.get() > 0.0,
        pareto: |choices| (0..choices.len()).filter(|_| X.get() > 0.0).collect(),
        choose: |_, _| Some(X.get().max(0.0) as usize),
        reading: || Reading {
            lecture_wrong: 0,
            lecture_over_watertight: X.get(),
            watertight_random: 1,
            certified_wrong: 1,
            filter_share: -X.get(),
        },
    })
}

thread_local! {
    static X: Cell<f64> = const { Cell::new(0.0) };
}
