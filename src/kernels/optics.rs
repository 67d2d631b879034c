//! Reflection, refraction and Fresnel reflectance.
//!
//! Snell's law has a transmitted direction as long as `n_i sin(i) <= n_t`. For a stored direction `d` and normal `n`,
//! of any length, that is the sign of
//!
//! ```text
//! S = n_t^2 |d|^2 |n|^2 - n_i^2 (|d|^2 |n|^2 - (d.n)^2)        S < 0: total reflection
//! ```
//!
//! and the transmitted cosine is `sqrt(S) / (n_t |d| |n|)`.
//!
//! # Bounds, derived here
//!
//! With `P = |d|^2 |n|^2`. In f64: each square of a length 3 roundings, P 7, `n_t^2 P` 9; `d.n` is within
//! `3 u |d||n|`, its square within `7 u P`, the bracket within `15 u P`, times `n_i^2` within `17 u n_i^2 P`; the
//! difference rounds by `u` of at most `(n_t^2 + n_i^2) P`: `10 u n_t^2 P + 18 u n_i^2 P`. Taken as
//! `24 u (n_t^2 + n_i^2) P`. In double-double, with 8 u^2 a product and 3 u^2 a sum, the same count gives
//! `31 u^2 n_t^2 P + 57 u^2 n_i^2 P`, and `8 u` times the filter's bound is `192 u^2` of each.

use crate::numbers::{Certificate, DoubleDouble, Expansion, Known, Real, Ring, Stage, U, Vector3, dot};

/// The direction `d - 2 (d . n) n`: `d` mirrored at the plane with unit normal `n`.
///
/// # Ranges
///
/// `n` is unit, on either side. The length of `d` is kept as well as that of `n` is 1, without renormalising.
///
/// # Source
///
/// The lecture; twice the projection of `d` on `n`, taken off.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::reflect;
/// # use glam::dvec3;
/// assert_eq!(reflect::<f64>(dvec3(3.0, -4.0, 0.0), dvec3(0.0, 1.0, 0.0)), dvec3(3.0, 4.0, 0.0));
/// ```
#[inline(always)]
pub fn reflect<R: Real>(d: R::Vec3, n: R::Vec3) -> R::Vec3 {
    d - n * (R::TWO * d.dot(n))
}

/// `S` in any arithmetic.
fn transmission<R: Real, T: Ring>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> T {
    let (d, n) = (d.to_f64().map(T::number), n.to_f64().map(T::number));
    let (incident, transmitted) = (incident.to_f64(), transmitted.to_f64());
    let lengths_sq = dot(&d, &d) * dot(&n, &n);
    let d_dot_n = dot(&d, &n);
    T::product(transmitted, transmitted) * lengths_sq.clone()
        - T::product(incident, incident) * (lengths_sq - d_dot_n.clone() * d_dot_n)
}

/// The bound on the error of `S` in f64.
fn transmission_bound<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> f64 {
    let (d, n) = (d.to_f64(), n.to_f64());
    let (incident, transmitted) = (incident.to_f64(), transmitted.to_f64());
    24.0 * U * (transmitted * transmitted + incident * incident) * (dot(&d, &d) * dot(&n, &n))
}

/// `S` from double-double, or exactly, with a value good to a few ulp.
fn known_transmission<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Known {
    let bound = 8.0 * U * transmission_bound(d, n, incident, transmitted);
    Known::measured(transmission::<R, DoubleDouble>(d, n, incident, transmitted), bound, || {
        transmission::<R, Expansion>(d, n, incident, transmitted)
    })
}

/// `S`, whose sign decides whether light passes the boundary: the sign exact, the value rounded once or nearly so. What the
/// refracted direction and the cosines are worked out from.
pub(crate) fn refraction_sign<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> f64 {
    known_transmission(d, n, incident, transmitted).value
}

/// Whether all light is reflected at this boundary, exactly for the stored direction, normal and indices.
///
/// # Ranges
///
/// `d` and `n` of any length but zero; indices of refraction above zero. Numbers as in
/// [`Certified`](crate::kernels::Certified).
///
/// # Accuracy
///
/// Exact; the critical angle itself transmits (along the surface). From the rounded cosine the usual form is wrong in
/// one case of six within a few ulp of that angle.
///
/// # Source
///
/// Snell's law, squared so that nothing is divided and no root is taken; the bounds are derived at the head of this
/// file.
///
/// # Example
///
/// The angle with sine 3/5, from index 5/3 or the f64 next to it:
///
/// ```
/// # use raytree::kernels::optics::is_total_reflection;
/// # use glam::dvec3;
/// let (d, n) = (dvec3(3.0, -4.0, 0.0), dvec3(0.0, 1.0, 0.0));
/// assert!(!is_total_reflection::<f64>(d, n, 5.0, 3.0)); // 5 sin = 3 sin 90 degrees
/// assert!(is_total_reflection::<f64>(d, n, 5.000000000000001, 3.0));
/// ```
pub fn is_total_reflection<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> bool {
    let s: f64 = transmission(d, n, incident, transmitted);
    if s.abs() > transmission_bound(d, n, incident, transmitted) {
        return s < 0.0;
    }
    known_transmission(d, n, incident, transmitted).value < 0.0
}

/// How [`is_total_reflection`] was decided: the margin is `|S|` over its bound.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::certify_total_reflection;
/// # use raytree::numbers::{Certificate, Stage};
/// # use glam::dvec3;
/// let (d, n) = (dvec3(3.0, -4.0, 0.0), dvec3(0.0, 1.0, 0.0));
/// let at_the_angle = certify_total_reflection::<f64>(d, n, 5.0, 3.0);
/// assert_eq!(at_the_angle, Certificate { stage: Stage::Expansion, margin: 0.0 });
/// ```
pub fn certify_total_reflection<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Certificate {
    let bound = transmission_bound(d, n, incident, transmitted);
    let s: f64 = transmission(d, n, incident, transmitted);
    let margin = |s: f64| if bound > 0.0 { s.abs() / bound } else { 0.0 };
    if margin(s) > 1.0 {
        return Certificate { stage: Stage::Filter, margin: margin(s) };
    }
    let known = known_transmission(d, n, incident, transmitted);
    Certificate::after_filter(known.stage, margin(known.value))
}

/// The transmitted direction, or nothing at total reflection.
///
/// # Ranges
///
/// `n` is the unit normal against `d` (`d . n <= 0`; one along `d` counts as turned round); indices of refraction
/// above zero. The result has the length of `d`, without renormalising. At equal indices, and straight along the
/// normal, it is `d` bit for bit. Never NaN.
///
/// # None when
///
/// [`is_total_reflection`].
///
/// # Accuracy
///
/// Each component is within `16 u (eta + 1) |d|` of that for the stored `n` scaled to unit length, `eta = n_i / n_t`,
/// `u` = 2^-53; in f32 it is then rounded once. Its part along the normal is a difference, off by that much too, so at
/// the critical angle take the cosine from [`refraction_cosines`], not from here.
///
/// # Source
///
/// Snell's law: `eta d + (eta cos_i - cos_t) n`. Multiplying the difference of cosines by their sum leaves
/// `eta cos_i - cos_t = (n_i^2 - n_t^2) |d|^2 / (n_t (n_i |d.n| + sqrt(S)))`, which does not cancel. Derived here.
///
/// # Example
///
/// Sine 3/5 outside, index 5/4 inside: sine 12/25, cosine sqrt(481)/25.
///
/// ```
/// # use raytree::kernels::optics::refract;
/// # use glam::dvec3;
/// let t = refract::<f64>(dvec3(0.6, -0.8, 0.0), dvec3(0.0, 1.0, 0.0), 1.0, 1.25).unwrap();
/// assert!((t.x - 12.0 / 25.0).abs() < 1e-16 && (t.y + 481f64.sqrt() / 25.0).abs() < 2e-16);
/// ```
pub fn refract<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Option<R::Vec3> {
    if incident == transmitted {
        return Some(d);
    }
    let s = known_transmission(d, n, incident, transmitted).value;
    if s < 0.0 { None } else { Some(refracted::<R>(d, n, incident, transmitted, s)) }
}

/// [`refract`] and [`refraction_cosines`] in one, the cosines in f64: what decides both is worked out once.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::{refract, refract_with_cosines, refraction_cosines};
/// # use glam::dvec3;
/// let (d, n) = (dvec3(0.6, -0.8, 0.0), dvec3(0.0, 1.0, 0.0));
/// let (direction, cosines) = refract_with_cosines::<f64>(d, n, 1.0, 1.25).unwrap();
/// assert_eq!(Some(direction), refract::<f64>(d, n, 1.0, 1.25));
/// assert_eq!(Some(cosines), refraction_cosines::<f64>(d, n, 1.0, 1.25));
/// ```
pub fn refract_with_cosines<R: Real>(
    d: R::Vec3,
    n: R::Vec3,
    incident: R,
    transmitted: R,
) -> Option<(R::Vec3, [f64; 2])> {
    let [cos_incident, lengths] = incident_cosine::<R>(d, n);
    if incident == transmitted {
        return Some((d, [cos_incident, cos_incident]));
    }
    let s = known_transmission(d, n, incident, transmitted).value;
    if s < 0.0 {
        return None;
    }
    let cos_transmitted = (s.sqrt() / transmitted.to_f64() / lengths).smaller(1.0);
    Some((refracted::<R>(d, n, incident, transmitted, s), [cos_incident, cos_transmitted]))
}

/// The refracted direction where `S` is not negative.
fn refracted<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R, s: f64) -> R::Vec3 {
    let (wide_d, wide_n) = (glam::DVec3::from_array(d.to_f64()), glam::DVec3::from_array(n.to_f64()));
    let (n_i, n_t) = (incident.to_f64(), transmitted.to_f64());
    let d_dot_n = wide_d.dot(wide_n);
    let denominator = n_t * (n_i * d_dot_n.abs() + s.sqrt());
    let along_normal = wide_d.cross(wide_n) == glam::DVec3::ZERO;
    // A denominator of zero would need a direction or a normal of zero.
    if along_normal || !(denominator > 0.0) {
        return d;
    }
    let against = if d_dot_n > 0.0 { -1.0 } else { 1.0 };
    let along = against * ((n_i - n_t) * (n_i + n_t) * wide_d.dot(wide_d)) / denominator;
    R::Vec3::from_f64((wide_d * (n_i / n_t) + wide_n * along).to_array())
}

/// The cosine of incidence, and `|d| |n|`.
fn incident_cosine<R: Real>(d: R::Vec3, n: R::Vec3) -> [f64; 2] {
    let (wide_d, wide_n) = (glam::DVec3::from_array(d.to_f64()), glam::DVec3::from_array(n.to_f64()));
    let lengths = (wide_d.dot(wide_d) * wide_n.dot(wide_n)).sqrt();
    // Rounding must not take a cosine beyond 1; smaller() also turns 0 / 0, for a direction of zero, into 1.
    [(wide_d.dot(wide_n).abs() / lengths).smaller(1.0), lengths]
}

/// The cosines of incidence and of transmission, `[cos_i, cos_t]`, what [`fresnel_exact`] wants; or nothing at total
/// reflection.
///
/// # Ranges
///
/// As [`refract`], but `d` and `n` may have any length and `n` may be on either side. Both cosines are in [0, 1].
///
/// # None when
///
/// [`is_total_reflection`].
///
/// # Accuracy
///
/// `cos_i` is within 8 u absolutely, `u` = 2^-53; `cos_t` within 40 u relatively, at the critical angle too (`S` is
/// good to 2^-48, its root to half of that). In f32 both are then rounded once.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::refraction_cosines;
/// # use glam::dvec3;
/// let cosines = refraction_cosines::<f64>(dvec3(3.0, -4.0, 0.0), dvec3(0.0, 1.0, 0.0), 5.0, 3.0);
/// assert_eq!(cosines, Some([0.8, 0.0])); // the critical angle
/// ```
pub fn refraction_cosines<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Option<[R; 2]> {
    refract_with_cosines(d, n, incident, transmitted).map(|(_, cosines)| cosines.map(R::from_f64))
}

/// The transmitted cosine as usually written, `sqrt(1 - eta^2 (1 - c^2))`, or nothing at total reflection.
///
/// # Ranges
///
/// `eta = n_i / n_t`, `cos_incident` in [0, 1].
///
/// # Accuracy
///
/// None to rely on near the critical angle: within four ulp of it about a quarter of the verdicts are wrong, in f32
/// and in f64.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::transmitted_cosine_usual;
/// assert_eq!(transmitted_cosine_usual(1.25, 0.6), Some(0.0)); // sine 4/5 times 5/4
/// assert_eq!(transmitted_cosine_usual(1.25, 0.5), None);
/// ```
#[inline(always)]
pub fn transmitted_cosine_usual<R: Real>(eta: R, cos_incident: R) -> Option<R> {
    let k = R::ONE - eta * eta * (R::ONE - cos_incident * cos_incident);
    if k >= R::ZERO { Some(k.sqrt()) } else { None }
}

/// The transmitted direction as usually written, with the two cosines, or nothing at total reflection.
///
/// # Ranges
///
/// As [`refract`].
///
/// # Accuracy
///
/// That of [`transmitted_cosine_usual`], on a cosine that is rounded before it is squared. At equal indices most
/// directions change in their last bits.
///
/// # Source
///
/// Snell's law as in the lecture: `eta d + (eta cos_i - cos_t) n`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::refract_usual;
/// # use glam::dvec3;
/// let (t, [_, cosine]) = refract_usual::<f64>(dvec3(0.6, -0.8, 0.0), dvec3(0.0, 1.0, 0.0), 1.0, 1.25).unwrap();
/// assert!((cosine - 481f64.sqrt() / 25.0).abs() < 1e-15 && (t.x - 12.0 / 25.0).abs() < 1e-15);
/// ```
pub fn refract_usual<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Option<(R::Vec3, [R; 2])> {
    let (eta, length) = (incident / transmitted, d.dot(d).sqrt());
    let cos_incident = (-d.dot(n) / length).larger(R::ZERO).smaller(R::ONE);
    let cos_transmitted = transmitted_cosine_usual(eta, cos_incident)?;
    let direction = d * eta + n * ((eta * cos_incident - cos_transmitted) * length);
    Some((direction, [cos_incident, cos_transmitted]))
}

/// The transmitted cosine, or nothing exactly at total reflection for these two numbers.
///
/// # Ranges
///
/// `eta = n_i / n_t > 0`; a `cos_incident` above 1, out of a rounded scalar product, counts as 1.
///
/// # Accuracy
///
/// Verdict exact. The cosine is within 4 u of the true one relatively in f64, and rounded once more in f32.
///
/// # Source
///
/// `k = (eta c)^2 - (eta - 1)(eta + 1)`, which cancels less than the usual form; derived here. Every operand is exact
/// in double-double, so k is within `8 + 8 + 3` times `u^2` of `(eta c)^2` or `|eta^2 - 1|`; taken as `64 u^2`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::transmitted_cosine;
/// assert_eq!(transmitted_cosine(1.25, 0.75), Some(0.31640625f64.sqrt())); // 0.9375^2 - 0.25 * 2.25
/// assert_eq!(transmitted_cosine(1.0, 0.25), Some(0.25));
/// assert_eq!(transmitted_cosine(1.25, 0.5), None);
/// ```
pub fn transmitted_cosine<R: Real>(eta: R, cos_incident: R) -> Option<R> {
    let (eta, c) = (eta.to_f64(), cos_incident.smaller(R::ONE).to_f64());
    fn k<T: Ring>(eta: f64, c: f64) -> (T, T) {
        let eta_c = T::product(eta, c);
        (eta_c.clone() * eta_c, T::difference(eta, 1.0) * T::difference(eta, -1.0))
    }
    let (square, rest) = k::<DoubleDouble>(eta, c);
    let bound = 64.0 * U * U * (square.hi + rest.hi.abs());
    let k = Known::measured(square - rest, bound, || {
        let (square, rest) = k::<Expansion>(eta, c);
        square - rest
    });
    if k.value < 0.0 { None } else { Some(R::from_f64(k.value.sqrt())) }
}

/// The share of unpolarised light that a boundary reflects, in [0, 1].
///
/// # Ranges
///
/// `cos_incident` and `cos_transmitted` are the cosines to the normal on either side, `>= 0`. Equal indices reflect
/// nothing; at a grazing angle (`cos_incident = 0`) it is 1. What is not reflected, `1 - R`, is transmitted.
///
/// # Source
///
/// Fresnel's equations for a dielectric: the mean of the squared amplitudes of both polarisations.
///
/// # Example
///
/// Glass seen straight on:
///
/// ```
/// # use raytree::kernels::optics::fresnel_exact;
/// assert!((fresnel_exact(1.0, 1.0, 1.0, 1.5) - 0.04f64).abs() < 1e-16); // (0.5 / 2.5)^2
/// assert_eq!(fresnel_exact(0.0, 0.745, 1.0, 1.5), 1.0);
/// ```
#[inline(always)]
pub fn fresnel_exact<R: Real>(cos_incident: R, cos_transmitted: R, incident: R, transmitted: R) -> R {
    if incident == transmitted {
        return R::ZERO;
    }
    let (ni_ci, nt_ct) = (incident * cos_incident, transmitted * cos_transmitted);
    let (nt_ci, ni_ct) = (transmitted * cos_incident, incident * cos_transmitted);
    // |a - b| <= a + b holds after rounding too, so both quotients stay within [-1, 1]. Both cosines zero: as grazing.
    let amplitude = |a: R, b: R| if a + b > R::ZERO { (a - b) / (a + b) } else { R::ONE };
    let s = amplitude(ni_ci, nt_ct);
    let p = amplitude(nt_ci, ni_ct);
    (s * s + p * p) / R::TWO
}

/// Schlick's approximation of the Fresnel reflectance, in [0, 1].
///
/// # Ranges
///
/// As [`fresnel_exact`]. The cosine that counts is that on the side of the smaller index.
///
/// # Accuracy
///
/// An approximation of the equations, not of their rounding: off by up to a few hundredths for glass.
///
/// # Source
///
/// Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994: `r0 + (1 - r0) (1 - cos)^5`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::optics::fresnel_schlick;
/// assert_eq!(fresnel_schlick(0.5, 0.9, 1.0, 3.0), 0.25 + 0.75 / 32.0); // r0 = (2/4)^2
/// ```
#[inline(always)]
pub fn fresnel_schlick<R: Real>(cos_incident: R, cos_transmitted: R, incident: R, transmitted: R) -> R {
    let r = (incident - transmitted) / (incident + transmitted);
    let r0 = r * r;
    // A cosine above 1 out of a rounded scalar product counts as 1.
    let x = (R::ONE - if incident <= transmitted { cos_incident } else { cos_transmitted }).larger(R::ZERO);
    let x2 = x * x;
    r0 + (R::ONE - r0) * (x2 * x2 * x)
}
