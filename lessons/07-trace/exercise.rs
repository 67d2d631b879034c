//! Lesson 07: Trace, Intersect and direct light. Read README.md beside this file, write the six functions, and run
//!
//!     cargo run --example lesson-07
#![allow(unused_imports, unused_variables, reason = "until the functions are written")]

mod check;

use glam::DVec3;
use raytree::lessons::{DirectLight, Hit, Light, LightKind, Material, Program, Ray, Rgb};

/// The nearest of the hits of all objects; `None` where the ray meets none.
pub fn intersect(program: &Program, ray: &Ray) -> Option<Hit> {
    todo!()
}

/// What the ray brings back: what `program.shade` makes of the nearest hit, or the background.
pub fn trace(program: &Program, level: u32, ray: &Ray) -> Rgb {
    todo!()
}

/// The direction from the point to the light, of length 1.
pub fn to_light(point: DVec3, light: &Light) -> DVec3 {
    todo!()
}

/// Lambert's term: k_d times the colour of the surface times max(0, n . l) times the colour of the light.
pub fn diffuse(material: &Material, n: DVec3, l: DVec3, light: Rgb) -> Rgb {
    todo!()
}

/// Phong's highlight: k_s times max(0, r . v)^shininess times the colour of the light. `d` is the direction of the ray.
pub fn specular(material: &Material, n: DVec3, l: DVec3, d: DVec3, light: Rgb) -> Rgb {
    todo!()
}

/// Both terms of one light; both 0 where the surface faces away from the light, and where `program.is_lit` says no.
pub fn direct_light(program: &Program, ray: &Ray, hit: &Hit, light: &Light) -> DirectLight {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { intersect, trace, to_light, diffuse, specular, direct_light })
}
