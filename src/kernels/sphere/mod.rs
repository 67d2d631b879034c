//! Ray and sphere.
//!
//! With `f = o - c` the roots are those of `a t^2 + 2 b t + (f.f - r^2)`, `a = d.d`, `b = f.d`: `t = (-b -+ sqrt(disc))
//! / a`. The forms differ in how they come by `disc` and which cancellations they avoid.

mod certified;

pub(crate) use certified::{SphereBounds, SphereTerms};
pub use certified::{certify_sphere, intersect_sphere_certified, intersect_sphere_exact, sphere_stage};

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

/// The hit of a ray and a sphere by the textbook's quadratic formula.
///
/// # Accuracy
///
/// None to rely on: `b^2 - 4 a c` is the difference of two squares of the distance. In f32, rays that pass a unit
/// sphere 4100 away at a quarter of its radius hit it.
///
/// # Source
///
/// `|o + t d - c|^2 = r^2`, with the formula for `a t^2 + b t + c = 0`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(-5.0, 0.0, 0.0), direction: dvec3(2.0, 0.0, 0.0) };
/// let sphere = Sphere::<f64> { center: dvec3(0.0, 0.0, 0.0), radius: 1.0 };
/// let hit = intersect_sphere_naive(&ray, &sphere, Start::Anywhere).unwrap();
/// assert_eq!((hit.t, hit.t_in, hit.t_out), (2.0, 2.0, 3.0));
/// ```
#[inline(always)]
pub fn intersect_sphere_naive<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Result<SphereHit<R>, Miss> {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    let a = d.dot(d);
    let b = R::TWO * f.dot(d);
    let c = f.dot(f) - sphere.radius * sphere.radius;
    let disc = b * b - R::TWO * R::TWO * a * c;
    if !(disc >= R::ZERO) {
        return Err(Miss::NegativeDiscriminant);
    }
    let root = disc.sqrt();
    let (t_in, t_out) = ((-b - root) / (R::TWO * a), (-b + root) / (R::TWO * a));
    nearest(t_in, t_out, start)
}

/// The root that counts.
#[inline(always)]
fn nearest<R: Real>(t_in: R, t_out: R, start: Start) -> Result<SphereHit<R>, Miss> {
    if !(t_out >= R::ZERO) {
        return Err(Miss::Behind);
    }
    let t = if t_in >= R::ZERO && start == Start::Anywhere { t_in } else { t_out };
    Ok(SphereHit { t, t_in, t_out })
}

/// Every intermediate value of [`intersect_sphere_naive`], whether or not it stops early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereNaiveValues<R> {
    /// `d . d`.
    pub a: R,
    /// `2 f . d`, `f = o - center`.
    pub b: R,
    /// `f . f - r^2`.
    pub c: R,
    /// `b^2 - 4 a c`.
    pub disc: R,
    /// The smaller root; NaN without one.
    pub t_in: R,
    /// The larger root; NaN without one.
    pub t_out: R,
}

/// The intermediate values of [`intersect_sphere_naive`], to the same bits.
pub fn sphere_naive_values<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> SphereNaiveValues<R> {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    let a = d.dot(d);
    let b = R::TWO * f.dot(d);
    let c = f.dot(f) - sphere.radius * sphere.radius;
    let disc = b * b - R::TWO * R::TWO * a * c;
    let root = disc.sqrt();
    SphereNaiveValues { a, b, c, disc, t_in: (-b - root) / (R::TWO * a), t_out: (-b + root) / (R::TWO * a) }
}

/// The hit of a ray and a sphere by the stable quadratic.
///
/// # Accuracy
///
/// The discriminant is a difference of squares of *small* lengths, the radius and the line's distance from the centre,
/// and no root is a difference of nearly equal numbers. Grazing rays and origins on the surface are still decided by
/// rounding.
///
/// # Source
///
/// Haines, Günther and Akenine-Möller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems 2019,
/// chapter 7 (the discriminant after Hearn and Baker); here as `r^2 |d|^2 - |f x d|^2`, so that `d` need not be unit.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::vec3;
/// // 1.25 beside a unit sphere, 4100 away: a miss that the naive form takes for a hit.
/// let ray = Ray::<f32> { origin: vec3(-4100.0, 1.25, 0.0), direction: vec3(1.0, 0.0, 0.0) };
/// let sphere = Sphere::<f32> { center: vec3(0.0, 0.0, 0.0), radius: 1.0f32 };
/// assert_eq!(intersect_sphere_stable(&ray, &sphere, Start::Anywhere), Err(Miss::NegativeDiscriminant));
/// assert!(intersect_sphere_naive(&ray, &sphere, Start::Anywhere).is_ok());
/// ```
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
    nearest(t_in, t_out, start)
}

/// Every intermediate value of [`intersect_sphere_stable`], whether or not it stops early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereValues<R> {
    /// `d . d`.
    pub a: R,
    /// `f . d`, `f = o - center`.
    pub b: R,
    /// `f . f - r^2`.
    pub c: R,
    /// `l . l`, `l = f x d`.
    pub l_dot_l: R,
    /// `r^2 a - l . l`.
    pub disc: R,
    /// `-b -+ sqrt(disc)`, the sum that does not cancel; NaN without roots.
    pub q: R,
    /// The smaller root; NaN without one.
    pub t_in: R,
    /// The larger root; NaN without one.
    pub t_out: R,
}

/// The intermediate values of [`intersect_sphere_stable`], to the same bits.
pub fn sphere_values<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> SphereValues<R> {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    let a = d.dot(d);
    let l = f.cross(d);
    let l_dot_l = l.dot(l);
    let disc = sphere.radius * sphere.radius * a - l_dot_l;
    let b = f.dot(d);
    let c = f.dot(f) - sphere.radius * sphere.radius;
    let root = disc.sqrt();
    let q = if b < R::ZERO { root - b } else { -b - root };
    let (t0, t1) = if q == R::ZERO { (R::ZERO, R::ZERO) } else { (q / a, c / q) };
    let (t_in, t_out) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
    SphereValues { a, b, c, l_dot_l, disc, q, t_in, t_out }
}
