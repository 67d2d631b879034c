//! Lesson 11, numbers that lie: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{Lesson, Span};

#[path = "../../../lessons/11-numbers/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/11-numbers/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/11-numbers/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

pub(super) fn unsolved() -> Lesson {
    check::lesson(check::Student {
        slab: exercise::slab,
        box_span: exercise::box_span,
        roots: exercise::roots,
        meets_sphere: exercise::meets_sphere,
        leave: exercise::leave,
        side: exercise::side,
        is_hit: exercise::is_hit,
    })
}

fn student() -> check::Student {
    check::Student {
        slab: solution::slab,
        box_span: solution::box_span,
        roots: solution::roots,
        meets_sphere: solution::meets_sphere,
        leave: solution::leave,
        side: solution::side,
        is_hit: solution::is_hit,
    }
}

pub(super) fn solved() -> Lesson {
    check::lesson(student())
}

/// Wrong functions as a student might write them, with the names of their mistakes: mostly those of the lessons before.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    let right = student();
    let with = |id, student| (id, check::lesson(student));
    vec![
        with(
            "zero-divided-min-max",
            check::Student {
                slab: |o, d, low, high| {
                    let inverse = 1.0 / d;
                    let (a, b) = ((low - o) * inverse, (high - o) * inverse);
                    Some(Span { t_in: a.min(b), t_out: a.max(b) })
                },
                ..right
            },
        ),
        with(
            "zero-open",
            check::Student {
                slab: |o, d, low, high| match d == 0.0 {
                    true if o <= low || o >= high => None,
                    _ => solution::slab(if d == 0.0 { 0.5 * (low + high) } else { o }, d, low, high),
                },
                ..right
            },
        ),
        with(
            "flat-min-max",
            check::Student { box_span: |ray, aabb| super::aabb::solution::box_span(ray, aabb), ..right },
        ),
        with("stable-textbook", check::Student { roots: super::sphere::solution::roots, ..right }),
        with(
            "far-textbook",
            check::Student {
                meets_sphere: |ray, sphere| {
                    let [a, b, c] = super::sphere::solution::coefficients(ray, sphere);
                    super::sphere::solution::roots(a, b, c).is_some()
                },
                ..right
            },
        ),
        with("leave-unmoved", check::Student { leave: |ray, t, _, _| ray.at(t), ..right }),
        with("leave-fixed", check::Student { leave: |ray, t, n, d| ray.at(t) + 1e-4 * n.dot(d).signum() * n, ..right }),
        with(
            "leave-one-side",
            check::Student { leave: |ray, t, n, _| ray.at(t) + 1e-14 * (ray.origin.length() + t) * n, ..right },
        ),
        with(
            "side-rounded",
            check::Student {
                side: |ray, p, q| {
                    let (x, y) = (p - ray.origin, q - ray.origin);
                    match x.cross(y).dot(ray.direction) {
                        0.0 => 0,
                        x if x > 0.0 => 1,
                        _ => -1,
                    }
                },
                ..right
            },
        ),
        with(
            "watertight-lecture",
            check::Student {
                is_hit: |ray, triangle| super::triangle::solution::intersect(ray, triangle).is_some(),
                ..right
            },
        ),
        with(
            "watertight-open",
            check::Student {
                is_hit: |ray, triangle| {
                    let [a, b, c] = triangle.vertices;
                    let sides = [solution::side(ray, a, b), solution::side(ray, b, c), solution::side(ray, c, a)];
                    sides.iter().sum::<i32>().abs() == 3
                },
                ..right
            },
        ),
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(span: Span, point: DVec3, sign: i32) -> Lesson {
    SPAN.set(Some(span));
    POINT.set(point);
    SIGN.set(sign);
    check::lesson(check::Student {
        slab: |_, _, _, _| SPAN.get(),
        box_span: |_, _| SPAN.get(),
        roots: |_, _, _| SPAN.get(),
        meets_sphere: |_, _| SIGN.get() > 0,
        leave: |_, _, _, _| POINT.get(),
        side: |_, _, _| SIGN.get(),
        is_hit: |_, _| SIGN.get() > 0,
    })
}

thread_local! {
    static SPAN: Cell<Option<Span>> = const { Cell::new(None) };
    static POINT: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
    static SIGN: Cell<i32> = const { Cell::new(0) };
}
