//! Lesson 11: numbers that lie. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Aabb, Ray, Span, Sphere, Triangle};
use raytree::numbers::{Expansion, Ring, determinant};

/// When one coordinate of a ray, `origin + t * direction`, is between `low` and `high`, both included; `None` where never.
/// `direction` may be 0 and -0: then it is always, from `f64::NEG_INFINITY` to `f64::INFINITY`, or never.
pub fn slab(origin: f64, direction: f64, low: f64, high: f64) -> Option<Span> {
    if direction == 0.0 {
        let is_within = low <= origin && origin <= high;
        return is_within.then_some(Span { t_in: f64::NEG_INFINITY, t_out: f64::INFINITY });
    }
    let t_low = (low - origin) / direction;
    let t_high = (high - origin) / direction;
    Some(Span { t_in: t_low.min(t_high), t_out: t_low.max(t_high) })
}

/// When a ray is in a box, as in lesson 04; `None` where it misses it or has it behind. One or two components of the
/// direction may be 0.
pub fn box_span(ray: &Ray, aabb: &Aabb) -> Option<Span> {
    let (o, d) = (ray.origin, ray.direction);
    let x = slab(o.x, d.x, aabb.min.x, aabb.max.x)?;
    let y = slab(o.y, d.y, aabb.min.y, aabb.max.y)?;
    let z = slab(o.z, d.z, aabb.min.z, aabb.max.z)?;
    let t_in = x.t_in.max(y.t_in).max(z.t_in);
    let t_out = x.t_out.min(y.t_out).min(z.t_out);
    if t_in > t_out || t_out < 0.0 { None } else { Some(Span { t_in, t_out }) }
}

/// Both solutions of a t^2 + b t + c = 0 for a > 0, the smaller as `t_in`, both right to all digits but the last few, even
/// where one is much larger than the other; `None` where there is none.
pub fn roots(a: f64, b: f64, c: f64) -> Option<Span> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    let q = if b < 0.0 { -(b - root) / 2.0 } else { -(b + root) / 2.0 };
    if q == 0.0 {
        return Some(Span { t_in: 0.0, t_out: 0.0 });
    }
    let (first, second) = (q / a, c / q);
    Some(Span { t_in: first.min(second), t_out: first.max(second) })
}

/// Whether the line of a ray meets a sphere, wherever on the line; also where it touches it. Right even if the sphere is
/// small and far away.
pub fn meets_sphere(ray: &Ray, sphere: &Sphere) -> bool {
    let f = ray.origin - sphere.center;
    let across = f.cross(ray.direction);
    let discriminant = sphere.radius * sphere.radius * ray.direction.dot(ray.direction) - across.dot(across);
    discriminant >= 0.0
}

/// Where a new ray starts that leaves a surface at `ray.at(t)` in `direction`: beside that point, on the side of the
/// surface that `direction` points to, as far off as rounding makes it necessary. `normal` has length 1 and may point to
/// either side. It is tried with a small card that lies close to the surface: the new ray must see it, so it must not start
/// beyond it.
pub fn leave(ray: &Ray, t: f64, normal: DVec3, direction: DVec3) -> DVec3 {
    let size = ray.origin.length() + t * ray.direction.length();
    let distance = 16.0 * f64::EPSILON * size;
    let outward = if normal.dot(direction) < 0.0 { -normal } else { normal };
    ray.at(t) + distance * outward
}

/// On which side of the line from `p` to `q` a ray passes: the sign (1, 0 or -1) of the determinant with the rows
/// `ray.direction`, `p - ray.origin` and `q - ray.origin`, exactly.
pub fn side(ray: &Ray, p: DVec3, q: DVec3) -> i32 {
    let d = ray.direction.to_array().map(Expansion::number);
    let to = |v: DVec3| [0, 1, 2].map(|k| Expansion::difference(v[k], ray.origin[k]));
    determinant(&d, &to(p), &to(q)).sign()
}

/// Whether a ray hits a triangle that lies ahead of it, on an edge or a corner too; not where the ray lies in its plane.
pub fn is_hit(ray: &Ray, triangle: &Triangle) -> bool {
    let [v0, v1, v2] = triangle.vertices;
    let sides = [side(ray, v0, v1), side(ray, v1, v2), side(ray, v2, v0)];
    let has_left = sides.contains(&1);
    let has_right = sides.contains(&-1);
    has_left != has_right
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { slab, box_span, roots, meets_sphere, leave, side, is_hit })
}
