//! Ray and axis-aligned box.

use crate::kernels::{Certified, Miss, Ray, Start};
use crate::numbers::{Certificate, Expansion, Real, Ring, Stage, U, Vector3, integers};

/// The closed axis-aligned box of all points between `min` and `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb<R: Real> {
    /// The corner with the smallest coordinates.
    pub min: R::Vec3,
    /// The corner with the largest coordinates, `min <= max` in each.
    pub max: R::Vec3,
}

impl<R: Real> Aabb<R> {
    /// The smallest box that contains all of the points; with no points, the box from +infinity to -infinity.
    pub fn of_points(points: &[R::Vec3]) -> Self {
        let (mut min, mut max) = ([R::INFINITY; 3], [-R::INFINITY; 3]);
        for point in points {
            for (k, x) in point.to_array().into_iter().enumerate() {
                (min[k], max[k]) = (x.smaller(min[k]), x.larger(max[k]));
            }
        }
        let vector = |[x, y, z]: [R; 3]| R::Vec3::new(x, y, z);
        Aabb { min: vector(min), max: vector(max) }
    }
}

/// Where a ray's line enters and leaves a box. Faces are 0 to 5: -x, +x, -y, +y, -z, +z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxHit<R> {
    /// The hit: `t_in` where the ray starts outside, else `t_out`.
    pub t: R,
    /// The face hit; of several at the same `t`, the lowest.
    pub face: u32,
    /// Where the line enters, the largest of the slabs' smaller ends; -infinity only if the direction is zero.
    pub t_in: R,
    /// Where the line leaves, the smallest of the slabs' larger ends.
    pub t_out: R,
}

/// The hit of a ray and a box by slabs, as the lecture writes it down.
///
/// # Accuracy
///
/// Wrong where a direction component is zero and the origin lies on a face: 0 / 0 is NaN and the other end an infinity
/// of the wrong sign. Of the 21,000 small-integer cases of the tests it misses 1,128.
///
/// # Source
///
/// The lecture, typed literally: swap so that `a <= b`, `t_in` the largest `a`, `t_out` the smallest `b`.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(-2.0, 0.5, 0.5), direction: dvec3(1.0, 0.0, 0.0) };
/// let unit = Aabb::<f64> { min: dvec3(0.0, 0.0, 0.0), max: dvec3(1.0, 1.0, 1.0) };
/// let hit = intersect_box_lecture(&ray, &unit, Start::Anywhere).unwrap();
/// assert_eq!((hit.t, hit.face, hit.t_in, hit.t_out), (2.0, 0, 2.0, 3.0));
/// ```
#[inline(always)]
pub fn intersect_box_lecture<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Result<BoxHit<R>, Miss> {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    let (lo, hi) = (aabb.min.to_array(), aabb.max.to_array());
    let (mut t_in, mut t_out) = (-R::INFINITY, R::INFINITY);
    let (mut face_in, mut face_out) = (0, 1);
    for k in 0..3 {
        let (mut a, mut b) = ((lo[k] - o[k]) / d[k], (hi[k] - o[k]) / d[k]);
        let (mut face_a, mut face_b) = (2 * k as u32, 2 * k as u32 + 1);
        if a > b {
            (a, b) = (b, a);
            (face_a, face_b) = (face_b, face_a);
        }
        if a > t_in {
            (t_in, face_in) = (a, face_a);
        }
        if b < t_out {
            (t_out, face_out) = (b, face_b);
        }
    }
    if t_in > t_out && start == Start::Anywhere {
        return Err(Miss::SlabsDisjoint);
    }
    if t_out < R::ZERO {
        return Err(Miss::Behind);
    }
    let outside = t_in >= R::ZERO && start == Start::Anywhere;
    let (t, face) = if outside { (t_in, face_in) } else { (t_out, face_out) };
    Ok(BoxHit { t, face, t_in, t_out })
}

/// The hit of a ray and a box by slabs, a direction component of zero treated on its own.
///
/// # Accuracy
///
/// All 21,000 small-integer cases right. Each `t` is within 2.01 u of the true one, relatively; where `t_in` and
/// `t_out` come that close (edges, corners) the verdict may be wrong.
///
/// # Source
///
/// Slabs: Kay and Kajiya 1986. A direction component of zero leaves the slab either everywhere or nowhere.
///
/// # Example
///
/// Along an edge of the box, where the lecture's form divides 0 by 0:
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::dvec3;
/// let ray = Ray::<f64> { origin: dvec3(0.0, 0.0, -1.0), direction: dvec3(-0.0, -0.0, 1.0) };
/// let unit = Aabb::<f64> { min: dvec3(0.0, 0.0, 0.0), max: dvec3(1.0, 1.0, 1.0) };
/// assert_eq!(intersect_box_explicit_zero(&ray, &unit, Start::Anywhere).unwrap().t, 1.0);
/// ```
#[inline(always)]
pub fn intersect_box_explicit_zero<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Result<BoxHit<R>, Miss> {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    let (lo, hi) = (aabb.min.to_array(), aabb.max.to_array());
    let (mut t_in, mut t_out) = (-R::INFINITY, R::INFINITY);
    let (mut face_in, mut face_out) = (0, 1);
    for k in 0..3 {
        if d[k] == R::ZERO {
            if (o[k] < lo[k] || o[k] > hi[k]) && start == Start::Anywhere {
                return Err(Miss::SlabsDisjoint);
            }
            continue;
        }
        let (t_lo, t_hi) = ((lo[k] - o[k]) / d[k], (hi[k] - o[k]) / d[k]);
        let (near, far) = if d[k] > R::ZERO { (t_lo, t_hi) } else { (t_hi, t_lo) };
        let side = u32::from(d[k] < R::ZERO);
        if near > t_in {
            (t_in, face_in) = (near, 2 * k as u32 + side);
        }
        if far < t_out {
            (t_out, face_out) = (far, 2 * k as u32 + 1 - side);
        }
    }
    if !(t_in <= t_out) && start == Start::Anywhere {
        return Err(Miss::SlabsDisjoint);
    }
    if !(t_out >= R::ZERO) {
        return Err(Miss::Behind);
    }
    let outside = t_in >= R::ZERO && start == Start::Anywhere;
    let (t, face) = if outside { (t_in, face_in) } else { (t_out, face_out) };
    Ok(BoxHit { t, face, t_in, t_out })
}

/// Every intermediate value of a slab test, whether or not it stops early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxValues<R> {
    /// `t` at the faces -x, +x, -y, +y, -z, +z; NaN or infinite where the direction component is zero.
    pub t: [R; 6],
    /// The largest of the slabs' smaller ends.
    pub t_in: R,
    /// The smallest of the slabs' larger ends.
    pub t_out: R,
}

fn slab_ends<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> [R; 6] {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    let (lo, hi) = (aabb.min.to_array(), aabb.max.to_array());
    std::array::from_fn(|face| {
        let k = face / 2;
        (if face % 2 == 0 { lo[k] - o[k] } else { hi[k] - o[k] }) / d[k]
    })
}

/// The intermediate values of [`intersect_box_lecture`], to the same bits.
pub fn box_lecture_values<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> BoxValues<R> {
    let t = slab_ends(ray, aabb);
    let (mut t_in, mut t_out) = (-R::INFINITY, R::INFINITY);
    for k in 0..3 {
        let (mut a, mut b) = (t[2 * k], t[2 * k + 1]);
        if a > b {
            (a, b) = (b, a);
        }
        if a > t_in {
            t_in = a;
        }
        if b < t_out {
            t_out = b;
        }
    }
    BoxValues { t, t_in, t_out }
}

/// The intermediate values of [`intersect_box_explicit_zero`], to the same bits.
pub fn box_explicit_zero_values<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> BoxValues<R> {
    let t = slab_ends(ray, aabb);
    let d = ray.direction.to_array();
    let (mut t_in, mut t_out) = (-R::INFINITY, R::INFINITY);
    for k in 0..3 {
        if d[k] == R::ZERO {
            continue;
        }
        let (near, far) = if d[k] > R::ZERO { (t[2 * k], t[2 * k + 1]) } else { (t[2 * k + 1], t[2 * k]) };
        if near > t_in {
            t_in = near;
        }
        if far < t_out {
            t_out = far;
        }
    }
    BoxValues { t, t_in, t_out }
}

/// `|t_out - t_in|` over this times `|t_in| + |t_out|` decides.
///
/// A slab's end `(p - o) / d` rounds twice, so it is within `2.01 u` of the true one, relatively; largest and smallest
/// of several keep that bound (scaling by 1 - e or 1 + e keeps the order). The difference of two ends is thus within
/// `2.01 u (|t_in| + |t_out|)`, and rounds once itself: `3.01 u`.
const GAP: f64 = 4.0 * U;

/// The hit of a ray and a box, the verdict exactly right for the stored numbers.
///
/// # Ranges
///
/// Numbers as in [`Certified`]. With [`Start::OnSurfaceInward`] only where the line leaves counts: the slabs need not
/// overlap, for rounding may have put the origin outside.
///
/// # Accuracy
///
/// Verdict and face exact; the signs of `t_in` and `t_out` are those of single differences and need no care. `t`,
/// `t_in` and `t_out` are within 3 u relatively (in f64). `cargo bench --bench kernels` prints the cost
/// against plain slabs.
///
/// # Source
///
/// Slabs: Kay and Kajiya 1986; the bounds derived here (beside the constant `GAP`), the undecided cases
/// cross-multiplied.
///
/// # Example
///
/// The corner of the box, and past it by one ulp:
///
/// ```
/// # use raytree::kernels::*;
/// # use glam::vec3;
/// let unit = Aabb::<f32> { min: vec3(0.0, 0.0, 0.0), max: vec3(1.0, 1.0, 1.0) };
/// let at = |y: f32| Ray::<f32> { origin: vec3(-1.0, 0.0, 2.0), direction: vec3(1.0, y, -1.0) };
/// assert_eq!(intersect_box_certified(&at(1.0), &unit, Start::Anywhere).unwrap().t, 1.0);
/// assert_eq!(intersect_box_certified(&at(1.0000001), &unit, Start::Anywhere), Err(Miss::SlabsDisjoint));
/// ```
#[inline(always)]
pub fn intersect_box_certified<R: Real>(
    ray: &Ray<R>,
    aabb: &Aabb<R>,
    start: Start,
) -> Result<Certified<BoxHit<R>>, Miss> {
    filtered(ray, aabb, start, || undecided(ray, aabb, start))
}

/// What the filter says; `otherwise` where it cannot tell, in tail position, or the hot loop pays for it.
#[inline(always)]
fn filtered<R: Real>(
    ray: &Ray<R>,
    aabb: &Aabb<R>,
    start: Start,
    otherwise: impl FnOnce() -> Result<Certified<BoxHit<R>>, Miss>,
) -> Result<Certified<BoxHit<R>>, Miss> {
    let (o, d) = (ray.origin.to_f64(), ray.direction.to_f64());
    let (lo, hi) = (aabb.min.to_f64(), aabb.max.to_f64());
    let (mut near, mut far) = ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]);
    let (mut t_in, mut t_out) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut axis_in, mut axis_out) = (0, 0);
    for k in 0..3 {
        if d[k] == 0.0 {
            if (o[k] < lo[k] || o[k] > hi[k]) && start == Start::Anywhere {
                return Err(Miss::SlabsDisjoint);
            }
            continue;
        }
        let (plane_in, plane_out) = if d[k] > 0.0 { (lo[k], hi[k]) } else { (hi[k], lo[k]) };
        near[k] = (plane_in - o[k]) / d[k];
        far[k] = (plane_out - o[k]) / d[k];
        if near[k] > t_in {
            (t_in, axis_in) = (near[k], k);
        }
        if far[k] < t_out {
            (t_out, axis_out) = (far[k], k);
        }
    }
    if start == Start::Anywhere {
        let (gap, bound) = (t_out - t_in, GAP * (t_in.abs() + t_out.abs()));
        if gap < -bound {
            return Err(Miss::SlabsDisjoint);
        }
        if !(gap > bound) {
            return otherwise();
        }
    }
    if t_out < 0.0 {
        return Err(Miss::Behind);
    }
    // The hit is at t >= 0 on one face, if no other comes within 2 * 2.01 u of it, relatively.
    let enters = t_in >= 0.0 && start == Start::Anywhere;
    let (axis, t) = if enters { (axis_in, t_in) } else { (axis_out, t_out) };
    let at_t = if enters {
        near.map(|x| u8::from(x >= t - 10.0 * U * t))
    } else {
        far.map(|x| u8::from(x <= t + 10.0 * U * t))
    };
    if at_t[0] + at_t[1] + at_t[2] > 1 {
        return otherwise();
    }
    Ok(certified(ray, axis, enters, t_in, t_out))
}

/// The face through which a ray of this direction enters or leaves the slab of an axis.
#[inline(always)]
fn face_of<R: Real>(ray: &Ray<R>, axis: usize, enters: bool) -> u32 {
    let down = ray.direction.to_array()[axis] < R::ZERO;
    2 * axis as u32 + u32::from(down == enters)
}

#[inline(always)]
fn certified<R: Real>(ray: &Ray<R>, axis: usize, enters: bool, t_in: f64, t_out: f64) -> Certified<BoxHit<R>> {
    // The sum turns -0 into 0.
    let t = if enters { t_in } else { t_out } + 0.0;
    let face = face_of(ray, axis, enters);
    let hit = BoxHit { t: R::from_f64(t), face, t_in: R::from_f64(t_in), t_out: R::from_f64(t_out) };
    Certified { hit, t, t_error: 3.0 * U * t }
}

/// The slabs' ends, compared exactly by cross-multiplication.
struct Slabs {
    o: [f64; 3],
    d: [f64; 3],
    /// The planes through which the line enters the slabs, and those through which it leaves.
    planes: [[f64; 3]; 2],
    integers: Option<IntegerSlabs>,
}

/// `(plane - o) sign(d)` for both planes of each slab, and `|d|`, all scaled to integers below 2^61.
struct IntegerSlabs {
    ends: [[i64; 3]; 2],
    d: [i64; 3],
}

/// An end of a slab: its axis, and whether it is where the line leaves.
type End = (usize, bool);

impl Slabs {
    fn new<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>) -> Self {
        let (o, d) = (ray.origin.to_f64(), ray.direction.to_f64());
        let (lo, hi) = (aabb.min.to_f64(), aabb.max.to_f64());
        let pick = |leaving: bool| std::array::from_fn(|k| if (d[k] < 0.0) == leaving { lo[k] } else { hi[k] });
        let planes = [pick(false), pick(true)];
        let largest = |v: [f64; 3]| v[0].abs().max(v[1].abs()).max(v[2].abs());
        let scale = integers::scale_to(largest(o).max(largest(lo)).max(largest(hi)), 60);
        let scale_d = integers::scale_to(largest(d), 61);
        let all = || {
            let o = integers::to_integers(o, scale)?;
            let d = integers::to_integers(d, scale_d)?;
            let planes = [integers::to_integers(planes[0], scale)?, integers::to_integers(planes[1], scale)?];
            let ends = planes.map(|plane| std::array::from_fn(|k| (plane[k] - o[k]) * d[k].signum()));
            Some(IntegerSlabs { ends, d: d.map(i64::abs) })
        };
        Slabs { o, d, planes, integers: all() }
    }

    /// The sign of `t` at `a` minus `t` at `b`. Neither axis has a direction component of zero.
    fn compare(&self, (i, a): End, (j, b): End) -> i32 {
        if let Some(slabs) = &self.integers {
            let (end_i, end_j) = (slabs.ends[usize::from(a)][i], slabs.ends[usize::from(b)][j]);
            return integers::sign_of_products(end_i, slabs.d[j], end_j, slabs.d[i]);
        }
        let end = |k: usize, leaving: bool| {
            let end = Expansion::difference(self.planes[usize::from(leaving)][k], self.o[k]);
            if self.d[k] < 0.0 { -end } else { end }
        };
        let times = |end: Expansion, k: usize| end * Expansion::number(self.d[k].abs());
        (times(end(i, a), j) - times(end(j, b), i)).sign()
    }

    fn t(&self, (k, leaving): End) -> f64 {
        (self.planes[usize::from(leaving)][k] - self.o[k]) / self.d[k]
    }

    /// Where the line enters and leaves all slabs; nothing only for a direction of zero.
    fn span(&self) -> Option<(usize, usize)> {
        let mut axes = (0..3).filter(|k| self.d[*k] != 0.0);
        let first = axes.next()?;
        // Ties stay with the lower axis, which has the lower faces.
        Some(axes.fold((first, first), |(axis_in, axis_out), k| {
            let later = self.compare((k, false), (axis_in, false)) > 0;
            let sooner = self.compare((k, true), (axis_out, true)) < 0;
            (if later { k } else { axis_in }, if sooner { k } else { axis_out })
        }))
    }

    fn stage(&self) -> Stage {
        if self.integers.is_some() { Stage::Integer } else { Stage::Expansion }
    }
}

#[cold]
#[inline(never)]
fn undecided<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Result<Certified<BoxHit<R>>, Miss> {
    let slabs = Slabs::new(ray, aabb);
    let Some((axis_in, axis_out)) = slabs.span() else { return Err(Miss::SlabsDisjoint) };
    if start == Start::Anywhere && slabs.compare((axis_in, false), (axis_out, true)) > 0 {
        return Err(Miss::SlabsDisjoint);
    }
    let (t_in, t_out) = (slabs.t((axis_in, false)), slabs.t((axis_out, true)));
    if t_out < 0.0 {
        return Err(Miss::Behind);
    }
    let enters = t_in >= 0.0 && start == Start::Anywhere;
    Ok(certified(ray, if enters { axis_in } else { axis_out }, enters, t_in, t_out))
}

/// Which stage decides this ray and box, hit or miss.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::Stage;
/// # use glam::dvec3;
/// let unit = Aabb::<f64> { min: dvec3(0.0, 0.0, 0.0), max: dvec3(1.0, 1.0, 1.0) };
/// let corner = Ray::<f64> { origin: dvec3(-1.0, 0.0, 2.0), direction: dvec3(1.0, 1.0, -1.0) };
/// assert_eq!(box_stage(&corner, &unit, Start::Anywhere), Stage::Integer);
/// ```
pub fn box_stage<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Stage {
    let mut is_open = false;
    let _ = filtered(ray, aabb, start, || {
        is_open = true;
        Err(Miss::SlabsDisjoint)
    });
    if is_open { Slabs::new(ray, aabb).stage() } else { Stage::Filter }
}

/// How a *hit* of this ray and box was decided.
///
/// The margin is `t_out - t_in` over its bound `4 u (|t_in| + |t_out|)`. For a ray that starts on the box and goes in,
/// only the sign of `t_out` matters, which needs no bound: `|t_out|` over `4 u |t_out|`, 2^51.
///
/// # Example
///
/// ```
/// # use raytree::kernels::*;
/// # use raytree::numbers::{Certificate, Stage};
/// # use glam::dvec3;
/// let unit = Aabb::<f64> { min: dvec3(0.0, 0.0, 0.0), max: dvec3(1.0, 1.0, 1.0) };
/// let corner = Ray::<f64> { origin: dvec3(-1.0, 0.0, 2.0), direction: dvec3(1.0, 1.0, -1.0) };
/// let certificate = certify_box(&corner, &unit, Start::Anywhere);
/// assert_eq!(certificate, Certificate { stage: Stage::Integer, margin: 0.0 });
/// ```
pub fn certify_box<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Certificate {
    if start == Start::OnSurfaceInward {
        return Certificate { stage: Stage::Filter, margin: 1.0 / GAP };
    }
    let slabs = Slabs::new(ray, aabb);
    let Some((axis_in, axis_out)) = slabs.span() else {
        return Certificate { stage: Stage::Filter, margin: 0.0 };
    };
    let (t_in, t_out) = (slabs.t((axis_in, false)), slabs.t((axis_out, true)));
    let bound = GAP * (t_in.abs() + t_out.abs());
    let margin = if bound > 0.0 { (t_out - t_in).abs() / bound } else { 0.0 };
    Certificate { stage: if margin > 1.0 { Stage::Filter } else { slabs.stage() }, margin }
}
