//! Lesson 02, the plane: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use raytree::lessons::{Lesson, Plane, Ray};

#[path = "../../../lessons/02-plane/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/02-plane/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/02-plane/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(plane_from, signed_distance, intersect);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "normal-not-unit": plane_from = |p, n| Plane { normal: n, distance: n.dot(p) },
        "plane-d-sign": plane_from = |p, n| Plane { normal: n / n.length(), distance: -(n / n.length()).dot(p) },
        "distance-plus-d": signed_distance = |p, plane| plane.normal.dot(p) + plane.distance,
        "distance-unsigned": signed_distance = |p, plane| solution::signed_distance(p, plane).abs(),
        "plane-t-sign": intersect = |ray, plane| {
            let t = (ray.origin.dot(plane.normal) - plane.distance) / ray.direction.dot(plane.normal);
            if t < 0.0 { None } else { Some(t) }
        },
        "plane-negative-t": intersect = |ray, plane| {
            let below = ray.direction.dot(plane.normal);
            if below == 0.0 {
                return None;
            }
            Some((plane.distance - ray.origin.dot(plane.normal)) / below)
        },
        "plane-parallel": intersect = |ray, plane| {
            let t = -solution::signed_distance(ray.origin, plane) / ray.direction.dot(plane.normal);
            if t >= 0.0 { Some(t) } else { None }
        },
        "plane-t-in-lengths": intersect = |ray, plane| {
            solution::intersect(&Ray { direction: ray.direction.normalize(), ..*ray }, plane)
        },
        "ray-without-start": intersect = |ray, plane| solution::intersect(ray, plane).filter(|t| *t > 0.0),
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(plane: Plane, x: f64) -> Lesson {
    PLANE.set(Some(plane));
    X.set(x);
    check::lesson(check::Student {
        plane_from: |_, _| PLANE.get().unwrap(),
        signed_distance: |_, _| X.get(),
        intersect: |_, _| Some(X.get()),
    })
}

thread_local! {
    static PLANE: Cell<Option<Plane>> = const { Cell::new(None) };
    static X: Cell<f64> = const { Cell::new(0.0) };
}
