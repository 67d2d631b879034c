//! Ray and triangle.
//!
//! Five forms under one signature, from the lecture's to the exact one:
//!
//! | form | wrong verdicts per million, f32 rays aimed at edges | what it does |
//! |---|---|---|
//! | [`intersect_triangle_lecture`] | 344,020 | the plane first, then where the point lies |
//! | [`intersect_triangle_moller_trumbore`] | 385,090 | one linear system, no plane |
//! | [`intersect_triangle_watertight`] | 285,070 | edges decided alike for both neighbours |
//! | [`intersect_triangle_certified`] | 0 | Möller-Trumbore in f64 with a proven bound, exact where that leaves it open |
//! | [`intersect_triangle_exact`] | 0 | no rounding at all |
//!
//! (100,000 pairs; `cargo test certified_verdicts -- --nocapture` prints these figures for all sets, `raytree accuracy` draws
//! its own.)

mod certified;

pub use certified::{
    TriangleFilter, are_coplanar, certify_triangle, intersect_triangle_certified, intersect_triangle_exact,
    longest_edge, triangle_stage,
};
pub(crate) use certified::{triangle_terms, triangle_terms_f64};

use crate::kernels::{Miss, Plane, Ray, intersect_plane_lecture};
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

/// The hit of a ray and a triangle as the lecture finds it: where the ray meets the plane, then whether that is inside.
///
/// # Accuracy
///
/// None to rely on: the point `p` is rounded, and next to an edge its rounding decides. Of f32 rays aimed at edges it
/// gets a third wrong, of needles 1e5 : 1 three in four.
///
/// # Source
///
/// Plane in Hesse form, `p = a v0 + b v1 + (1 - a - b) v2`, and the three tests `a >= 0`, `b >= 0`, `a + b <= 1`; the
/// weights are the areas of the sub-triangles along the normal over that of the whole.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.25, 0.5, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// let hit = intersect_triangle_lecture(&ray, &triangle).unwrap();
/// assert_eq!((hit.t, hit.barycentrics), (2.0, [0.25, 0.25, 0.5]));
/// ```
#[inline(always)]
pub fn intersect_triangle_lecture<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Result<TriangleHit<R>, Miss> {
    let [v0, v1, v2] = triangle.vertices;
    // The plane through the triangle, n.x = n.v0, and the point p where the ray meets it.
    let n = (v1 - v0).cross(v2 - v0);
    let t = intersect_plane_lecture(ray, &Plane { normal: n, distance: n.dot(v0) })?.t;
    let p = ray.at(t);
    // p = a v0 + b v1 + (1 - a - b) v2.
    let n_dot_n = n.dot(n);
    let a = n.dot((v2 - v1).cross(p - v1)) / n_dot_n;
    if !(a >= R::ZERO) {
        return Err(Miss::AIsNegative);
    }
    let b = n.dot((v0 - v2).cross(p - v2)) / n_dot_n;
    if !(b >= R::ZERO) {
        return Err(Miss::BIsNegative);
    }
    let c = R::ONE - a - b;
    if !(c >= R::ZERO) {
        return Err(Miss::SumExceedsOne);
    }
    Ok(TriangleHit { t, barycentrics: [a, b, c] })
}

/// Every intermediate value of [`intersect_triangle_lecture`], whether or not it stops early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleLectureValues<R: Real> {
    /// The normal `(v1 - v0) x (v2 - v0)`, not unit.
    pub n: R::Vec3,
    /// `n . d`; zero for a parallel ray.
    pub n_dot_d: R,
    /// Ray parameter of the plane hit.
    pub t: R,
    /// The plane hit.
    pub p: R::Vec3,
    /// Weight of v0.
    pub a: R,
    /// Weight of v1.
    pub b: R,
    /// Weight of v2, `1 - a - b`.
    pub c: R,
}

/// The intermediate values of [`intersect_triangle_lecture`], to the same bits.
pub fn triangle_lecture_values<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> TriangleLectureValues<R> {
    let [v0, v1, v2] = triangle.vertices;
    let n = (v1 - v0).cross(v2 - v0);
    let n_dot_d = n.dot(ray.direction);
    let t = (n.dot(v0) - n.dot(ray.origin)) / n_dot_d;
    let p = ray.at(t);
    let n_dot_n = n.dot(n);
    let a = n.dot((v2 - v1).cross(p - v1)) / n_dot_n;
    let b = n.dot((v0 - v2).cross(p - v2)) / n_dot_n;
    let c = R::ONE - a - b;
    TriangleLectureValues { n, n_dot_d, t, p, a, b, c }
}

/// The hit of a ray and a triangle as the solution of one linear system.
///
/// # Accuracy
///
/// None to rely on in the verdict: each barycentric coordinate is off by rounding, next to an edge that decides, and
/// two neighbours can both say no (a leak). Of f32 rays aimed at edges 39 % are wrong, and as many f64 rays in f64.
///
/// # Source
///
/// Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997, with `b`, `c` for their `u`, `v`:
/// `o - v0 = -t d + b e1 + c e2`, solved by Cramer's rule.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.25, 0.5, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// let hit = intersect_triangle_moller_trumbore(&ray, &triangle).unwrap();
/// assert_eq!((hit.t, hit.barycentrics), (2.0, [0.25, 0.25, 0.5]));
/// ```
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

/// Every intermediate value of a kernel in the manner of Möller and Trumbore, whether or not it stops early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleValues<R> {
    /// The determinant `d . (e2 x e1)`; zero for a parallel ray. The watertight form has the sum of its edge functions.
    pub det: R,
    /// Weight of v1, `b`.
    pub u: R,
    /// Weight of v2, `1 - a - b`.
    pub v: R,
    /// Weight of v0, `a`.
    pub w: R,
    /// Ray parameter.
    pub t: R,
}

/// The intermediate values of [`intersect_triangle_moller_trumbore`], to the same bits.
pub fn triangle_moller_trumbore_values<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> TriangleValues<R> {
    let [v0, v1, v2] = triangle.vertices;
    let (e1, e2) = (v1 - v0, v2 - v0);
    let p = ray.direction.cross(e2);
    let det = e1.dot(p);
    let inv_det = R::ONE / det;
    let s = ray.origin - v0;
    let u = s.dot(p) * inv_det;
    let q = s.cross(e1);
    let v = ray.direction.dot(q) * inv_det;
    let w = R::ONE - u - v;
    let t = e2.dot(q) * inv_det;
    TriangleValues { det, u, v, w, t }
}

/// The hit of a ray and a triangle by edge functions in a sheared space where the ray is the z axis.
///
/// # Accuracy
///
/// No leaks: an edge function is computed from the edge alone, to the same bits with the opposite sign for the
/// neighbour. That is not the same as a right verdict: vertices are rounded when they are sheared, and more than a
/// quarter of its verdicts on f32 rays aimed at edges are not the true ones.
///
/// # Source
///
/// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, 2013, without back-face culling; `kz`, `Sx`, `Ax`, `U` as
/// there. Where an edge function is zero the paper recomputes it in f64; in f64 there is nothing wider to go to.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.25, 0.5, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// let hit = intersect_triangle_watertight(&ray, &triangle).unwrap();
/// assert_eq!((hit.t, hit.barycentrics), (2.0, [0.25, 0.25, 0.5]));
/// ```
#[inline(always)]
pub fn intersect_triangle_watertight<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Result<TriangleHit<R>, Miss> {
    let TriangleEdges { u, v, w, t_scaled } = edge_functions(ray, triangle);
    // Inside: no two edge functions of different sign.
    let det = u + v + w;
    if (u < R::ZERO || v < R::ZERO || w < R::ZERO) && (u > R::ZERO || v > R::ZERO || w > R::ZERO) {
        let outside = |x: R| x * det < R::ZERO;
        return Err(if outside(v) {
            Miss::BIsNegative
        } else if outside(w) {
            Miss::SumExceedsOne
        } else {
            Miss::AIsNegative
        });
    }
    if !(det != R::ZERO) {
        return Err(Miss::Parallel);
    }
    let inv_det = R::ONE / det;
    let t = t_scaled * inv_det;
    if !(t >= R::ZERO) {
        return Err(Miss::Behind);
    }
    Ok(TriangleHit { t, barycentrics: [u * inv_det, v * inv_det, w * inv_det] })
}

/// The paper's `U`, `V`, `W` (edge functions opposite v0, v1, v2) and `T`.
struct TriangleEdges<R> {
    u: R,
    v: R,
    w: R,
    t_scaled: R,
}

#[inline(always)]
fn edge_functions<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> TriangleEdges<R> {
    let d = ray.direction.to_array();
    // z is the direction's largest component; x and y swap for a negative one to keep the winding.
    let mut kz = if d[1].abs() > d[0].abs() { 1 } else { 0 };
    if d[2].abs() > d[kz].abs() {
        kz = 2;
    }
    let (mut kx, mut ky) = ((kz + 1) % 3, (kz + 2) % 3);
    if d[kz] < R::ZERO {
        (kx, ky) = (ky, kx);
    }
    let (sx, sy, sz) = (d[kx] / d[kz], d[ky] / d[kz], R::ONE / d[kz]);
    let sheared = |vertex: R::Vec3| {
        let a = (vertex - ray.origin).to_array();
        [a[kx] - sx * a[kz], a[ky] - sy * a[kz], sz * a[kz]]
    };
    let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = triangle.vertices.map(sheared);
    let (mut u, mut v, mut w) = (cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax);
    if u == R::ZERO || v == R::ZERO || w == R::ZERO {
        let wider = |a: R, b: R, c: R, d: R| R::from_f64(a.to_f64() * b.to_f64() - c.to_f64() * d.to_f64());
        (u, v, w) = (wider(cx, by, cy, bx), wider(ax, cy, ay, cx), wider(bx, ay, by, ax));
    }
    TriangleEdges { u, v, w, t_scaled: u * az + v * bz + w * cz }
}

/// The intermediate values of [`intersect_triangle_watertight`], to the same bits; the weights over `det`.
pub fn triangle_watertight_values<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> TriangleValues<R> {
    let TriangleEdges { u, v, w, t_scaled } = edge_functions(ray, triangle);
    let det = u + v + w;
    let inv_det = R::ONE / det;
    // The paper's U, V, W belong to v0, v1, v2; here w, u, v do.
    TriangleValues { det, u: v * inv_det, v: w * inv_det, w: u * inv_det, t: t_scaled * inv_det }
}
