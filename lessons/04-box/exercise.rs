//! Lesson 04: the box. Read README.md beside this file, write the four functions, and run
//!
//!     cargo run --example lesson-04
#![allow(unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec2;
use raytree::lessons::{Aabb, Ray, Span};

/// When one coordinate of a ray, `origin + t * direction`, is between `low` and `high`: from `t_in`, the smaller t, to `t_out`.
/// `direction` is not 0.
pub fn slab(origin: f64, direction: f64, low: f64, high: f64) -> Span {
    todo!()
}

/// When a ray in the plane is in the rectangle from `min` to `max`; `None` where it misses it or has it behind.
pub fn rectangle(origin: DVec2, direction: DVec2, min: DVec2, max: DVec2) -> Option<Span> {
    todo!()
}

/// When a ray in space is in the box from `aabb.min` to `aabb.max`; `None` where it misses it or has it behind.
pub fn box_span(ray: &Ray, aabb: &Aabb) -> Option<Span> {
    todo!()
}

/// The t of the first hit: where the ray comes in, or, where it starts inside, where it goes out.
pub fn intersect(ray: &Ray, aabb: &Aabb) -> Option<f64> {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { slab, rectangle, box_span, intersect })
}
