//! Lesson 04, the box: the exercise, the solution, and wrong solutions.

use std::cell::Cell;

use raytree::lessons::{Lesson, Span};

#[path = "../../../lessons/04-box/check.rs"]
#[allow(dead_code, reason = "here nothing runs the lesson as a program")]
mod check;
#[path = "../../../lessons/04-box/exercise.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
mod exercise;
#[path = "../../../lessons/04-box/solution.rs"]
#[allow(dead_code, unreachable_pub, reason = "a program of its own")]
pub(super) mod solution;

course!(slab, rectangle, box_span, intersect);

/// Wrong functions as a student might write them, with the names of their mistakes.
pub(super) fn wrong() -> Vec<(&'static str, Lesson)> {
    planted![
        "slab-unsorted": slab = |o, d, low, high| Span { t_in: (low - o) / d, t_out: (high - o) / d },
        "slab-swapped": slab = |o, d, low, high| {
            let span = solution::slab(o, d, low, high);
            Span { t_in: span.t_out, t_out: span.t_in }
        },
        "rectangle-min-max-swapped": rectangle = |o, d, min, max| {
            let (x, y) = (solution::slab(o.x, d.x, min.x, max.x), solution::slab(o.y, d.y, min.y, max.y));
            let (t_in, t_out) = (x.t_in.min(y.t_in), x.t_out.max(y.t_out));
            if t_in > t_out || t_out < 0.0 { None } else { Some(Span { t_in, t_out }) }
        },
        "rectangle-behind": rectangle = |o, d, min, max| {
            let (x, y) = (solution::slab(o.x, d.x, min.x, max.x), solution::slab(o.y, d.y, min.y, max.y));
            let (t_in, t_out) = (x.t_in.max(y.t_in), x.t_out.min(y.t_out));
            if t_in > t_out { None } else { Some(Span { t_in, t_out }) }
        },
        "box-without-z": box_span = |ray, aabb| {
            let flat = |v: glam::DVec3| v.truncate();
            solution::rectangle(flat(ray.origin), flat(ray.direction), flat(aabb.min), flat(aabb.max))
        },
        "box-inside": box_span = |ray, aabb| solution::box_span(ray, aabb).filter(|s| s.t_in >= 0.0),
        "box-entry-inside": intersect = |ray, aabb| solution::box_span(ray, aabb).map(|span| span.t_in),
        "box-inside-none": intersect = |ray, aabb| {
            let t = solution::box_span(ray, aabb)?.t_in;
            if t < 0.0 { None } else { Some(t) }
        },
    ]
}

/// A lesson whose functions always answer the same. A function pointer holds nothing: the answers go by way of a cell.
pub(super) fn answering(span: Span, t: f64) -> Lesson {
    SPAN.set(Some(span));
    T.set(t);
    check::lesson(check::Student {
        slab: |_, _, _, _| SPAN.get().unwrap(),
        rectangle: |_, _, _, _| SPAN.get(),
        box_span: |_, _| SPAN.get(),
        intersect: |_, _| Some(T.get()),
    })
}

thread_local! {
    static SPAN: Cell<Option<Span>> = const { Cell::new(None) };
    static T: Cell<f64> = const { Cell::new(0.0) };
}
