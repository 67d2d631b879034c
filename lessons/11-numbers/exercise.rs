//! Lesson 11: numbers that lie. Read README.md beside this file, write the seven functions, and run
//!
//!     cargo run --example lesson-11
#![allow(unused_variables, unused_imports, reason = "until the functions are written")]

mod check;

use glam::DVec3;
use raytree::lessons::{Aabb, Ray, Span, Sphere, Triangle};
use raytree::numbers::{Expansion, Ring, determinant};

/// When one coordinate of a ray, `origin + t * direction`, is between `low` and `high`, both included; `None` where never.
/// `direction` may be 0 and -0: then it is always, from `f64::NEG_INFINITY` to `f64::INFINITY`, or never.
pub fn slab(origin: f64, direction: f64, low: f64, high: f64) -> Option<Span> {
    todo!()
}

/// When a ray is in a box, as in lesson 04; `None` where it misses it or has it behind. One or two components of the
/// direction may be 0.
pub fn box_span(ray: &Ray, aabb: &Aabb) -> Option<Span> {
    todo!()
}

/// Both solutions of a t^2 + b t + c = 0 for a > 0, the smaller as `t_in`, both right to all digits but the last few, even
/// where one is much larger than the other; `None` where there is none.
pub fn roots(a: f64, b: f64, c: f64) -> Option<Span> {
    todo!()
}

/// Whether the line of a ray meets a sphere, wherever on the line; also where it touches it. Right even if the sphere is
/// small and far away.
pub fn meets_sphere(ray: &Ray, sphere: &Sphere) -> bool {
    todo!()
}

/// Where a new ray starts that leaves a surface at `ray.at(t)` in `direction`: beside that point, on the side of the
/// surface that `direction` points to, as far off as rounding makes it necessary. `normal` has length 1 and may point to
/// either side. It is tried with a small card that lies close to the surface: the new ray must see it, so it must not start
/// beyond it.
pub fn leave(ray: &Ray, t: f64, normal: DVec3, direction: DVec3) -> DVec3 {
    todo!()
}

/// On which side of the line from `p` to `q` a ray passes: the sign (1, 0 or -1) of the determinant with the rows
/// `ray.direction`, `p - ray.origin` and `q - ray.origin`, exactly.
pub fn side(ray: &Ray, p: DVec3, q: DVec3) -> i32 {
    todo!()
}

/// Whether a ray hits a triangle that lies ahead of it, on an edge or a corner too; not where the ray lies in its plane.
pub fn is_hit(ray: &Ray, triangle: &Triangle) -> bool {
    todo!()
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { slab, box_span, roots, meets_sphere, leave, side, is_hit })
}
