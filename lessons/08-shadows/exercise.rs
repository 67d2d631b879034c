//! Lesson 08: shadows. Read README.md beside this file, write the two functions, and run
//!
//!     cargo run --example lesson-08
#![allow(unused_imports, unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec3;
use raytree::lessons::{Light, LightKind, Program, Ray, ShadowRay};

/// The ray from the point to the light, its direction of length 1, and as `t_max` the distance to the light; that of a
/// directional light is `f64::INFINITY`.
pub fn shadow_ray(point: DVec3, light: &Light) -> ShadowRay {
    todo!()
}

/// Whether any object is hit before the light, at a t below `t_max`.
pub fn is_blocked(program: &Program, shadow_ray: &ShadowRay) -> bool {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { shadow_ray, is_blocked })
}
