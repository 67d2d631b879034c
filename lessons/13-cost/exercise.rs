//! Lesson 13: what accuracy costs. Read README.md beside this file, write the six functions, and run
//!
//!     cargo run --example lesson-13
#![allow(unused_variables, reason = "until the functions are written")]

mod check;

use raytree::lessons::{Choice, Reading};

/// How many times as fast something is that took `before` and now takes `after`.
pub fn speedup(before: f64, after: f64) -> f64 {
    todo!()
}

/// The number of rays from which on it pays to build something first. Building costs `build`, a ray costs `slow` without it
/// and `fast` with it. `None` where it never pays.
pub fn break_even(build: f64, slow: f64, fast: f64) -> Option<f64> {
    todo!()
}

/// Whether `a` beats `b`: neither its cost nor its error is larger, and one of them is smaller.
pub fn beats(a: &Choice, b: &Choice) -> bool {
    todo!()
}

/// The Pareto front: the numbers, from 0, of all choices that no other beats.
pub fn pareto(choices: &[Choice]) -> Vec<usize> {
    todo!()
}

/// The number of the cheapest choice whose error is at most `budget`; `None` where there is none.
pub fn choose(choices: &[Choice], budget: f64) -> Option<usize> {
    todo!()
}

/// What is read off `report/verdicts.csv`, the triangles in f32. README.md says what the five numbers are. Where one is a ratio,
/// write the division: `3.0 / 4.0`.
pub fn reading() -> Reading {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { speedup, break_even, beats, pareto, choose, reading })
}
