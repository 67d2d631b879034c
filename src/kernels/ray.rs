//! The ray, and where it starts.

use crate::numbers::Real;

/// The half-line `origin + t direction`, `t >= 0`. The direction need not be unit: `t` is in units of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<R: Real> {
    /// Where it starts, in world space.
    pub origin: R::Vec3,
    /// Where it goes; any finite length but zero.
    pub direction: R::Vec3,
}

impl<R: Real> Ray<R> {
    /// The point `origin + t direction`, rounded once in each product and each sum.
    #[inline(always)]
    pub fn at(&self, t: R) -> R::Vec3 {
        self.origin + self.direction * t
    }
}

/// Where a ray starts with regard to one convex solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Anywhere: both of the solid's roots count where `t >= 0`.
    Anywhere,
    /// On the solid's surface by identity, going in: only the far root counts, however the origin was rounded.
    OnSurfaceInward,
}
