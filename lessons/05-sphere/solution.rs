//! Lesson 05: the sphere. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Ray, Span, Sphere};

/// The a, b and c of the quadratic equation a t^2 + b t + c = 0 for the t where the ray's line meets the sphere.
pub fn coefficients(ray: &Ray, sphere: &Sphere) -> [f64; 3] {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    [d.dot(d), 2.0 * f.dot(d), f.dot(f) - sphere.radius * sphere.radius]
}

/// Both solutions of a t^2 + b t + c = 0 for a > 0, the smaller as `t_in`; `None` where there is none. A double one counts twice.
pub fn roots(a: f64, b: f64, c: f64) -> Option<Span> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    Some(Span { t_in: (-b - root) / (2.0 * a), t_out: (-b + root) / (2.0 * a) })
}

/// The t of the first hit: where the ray comes in, or, where it starts inside, where it goes out.
pub fn intersect(ray: &Ray, sphere: &Sphere) -> Option<f64> {
    let [a, b, c] = coefficients(ray, sphere);
    let Span { t_in, t_out } = roots(a, b, c)?;
    if t_in >= 0.0 {
        Some(t_in)
    } else if t_out >= 0.0 {
        Some(t_out)
    } else {
        None
    }
}

/// The unit normal of the sphere where the ray hits it at `t`, on the side that the ray comes from.
pub fn normal(ray: &Ray, sphere: &Sphere, t: f64) -> DVec3 {
    let outward = (ray.at(t) - sphere.center) / sphere.radius;
    if outward.dot(ray.direction) > 0.0 { -outward } else { outward }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { coefficients, roots, intersect, normal })
}
