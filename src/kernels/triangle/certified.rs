//! Ray and triangle, certified: a filter in f64, and behind it integers, double-double and expansions.
//!
//! With `e1 = v1 - v0`, `e2 = v2 - v0`, `s = o - v0` and `det(x, y, z) = x . (y x z)`, Möller and Trumbore's letters
//! are
//!
//! ```text
//! det = det(d, e2, e1)    U = det(d, e2, s)    V = det(d, s, e1)    W = det - U - V    T = det(e2, s, e1)
//! ```
//!
//! and the closed triangle is hit exactly when `det` is not zero and `U`, `V`, `W`, `T` are zero or have its sign.
//!
//! # The filter's bounds, derived here
//!
//! `u` = 2^-53, `D` = |d|, `M` = a bound on |vertex - o|, `L` = a bound on |edge|, all in the largest component. A
//! determinant is six triple products. In each, a difference of stored numbers is rounded once (relative `u`), and:
//!
//! - `det = e1 . (d x e2)`: e2, the product, the difference in the vector product, e1, the product, two sums: 7
//!   roundings, so `6 * 7 u D L^2 = 42 u D L^2`;
//! - `U = s . (d x e2)`, `V = d . (s x e1)`: 7 as well, `42 u D L M`;
//! - `T = e2 . (s x e1)`: three rounded rows, 8 roundings, `48 u M L^2`;
//! - `W = |det| - U - V` inherits those of all three, and its two subtractions round by `u |det - U|` and `u |W|`,
//!   where `|det| <= 6 D L^2` and `|U|, |V| <= 6 D L M`: `(42 + 12) u D L^2 + (84 + 18) u D L M`.
//!
//! The constants below are larger by an eighth at least, which pays for the terms in `u^2` and the rounding of the
//! bounds themselves:
//!
//! ```text
//! E_D = 48 u D L^2    E = 48 u D L M    E_W = 1.5 E_D + 2.5 E  (54/48 = 1.125, 102/48 = 2.125)    E_T = 56 u M L^2
//! ```
//!
//! Nothing underflows: the smallest product of three numbers in range is 2^-534.
//!
//! # The double-double bound
//!
//! Differences are exact, so a determinant is within `150 u^2` of the product of its rows' bounds
//! ([`determinant`](crate::numbers::determinant)). `8 u E = 384 u^2 D L M` (and so on) is more than twice that.
//! Here `W = det(d, v2 - v1, v1 - o)`, one determinant (rows of D, L, M) instead of three.

use std::cell::Cell;

use crate::kernels::certified::FILTER_ACCURACY;
use crate::kernels::{Aabb, Certified, Miss, Ray, Triangle, TriangleHit};
use crate::numbers::integers::{self, Row};
use crate::numbers::{self, Certificate, DoubleDouble, Expansion, Known, Real, Ring, Stage, U, Vector3};

/// The largest `|component|` of the triangle's three edges.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::vec3;
/// let triangle = Triangle::<f32> { vertices: [vec3(0.0, 0.0, 0.0), vec3(3.0, 0.0, 0.0), vec3(0.0, 4.0, 0.0)] };
/// assert_eq!(longest_edge(&triangle), 4.0);
/// ```
pub fn longest_edge<R: Real>(triangle: &Triangle<R>) -> f64 {
    let v = triangle.vertices.map(|vertex| vertex.to_f64());
    let mut longest = 0.0f64;
    for k in 0..3 {
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            longest = longest.max((v[i][k] - v[j][k]).abs());
        }
    }
    longest
}

/// The bounds of the filter for one ray and all triangles of a mesh.
///
/// Made once per ray and mesh; wider ones (of a whole scene, say) are sound but leave more to the slow stages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleFilter {
    /// E_D, on det.
    det: f64,
    /// E, on U and V.
    uv: f64,
    /// E_W, on W.
    w: f64,
    /// E_T, on T.
    t: f64,
}

impl TriangleFilter {
    /// The filter for `ray` and every triangle within `bounds` with edges of at most `longest_edge` in each component.
    pub fn new<R: Real>(ray: &Ray<R>, bounds: &Aabb<R>, longest_edge: f64) -> Self {
        let (o, d) = (ray.origin.to_f64(), ray.direction.to_f64());
        let (lo, hi) = (bounds.min.to_f64(), bounds.max.to_f64());
        let (mut largest_d, mut reach) = (0.0f64, 0.0f64);
        for k in 0..3 {
            largest_d = largest_d.max(d[k].abs());
            reach = reach.max((lo[k] - o[k]).abs()).max((hi[k] - o[k]).abs());
        }
        let det = 48.0 * U * largest_d * longest_edge * longest_edge;
        let uv = 48.0 * U * largest_d * longest_edge * reach;
        let t = 56.0 * U * reach * longest_edge * longest_edge;
        TriangleFilter { det, uv, w: 1.5 * det + 2.5 * uv, t }
    }

    /// The filter for `ray` and this one triangle.
    pub fn of_triangle<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Self {
        TriangleFilter::new(ray, &Aabb::of_points(&triangle.vertices), longest_edge(triangle))
    }
}

/// `x` with its sign flipped where `sign` is negative.
#[inline(always)]
fn fold(x: f64, sign: f64) -> f64 {
    f64::from_bits(x.to_bits() ^ (sign.to_bits() & (1 << 63)))
}

/// The hit of a ray and a triangle, the verdict exactly right for the stored numbers.
///
/// # Ranges
///
/// `filter` was made for this ray and bounds that contain the triangle. Numbers as in [`Certified`].
///
/// # Accuracy
///
/// Verdict exact, edges and vertices included; a ray in the triangle's plane and a triangle of no area are misses. `t`
/// is good to 2^-36 where the filter gives it, and to a few ulp otherwise; `t_error` says. `cargo bench
/// --bench kernels` prints the cost against Möller and Trumbore's form; a test that the filter leaves open costs
/// several times the usual one.
///
/// # Source
///
/// Filter bounds and stages derived here (see the head of this file); the idea of a filter with exact stages behind it
/// is Shewchuk's, 1997.
///
/// # Example
///
/// A ray through the very middle of an edge hits:
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.5, 0.5, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// let filter = TriangleFilter::of_triangle(&ray, &triangle);
/// let certified = intersect_triangle_certified(&ray, &triangle, &filter).unwrap();
/// assert_eq!((certified.t, certified.hit.barycentrics), (2.0, [0.0, 0.5, 0.5]));
/// ```
#[inline(always)]
pub fn intersect_triangle_certified<R: Real>(
    ray: &Ray<R>,
    triangle: &Triangle<R>,
    filter: &TriangleFilter,
) -> Result<Certified<TriangleHit<R>>, Miss> {
    filtered(ray, triangle, filter, || undecided(ray, triangle))
}

/// What the filter says; `otherwise` where it cannot tell, in tail position, or the hot loop pays for it.
#[inline(always)]
fn filtered<R: Real>(
    ray: &Ray<R>,
    triangle: &Triangle<R>,
    filter: &TriangleFilter,
    otherwise: impl FnOnce() -> Result<Certified<TriangleHit<R>>, Miss>,
) -> Result<Certified<TriangleHit<R>>, Miss> {
    let (o, d) = (wide::<R>(ray.origin), wide::<R>(ray.direction));
    let [v0, v1, v2] = triangle.vertices.map(wide::<R>);
    let (e1, e2) = (v1 - v0, v2 - v0);
    let p = d.cross(e2);
    let signed_det = e1.dot(p);
    let det = signed_det.abs();
    if !(det > filter.det) {
        return otherwise();
    }
    let s = o - v0;
    let q = s.cross(e1);
    let u = fold(s.dot(p), signed_det);
    if u < -filter.uv {
        return Err(Miss::BIsNegative);
    }
    // V + W = det - U is negative: the point lies beyond v1, and one of the two is to blame. With U this large, V >=
    // -E leaves W <= -2 E_W + E + its error < 0. A caller who drops the reason never computes V here.
    if u - det > 2.0 * filter.w {
        let v = fold(d.dot(q), signed_det);
        return Err(if v < -filter.uv { Miss::SumExceedsOne } else { Miss::AIsNegative });
    }
    let v = fold(d.dot(q), signed_det);
    if v < -filter.uv {
        return Err(Miss::SumExceedsOne);
    }
    let w = det - u - v;
    if w < -filter.w {
        return Err(Miss::AIsNegative);
    }
    let t_scaled = fold(e2.dot(q), signed_det);
    if t_scaled < -filter.t {
        return Err(Miss::Behind);
    }
    if u > filter.uv && v > filter.uv && w > filter.w && t_scaled > filter.t {
        // t = T / det, T = T' + tau, det = det' + delta: T'/det' - T/det = (T'/det' delta - tau) / det, |tau| <= E_T,
        // |delta| <= E_D, |det| >= det' - E_D. The quotient itself rounds by u t; the rest is paid by the room in the
        // bounds.
        let t = t_scaled / det;
        let t_error = (filter.t + t * filter.det) / (det - filter.det) + 2.0 * U * t;
        if t_error <= FILTER_ACCURACY * t {
            let inv_det = 1.0 / det;
            let barycentrics = [w, u, v].map(|x| R::from_f64(x * inv_det));
            return Ok(Certified { hit: TriangleHit { t: R::from_f64(t), barycentrics }, t, t_error });
        }
    }
    otherwise()
}

#[inline(always)]
fn wide<R: Real>(v: R::Vec3) -> glam::DVec3 {
    glam::DVec3::from_array(v.to_f64())
}

/// The hit of a ray and a triangle without any rounding in the verdict, by expansions alone: the filter's referee.
///
/// # Accuracy
///
/// Verdict exact, `t` and the weights within a few ulp. Far dearer than the filter, and never on the hot path.
///
/// # Source
///
/// Shewchuk 1997, see [`Expansion`].
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// // One ulp beside the edge x + y = 1.
/// let ray = Ray::<f64> { origin: dvec3(0.5, 0.5000000000000001, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// assert_eq!(intersect_triangle_exact(&ray, &triangle), Err(Miss::AIsNegative));
/// ```
pub fn intersect_triangle_exact<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Result<TriangleHit<R>, Miss> {
    let rows = Rows::<Expansion>::new(ray, triangle);
    decide(&rows).map(|certified| certified.hit)
}

impl Determinants for Rows<Expansion> {
    fn decided(&self, quantity: Quantity) -> Known {
        Known::exact(&self.determinant(quantity))
    }
    fn measured(&self, quantity: Quantity) -> Known {
        self.decided(quantity)
    }
}

/// The five determinants of a ray and a triangle.
#[derive(Clone, Copy)]
enum Quantity {
    Det,
    U,
    V,
    W,
    T,
}

/// The five determinants in some arithmetic that knows their signs exactly.
trait Determinants {
    /// The quantity with its sign exact.
    fn decided(&self, quantity: Quantity) -> Known;
    /// The quantity with its sign exact and its value within a few ulp.
    fn measured(&self, quantity: Quantity) -> Known;
}

/// The verdict from the five quantities, asked for one by one.
#[inline(always)]
fn decide<R: Real>(determinants: &impl Determinants) -> Result<Certified<TriangleHit<R>>, Miss> {
    let det = determinants.decided(Quantity::Det);
    let sign = det.value;
    if sign == 0.0 {
        return Err(Miss::Parallel);
    }
    let not_negative = |quantity, miss| {
        let known = determinants.decided(quantity);
        if fold(known.value, sign) < 0.0 { Err(miss) } else { Ok((quantity, known)) }
    };
    let u = not_negative(Quantity::U, Miss::BIsNegative)?;
    let v = not_negative(Quantity::V, Miss::SumExceedsOne)?;
    let w = not_negative(Quantity::W, Miss::AIsNegative)?;
    let t_scaled = not_negative(Quantity::T, Miss::Behind)?;
    // A sign may be known of a value that is not.
    let measured = |(quantity, known): (Quantity, Known)| {
        if known.is_accurate() { known } else { measured_anew(determinants, quantity) }
    };
    let (det, t_scaled) = (measured((Quantity::Det, det)), measured(t_scaled));
    let magnitude = det.value.abs();
    let t = t_scaled.value.abs() / magnitude;
    // Both are within 2^-48 or better, so that their product and 1 / (1 - 2^-48) are well within the 8 u.
    let t_error = t * (t_scaled.relative_error + det.relative_error + 8.0 * U);
    let barycentrics = [w, u, v].map(|weight| R::from_f64(measured(weight).value.abs() / magnitude));
    Ok(Certified { hit: TriangleHit { t: R::from_f64(t), barycentrics }, t, t_error })
}

/// A value that double-double knew too roughly.
#[cold]
#[inline(never)]
fn measured_anew(determinants: &impl Determinants, quantity: Quantity) -> Known {
    determinants.measured(quantity)
}

/// The hit where the filter could not tell, or not tell `t` well enough.
#[cold]
#[inline(never)]
fn undecided<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Result<Certified<TriangleHit<R>>, Miss> {
    // The poles of a sphere's mesh: no need to work out that there is no area.
    let [v0, v1, v2] = triangle.vertices;
    if v0 == v1 || v1 == v2 || v2 == v0 {
        return Err(Miss::Parallel);
    }
    match IntegerRows::new(ray, triangle) {
        Some(rows) => decide(&rows),
        None => decide(&SlowStages::new(ray, triangle)),
    }
}

/// Which stage decides this ray and triangle, hit or miss: the dearest that any sign on the way to the verdict calls
/// for.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::Stage;
/// # use glam::dvec3;
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// let stage = |x, y| {
///     let ray = Ray::<f64> { origin: dvec3(x, y, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
///     triangle_stage(&ray, &triangle, &TriangleFilter::of_triangle(&ray, &triangle))
/// };
/// assert_eq!((stage(0.25, 0.25), stage(0.5, 0.5)), (Stage::Filter, Stage::Integer));
/// ```
pub fn triangle_stage<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>, filter: &TriangleFilter) -> Stage {
    let mut is_open = false;
    let _ = filtered(ray, triangle, filter, || {
        is_open = true;
        Err(Miss::Parallel)
    });
    if !is_open {
        return Stage::Filter;
    }
    if IntegerRows::new(ray, triangle).is_some() {
        return Stage::Integer;
    }
    let stages = Witness { determinants: SlowStages::new(ray, triangle), dearest: Cell::new(Stage::DoubleDouble) };
    let _: Result<Certified<TriangleHit<R>>, Miss> = decide(&stages);
    stages.dearest.get()
}

/// Notes the dearest stage that a sign has called for.
struct Witness<D> {
    determinants: D,
    dearest: Cell<Stage>,
}

impl<D: Determinants> Determinants for Witness<D> {
    fn decided(&self, quantity: Quantity) -> Known {
        let known = self.determinants.decided(quantity);
        self.dearest.set(self.dearest.get().max(known.stage));
        known
    }
    fn measured(&self, quantity: Quantity) -> Known {
        self.determinants.measured(quantity)
    }
}

/// How a *hit* of this ray and triangle was decided, with the bounds of this one triangle.
///
/// The margin is the smallest of `|det| / E_D`, `U / E`, `V / E`, `W / E_W`, `T / E_T`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::{Certificate, Stage};
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.5, 0.5, 2.0), direction: dvec3(0.0, 0.0, -1.0) };
/// let triangle = Triangle::<f64> { vertices: [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0)] };
/// assert_eq!(certify_triangle(&ray, &triangle), Certificate { stage: Stage::Integer, margin: 0.0 }); // W = 0
/// ```
pub fn certify_triangle<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Certificate {
    let filter = TriangleFilter::of_triangle(ray, triangle);
    let bounds = [filter.det, filter.uv, filter.uv, filter.w, filter.t];
    let rows = Rows::<f64>::new(ray, triangle);
    let quantities = [Quantity::Det, Quantity::U, Quantity::V, Quantity::W, Quantity::T];
    let [det, u, v, _, t] = quantities.map(|quantity| rows.determinant(quantity));
    let w = det.abs() - fold(u, det) - fold(v, det);
    let margin_of = |values: [f64; 5]| {
        // A bound of zero belongs to a triangle without area, which is never hit.
        let ratios = values.iter().zip(bounds).map(|(x, bound)| if bound > 0.0 { x.abs() / bound } else { 0.0 });
        ratios.fold(f64::MAX, f64::min)
    };
    let margin = margin_of([det, u, v, w, t]);
    if margin > 1.0 {
        return Certificate { stage: Stage::Filter, margin };
    }
    let known = match IntegerRows::new(ray, triangle) {
        Some(rows) => quantities.map(|quantity| rows.decided(quantity)),
        None => {
            let stages = SlowStages::new(ray, triangle);
            quantities.map(|quantity| stages.decided(quantity))
        }
    };
    let stage = known.iter().map(|known| known.stage).fold(Stage::Filter, Stage::max);
    Certificate::after_filter(stage, margin_of(known.map(|known| known.value)))
}

/// The rows of the five determinants.
struct Rows<T> {
    d: [T; 3],
    e1: [T; 3],
    e2: [T; 3],
    /// o - v0.
    s: [T; 3],
    /// v2 - v1.
    e3: [T; 3],
    /// v1 - o.
    b: [T; 3],
}

impl<T> Rows<T> {
    #[inline(always)]
    fn of(&self, quantity: Quantity) -> [&[T; 3]; 3] {
        match quantity {
            Quantity::Det => [&self.d, &self.e2, &self.e1],
            Quantity::U => [&self.d, &self.e2, &self.s],
            Quantity::V => [&self.d, &self.s, &self.e1],
            Quantity::W => [&self.d, &self.e3, &self.b],
            Quantity::T => [&self.e2, &self.s, &self.e1],
        }
    }
}

impl<T: Ring> Rows<T> {
    #[inline(always)]
    fn new<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Self {
        let o = ray.origin.to_f64();
        let [v0, v1, v2] = triangle.vertices.map(|vertex| vertex.to_f64());
        let difference = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|k| T::difference(a[k], b[k]));
        Rows {
            d: ray.direction.to_f64().map(T::number),
            e1: difference(v1, v0),
            e2: difference(v2, v0),
            s: difference(o, v0),
            e3: difference(v2, v1),
            b: difference(v1, o),
        }
    }

    #[inline(always)]
    fn determinant(&self, quantity: Quantity) -> T {
        let [x, y, z] = self.of(quantity);
        numbers::determinant(x, y, z)
    }
}

/// The rows as integers: coordinates below 2^60 and the direction below 2^61, so that every entry is.
struct IntegerRows {
    rows: Rows<i64>,
    /// What the entries were multiplied with.
    scale: f64,
    scale_d: f64,
}

impl IntegerRows {
    /// Nothing where the numbers spread over too many bits.
    #[inline(always)]
    fn new<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Option<Self> {
        let (o, d) = (ray.origin.to_f64(), ray.direction.to_f64());
        let vertices = triangle.vertices.map(|vertex| vertex.to_f64());
        let largest = |v: [f64; 3]| v[0].abs().max(v[1].abs()).max(v[2].abs());
        let largest_point = vertices.into_iter().map(largest).fold(largest(o), f64::max);
        let (scale, scale_d) = (integers::scale_to(largest_point, 60), integers::scale_to(largest(d), 61));
        let d = integers::to_integers(d, scale_d)?;
        let o = integers::to_integers(o, scale)?;
        let v0 = integers::to_integers(vertices[0], scale)?;
        let v1 = integers::to_integers(vertices[1], scale)?;
        let v2 = integers::to_integers(vertices[2], scale)?;
        let difference = |a: &Row, b: &Row| integers::difference(a, b);
        let rows = Rows {
            d,
            e1: difference(&v1, &v0),
            e2: difference(&v2, &v0),
            s: difference(&o, &v0),
            e3: difference(&v2, &v1),
            b: difference(&v1, &o),
        };
        Some(IntegerRows { rows, scale, scale_d })
    }
}

impl Determinants for IntegerRows {
    #[inline(always)]
    fn decided(&self, quantity: Quantity) -> Known {
        let [x, y, z] = self.rows.of(quantity);
        // Powers of two, and every step stays in range: no rounding.
        let first_row = if matches!(quantity, Quantity::T) { self.scale } else { self.scale_d };
        let value = integers::determinant(x, y, z) / first_row / self.scale / self.scale;
        Known { value, relative_error: 4.0 * U, stage: Stage::Integer }
    }
    #[inline(always)]
    fn measured(&self, quantity: Quantity) -> Known {
        self.decided(quantity)
    }
}

/// Double-double, and expansions where that is not certain.
struct SlowStages<'a, R: Real> {
    ray: &'a Ray<R>,
    triangle: &'a Triangle<R>,
    filter: TriangleFilter,
    rows: Rows<DoubleDouble>,
}

impl<'a, R: Real> SlowStages<'a, R> {
    fn new(ray: &'a Ray<R>, triangle: &'a Triangle<R>) -> Self {
        let filter = TriangleFilter::of_triangle(ray, triangle);
        SlowStages { ray, triangle, filter, rows: Rows::new(ray, triangle) }
    }

    fn bound(&self, quantity: Quantity) -> f64 {
        8.0 * U
            * match quantity {
                Quantity::Det => self.filter.det,
                Quantity::T => self.filter.t,
                // W is one determinant of rows D, L, M here: the bound of U and V is its.
                Quantity::U | Quantity::V | Quantity::W => self.filter.uv,
            }
    }

    fn exact(&self, quantity: Quantity) -> Expansion {
        Rows::<Expansion>::new(self.ray, self.triangle).determinant(quantity)
    }
}

impl<R: Real> Determinants for SlowStages<'_, R> {
    fn decided(&self, quantity: Quantity) -> Known {
        Known::decided(self.rows.determinant(quantity), self.bound(quantity), || self.exact(quantity))
    }
    fn measured(&self, quantity: Quantity) -> Known {
        Known::measured(self.rows.determinant(quantity), self.bound(quantity), || self.exact(quantity))
    }
}

/// `T` and `det`, whose quotient is `t` in the triangle's plane.
pub(crate) fn triangle_terms<R: Real, N: Ring>(ray: &Ray<R>, triangle: &Triangle<R>) -> (N, N) {
    let rows = Rows::<N>::new(ray, triangle);
    (rows.determinant(Quantity::T), rows.determinant(Quantity::Det))
}

/// `T`, a bound on its error, `det`, and a bound on its error.
pub(crate) fn triangle_terms_f64<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> (f64, f64, f64, f64) {
    let filter = TriangleFilter::of_triangle(ray, triangle);
    let (t, det) = triangle_terms::<R, f64>(ray, triangle);
    (t, filter.t, det, filter.det)
}

/// Whether both triangles lie in one plane, exactly: each one's vertices in the plane of the other.
///
/// A triangle without area has no plane and does not object (it is never hit either).
///
/// # Accuracy
///
/// Exact. A filter settles triangles that are clearly not coplanar; those that are take integers, or expansions.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::vec3;
/// let a = Triangle::<f32> { vertices: [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 1.0), vec3(0.0, 1.0, 1.0)] }; // z = x + y
/// let b = Triangle::<f32> { vertices: [vec3(5.0, 5.0, 10.0), vec3(6.0, 5.0, 11.0), vec3(5.0, 6.0, 11.0)] };
/// let c = Triangle::<f32> { vertices: [vec3(5.0, 5.0, 10.0), vec3(6.0, 5.0, 11.0), vec3(5.0, 6.0, 11.000001)] };
/// assert!(are_coplanar(&a, &b) && !are_coplanar(&a, &c));
/// ```
pub fn are_coplanar<R: Real>(a: &Triangle<R>, b: &Triangle<R>) -> bool {
    let in_plane = |plane: &Triangle<R>, triangle: &Triangle<R>| {
        triangle.vertices.iter().all(|vertex| orientation(plane, *vertex) == 0)
    };
    in_plane(a, b) && in_plane(b, a)
}

/// The side of the triangle's plane that `point` lies on, as -1, 0 or 1: the sign of `det(e2, s, e1)`, `s = point -
/// v0`.
fn orientation<R: Real>(triangle: &Triangle<R>, point: R::Vec3) -> i32 {
    // T of a ray from that point does not depend on the ray's direction.
    let ray = Ray::<R> { origin: point, direction: R::Vec3::new(R::ZERO, R::ZERO, R::ONE) };
    let filter = TriangleFilter::of_triangle(&ray, triangle);
    let t = Rows::<f64>::new(&ray, triangle).determinant(Quantity::T);
    let t = if t.abs() > filter.t {
        t
    } else {
        match IntegerRows::new(&ray, triangle) {
            Some(rows) => rows.decided(Quantity::T).value,
            None => SlowStages::new(&ray, triangle).decided(Quantity::T).value,
        }
    };
    i32::from(t > 0.0) - i32::from(t < 0.0)
}
