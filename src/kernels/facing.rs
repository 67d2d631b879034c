//! Which way a ray crosses a flat surface, exactly, and a triangle's normal, however thin the triangle is.

use std::cmp::Ordering;

use crate::kernels::{Plane, Ray, Triangle};
use crate::numbers::{Expansion, Real, Ring, U, Vector3, determinant, dot, unit};

/// The sign of `d . n` for a plane: less for a ray that goes against the normal, equal for one along the plane.
///
/// # Accuracy
/// Exact. The filter: three products and two sums of them are within `3 u` of the sum of magnitudes, taken as `4 u`.
///
/// # Example
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.0, 1.0, 0.0), direction: dvec3(1.0, -1e-30, 0.0) };
/// let floor = Plane::<f64> { normal: dvec3(0.0, 1.0, 0.0), distance: 0.0 };
/// assert!(plane_facing(&ray, &floor).is_lt());
/// ```
pub fn plane_facing<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Ordering {
    let (d, n) = (ray.direction.to_f64(), plane.normal.to_f64());
    let terms: [f64; 3] = std::array::from_fn(|k| d[k] * n[k]);
    let bound = 4.0 * U * terms.iter().map(|x| x.abs()).sum::<f64>();
    facing(terms.iter().sum(), bound, || dot(&d.map(Expansion::number), &n.map(Expansion::number)))
}

/// The sign of `d . ((v1 - v0) x (v2 - v0))` for a triangle: less for a ray that goes against its normal.
///
/// # Accuracy
/// Exact. The filter's bound is that of the certified kernel's determinant, `48 u D L^2`.
pub fn triangle_facing<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Ordering {
    let d = ray.direction.to_f64();
    let (e1, e2) = edges::<R, f64>(triangle);
    let longest = |v: &[f64; 3]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let bound = 48.0 * U * longest(&d) * longest(&e1) * longest(&e2);
    facing(determinant(&d, &e1, &e2), bound, || {
        let (e1, e2) = edges::<R, Expansion>(triangle);
        determinant(&d.map(Expansion::number), &e1, &e2)
    })
}

/// The unit normal `(v1 - v0) x (v2 - v0)`; zero for a triangle without area, which is never hit.
///
/// # Accuracy
/// Within `2^-28` of the true one, usually a few ulp: where the cross product in f64 loses more to cancellation, as in
/// a needle, it is computed exactly and rounded once.
pub fn triangle_normal<R: Real>(triangle: &Triangle<R>) -> R::Vec3 {
    let (e1, e2) = edges::<R, f64>(triangle);
    let mut normal = cross(&e1, &e2);
    let longest = |v: &[f64; 3]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    // Each component is within 6 u of the products of edges; this leaves 2^-28 of the largest.
    if longest(&normal) < 6.0 * U * (1_u64 << 28) as f64 * longest(&e1) * longest(&e2) {
        let (e1, e2) = edges::<R, Expansion>(triangle);
        normal = cross(&e1, &e2).map(|x| x.estimate());
    }
    R::Vec3::from_f64(unit(normal).unwrap_or_default())
}

fn facing(value: f64, bound: f64, exact: impl FnOnce() -> Expansion) -> Ordering {
    if value.abs() > bound { value.total_cmp(&0.0) } else { exact().sign().cmp(&0) }
}

fn edges<R: Real, T: Ring>(triangle: &Triangle<R>) -> ([T; 3], [T; 3]) {
    let [v0, v1, v2] = triangle.vertices.map(|v| v.to_f64());
    let difference = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|k| T::difference(a[k], b[k]));
    (difference(v1, v0), difference(v2, v0))
}

fn cross<T: Ring>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    let minor = |i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}
