//! Exact answers from rational numbers, by formulas other than the kernels'.

use std::cmp::Ordering;

use dashu_int::ops::SquareRoot;
use dashu_int::{IBig, UBig};
use dashu_ratio::Relaxed;
use raytree::kernels::{Aabb, Plane, Ray, Sphere, Triangle};
use raytree::numbers::{Real, Vector3};

pub(super) type Q = Relaxed;
type V = [Q; 3];

pub(super) fn q(x: f64) -> Q {
    Q::try_from(x).unwrap()
}

pub(super) fn vector<R: Real>(v: R::Vec3) -> V {
    v.to_f64().map(q)
}

pub(super) fn sign(x: &Q) -> i32 {
    match x.cmp(&Q::ZERO) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

pub(super) fn dot(a: &V, b: &V) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub(super) fn subtract(a: &V, b: &V) -> V {
    std::array::from_fn(|k| &a[k] - &b[k])
}

pub(super) fn cross(a: &V, b: &V) -> V {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &a[i] * &b[j] - &a[j] * &b[i]
    })
}

/// `t` as a fraction and the signs of the barycentric coordinates; nothing for a parallel ray.
pub(super) struct TriangleTruth {
    /// `t = t_numerator / denominator`.
    pub(super) t_numerator: Q,
    pub(super) denominator: Q,
    pub(super) weight_signs: [i32; 3],
}

impl TriangleTruth {
    /// The lecture's way, without dividing: p (n.d) = o (n.d) + d (n.v0 - n.o), and the areas towards p.
    pub(super) fn new<R: Real>(ray: &Ray<R>, triangle: &Triangle<R>) -> Option<Self> {
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

    pub(super) fn t_sign(&self) -> i32 {
        sign(&self.t_numerator) * sign(&self.denominator)
    }

    pub(super) fn is_hit(&self) -> bool {
        self.t_sign() >= 0 && self.weight_signs.iter().all(|sign| *sign >= 0)
    }
}

/// Whether `|t - numerator / denominator| <= error`.
pub(super) fn is_within(t: f64, error: f64, numerator: &Q, denominator: &Q) -> bool {
    assert!(error.is_finite() && error >= 0.0, "t_error {error}");
    let distance = q(t) * denominator - numerator;
    let allowed = q(error) * denominator;
    &distance * &distance <= &allowed * &allowed
}

/// `n.d` and `D - n.o`.
pub(super) fn plane<R: Real>(ray: &Ray<R>, plane: &Plane<R>) -> (Q, Q) {
    let n = vector::<R>(plane.normal);
    let height = q(plane.distance.to_f64()) - dot(&n, &vector::<R>(ray.origin));
    (dot(&n, &vector::<R>(ray.direction)), height)
}

/// The quadratic `a t^2 + 2 b t + c`.
pub(super) struct SphereTruth {
    pub(super) a: Q,
    pub(super) b: Q,
    pub(super) c: Q,
    pub(super) disc: Q,
}

impl SphereTruth {
    pub(super) fn new<R: Real>(ray: &Ray<R>, sphere: &Sphere<R>) -> Self {
        let d = vector::<R>(ray.direction);
        let f = subtract(&vector::<R>(ray.origin), &vector::<R>(sphere.center));
        let r = q(sphere.radius.to_f64());
        let (a, b, c) = (dot(&d, &d), dot(&f, &d), dot(&f, &f) - &r * &r);
        let disc = &b * &b - &a * &c;
        SphereTruth { a, b, c, disc }
    }

    /// How the smaller or larger root compares with `x`, from the sign of the quadratic there. There are roots.
    pub(super) fn compare(&self, far: bool, x: &Q) -> Ordering {
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
    pub(super) fn is_within(&self, far: bool, t: f64, error: f64) -> bool {
        assert!(error.is_finite() && error >= 0.0, "t_error {error}");
        self.compare(far, &(q(t) - q(error))) != Ordering::Less
            && self.compare(far, &(q(t) + q(error))) != Ordering::Greater
    }

    /// An interval of width 2^-bits (before division by a) around `-b -+ sqrt(disc)`, over a.
    pub(super) fn interval(&self, far: bool, bits: usize) -> (Q, Q) {
        let scaled = &self.disc * Q::from(UBig::ONE << (2 * bits));
        let (numerator, denominator) = scaled.into_parts();
        let floor = numerator / IBig::from(denominator);
        let root = IBig::from(UBig::try_from(floor).unwrap().sqrt());
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

/// A face of a box, and `t` there.
type FaceAt = (u32, Q);

/// The face and `t` where the line enters and leaves, or nothing where a slab without direction excludes it.
pub(super) fn box_span<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> Option<(FaceAt, FaceAt)> {
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
