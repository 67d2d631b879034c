//! Lesson 10: refraction and total internal reflection. Read README.md beside this file, write the two functions, and run
//!
//!     cargo run --example lesson-10
#![allow(unused_imports, unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec3;
use raytree::lessons::{Hit, Program, Ray, Rgb};

/// The direction of a ray of direction d after it went through a surface with the unit normal n, from index of refraction n1
/// to n2, as long as d. `n` is on the side of the ray: d . n <= 0. `None` where all light is reflected.
pub fn refracted_direction(d: DVec3, n: DVec3, n1: f64, n2: f64) -> Option<DVec3> {
    todo!()
}

/// What the surface sends back: its own light, and, where the level allows it, the weighted light of the reflected and of the
/// refracted ray. At total reflection the reflected ray takes the weight of the refracted one as well.
pub fn shade(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { refracted_direction, shade })
}
