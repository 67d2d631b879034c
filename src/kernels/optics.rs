//! Reflection, refraction and Fresnel reflectance.

use crate::numbers::{Real, Vector3};

/// The direction `d - 2 (d . n) n`: `d` mirrored at the plane with unit normal `n`. Keeps the length of `d`.
#[inline(always)]
pub fn reflect<R: Real>(d: R::Vec3, n: R::Vec3) -> R::Vec3 {
    d - n * (R::TWO * d.dot(n))
}

/// The transmitted direction, or nothing at total internal reflection. Keeps the length of `d`.
///
/// `n` is unit and against `d` (`d . n <= 0`); `incident` and `transmitted` are the indices of refraction on both sides.
#[inline(always)]
pub fn refract<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Option<R::Vec3> {
    if incident == transmitted {
        return Some(d);
    }
    let eta = incident / transmitted;
    let eta_cos = eta * -d.dot(n);
    let k = eta_cos * eta_cos - (eta - R::ONE) * (eta + R::ONE) * d.dot(d);
    if !(k >= R::ZERO) {
        return None;
    }
    Some(d * eta + n * (eta_cos - k.sqrt()))
}

/// The share of unpolarised light that a boundary reflects (Fresnel's equations), in [0, 1].
///
/// `cos_incident` and `cos_transmitted` are the cosines to the normal on either side.
#[inline(always)]
pub fn fresnel_exact<R: Real>(cos_incident: R, cos_transmitted: R, incident: R, transmitted: R) -> R {
    let (ni_ci, nt_ct) = (incident * cos_incident, transmitted * cos_transmitted);
    let (nt_ci, ni_ct) = (transmitted * cos_incident, incident * cos_transmitted);
    if incident == transmitted {
        return R::ZERO;
    }
    let s = (ni_ci - nt_ct) / (ni_ci + nt_ct);
    let p = (nt_ci - ni_ct) / (nt_ci + ni_ct);
    (s * s + p * p) / R::TWO
}

/// Schlick's approximation of the Fresnel reflectance, in [0, 1]. The cosine is that on the side of the smaller index.
#[inline(always)]
pub fn fresnel_schlick<R: Real>(cos_incident: R, cos_transmitted: R, incident: R, transmitted: R) -> R {
    let r = (incident - transmitted) / (incident + transmitted);
    let r0 = r * r;
    let x = R::ONE - if incident <= transmitted { cos_incident } else { cos_transmitted };
    let x2 = x * x;
    r0 + (R::ONE - r0) * (x2 * x2 * x)
}
