//! Lesson 03: the triangle. A solution.

mod check;

use glam::DVec3;
use raytree::lessons::{Ray, Triangle, TriangleHit};

/// The t where the ray meets the plane of the triangle, `None` where it does not; `triangle.vertices` are v0, v1, v2.
pub fn plane_t(ray: &Ray, triangle: &Triangle) -> Option<f64> {
    let [v0, v1, v2] = triangle.vertices;
    let normal = (v1 - v0).cross(v2 - v0);
    let n_dot_d = normal.dot(ray.direction);
    if n_dot_d == 0.0 {
        return None;
    }
    let t = (normal.dot(v0) - normal.dot(ray.origin)) / n_dot_d;
    if t >= 0.0 { Some(t) } else { None }
}

/// The weights [a, b, c] of v0, v1, v2 for a point p of the triangle's plane: p = a v0 + b v1 + c v2 with c = 1 - a - b.
pub fn weights(p: DVec3, triangle: &Triangle) -> [f64; 3] {
    let [v0, v1, v2] = triangle.vertices;
    let normal = (v1 - v0).cross(v2 - v0);
    let whole = normal.dot(normal);
    let a = (v2 - v1).cross(p - v1).dot(normal) / whole;
    let b = (v0 - v2).cross(p - v2).dot(normal) / whole;
    [a, b, 1.0 - a - b]
}

/// Whether the point with the weights a, b and 1 - a - b lies in the triangle. The border belongs to it.
pub fn is_inside(a: f64, b: f64) -> bool {
    a >= 0.0 && b >= 0.0 && a + b <= 1.0
}

/// Where the ray meets the triangle: `TriangleHit { t, barycentrics: [a, b, c] }`, `None` where it does not.
pub fn intersect(ray: &Ray, triangle: &Triangle) -> Option<TriangleHit> {
    let t = plane_t(ray, triangle)?;
    let [a, b, c] = weights(ray.at(t), triangle);
    if is_inside(a, b) { Some(TriangleHit { t, barycentrics: [a, b, c] }) } else { None }
}

fn main() -> std::process::ExitCode {
    check::run(check::Student { plane_t, weights, is_inside, intersect })
}
