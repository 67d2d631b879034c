//! Lesson 05, the sphere: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use glam::DVec3;
use raytree::lessons::{Lesson, Span};

#[path = "../../../lessons/05-sphere/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/05-sphere/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/05-sphere/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(coefficients, roots, intersect, normal);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "sphere-b-sign": coefficients = |ray, sphere| {
            let f = sphere.center - ray.origin;
            [ray.direction.dot(ray.direction), 2.0 * f.dot(ray.direction), f.dot(f) - sphere.radius.powi(2)]
        },
        "sphere-direction-unit": coefficients = |ray, sphere| {
            let f = ray.origin - sphere.center;
            [1.0, 2.0 * ray.direction.dot(f), f.length_squared() - sphere.radius * sphere.radius]
        },
        "quadratic-times-a": roots = |a, b, c| {
            let disc = b * b - 4.0 * a * c;
            if disc < 0.0 {
                return None;
            }
            Some(Span { t_in: (-b - disc.sqrt()) / 2.0 * a, t_out: (-b + disc.sqrt()) / 2.0 * a })
        },
        "quadratic-first-times-a": roots = |a, b, c| {
            let t_out = solution::roots(a, b, c)?.t_out;
            Some(Span { t_in: (-b - (b * b - 4.0 * a * c).sqrt()) / 2.0 * a, t_out })
        },
        "quadratic-second-times-a": roots = |a, b, c| {
            let t_in = solution::roots(a, b, c)?.t_in;
            Some(Span { t_in, t_out: (-b + (b * b - 4.0 * a * c).sqrt()) / 2.0 * a })
        },
        "quadratic-unchecked": roots = |a, b, c| {
            let root = (b * b - 4.0 * a * c).sqrt();
            Some(Span { t_in: (-b - root) / (2.0 * a), t_out: (-b + root) / (2.0 * a) })
        },
        "sphere-entry-inside": intersect = |ray, sphere| {
            let [a, b, c] = solution::coefficients(ray, sphere);
            let span = solution::roots(a, b, c)?;
            if span.t_out < 0.0 { None } else { Some(span.t_in) }
        },
        "sphere-negative-t": intersect = |ray, sphere| {
            let [a, b, c] = solution::coefficients(ray, sphere);
            solution::roots(a, b, c).map(|span| span.t_in)
        },
        "normal-not-flipped": normal = |ray, sphere, t| (ray.at(t) - sphere.center).normalize(),
        "normal-length-of-radius": normal = |ray, sphere, t| {
            let n = ray.at(t) - sphere.center;
            if n.dot(ray.direction) > 0.0 { -n } else { n }
        },
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(coefficients: [f64; 3], span: Span, t: f64, n: DVec3) -> Lesson {
    COEFFICIENTS.set(coefficients);
    SPAN.set(Some(span));
    T.set(t);
    N.set(n);
    check::lesson(check::Student {
        coefficients: |_, _| COEFFICIENTS.get(),
        roots: |_, _, _| SPAN.get(),
        intersect: |_, _| Some(T.get()),
        normal: |_, _, _| N.get(),
    })
}

thread_local! {
    static COEFFICIENTS: Cell<[f64; 3]> = const { Cell::new([0.0; 3]) };
    static SPAN: Cell<Option<Span>> = const { Cell::new(None) };
    static T: Cell<f64> = const { Cell::new(0.0) };
    static N: Cell<DVec3> = const { Cell::new(DVec3::ZERO) };
}
