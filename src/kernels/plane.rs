//! Ray and plane in Hesse normal form.

use crate::kernels::{Miss, Ray};
use crate::numbers::{Real, Vector3};

/// All points `p` with `p . normal = distance`. The normal is unit up to rounding; the plane is what is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<R: Real> {
    /// Unit normal.
    pub normal: R::Vec3,
    /// Distance from the origin along the normal.
    pub distance: R,
}

/// Where a ray meets a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneHit<R> {
    /// Ray parameter, `t >= 0`.
    pub t: R,
}

/// The hit of a ray and a plane by the lecture's formula `t = (D - o.n) / (d.n)`.
#[inline(always)]
pub fn intersect_plane_lecture<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Result<PlaneHit<R>, Miss> {
    let n_dot_d = plane.normal.dot(ray.direction);
    if n_dot_d == R::ZERO {
        return Err(Miss::Parallel);
    }
    let t = (plane.distance - plane.normal.dot(ray.origin)) / n_dot_d;
    if !(t >= R::ZERO) {
        return Err(Miss::Behind);
    }
    Ok(PlaneHit { t })
}
