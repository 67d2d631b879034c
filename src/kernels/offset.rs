//! Leaving a surface by an offset: how far a new ray's origin is moved so that the surface lies behind it.

use crate::numbers::{Real, Vector3};

/// `gamma(n) = n u / (1 - n u)`: n roundings in a row change a product or quotient by at most this, relatively (Higham
/// 2002, lemma 3.1).
pub fn gamma<R: Real>(n: u32) -> R {
    let nu = f64::from(n) * R::UNIT_ROUNDOFF.to_f64();
    R::from_f64(nu / (1.0 - nu))
}

/// The origin of a ray that leaves `point` in `direction`, moved along the normal until the surface lies behind it.
///
/// # Ranges
///
/// `error` bounds the distance of `point` from the true surface in each component, all `>= 0`; `normal` is unit, on either
/// side. The ray goes to the side of the normal that `direction` points to.
///
/// # Accuracy
///
/// The origin is moved by at most `|error|` and a unit in the last place: as far as rounding may have put the point
/// beside the surface, and no further. Whatever is nearer than that is lost.
///
/// # Source
///
/// Pharr, Jakob and Humphreys, Physically Based Rendering, section 3.9.5.
///
/// # Example
///
/// ```
/// # use raytree::kernels::offset::offset_origin;
/// # use glam::dvec3;
/// let (up, right) = (dvec3(0.0, 1.0, 0.0), dvec3(1.0, 0.0, 0.0));
/// let moved = offset_origin::<f64>(dvec3(3.0, 2.0, 0.0), dvec3(0.5, 0.25, 0.5), up, right + up);
/// assert!((moved.x, moved.z) == (3.0, 0.0) && moved.y > 2.25 && moved.y < 2.2500001);
/// ```
pub fn offset_origin<R: Real>(point: R::Vec3, error: R::Vec3, normal: R::Vec3, direction: R::Vec3) -> R::Vec3 {
    let ([nx, ny, nz], [ex, ey, ez]) = (normal.to_array(), error.to_array());
    let distance = nx.abs() * ex + ny.abs() * ey + nz.abs() * ez;
    let along = if normal.dot(direction) < R::ZERO { -distance } else { distance };
    let offset = (normal * along).to_array();
    let mut moved = (point + normal * along).to_array();
    for k in 0..3 {
        if offset[k] > R::ZERO {
            moved[k] = moved[k].next_up();
        } else if offset[k] < R::ZERO {
            moved[k] = moved[k].next_down();
        }
    }
    R::Vec3::new(moved[0], moved[1], moved[2])
}
