//! The referee: exact answers from rational numbers, by formulas other than the kernels' and without any of their code.

use std::cmp::Ordering;

use crate::kernels::{Aabb, Plane, Ray, Sphere, Triangle};
use crate::numbers::{Real, Vector3};
use dashu_int::ops::SquareRoot;
use dashu_int::{IBig, UBig};
use dashu_ratio::Relaxed;

/// A rational number.
pub type Q = Relaxed;
type V = [Q; 3];

/// `x` as a fraction.
///
/// # Panics
/// If `x` is infinite or NaN.
pub fn q(x: f64) -> Q {
    Q::try_from(x).expect("a finite number")
}

/// `v` in fractions.
pub fn vector<R: Real>(v: R::Vec3) -> V {
    v.to_f64().map(q)
}

/// -1, 0 or 1.
pub fn sign(x: &Q) -> i32 {
    match x.cmp(&Q::ZERO) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

/// The scalar product.
pub fn dot(a: &V, b: &V) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// `a - b`.
pub fn subtract(a: &V, b: &V) -> V {
    std::array::from_fn(|k| &a[k] - &b[k])
}

/// The vector product.
pub fn cross(a: &V, b: &V) -> V {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &a[i] * &b[j] - &a[j] * &b[i]
    })
}

/// `t` as a fraction and the signs of the barycentric coordinates.
#[derive(Clone, Debug)]
pub struct TriangleTruth {
    /// `t = t_numerator / denominator`.
    pub t_numerator: Q,
    /// `n . d`.
    pub denominator: Q,
    /// Of those of v0, v1, v2.
    pub weight_signs: [i32; 3],
}

impl TriangleTruth {
    /// The lecture's way, without dividing: p (n.d) = o (n.d) + d (n.v0 - n.o), and the areas towards p. Nothing for a
    /// parallel ray and for a triangle without area.
    pub fn new<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Option<Self> {
        let (o, d) = (vector::<R>(ray.origin), vector::<R>(ray.direction));
        let v = triangle.vertices.map(|vertex| vector::<R>(vertex));
        let n = cross(&subtract(&v[1], &v[0]), &subtract(&v[2], &v[0]));
        let n_dot_d = dot(&n, &d);
        if sign(&n_dot_d) == 0 {
            return None;
        }
        let height = dot(&n, &subtract(&v[0], &o));
        let weight_signs = std::array::from_fn(|i| {
            let (from, to) = (&v[(i + 1) % 3], &v[(i + 2) % 3]);
            // (p - from) (n.d)
            let s: V = std::array::from_fn(|k| (&o[k] - &from[k]) * &n_dot_d + &d[k] * &height);
            sign(&dot(&n, &cross(&subtract(to, from), &s))) * sign(&n_dot_d)
        });
        Some(TriangleTruth { t_numerator: height, denominator: n_dot_d, weight_signs })
    }

    /// The sign of `t`.
    pub fn t_sign(&self) -> i32 {
        sign(&self.t_numerator) * sign(&self.denominator)
    }

    /// Whether the ray hits, edges and vertices included.
    pub fn is_hit(&self) -> bool {
        self.t_sign() >= 0 && self.weight_signs.iter().all(|sign| *sign >= 0)
    }
}

/// Whether `|t - numerator / denominator| <= error`.
pub fn is_within(t: f64, error: f64, numerator: &Q, denominator: &Q) -> bool {
    if !(error.is_finite() && error >= 0.0) {
        return false;
    }
    let distance = q(t) * denominator - numerator;
    let allowed = q(error) * denominator;
    &distance * &distance <= &allowed * &allowed
}

/// `n.d` and `D - n.o`.
pub fn plane<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> (Q, Q) {
    let n = vector::<R>(plane.normal);
    let height = q(plane.distance.to_f64()) - dot(&n, &vector::<R>(ray.origin));
    (dot(&n, &vector::<R>(ray.direction)), height)
}

/// The quadratic `a t^2 + 2 b t + c`.
#[derive(Clone, Debug)]
pub struct SphereTruth {
    /// `|d|^2`.
    pub a: Q,
    /// `(o - center) . d`.
    pub b: Q,
    /// `|o - center|^2 - r^2`.
    pub c: Q,
    /// `b^2 - a c`: negative where the line misses.
    pub disc: Q,
}

impl SphereTruth {
    /// The terms of a ray and a sphere.
    pub fn new<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> Self {
        let d = vector::<R>(ray.direction);
        let f = subtract(&vector::<R>(ray.origin), &vector::<R>(sphere.center));
        let r = q(sphere.radius.to_f64());
        let (a, b, c) = (dot(&d, &d), dot(&f, &d), dot(&f, &f) - &r * &r);
        let disc = &b * &b - &a * &c;
        SphereTruth { a, b, c, disc }
    }

    /// How the smaller or larger root compares with `x`, from the sign of the quadratic there. There are roots.
    pub fn compare(&self, far: bool, x: &Q) -> Ordering {
        let value = &self.a * x * x + Q::from(2) * &self.b * x + &self.c;
        // Between the roots the quadratic is negative; the vertex is at -b / a.
        let beyond_vertex = (&self.a * x + &self.b).cmp(&Q::ZERO);
        match (sign(&value), far) {
            (-1, false) => Ordering::Less,
            (-1, true) => Ordering::Greater,
            (1, _) => beyond_vertex.reverse(),
            (_, false) => {
                if beyond_vertex == Ordering::Greater {
                    Ordering::Less
                } else {
                    Ordering::Equal
                }
            }
            (_, true) => {
                if beyond_vertex == Ordering::Less {
                    Ordering::Greater
                } else {
                    Ordering::Equal
                }
            }
        }
    }

    /// Whether `|t - root| <= error`.
    pub fn is_within(&self, far: bool, t: f64, error: f64) -> bool {
        if !(error.is_finite() && error >= 0.0) {
            return false;
        }
        self.compare(far, &(q(t) - q(error))) != Ordering::Less
            && self.compare(far, &(q(t) + q(error))) != Ordering::Greater
    }

    /// With `disc >= 0`, an interval of width 2^-bits (before division by a) around `-b -+ sqrt(disc)`, over a.
    pub fn interval(&self, far: bool, bits: usize) -> (Q, Q) {
        let scaled = &self.disc * Q::from(UBig::ONE << (2 * bits));
        let (numerator, denominator) = scaled.into_parts();
        let floor = numerator / IBig::from(denominator);
        let root = IBig::from(UBig::try_from(floor).unwrap_or_default().sqrt());
        let unit = UBig::ONE << bits;
        let (lo, hi) = (Q::from_parts(root.clone(), unit.clone()), Q::from_parts(root + IBig::ONE, unit));
        let minus_b = -self.b.clone();
        if far {
            ((&minus_b + lo) / &self.a, (&minus_b + hi) / &self.a)
        } else {
            ((&minus_b - hi) / &self.a, (&minus_b - lo) / &self.a)
        }
    }
}

/// A face of a box (0 to 5 for -x, +x, -y, +y, -z, +z), and `t` there.
pub type FaceAt = (u32, Q);

/// The face and `t` where the line enters and leaves, or nothing where a slab without direction excludes it.
pub fn box_span<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> Option<(FaceAt, FaceAt)> {
    let (o, d) = (vector::<R>(ray.origin), vector::<R>(ray.direction));
    let (lo, hi) = (vector::<R>(aabb.min), vector::<R>(aabb.max));
    let (mut enter, mut leave): (Option<FaceAt>, Option<FaceAt>) = (None, None);
    for k in 0..3 {
        if sign(&d[k]) == 0 {
            if o[k] < lo[k] || o[k] > hi[k] {
                return None;
            }
            continue;
        }
        let mut ends = [(2 * k as u32, (&lo[k] - &o[k]) / &d[k]), (2 * k as u32 + 1, (&hi[k] - &o[k]) / &d[k])];
        if sign(&d[k]) < 0 {
            ends.swap(0, 1);
        }
        let [near, far] = ends;
        if enter.as_ref().is_none_or(|best| near.1 > best.1) {
            enter = Some(near);
        }
        if leave.as_ref().is_none_or(|best| far.1 < best.1) {
            leave = Some(far);
        }
    }
    Some((enter?, leave?))
}

/// The face and `t` of a box's hit: where the line enters, or leaves if that lies behind.
pub fn box_hit<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> Option<FaceAt> {
    let (enter, leave) = box_span(ray, aabb)?;
    if enter.1 > leave.1 || leave.1 < Q::ZERO {
        return None;
    }
    Some(if enter.1 >= Q::ZERO { enter } else { leave })
}

/// What decides total reflection, `n_t^2 |d|^2 |n|^2 - n_i^2 |d x n|^2`: total where it is negative.
pub fn transmission<R: Real>(d: R::Vec3, n: R::Vec3, incident: R, transmitted: R) -> Q {
    let (d, n) = (vector::<R>(d), vector::<R>(n));
    let (n_i, n_t) = (q(incident.to_f64()), q(transmitted.to_f64()));
    let sine = cross(&d, &n);
    &n_t * &n_t * dot(&d, &d) * dot(&n, &n) - &n_i * &n_i * dot(&sine, &sine)
}
