//! Lesson 02: the plane in Hesse form. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Plane, Ray};

/// The plane through `point` with `normal`, in Hesse form: `Plane { normal, distance }`, where `normal` has length 1 and
/// `distance` is D. The normal given may have any length but 0.
pub fn plane_from(point: DVec3, normal: DVec3) -> Plane {
    let normal = normal.normalize();
    Plane { normal, distance: point.dot(normal) }
}

/// How far `point` is from the plane: positive on the side to which `plane.normal` points, negative on the other.
pub fn signed_distance(point: DVec3, plane: &Plane) -> f64 {
    point.dot(plane.normal) - plane.distance
}

/// The t where the ray meets the plane, `None` where it does not. The ray is `ray.origin + t * ray.direction`, `t >= 0`.
pub fn intersect(ray: &Ray, plane: &Plane) -> Option<f64> {
    let n_dot_d = plane.normal.dot(ray.direction);
    if n_dot_d == 0.0 {
        return None;
    }
    let t = (plane.distance - plane.normal.dot(ray.origin)) / n_dot_d;
    if t >= 0.0 { Some(t) } else { None }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { plane_from, signed_distance, intersect })
}
