//! Which of two surfaces a ray meets first, exactly.
//!
//! Along one ray, `t` at a flat surface is a fraction `P / Q` of exact numbers, and `t` at a sphere is `(-b -+
//! sqrt(disc)) / a` with `a = d.d` shared by all spheres. Comparing two of them is the sign of an expression with at
//! most two square roots, found by squaring as often as there are roots. Numbers of any length ([`Wide`]) carry it
//! through: no cap on precision, so that ties are ties.

use std::cmp::Ordering;

use crate::kernels::plane::{PlaneFilter, plane_terms, quotient_error};
use crate::kernels::sphere::{SphereBounds, SphereTerms};
use crate::kernels::triangle::{triangle_terms, triangle_terms_f64};
use crate::kernels::{Aabb, Plane, Ray, Sphere, Triangle};
use crate::numbers::{Real, Ring, U, Vector3, Wide};

/// One place where a ray's line meets a surface.
#[derive(Clone, Copy, Debug)]
pub enum Root<'a, R: Real> {
    /// Where it meets a plane.
    Plane(&'a Plane<R>),
    /// Where it meets the plane of a triangle.
    Triangle(&'a Triangle<R>),
    /// Where it meets the plane of a box's face, 0 to 5: -x, +x, -y, +y, -z, +z.
    BoxFace(&'a Aabb<R>, u32),
    /// The smaller root of a sphere.
    SphereNear(&'a Sphere<R>),
    /// The larger root of a sphere.
    SphereFar(&'a Sphere<R>),
}

/// How `t` at `a` compares with `t` at `b`, exactly.
///
/// # Ranges
///
/// The line meets both surfaces (it is not parallel to a flat one, and no sphere's discriminant is negative); what
/// comes back otherwise means nothing. Any sign of `t`.
///
/// # Accuracy
///
/// Exact. Where the two `t` in f64 are further apart than the bounds on their errors that is all it takes; otherwise it
/// allocates, and is far dearer.
///
/// # Source
///
/// Derived here.
///
/// # Example
///
/// Two unit spheres that touch at (1, 0, 0), and a ray that grazes both there:
///
/// ```
/// # use raytree::kernels::*;
/// # use std::cmp::Ordering;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(1.0, 5.0, 0.0), direction: dvec3(0.0, -1.0, 0.0) };
/// let left = Sphere::<f64> { center: dvec3(0.0, 0.0, 0.0), radius: 1.0 };
/// let right = Sphere::<f64> { center: dvec3(2.0, 0.0, 0.0), radius: 1.0 };
/// assert_eq!(compare_t(&ray, Root::SphereNear(&left), Root::SphereNear(&right)), Ordering::Equal);
/// let floor = Plane::<f64> { normal: dvec3(0.0, 1.0, 0.0), distance: -1e-12 };
/// assert_eq!(compare_t(&ray, Root::SphereFar(&left), Root::Plane(&floor)), Ordering::Less);
/// ```
pub fn compare_t<R: Real>(ray: &Ray<R>, a: Root<R>, b: Root<R>) -> Ordering {
    clear_order(estimate(ray, a), estimate(ray, b)).unwrap_or_else(|| exact_order(exact(ray, a), exact(ray, b)))
}

/// How `t` at `root` compares with the number `t`, exactly.
///
/// # Ranges
///
/// The line meets the surface. `t` is any number but NaN, infinities included: 0 asks for the sign, `t_max` whether
/// the root lies within a span.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use std::cmp::Ordering;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(-2.0, 0.0, 0.0), direction: dvec3(1.0, 0.0, 0.0) };
/// let sphere = Sphere::<f64> { center: dvec3(0.0, 0.0, 0.0), radius: 1.0 };
/// assert_eq!(compare_t_with(&ray, Root::SphereNear(&sphere), 1.0), Ordering::Equal);
/// assert_eq!(compare_t_with(&ray, Root::SphereFar(&sphere), f64::INFINITY), Ordering::Less);
/// ```
pub fn compare_t_with<R: Real>(ray: &Ray<R>, root: Root<R>, t: f64) -> Ordering {
    if t.is_infinite() {
        return if t > 0.0 { Ordering::Less } else { Ordering::Greater };
    }
    clear_order(estimate(ray, root), (t, 0.0))
        .unwrap_or_else(|| exact_order(exact(ray, root), Exact::Fraction(Wide::number(t), Wide::number(1.0))))
}

/// The order of two numbers known to a bound on their errors, where that is enough. Never with an infinite bound, or
/// NaN.
fn clear_order((t_a, error_a): (f64, f64), (t_b, error_b): (f64, f64)) -> Option<Ordering> {
    // The difference and the sum round by u each; errors are bounds with room for that, but one may be zero.
    let (gap, bound) = (t_b - t_a, (error_a + error_b) * (1.0 + 4.0 * U));
    if gap.abs() * (1.0 - 4.0 * U) > bound {
        Some(if gap > 0.0 { Ordering::Less } else { Ordering::Greater })
    } else {
        None
    }
}

/// `t` in f64 and a bound on its error; infinite or NaN where there is none.
fn estimate<R: Real>(ray: &Ray<R>, root: Root<R>) -> (f64, f64) {
    match root {
        Root::Plane(plane) => {
            let filter = PlaneFilter::new(ray, plane);
            let t = filter.height / filter.n_dot_d;
            (t, quotient_error(filter.height_error, t, filter.n_dot_d, filter.n_dot_d_error))
        }
        Root::Triangle(triangle) => {
            let (t_scaled, t_error, det, det_error) = triangle_terms_f64(ray, triangle);
            let t = t_scaled / det;
            (t, quotient_error(t_error, t, det, det_error))
        }
        Root::BoxFace(aabb, face) => {
            let (plane, o, d) = face_terms(ray, aabb, face);
            let t = (plane - o) / d;
            (t, 3.0 * U * t.abs())
        }
        Root::SphereNear(sphere) | Root::SphereFar(sphere) => {
            let (terms, bounds) = (SphereTerms::<f64>::new(ray, sphere), SphereBounds::new(ray, sphere));
            let SphereTerms { a, b, c, disc } = terms;
            if !(disc > bounds.disc) {
                return (0.0, f64::INFINITY);
            }
            // As in the certified kernel: q does not cancel; one root is q / a, the other c / q.
            let root_of_disc = disc.sqrt();
            let q = if b < 0.0 { root_of_disc - b } else { -b - root_of_disc };
            let q_error = bounds.b + bounds.disc / root_of_disc + 2.0 * U * q.abs();
            let far = matches!(root, Root::SphereFar(_));
            if far == (b < 0.0) {
                let t = q / a;
                // a is within 3 u.
                (t, quotient_error(q_error, t, a, 4.0 * U * a))
            } else {
                let t = c / q;
                (t, quotient_error(bounds.c, t, q, q_error))
            }
        }
    }
}

/// The coordinate of the face's plane, and those of origin and direction.
fn face_terms<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, face: u32) -> (f64, f64, f64) {
    let axis = face as usize / 2;
    let corner = if face.is_multiple_of(2) { aabb.min } else { aabb.max };
    (corner.to_f64()[axis], ray.origin.to_f64()[axis], ray.direction.to_f64()[axis])
}

/// `t`, exactly.
enum Exact {
    /// `P / Q`, `Q > 0`.
    Fraction(Wide, Wide),
    /// `(b + sign sqrt(disc)) / a`, `a > 0`.
    Root { b: Wide, sign: i32, disc: Wide, a: Wide },
}

fn exact<R: Real>(ray: &Ray<R>, root: Root<R>) -> Exact {
    let fraction = |p: Wide, q: Wide| if q.sign() < 0 { Exact::Fraction(-p, -q) } else { Exact::Fraction(p, q) };
    match root {
        Root::Plane(plane) => {
            let (n_dot_d, height) = plane_terms(ray, plane);
            fraction(height, n_dot_d)
        }
        Root::Triangle(triangle) => {
            let (t, det) = triangle_terms(ray, triangle);
            fraction(t, det)
        }
        Root::BoxFace(aabb, face) => {
            let (plane, o, d) = face_terms(ray, aabb, face);
            fraction(Wide::difference(plane, o), Wide::number(d))
        }
        Root::SphereNear(sphere) | Root::SphereFar(sphere) => {
            let SphereTerms { a, b, disc, .. } = SphereTerms::<Wide>::new(ray, sphere);
            let sign = if matches!(root, Root::SphereFar(_)) { 1 } else { -1 };
            Exact::Root { b: -b, sign, disc, a }
        }
    }
}

fn exact_order(left: Exact, right: Exact) -> Ordering {
    let sign = match (left, right) {
        (Exact::Fraction(p, q), Exact::Fraction(r, s)) => (p * s - r * q).sign(),
        (Exact::Fraction(p, q), Exact::Root { b, sign, disc, a }) => fraction_minus_root(p, q, b, sign, disc, a),
        (Exact::Root { b, sign, disc, a }, Exact::Fraction(p, q)) => -fraction_minus_root(p, q, b, sign, disc, a),
        // Both over the same a > 0: the sign of (b1 - b2) + s1 sqrt(disc1) - s2 sqrt(disc2).
        (Exact::Root { b: b1, sign: s1, disc: disc1, .. }, Exact::Root { b: b2, sign: s2, disc: disc2, .. }) => {
            sign_with_two_roots(b1 - b2, s1, disc1, -s2, disc2)
        }
    };
    sign.cmp(&0)
}

/// The sign of `p / q - (b + sign sqrt(disc)) / a`: that of `(p a - b q) - sign sqrt(q^2 disc)`, since q and a are
/// positive.
fn fraction_minus_root(p: Wide, q: Wide, b: Wide, sign: i32, disc: Wide, a: Wide) -> i32 {
    sign_with_root(p * a - b * q.clone(), -sign, q.clone() * q * disc)
}

/// The sign of `x + s sqrt(y)`, `s` = -1 or 1, `y >= 0`.
fn sign_with_root(x: Wide, s: i32, y: Wide) -> i32 {
    // The sign of the root's term; where x has another one, the larger square wins.
    let root_sign = s * y.sign();
    match (x.sign(), root_sign) {
        (x_sign, 0) => x_sign,
        (0, root_sign) => root_sign,
        (x_sign, root_sign) if x_sign == root_sign => x_sign,
        (x_sign, _) => x_sign * (x.clone() * x - y).sign(),
    }
}

/// The sign of `z + s1 sqrt(y1) + s2 sqrt(y2)`, `s` = -1 or 1, `y >= 0`.
fn sign_with_two_roots(z: Wide, s1: i32, y1: Wide, s2: i32, y2: Wide) -> i32 {
    // The sign of both roots' terms together.
    let (sign_1, sign_2) = (s1 * y1.sign(), s2 * y2.sign());
    let roots_sign = match (sign_1, sign_2) {
        (sign_1, 0) => sign_1,
        (0, sign_2) => sign_2,
        (sign_1, sign_2) if sign_1 == sign_2 => sign_1,
        (sign_1, _) => sign_1 * (y1.clone() - y2.clone()).sign(),
    };
    match (z.sign(), roots_sign) {
        (z_sign, 0) => z_sign,
        (0, roots_sign) => roots_sign,
        (z_sign, roots_sign) if z_sign == roots_sign => z_sign,
        // The larger square wins: z^2 - (y1 + y2 + 2 s1 s2 sqrt(y1 y2)).
        (z_sign, _) => {
            let rest = z.clone() * z - y1.clone() - y2.clone();
            z_sign * sign_with_root(rest, -s1 * s2, Wide::number(4.0) * y1 * y2)
        }
    }
}
