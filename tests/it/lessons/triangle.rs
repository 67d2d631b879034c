//! Lesson 03, the triangle: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use raytree::lessons::{Lesson, TriangleHit};

#[path = "../../../lessons/03-triangle/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/03-triangle/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/03-triangle/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(plane_t, weights, is_inside, intersect);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "normal-of-corners": plane_t = |ray, triangle| {
            let [v0, v1, v2] = triangle.vertices;
            let n = v1.cross(v2);
            let t = (n.dot(v0) - n.dot(ray.origin)) / n.dot(ray.direction);
            if t >= 0.0 { Some(t) } else { None }
        },
        "barycentrics-a-b-exchanged": weights = |p, triangle| {
            let [a, b, c] = solution::weights(p, triangle);
            [b, a, c]
        },
        // Moller and Trumbore's u and v first.
        "barycentrics-permuted-back": weights = |p, triangle| {
            let [v0, v1, v2] = triangle.vertices;
            let (e1, e2, s) = (v1 - v0, v2 - v0, p - v0);
            let n = e1.cross(e2);
            let (u, v) = (s.cross(e2).dot(n) / n.dot(n), e1.cross(s).dot(n) / n.dot(n));
            [u, v, 1.0 - u - v]
        },
        "barycentrics-unsigned-rest": weights = |p, triangle| {
            let [v0, v1, v2] = triangle.vertices;
            let whole = (v1 - v0).cross(v2 - v0).length() / 2.0;
            let a = (v1 - p).cross(v2 - p).length() / 2.0 / whole;
            let b = (v2 - p).cross(v0 - p).length() / 2.0 / whole;
            [a, b, 1.0 - a - b]
        },
        "b-above-one": is_inside = |a, b| !(b > 1.0 || a < 0.0 || b < 0.0),
        "sum-forgotten": is_inside = |a, b| !(a < 0.0 || b < 0.0),
        "border-left-out": is_inside = |a, b| a > 0.0 && b > 0.0 && 1.0 - a - b > 0.0,
        "triangle-no-inside-test": intersect = |ray, triangle| {
            let t = solution::plane_t(ray, triangle)?;
            Some(TriangleHit { t, barycentrics: solution::weights(ray.at(t), triangle) })
        },
        "triangle-culled": intersect = |ray, triangle| {
            let [v0, v1, v2] = triangle.vertices;
            if (v1 - v0).cross(v2 - v0).dot(ray.direction) > 0.0 {
                return None;
            }
            solution::intersect(ray, triangle)
        },
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(t: f64, weights: [f64; 3], hit: TriangleHit) -> Lesson {
    T.set(t);
    WEIGHTS.set(weights);
    HIT.set(Some(hit));
    check::lesson(check::Student {
        plane_t: |_, _| Some(T.get()),
        weights: |_, _| WEIGHTS.get(),
        is_inside: |a, b| (a < b) ^ T.get().is_nan(),
        intersect: |_, _| HIT.get(),
    })
}

thread_local! {
    static T: Cell<f64> = const { Cell::new(0.0) };
    static WEIGHTS: Cell<[f64; 3]> = const { Cell::new([0.0; 3]) };
    static HIT: Cell<Option<TriangleHit>> = const { Cell::new(None) };
}
