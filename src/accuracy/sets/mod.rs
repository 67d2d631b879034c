//! Random rays and shapes: easy ones, and ones that sit on the edge of a verdict.
//!
//! Every set is an endless sequence from a seed; the numbers are rounded to the precision before anything is asked of
//! them, so that whatever is right for one kernel is right for all.

mod aabb;
mod optics;
mod plane;
mod sphere;
mod triangle;

pub use aabb::{BoxSet, box_lattice};
pub use optics::{Crossing, OpticsSet};
pub use plane::PlaneSet;
pub use sphere::SphereSet;
pub use triangle::TriangleSet;

use glam::DVec3;

use crate::kernels::Ray;
use crate::numbers::{Real, Vector3, power_of_two};

use super::random::stored;

/// The ray as stored in the precision, unless its direction has become zero or too long.
fn ray<R: Real>(origin: DVec3, direction: DVec3) -> Option<Ray<R>> {
    let ray = Ray::<R> { origin: stored::<R>(origin), direction: stored::<R>(direction) };
    let d = DVec3::from_array(ray.direction.to_f64()).abs().max_element();
    (d > 0.0 && d <= power_of_two(127)).then_some(ray)
}

/// Draws until there is something.
fn until<T>(mut draw: impl FnMut() -> Option<T>) -> T {
    loop {
        if let Some(drawn) = draw() {
            return drawn;
        }
    }
}
