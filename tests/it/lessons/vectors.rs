//! Lesson 01, vectors: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::Lesson;

#[path = "../../../lessons/01-vectors/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/01-vectors/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/01-vectors/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(dot, length, normalize, project, cross);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "dot-without-z": dot = |a, b| a.x * b.x + a.y * b.y,
        "dot-of-lengths": dot = |a, b| a.length() * b.length(),
        "length-squared": length = |a| solution::dot(a, a),
        "length-by-sum": length = |a| a.x.abs() + a.y.abs() + a.z.abs(),
        "not-normalized": normalize = |a| a,
        "normalized-by-square": normalize = |a| a / a.dot(a),
        "projection-undivided": project = |a, b| b * a.dot(b),
        "projection-divided-once": project = |a, b| b * (a.dot(b) / b.length()),
        "projection-swapped": project = |a, b| solution::project(b, a),
        "cross-reversed": cross = |a, b| -a.cross(b),
        "cross-middle-sign": cross = |a, b| DVec3::new(a.y * b.z - a.z * b.y, a.x * b.z - a.z * b.x, a.x * b.y - a.y * b.x),
        "cross-by-components": cross = |a, b| a * b,
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(x: f64, v: DVec3) -> Lesson {
    X.set(x);
    V.set(v);
    check::lesson(check::Student {
        dot: |_, _| X.get(),
        length: |_| X.get(),
        normalize: |_| V.get(),
        project: |_, _| V.get(),
        cross: |_, _| V.get(),
    })
}

thread_local! {
    static X: Cell<f64> = const { Cell::new(0.0) };
    static V: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
}
