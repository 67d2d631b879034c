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

course!(slab, box_span, roots, meets_sphere, leave, side, is_hit);

/// Wrong functions as a student might write them, with the names of their mistakes: mostly those of the lessons before.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "zero-divided-min-max": slab = |o, d, low, high| {
            let inverse = 1.0 / d;
            let (a, b) = ((low - o) * inverse, (high - o) * inverse);
            Some(Span { t_in: a.min(b), t_out: a.max(b) })
        },
        "zero-open": slab = |o, d, low, high| {
            if d == 0.0 && (o <= low || o >= high) { None } else { solution::slab(o, d, low, high) }
        },
        "flat-min-max": box_span = super::aabb::solution::box_span,
        "stable-textbook": roots = super::sphere::solution::roots,
        "far-textbook": meets_sphere = |ray, sphere| {
            let [a, b, c] = super::sphere::solution::coefficients(ray, sphere);
            super::sphere::solution::roots(a, b, c).is_some()
        },
        "leave-unmoved": leave = |ray, t, _, _| ray.at(t),
        "leave-fixed": leave = |ray, t, n, d| ray.at(t) + 1e-4 * n.dot(d).signum() * n,
        "leave-fixed-one-side": leave = |ray, t, n, _| ray.at(t) + 1e-4 * n,
        "leave-fixed-along-direction": leave = |ray, t, _, d| ray.at(t) + d * 1e-4,
        "leave-one-side": leave = |ray, t, n, _| ray.at(t) + 1e-14 * (ray.origin.length() + t) * n,
        "side-rounded": side = |ray, p, q| {
            match (p - ray.origin).cross(q - ray.origin).dot(ray.direction) {
                0.0 => 0,
                x if x > 0.0 => 1,
                _ => -1,
            }
        },
        "watertight-lesson-03": is_hit = |ray, t| super::triangle::solution::intersect(ray, t).is_some(),
        "watertight-open": is_hit = |ray, triangle| {
            let [a, b, c] = triangle.vertices;
            let sides = [solution::side(ray, a, b), solution::side(ray, b, c), solution::side(ray, c, a)];
            sides.iter().sum::<i32>().abs() == 3
        },
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
