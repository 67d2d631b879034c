//! Ray and axis-aligned box.

use crate::kernels::{Miss, Ray, Start};
use crate::numbers::{Real, Vector3};

/// The closed axis-aligned box of all points between `min` and `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb<R: Real> {
    /// The corner with the smallest coordinates.
    pub min: R::Vec3,
    /// The corner with the largest coordinates, `min <= max` in each.
    pub max: R::Vec3,
}

/// Where a ray's line enters and leaves a box. Faces are 0 to 5: -x, +x, -y, +y, -z, +z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxHit<R> {
    /// The hit: `t_in` where the ray starts outside, else `t_out`.
    pub t: R,
    /// The face hit.
    pub face: u32,
    /// Where the line enters, the largest of the slabs' smaller ends; -infinity only if the direction is zero.
    pub t_in: R,
    /// Where the line leaves, the smallest of the slabs' larger ends.
    pub t_out: R,
}

/// The hit of a ray and a box by slabs, a direction component of zero treated on its own.
#[inline(always)]
pub fn intersect_box_explicit_zero<R: Real>(ray: &Ray<R>, aabb: &Aabb<R>, start: Start) -> Result<BoxHit<R>, Miss> {
    let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
    let (lo, hi) = (aabb.min.to_array(), aabb.max.to_array());
    let (mut t_in, mut t_out) = (-R::INFINITY, R::INFINITY);
    let (mut face_in, mut face_out) = (0, 1);
    for k in 0..3 {
        if d[k] == R::ZERO {
            if o[k] < lo[k] || o[k] > hi[k] {
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
