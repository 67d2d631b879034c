//! Lesson 03: the triangle. Read README.md beside this file, write the four functions, and run
//!
//!     cargo run --example lesson-03
#![allow(unused_variables, reason = "until the functions are written")]
#![allow(non_snake_case, reason = "D is the letter of the page")]

mod check;

use glam::DVec3;
use raytree::lessons::{Ray, Triangle, TriangleHit};

/// The t where the ray meets the plane of the triangle, `None` where it does not; `triangle.vertices` are v0, v1, v2.
pub fn plane_t(ray: &Ray, triangle: &Triangle) -> Option<f64> {
    todo!()
}

/// The weights [a, b, c] of v0, v1, v2 for a point p of the triangle's plane: p = a v0 + b v1 + c v2 with c = 1 - a - b.
pub fn weights(p: DVec3, triangle: &Triangle) -> [f64; 3] {
    todo!()
}

/// Whether the point with the weights a, b and 1 - a - b lies in the triangle. The border belongs to it.
pub fn is_inside(a: f64, b: f64) -> bool {
    todo!()
}

/// Where the ray meets the triangle: `TriangleHit { t, barycentrics: [a, b, c] }`, `None` where it does not.
pub fn intersect(ray: &Ray, triangle: &Triangle) -> Option<TriangleHit> {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { plane_t, weights, is_inside, intersect })
}
