//! The ray, and where it starts.

use crate::numbers::{Real, Vector3, is_in_range};

/// The half-line `origin + t direction`, `t >= 0`. The direction need not be unit: `t` is in units of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<R: Real> {
    /// Where it starts, in world space.
    pub origin: R::Vec3,
    /// Where it goes; any finite length but zero.
    pub direction: R::Vec3,
}

impl<R: Real> Ray<R> {
    /// Whether this is a ray, and one that exact arithmetic can decide.
    ///
    /// # Errors
    /// [`InvalidRay`], for the first reason that holds.
    ///
    /// # Example
    ///
    /// ```
    /// # use raytree::kernels::{InvalidRay, Ray};
    /// # use glam::vec3;
    /// let ray = |direction| Ray::<f32> { origin: vec3(0.0, 0.0, 0.0), direction };
    /// assert_eq!(ray(vec3(0.0, 2.0, 0.0)).check(), Ok(()));
    /// assert_eq!(ray(vec3(0.0, f32::NAN, 0.0)).check(), Err(InvalidRay::NotFinite));
    /// assert_eq!(ray(vec3(0.0, -0.0, 0.0)).check(), Err(InvalidRay::ZeroDirection));
    /// ```
    pub fn check(&self) -> Result<(), InvalidRay> {
        let components = || self.origin.to_f64().into_iter().chain(self.direction.to_f64());
        if !components().all(f64::is_finite) {
            return Err(InvalidRay::NotFinite);
        }
        if self.direction.to_f64() == [0.0; 3] {
            return Err(InvalidRay::ZeroDirection);
        }
        if components().all(is_in_range) { Ok(()) } else { Err(InvalidRay::OutOfRange) }
    }

    /// The point `origin + t direction`, rounded once in each product and each sum.
    #[inline(always)]
    pub fn at(&self, t: R) -> R::Vec3 {
        self.origin + self.direction * t
    }
}

/// Why three numbers and three numbers are no ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InvalidRay {
    /// A component is infinite or not a number.
    NotFinite,
    /// The direction has length zero.
    ZeroDirection,
    /// A component is out of the range of exact arithmetic, see [`is_in_range`]; `transport::spawn` brings it in where
    /// it is too small.
    OutOfRange,
}

impl std::fmt::Display for InvalidRay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "a component of the ray is infinite or not a number",
            Self::ZeroDirection => "the ray's direction has length zero",
            Self::OutOfRange => "a component of the ray is neither 0 nor a multiple of 2^-178 of at most 2^128",
        })
    }
}

impl std::error::Error for InvalidRay {}

/// Where a ray starts with regard to one convex solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Anywhere: both of the solid's roots count where `t >= 0`.
    Anywhere,
    /// On the solid's surface by identity, going in: only the far root counts, however the origin was rounded.
    OnSurfaceInward,
}
