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

pub(super) fn unsolved() -> Lesson {
    check::lesson(check::Student {
        dot: exercise::dot,
        length: exercise::length,
        normalize: exercise::normalize,
        project: exercise::project,
        cross: exercise::cross,
    })
}

fn student() -> check::Student {
    check::Student {
        dot: solution::dot,
        length: solution::length,
        normalize: solution::normalize,
        project: solution::project,
        cross: solution::cross,
    }
}

pub(super) fn solved() -> Lesson {
    check::lesson(student())
}

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    let right = student();
    let with = |id, student| (id, check::lesson(student));
    vec![
        with("dot-without-z", check::Student { dot: |a, b| a.x * b.x + a.y * b.y, ..right }),
        with("dot-of-lengths", check::Student { dot: |a, b| a.length() * b.length(), ..right }),
        with("length-squared", check::Student { length: |a| solution::dot(a, a), ..right }),
        with("length-by-sum", check::Student { length: |a| a.x.abs() + a.y.abs() + a.z.abs(), ..right }),
        with("not-normalized", check::Student { normalize: |a| a, ..right }),
        with("normalized-by-square", check::Student { normalize: |a| a / a.dot(a), ..right }),
        with("projection-undivided", check::Student { project: |a, b| b * a.dot(b), ..right }),
        with("projection-divided-once", check::Student { project: |a, b| b * (a.dot(b) / b.length()), ..right }),
        with("projection-swapped", check::Student { project: |a, b| solution::project(b, a), ..right }),
        with("cross-reversed", check::Student { cross: |a, b| -a.cross(b), ..right }),
        with(
            "cross-middle-sign",
            check::Student {
                cross: |a, b| DVec3::new(a.y * b.z - a.z * b.y, a.x * b.z - a.z * b.x, a.x * b.y - a.y * b.x),
                ..right
            },
        ),
        with("cross-by-components", check::Student { cross: |a, b| a * b, ..right }),
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
