//! Lesson 13: what accuracy costs. A solution.

mod check;

use raytree::lessons::{Choice, Reading};

/// How many times as fast something is that took `before` and now takes `after`.
pub fn speedup(before: f64, after: f64) -> f64 {
    before / after
}

/// The number of rays from which on it pays to build something first. Building costs `build`, a ray costs `slow` without it
/// and `fast` with it. `None` where it never pays.
pub fn break_even(build: f64, slow: f64, fast: f64) -> Option<f64> {
    if fast >= slow {
        return None;
    }
    Some(build / (slow - fast))
}

/// Whether `a` beats `b`: neither its cost nor its error is larger, and one of them is smaller.
pub fn beats(a: &Choice, b: &Choice) -> bool {
    a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error)
}

/// The Pareto front: the numbers, from 0, of all choices that no other beats.
pub fn pareto(choices: &[Choice]) -> Vec<usize> {
    let mut front = Vec::new();
    for (i, choice) in choices.iter().enumerate() {
        if !choices.iter().any(|other| beats(other, choice)) {
            front.push(i);
        }
    }
    front
}

/// The number of the cheapest choice whose error is at most `budget`; `None` where there is none.
pub fn choose(choices: &[Choice], budget: f64) -> Option<usize> {
    let mut best: Option<usize> = None;
    for (i, choice) in choices.iter().enumerate() {
        if choice.error <= budget && best.is_none_or(|b| choice.cost < choices[b].cost) {
            best = Some(i);
        }
    }
    best
}

/// What is read off `report/verdicts.csv`, the triangles in f32.
pub fn reading() -> Reading {
    Reading {
        lecture_wrong: 685,
        lecture_over_watertight: 685.0 / 563.0,
        watertight_random: 0,
        certified_wrong: 0,
        filter_share: 1893.0 / 2000.0,
    }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { speedup, break_even, beats, pareto, choose, reading })
}
