//! Ray and sphere, certified: a filter in f64, and behind it double-double and expansions.
//!
//! With `f = o - c`, `l = f x d`, `a = d.d`, `b = f.d`, `c = f.f - r^2`, `disc = r^2 a - l.l`:
//!
//! - there are roots exactly when `disc >= 0`;
//! - `t_in t_out = c / a` and `t_in + t_out = -2 b / a`: given roots, `t_out >= 0` exactly when `c <= 0` or `b <= 0`,
//!   and `t_in >= 0` exactly when `c >= 0` and `b <= 0`. Three signs make the verdict.
//!
//! # The filter's bounds, derived here
//!
//! - `l`: each of the six products rounds in f, in the product and in the difference, 3 u; as a vector the error is at
//!   most `3 u sqrt(2) |f||d| < 4.25 u |f||d|`, since the sum of the squares of `|f_i d_j|`, `i != j`, is at most
//!   `|f|^2 |d|^2`.
//! - `l.l`: from l, `2 * 4.25 u |f||d||l| + (4.25 u |f||d|)^2`; from the scalar product, `3 u |l|^2`.
//! - `r^2 a`: 5 roundings. The difference of the two: `u (r^2 a + |l|^2)`.
//! - `c`: `f.f` 5 roundings (f twice), `r^2` one, the difference one: `6 u f.f + 2 u r^2`; taken as `8 u (f.f + r^2)`.
//! - `b`: 4 roundings on `|f_i d_i|`: `4 u |f||d|`; taken as `8 u |f||d|`.
//!
//! So `disc` is within, and is taken to be within:
//!
//! ```text
//! with |l| <= |f||d| in all     6 u r^2 a + 12.5 u |f||d||l| + 19 u^2 |f|^2 |d|^2
//! without a root, |l| = |f||d|  8 u r^2 a + 26 u |f|^2 a
//! at a hit, |l| <= r|d|         8 u r^2 a + 16 u r a |f| + 64 u^2 |f|^2 a             (bounds the error of t)
//! everywhere, the computed l    8 u r^2 a + 24 u |f||d||l| + (32 u)^2 |f|^2 a
//! ```
//!
//! # The filter's miss, derived here
//!
//! Most tests are misses, and those need no `l`: `disc = b^2 - a c` is negative where `b^2 + r^2 a < |f|^2 a`. In units of
//! `u |f|^2 a`, and if the left is less than the right, `b^2` is within 9 (8 from b, its own rounding), `r^2 a` within 5
//! (`r^2`, 3 in `a`, the product), their sum within 1, `|f|^2 a` within 10 (5 in `f.f`, 3 in `a`, two products): 25 in all.
//! The right is made less by 32.
//!
//! # The error of a filter's t, derived here
//!
//! `q = -b -+ sqrt(disc)`, its sign that of `-b`, sums two numbers of one sign; `sqrt(disc)` is off by disc's error over
//! itself. It rounds (u), and so does the sum (u); then `t = q / a` divides by `a` (3 u), and `t = c / q` takes in the
//! error of `c`; either quotient rounds (u), which leaves 2 u for the bound itself. With `E` the error of `disc` at a
//! hit:
//!
//! ```text
//! |t - exact t| / t <= 8 u |f||d| / |q| + E / (root |q|) + (error of c) / |c| + 8 u
//! ```
//!
//! A *clear* hit spares the roots and quotients that this takes. It has `disc > 2^-10 r^2 a + 26 u |f|^2 a`, and is
//! well outside or well inside, `|c| > 2^-12 (f.f + r^2)`, or else `t = q / a`, which has no `c` in it:
//!
//! - the error of `c` is at most `8 u / 2^-12 = 2^-38` of it;
//! - well outside, `r < |f|`, and `b^2 = a c + disc` makes `|q| >= |b| > 2^-6.1 |f||d|`: the first term is below `2^-43`.
//!   `E < 27 u r |f| a`, since `26 u |f|^2 a < disc <= r^2 a`, and `root > 2^-5 r|d|`: the second is below `27 * 2^11.1 u <
//!   2^-37.1`;
//! - elsewhere `|f| < 1.001 r`, and `|q| >= root > 2^-5 r|d|`: the first term is below `2^-44`, the second below `25 *
//!   2^10 u < 2^-38`.
//!
//! In all at most `2^-37.1 + 2^-38 + 2^-43 + 8 u < 2^-36`, which is [`FILTER_ACCURACY`].
//!
//! # The double-double bounds
//!
//! With `8 u^2` a product and `3 u^2` a sum, `l` is within `11 sqrt(2) u^2 |f||d|`. In units of `u^2`:
//!
//! ```text
//!          derived                                            8 u times the filter's
//! disc     33 r^2 a +  49 |f||d||l| +  250 u^2 |f|^2 |d|^2    64 r^2 a + 192 |f||d||l| + 8192 u^2 |f|^2 |d|^2
//! c        17 f.f + 11 r^2                                    64 f.f + 64 r^2
//! b        14 |f||d|                                          64 |f||d|
//! ```

use crate::kernels::certified::FILTER_ACCURACY;
use crate::kernels::{Certified, Miss, Ray, Sphere, SphereHit, Start};
use crate::numbers::{Certificate, DoubleDouble, Expansion, Known, Real, Ring, Stage, U, Vector3, dot};

/// The hit of a ray and a sphere, the verdict and the choice of root exactly right for the stored numbers.
///
/// # Ranges
///
/// Numbers as in [`Certified`]. With [`Start::OnSurfaceInward`] only the far root counts, and whether it is there is
/// decided for the ray as stored.
///
/// # Accuracy
///
/// Verdict exact, tangents included. `t` as in [`Certified`]; `t_in` and `t_out` beside it are as good as the
/// stable form in f64 makes them. `t_error` is `2^-36 t` unless the hit is a grazing one or the origin next to the
/// surface. `cargo bench --bench kernels` prints the cost against the stable form; grazing rays and origins on the
/// surface, which the filter leaves open, cost many times as much.
///
/// # Source
///
/// The discriminant and the stable roots: Haines, Günther and Akenine-Möller 2019. Bounds and stages derived here (see
/// the head of this file).
///
/// # Example
///
/// A tangent is a hit, and one ulp further out is a miss:
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::vec3;
/// let sphere = Sphere::<f32> { center: vec3(0.0, 0.0, 0.0), radius: 1.0f32 };
/// let at = |y: f32| Ray::<f32> { origin: vec3(-5.0, y, 0.0), direction: vec3(1.0, 0.0, 0.0) };
/// assert_eq!(intersect_sphere_certified(&at(1.0), &sphere, Start::Anywhere).unwrap().t, 5.0);
/// assert!(intersect_sphere_certified(&at(1.0000001), &sphere, Start::Anywhere).is_err());
/// ```
#[inline(always)]
pub fn intersect_sphere_certified<R: Real>(
    ray: &Ray<R>,
    sphere: &Sphere<R>,
    start: Start,
) -> Result<Certified<SphereHit<R>>, Miss> {
    clear(ray, sphere, start, || unclear(ray, sphere, start))
}

/// Misses and hits that are clear at first sight; `otherwise` for the rest, in tail position, or the hot loop pays for it.
#[inline(always)]
fn clear<R: Real>(
    ray: &Ray<R>,
    sphere: &Sphere<R>,
    start: Start,
    otherwise: impl FnOnce() -> Result<Certified<SphereHit<R>>, Miss>,
) -> Result<Certified<SphereHit<R>>, Miss> {
    let vector = |v: R::Vec3| glam::DVec3::from_array(v.to_f64());
    let d = vector(ray.direction);
    let f = vector(ray.origin) - vector(sphere.center);
    let r = sphere.radius.to_f64();
    let (a, b, f_dot_f, r_sq) = (d.dot(d), f.dot(d), f.dot(f), r * r);
    let r_sq_a = r_sq * a;
    // |f|^2 a, less 32 u of it; the factor in front is the ray's.
    let f_sq_a = a * (1.0 - 32.0 * U) * f_dot_f;
    if b * b + r_sq_a < f_sq_a {
        return Err(Miss::NegativeDiscriminant);
    }
    // Only its square counts, and the compiler makes less of a detour of d x f than of f x d.
    let l = d.cross(f);
    let disc = r_sq_a - l.dot(l);
    if disc > CLEAR_DISC * r_sq_a + 26.0 * U * f_sq_a {
        let c = f_dot_f - r_sq;
        let clear_c = CLEAR_C * (f_dot_f + r_sq);
        let (outside, inside) = (c > clear_c, c < -clear_c);
        // Unless well inside, b^2 = disc + a c is more than 2^-12.1 |f|^2 a, and the sign of b is certain.
        if outside && b > 0.0 {
            return Err(Miss::Behind);
        }
        let near = outside && start == Start::Anywhere;
        let far = inside || (start == Start::OnSurfaceInward && b < 0.0);
        if near || far {
            let (t, hit) = Roots::new(a, b, c, disc).hit(near);
            return Ok(Certified { hit, t, t_error: FILTER_ACCURACY * t });
        }
    }
    otherwise()
}

/// The roots of `a t^2 + 2 b t + c`, of which `disc` is not negative, and what they were made of.
struct Roots {
    /// `sqrt(disc)`.
    root: f64,
    /// `-b -+ sqrt(disc)`, with the sign that does not cancel.
    q: f64,
    t_in: f64,
    t_out: f64,
}

impl Roots {
    #[inline(always)]
    fn new(a: f64, b: f64, c: f64, disc: f64) -> Self {
        let root = disc.sqrt();
        let q = if b < 0.0 { root - b } else { -b - root };
        let (t0, t1) = (q / a, c / q);
        let (t_in, t_out) = if b < 0.0 { (t1, t0) } else { (t0, t1) };
        Roots { root, q, t_in, t_out }
    }

    /// The near or the far one.
    #[inline(always)]
    fn hit<R: Real>(&self, near: bool) -> (f64, SphereHit<R>) {
        let t = if near { self.t_in } else { self.t_out };
        (t, SphereHit { t: R::from_f64(t), t_in: R::from_f64(self.t_in), t_out: R::from_f64(self.t_out) })
    }
}

/// A clear hit has `disc` above this times `r^2 a`, beyond the bound on its error ...
const CLEAR_DISC: f64 = 1.0 / 1024.0;

/// ... and `|c|` above this times `f.f + r^2`, where it matters.
const CLEAR_C: f64 = 1.0 / 4096.0;

/// The hit where it is not clear: the filter as far as its bounds carry, and then the exact stages.
#[cold]
#[inline(never)]
fn unclear<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Result<Certified<SphereHit<R>>, Miss> {
    filtered(ray, sphere, start).unwrap_or_else(|| KnownTerms::new(ray, sphere).hit(start))
}

/// What the filter says, if it can tell.
fn filtered<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Option<Result<Certified<SphereHit<R>>, Miss>> {
    let SphereTerms { a, b, c, disc } = SphereTerms::<f64>::new(ray, sphere);
    let vector = |v: R::Vec3| glam::DVec3::from_array(v.to_f64());
    let (f, r) = (vector(ray.origin) - vector(sphere.center), sphere.radius.to_f64());
    let (f_dot_f, r_sq) = (f.dot(f), r * r);
    let f_sq_a = f_dot_f * a;
    if disc > 8.0 * U * r_sq * a + 26.0 * U * f_sq_a {
        let c_bound = 8.0 * U * (f_dot_f + r_sq);
        let b_is_certain = b * b > 64.0 * U * U * f_sq_a;
        let (outside, inside) = (c > c_bound, c < -c_bound);
        if outside && b_is_certain && b > 0.0 {
            return Some(Err(Miss::Behind));
        }
        let near = outside && b_is_certain && start == Start::Anywhere;
        let far = inside || (start == Start::OnSurfaceInward && b_is_certain && b < 0.0);
        if near || far {
            let roots = Roots::new(a, b, c, disc);
            let (t, hit) = roots.hit(near);
            let Roots { root, q, .. } = roots;
            let f_length = f_dot_f.sqrt();
            let disc_error = 8.0 * U * r_sq * a + 16.0 * U * r * a * f_length + 64.0 * U * U * f_sq_a;
            let q_error_times_root = 8.0 * U * f_length * a.sqrt() * root + disc_error;
            // For b < 0 the far root is t0.
            let c_error = if near == (b < 0.0) { c_bound / c.abs() } else { 0.0 };
            let t_error = t * (q_error_times_root / (root * q.abs()) + c_error + 8.0 * U);
            if t_error <= FILTER_ACCURACY * t {
                return Some(Ok(Certified { hit, t, t_error }));
            }
        }
    }
    None
}

/// The hit of a ray and a sphere without any rounding in the verdict, by expansions alone: the filter's referee.
///
/// # Accuracy
///
/// Verdict exact, `t` within a few ulp.
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
/// let ray = Ray::<f64> { origin: dvec3(-5.0, 1.0, 0.0), direction: dvec3(1.0, 0.0, 0.0) };
/// let sphere = Sphere::<f64> { center: dvec3(0.0, 0.0, 0.0), radius: 1.0 };
/// assert_eq!(intersect_sphere_exact(&ray, &sphere, Start::Anywhere).unwrap().t, 5.0);
/// ```
pub fn intersect_sphere_exact<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Result<SphereHit<R>, Miss> {
    let terms = SphereTerms::<Expansion>::new(ray, sphere);
    let known = KnownTerms {
        a: Known::exact(&terms.a),
        b: Known::exact(&terms.b),
        c: Known::exact(&terms.c),
        disc: Known::exact(&terms.disc),
    };
    known.hit(start).map(|certified| certified.hit)
}

/// The terms of the quadratic.
pub(crate) struct SphereTerms<T> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) c: T,
    pub(crate) disc: T,
}

impl<T: Ring> SphereTerms<T> {
    #[inline(always)]
    pub(crate) fn new<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> Self {
        let (o, center) = (ray.origin.to_f64(), sphere.center.to_f64());
        let r = sphere.radius.to_f64();
        let d = ray.direction.to_f64().map(T::number);
        let f: [T; 3] = std::array::from_fn(|k| T::difference(o[k], center[k]));
        let l: [T; 3] = std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            f[i].clone() * d[j].clone() - f[j].clone() * d[i].clone()
        });
        let (a, r_sq) = (dot(&d, &d), T::product(r, r));
        SphereTerms { b: dot(&f, &d), c: dot(&f, &f) - r_sq.clone(), disc: r_sq * a.clone() - dot(&l, &l), a }
    }
}

/// The filter's bounds on the errors of the terms in f64.
pub(crate) struct SphereBounds {
    pub(crate) b: f64,
    pub(crate) c: f64,
    pub(crate) disc: f64,
}

impl SphereBounds {
    pub(crate) fn new<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> Self {
        let vector = |v: R::Vec3| glam::DVec3::from_array(v.to_f64());
        let (f, d) = (vector(ray.origin) - vector(sphere.center), vector(ray.direction));
        let (l, r) = (f.cross(d), sphere.radius.to_f64());
        let (a, f_dot_f, r_sq) = (d.dot(d), f.dot(f), r * r);
        let f_d = (f_dot_f * a).sqrt();
        SphereBounds {
            b: 8.0 * U * f_d,
            c: 8.0 * U * (f_dot_f + r_sq),
            disc: 8.0 * U * r_sq * a + 24.0 * U * f_d * l.dot(l).sqrt() + 1024.0 * U * U * f_dot_f * a,
        }
    }
}

/// The terms with exact signs and values good to a few ulp.
struct KnownTerms {
    a: Known,
    b: Known,
    c: Known,
    disc: Known,
}

impl KnownTerms {
    fn new<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> Self {
        let bounds = SphereBounds::new(ray, sphere);
        let rough = SphereTerms::<DoubleDouble>::new(ray, sphere);
        let exact = std::cell::OnceCell::new();
        let exact = || exact.get_or_init(|| SphereTerms::<Expansion>::new(ray, sphere));
        KnownTerms {
            // a is a sum of squares: within 14 u^2, relatively.
            a: Known { value: rough.a.hi, relative_error: 2.0 * U, stage: Stage::DoubleDouble },
            b: Known::measured(rough.b, 8.0 * U * bounds.b, || exact().b.clone()),
            c: Known::measured(rough.c, 8.0 * U * bounds.c, || exact().c.clone()),
            disc: Known::measured(rough.disc, 8.0 * U * bounds.disc, || exact().disc.clone()),
        }
    }

    fn hit<R: Real>(&self, start: Start) -> Result<Certified<SphereHit<R>>, Miss> {
        let (a, b, c, disc) = (self.a.value, self.b.value, self.c.value, self.disc.value);
        if disc < 0.0 {
            return Err(Miss::NegativeDiscriminant);
        }
        if c > 0.0 && b > 0.0 {
            return Err(Miss::Behind);
        }
        let near = c >= 0.0 && b <= 0.0 && start == Start::Anywhere;
        let mut roots = Roots::new(a, b, c, disc);
        if roots.q == 0.0 {
            // A tangent at the origin.
            (roots.t_in, roots.t_out) = (0.0, 0.0);
        }
        // The sums turn -0 into 0.
        (roots.t_in, roots.t_out) = (roots.t_in + 0.0, roots.t_out + 0.0);
        let (t, hit) = roots.hit(near);
        // q sums two numbers of one sign, so its relative error is at most the larger of theirs, and the root halves
        // that of disc. The rest is a handful of roundings: the root, the sum, the quotient, 2 u in a.
        let t_error = t * (self.b.relative_error + self.c.relative_error + self.disc.relative_error + 8.0 * U);
        Ok(Certified { hit, t, t_error })
    }
}

/// Which stage decides this ray and sphere, hit or miss: the dearest that any sign on the way to the verdict calls for.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::Stage;
/// # use glam::dvec3;
/// let sphere = Sphere::<f64> { center: dvec3(0.0, 0.0, 0.0), radius: 1.0 };
/// let stage = |y| {
///     let ray = Ray::<f64> { origin: dvec3(-5.0, y, 0.0), direction: dvec3(1.0, 0.0, 0.0) };
///     sphere_stage(&ray, &sphere, Start::Anywhere)
/// };
/// assert_eq!([0.5, 1.0, 1.5].map(stage), [Stage::Filter, Stage::Expansion, Stage::Filter]);
/// ```
pub fn sphere_stage<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Stage {
    let mut is_unclear = false;
    let _ = clear(ray, sphere, start, || {
        is_unclear = true;
        Err(Miss::NegativeDiscriminant)
    });
    if !is_unclear || filtered(ray, sphere, start).is_some() {
        return Stage::Filter;
    }
    let KnownTerms { b, c, disc, .. } = KnownTerms::new(ray, sphere);
    if disc.value < 0.0 {
        return disc.stage;
    }
    // Inside, or on the surface and going in, b says nothing.
    let b_matters = if start == Start::Anywhere { c.value >= 0.0 } else { c.value > 0.0 };
    disc.stage.max(c.stage).max(if b_matters { b.stage } else { Stage::Filter })
}

/// How a *hit* of this ray and sphere was decided.
///
/// The margin is the smallest of the terms over their bounds, counting those whose sign matters: `disc` always; for a
/// ray from anywhere `c` (inside or outside), and `b` unless the origin is inside; for a ray that starts on the sphere
/// and goes in, `b` or `c`, whichever says so more clearly.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::Stage;
/// # use glam::dvec3;
/// let sphere = Sphere::<f64> { center: dvec3(0.0, 0.0, 0.0), radius: 1.0 };
/// let tangent = Ray::<f64> { origin: dvec3(-5.0, 1.0, 0.0), direction: dvec3(1.0, 0.0, 0.0) };
/// let certificate = certify_sphere(&tangent, &sphere, Start::Anywhere);
/// assert_eq!((certificate.stage, certificate.margin), (Stage::Expansion, 0.0));
/// ```
pub fn certify_sphere<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>, start: Start) -> Certificate {
    let bounds = SphereBounds::new(ray, sphere);
    let rough = SphereTerms::<f64>::new(ray, sphere);
    let known = KnownTerms::new(ray, sphere);
    let certificate = |rough: f64, known: Known, bound: f64| {
        // A bound of zero: every product is zero, and so is the value.
        let margin = |x: f64| if bound > 0.0 { x.abs() / bound } else { 0.0 };
        if margin(rough) > 1.0 {
            Certificate { stage: Stage::Filter, margin: margin(rough) }
        } else {
            Certificate::after_filter(known.stage, margin(known.value))
        }
    };
    let disc = certificate(rough.disc, known.disc, bounds.disc);
    let (b, c) = (certificate(rough.b, known.b, bounds.b), certificate(rough.c, known.c, bounds.c));
    let both =
        |x: Certificate, y: Certificate| Certificate { stage: x.stage.max(y.stage), margin: x.margin.min(y.margin) };
    match start {
        Start::Anywhere if known.c.value < 0.0 => both(disc, c),
        Start::Anywhere => both(disc, both(b, c)),
        Start::OnSurfaceInward if known.c.value > 0.0 => both(disc, b),
        Start::OnSurfaceInward if known.b.value > 0.0 => both(disc, c),
        Start::OnSurfaceInward => both(disc, if b.margin > c.margin { b } else { c }),
    }
}
