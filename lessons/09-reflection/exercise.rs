//! Lesson 09: reflection and maxLevel. Read README.md beside this file, write the two functions, and run
//!
//!     cargo run --example lesson-09
#![allow(unused_imports, unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec3;
use raytree::lessons::{Hit, Program, Ray, Rgb};

/// The direction of a ray of direction d after a mirror with the unit normal n, as long as d.
pub fn reflected_direction(d: DVec3, n: DVec3) -> DVec3 {
    todo!()
}

/// What the surface sends back: its own light, and, where it reflects and the level allows it, the weighted light of the
/// reflected ray.
pub fn shade(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { reflected_direction, shade })
}
