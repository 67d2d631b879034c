//! Lesson 02: the plane in Hesse form. Read README.md beside this file, write the three functions, and run
//!
//!     cargo run --example lesson-02
#![allow(unused_variables, reason = "until the functions are written")]
#![allow(non_snake_case, reason = "D is the letter of the page")]

mod check;

use glam::DVec3;
use raytree::lessons::{Plane, Ray};

/// The plane through `point` with `normal`, in Hesse form: `Plane { normal, distance }`, where `normal` has length 1 and
/// `distance` is D. The normal given may have any length but 0.
pub fn plane_from(point: DVec3, normal: DVec3) -> Plane {
    todo!()
}

/// How far `point` is from the plane: positive on the side to which `plane.normal` points, negative on the other.
pub fn signed_distance(point: DVec3, plane: &Plane) -> f64 {
    todo!()
}

/// The t where the ray meets the plane, `None` where it does not. The ray is `ray.origin + t * ray.direction`, `t >= 0`.
pub fn intersect(ray: &Ray, plane: &Plane) -> Option<f64> {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { plane_from, signed_distance, intersect })
}
