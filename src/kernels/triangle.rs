//! Ray and triangle.

use crate::kernels::{Miss, Ray};
use crate::numbers::{Real, Vector3};

/// The closed triangle v0 v1 v2; its normal is `(v1 - v0) x (v2 - v0)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<R: Real> {
    /// v0, v1, v2 in world space.
    pub vertices: [R::Vec3; 3],
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit<R> {
    /// Ray parameter, `t >= 0`.
    pub t: R,
    /// Barycentric coordinates `[a, b, 1-a-b]`, the weights of v0, v1, v2.
    pub barycentrics: [R; 3],
}

/// The hit of a ray and a triangle after Möller and Trumbore 1997.
#[inline(always)]
pub fn intersect_triangle_moller_trumbore<R: Real>(
    ray: &Ray<R>,
    triangle: &Triangle<R>,
) -> Result<TriangleHit<R>, Miss> {
    let [v0, v1, v2] = triangle.vertices;
    let (e1, e2) = (v1 - v0, v2 - v0);
    let p = ray.direction.cross(e2);
    let det = e1.dot(p);
    if det == R::ZERO {
        return Err(Miss::Parallel);
    }
    let inv_det = R::ONE / det;
    let s = ray.origin - v0;
    let b = s.dot(p) * inv_det;
    if !(b >= R::ZERO) {
        return Err(Miss::BIsNegative);
    }
    let q = s.cross(e1);
    let c = ray.direction.dot(q) * inv_det;
    if !(c >= R::ZERO) {
        return Err(Miss::SumExceedsOne);
    }
    let a = R::ONE - b - c;
    if !(a >= R::ZERO) {
        return Err(Miss::AIsNegative);
    }
    let t = e2.dot(q) * inv_det;
    if !(t >= R::ZERO) {
        return Err(Miss::Behind);
    }
    Ok(TriangleHit { t, barycentrics: [a, b, c] })
}
