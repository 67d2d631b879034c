//! Ray and sphere.

use crate::kernels::{Miss, Ray, Start};
use crate::numbers::{Real, Vector3};

/// All points at `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<R: Real> {
    /// The centre in world space.
    pub center: R::Vec3,
    /// The radius, `>= 0`.
    pub radius: R,
}

/// Where a ray's line enters and leaves a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereHit<R> {
    /// The hit: `t_in` where the ray starts outside, else `t_out`.
    pub t: R,
    /// The smaller root.
    pub t_in: R,
    /// The larger root.
    pub t_out: R,
}

/// The hit of a ray and a sphere by the stable quadratic of Haines, Günther and Akenine-Möller 2019.
#[inline(always)]
pub fn intersect_sphere_stable<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Result<SphereHit<R>, Miss> {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    let a = d.dot(d);
    let l = f.cross(d);
    let disc = sphere.radius * sphere.radius * a - l.dot(l);
    if !(disc >= R::ZERO) {
        return Err(Miss::NegativeDiscriminant);
    }
    let b = f.dot(d);
    let c = f.dot(f) - sphere.radius * sphere.radius;
    let root = disc.sqrt();
    let q = if b < R::ZERO { root - b } else { -b - root };
    let (t0, t1) = if q == R::ZERO { (R::ZERO, R::ZERO) } else { (q / a, c / q) };
    let (t_in, t_out) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
    if !(t_out >= R::ZERO) {
        return Err(Miss::Behind);
    }
    let t = if t_in >= R::ZERO && start == Start::Anywhere { t_in } else { t_out };
    Ok(SphereHit { t, t_in, t_out })
}
