//! Lesson 04: the box. A solution.

mod check;

use glam::DVec2;
use raytree::lessons::{Aabb, Ray, Span};

/// When one coordinate of a ray, `origin + t * direction`, is between `low` and `high`: from `t_in`, the smaller t, to `t_out`.
/// `direction` is not 0.
pub fn slab(origin: f64, direction: f64, low: f64, high: f64) -> Span {
    let t_low = (low - origin) / direction;
    let t_high = (high - origin) / direction;
    Span { t_in: t_low.min(t_high), t_out: t_low.max(t_high) }
}

/// When a ray in the plane is in the rectangle from `min` to `max`; `None` where it misses it or has it behind.
pub fn rectangle(origin: DVec2, direction: DVec2, min: DVec2, max: DVec2) -> Option<Span> {
    let x = slab(origin.x, direction.x, min.x, max.x);
    let y = slab(origin.y, direction.y, min.y, max.y);
    let t_in = x.t_in.max(y.t_in);
    let t_out = x.t_out.min(y.t_out);
    if t_in > t_out || t_out < 0.0 { None } else { Some(Span { t_in, t_out }) }
}

/// When a ray in space is in the box from `aabb.min` to `aabb.max`; `None` where it misses it or has it behind.
pub fn box_span(ray: &Ray, aabb: &Aabb) -> Option<Span> {
    let (o, d) = (ray.origin, ray.direction);
    let x = slab(o.x, d.x, aabb.min.x, aabb.max.x);
    let y = slab(o.y, d.y, aabb.min.y, aabb.max.y);
    let z = slab(o.z, d.z, aabb.min.z, aabb.max.z);
    let t_in = x.t_in.max(y.t_in).max(z.t_in);
    let t_out = x.t_out.min(y.t_out).min(z.t_out);
    if t_in > t_out || t_out < 0.0 { None } else { Some(Span { t_in, t_out }) }
}

/// The t of the first hit: where the ray comes in, or, where it starts inside, where it goes out.
pub fn intersect(ray: &Ray, aabb: &Aabb) -> Option<f64> {
    let span = box_span(ray, aabb)?;
    if span.t_in >= 0.0 { Some(span.t_in) } else { Some(span.t_out) }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { slab, rectangle, box_span, intersect })
}
