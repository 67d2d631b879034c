//! Ray and plane in Hesse normal form.

use crate::kernels::certified::FILTER_ACCURACY;
use crate::kernels::{Certified, Miss, Ray};
use crate::numbers::{Certificate, DoubleDouble, Expansion, Known, Real, Ring, Stage, U, Vector3};

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
///
/// # Accuracy
///
/// None to rely on where a scalar product cancels: a ray that is parallel but for rounding, an origin far out near the
/// plane.
///
/// # Source
///
/// `p = o + t d` put into `p.n - D = 0`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.0, 3.0, 0.0), direction: dvec3(1.0, -2.0, 0.0) };
/// let floor = Plane::<f64> { normal: dvec3(0.0, 1.0, 0.0), distance: 1.0 };
/// assert_eq!(intersect_plane_lecture(&ray, &floor), Ok(PlaneHit { t: 1.0 }));
/// ```
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

/// Every intermediate value of [`intersect_plane_lecture`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneValues<R> {
    /// `n . d`; zero for a parallel ray.
    pub n_dot_d: R,
    /// `n . o`.
    pub n_dot_o: R,
    /// `(D - n . o) / (n . d)`.
    pub t: R,
}

/// The intermediate values of [`intersect_plane_lecture`], to the same bits.
pub fn plane_values<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> PlaneValues<R> {
    let n_dot_d = plane.normal.dot(ray.direction);
    let n_dot_o = plane.normal.dot(ray.origin);
    PlaneValues { n_dot_d, n_dot_o, t: (plane.distance - n_dot_o) / n_dot_d }
}

/// The hit of a ray and a plane, the verdict exactly right for the stored numbers.
///
/// # Accuracy
///
/// Verdict exact; a ray in the plane is a miss. `t` as in [`Certified`]. `cargo bench --bench kernels` prints the cost
/// against the lecture's form; rays that are parallel to the plane or start in it cost many times as much.
///
/// # Source
///
/// Bounds derived here. `n . d` rounds each of three products once and adds twice, so it is within `3 u (|n_x d_x| +
/// ...)`; `D - n . o` has one rounding more and one term more, `4 u (|D| + |n_x o_x| + ...)`. The filter takes 4 and 5.
///
/// # Example
///
/// 0.6 and 0.8 are rounded, but the products 0.6 x 0.8 cancel exactly: this ray is parallel.
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::vec3;
/// let ray = Ray::<f32> { origin: vec3(0.0, 1.0, 0.0), direction: vec3(0.8, -0.6, 0.0) };
/// let plane = Plane::<f32> { normal: vec3(0.6, 0.8, 0.0), distance: 0.0 };
/// assert_eq!(intersect_plane_certified(&ray, &plane), Err(Miss::Parallel));
/// ```
#[inline(always)]
pub fn intersect_plane_certified<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Result<Certified<PlaneHit<R>>, Miss> {
    filtered(ray, plane, || undecided(ray, plane))
}

/// What the filter says; `otherwise` where it cannot tell, in tail position, or the hot loop pays for it.
#[inline(always)]
fn filtered<R: Real>(
    ray: &Ray<R>,
    plane: &Plane<R>,
    otherwise: impl FnOnce() -> Result<Certified<PlaneHit<R>>, Miss>,
) -> Result<Certified<PlaneHit<R>>, Miss> {
    let PlaneFilter { n_dot_d, n_dot_d_error, height, height_error } = PlaneFilter::new(ray, plane);
    if n_dot_d.abs() > n_dot_d_error && height.abs() > height_error {
        let t = height / n_dot_d;
        if t < 0.0 {
            return Err(Miss::Behind);
        }
        let t_error = quotient_error(height_error, t, n_dot_d, n_dot_d_error);
        if t_error <= FILTER_ACCURACY * t {
            return Ok(Certified { hit: PlaneHit { t: R::from_f64(t) }, t, t_error });
        }
    }
    otherwise()
}

/// A bound on the error of `t = n / d` where `n` is within `n_error` and `d` within `d_error` of the true ones:
/// `n'/d' - n/d = (t' (d - d') + n' - n) / d`, and the quotient rounds once more. Infinite where `d` may be zero.
#[inline(always)]
pub(crate) fn quotient_error(n_error: f64, t: f64, d: f64, d_error: f64) -> f64 {
    let smallest = d.abs() - d_error;
    if smallest > 0.0 { (n_error + t.abs() * d_error) / smallest + 2.0 * U * t.abs() } else { f64::INFINITY }
}

/// Numerator and denominator of `t` in f64, with bounds on their errors.
pub(crate) struct PlaneFilter {
    pub(crate) n_dot_d: f64,
    pub(crate) n_dot_d_error: f64,
    /// `D - n . o`.
    pub(crate) height: f64,
    pub(crate) height_error: f64,
}

impl PlaneFilter {
    #[inline(always)]
    pub(crate) fn new<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Self {
        let (o, d) = (ray.origin.to_f64(), ray.direction.to_f64());
        let (n, distance) = (plane.normal.to_f64(), plane.distance.to_f64());
        let sum = |f: &dyn Fn(usize) -> f64| f(0) + f(1) + f(2);
        PlaneFilter {
            n_dot_d: sum(&|k| n[k] * d[k]),
            n_dot_d_error: 4.0 * U * sum(&|k| (n[k] * d[k]).abs()),
            height: distance - sum(&|k| n[k] * o[k]),
            height_error: 5.0 * U * (sum(&|k| (n[k] * o[k]).abs()) + distance.abs()),
        }
    }
}

/// `n . d` and `D - n . o`.
pub(crate) fn plane_terms<R: Real, T: Ring>(ray: &Ray<R>, plane: &Plane<R>) -> (T, T) {
    let (o, d) = (ray.origin.to_f64(), ray.direction.to_f64());
    let n = plane.normal.to_f64();
    let dot = |v: [f64; 3]| T::product(n[0], v[0]) + T::product(n[1], v[1]) + T::product(n[2], v[2]);
    (dot(d), T::number(plane.distance.to_f64()) - dot(o))
}

/// Both terms with exact signs.
///
/// The double-double bound: the products are exact, and each of the two or three sums adds `3 u^2` of the magnitudes:
/// `6 u^2` and `9 u^2` of the sums of magnitudes. `8 u` times the filter's bounds is `32 u^2` and `40 u^2`.
fn known_terms<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> (Known, Known) {
    let filter = PlaneFilter::new(ray, plane);
    let (n_dot_d, height) = plane_terms::<R, DoubleDouble>(ray, plane);
    (
        Known::measured(n_dot_d, 8.0 * U * filter.n_dot_d_error, || plane_terms::<R, Expansion>(ray, plane).0),
        Known::measured(height, 8.0 * U * filter.height_error, || plane_terms::<R, Expansion>(ray, plane).1),
    )
}

#[cold]
#[inline(never)]
fn undecided<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Result<Certified<PlaneHit<R>>, Miss> {
    let (n_dot_d, height) = known_terms(ray, plane);
    if n_dot_d.value == 0.0 {
        return Err(Miss::Parallel);
    }
    if height.value != 0.0 && (height.value < 0.0) != (n_dot_d.value < 0.0) {
        return Err(Miss::Behind);
    }
    let t = (height.value / n_dot_d.value).abs();
    let t_error = t * (height.relative_error + n_dot_d.relative_error + 4.0 * U);
    Ok(Certified { hit: PlaneHit { t: R::from_f64(t) }, t, t_error })
}

/// Which stage decides this ray and plane, hit or miss: the dearest that either of the two signs calls for.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::Stage;
/// # use glam::dvec3;
/// let floor = Plane::<f64> { normal: dvec3(0.0, 1.0, 0.0), distance: 1.0 };
/// let along = Ray::<f64> { origin: dvec3(0.0, 3.0, 0.0), direction: dvec3(1.0, 0.0, 0.0) };
/// assert_eq!(plane_stage(&along, &floor), Stage::Expansion); // n . d is exactly 0
/// ```
pub fn plane_stage<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Stage {
    let mut is_open = false;
    let _ = filtered(ray, plane, || {
        is_open = true;
        Err(Miss::Parallel)
    });
    if !is_open {
        return Stage::Filter;
    }
    let (n_dot_d, height) = known_terms(ray, plane);
    if n_dot_d.value == 0.0 { n_dot_d.stage } else { n_dot_d.stage.max(height.stage) }
}

/// How a *hit* of this ray and plane was decided.
///
/// The margin is the smaller of `|n . d|` and `|D - n . o|` over their bounds.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::Stage;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.0, 3.0, 0.0), direction: dvec3(1.0, -2.0, 0.0) };
/// let floor = Plane::<f64> { normal: dvec3(0.0, 1.0, 0.0), distance: 1.0 };
/// assert_eq!(certify_plane(&ray, &floor).stage, Stage::Filter);
/// ```
pub fn certify_plane<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> Certificate {
    let filter = PlaneFilter::new(ray, plane);
    // An error bound of zero: every term is zero, and so is the value.
    let ratio = |x: f64, bound: f64| if bound > 0.0 { x.abs() / bound } else { 0.0 };
    let margin_of =
        |n_dot_d: f64, height: f64| ratio(n_dot_d, filter.n_dot_d_error).min(ratio(height, filter.height_error));
    let margin = margin_of(filter.n_dot_d, filter.height);
    if margin > 1.0 {
        return Certificate { stage: Stage::Filter, margin };
    }
    let (n_dot_d, height) = known_terms(ray, plane);
    Certificate::after_filter(n_dot_d.stage.max(height.stage), margin_of(n_dot_d.value, height.value))
}
