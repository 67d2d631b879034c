//! Lesson 05: the sphere. Read README.md beside this file, write the four functions, and run
//!
//!     cargo run --example lesson-05
#![allow(unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec3;
use raytree::lessons::{Ray, Span, Sphere};

/// The a, b and c of the quadratic equation a t^2 + b t + c = 0 for the t where the ray's line meets the sphere.
pub fn coefficients(ray: &Ray, sphere: &Sphere) -> [f64; 3] {
    todo!()
}

/// Both solutions of a t^2 + b t + c = 0 for a > 0, the smaller as `t_in`; `None` where there is none. A double one counts twice.
pub fn roots(a: f64, b: f64, c: f64) -> Option<Span> {
    todo!()
}

/// The t of the first hit: where the ray comes in, or, where it starts inside, where it goes out.
pub fn intersect(ray: &Ray, sphere: &Sphere) -> Option<f64> {
    todo!()
}

/// The unit normal of the sphere where the ray hits it at `t`, on the side that the ray comes from.
pub fn normal(ray: &Ray, sphere: &Sphere, t: f64) -> DVec3 {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { coefficients, roots, intersect, normal })
}
