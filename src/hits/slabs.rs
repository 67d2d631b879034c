//! The conservative box test of the hierarchy: it may let a ray in that misses, never turn one away that hits.

use crate::kernels::Ray;
use crate::numbers::{Real, Vector3};

/// An axis-aligned box around something, in f64 whatever the precision of the geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The smallest coordinates.
    pub min: [f64; 3],
    /// The largest coordinates.
    pub max: [f64; 3],
}

impl Bounds {
    /// The box around nothing, which every union forgets.
    pub const EMPTY: Self = Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// The smallest box around some points.
    pub fn of<R: Real>(points: impl IntoIterator<Item = R::Vec3>) -> Self {
        points.into_iter().map(Vector3::to_f64).map(|p| Self { min: p, max: p }).fold(Self::EMPTY, |a, b| a.union(&b))
    }

    /// The smallest box around both.
    pub fn union(&self, other: &Self) -> Self {
        Self {
            min: std::array::from_fn(|k| self.min[k].min(other.min[k])),
            max: std::array::from_fn(|k| self.max[k].max(other.max[k])),
        }
    }

    /// Twice the middle.
    pub fn twice_center(&self) -> [f64; 3] {
        std::array::from_fn(|k| self.min[k] + self.max[k])
    }

    /// Half the surface area; 0 for the empty box.
    pub fn half_area(&self) -> f64 {
        let [x, y, z] = std::array::from_fn(|k| (self.max[k] - self.min[k]).max(0.0));
        x * y + y * z + z * x
    }

    /// The box with its sides moved out by `relative` times the largest coordinate.
    ///
    /// The sides of a sphere's box, `c -+ r`, round by `u` of the largest coordinate, and so does moving them: `4 u` holds
    /// both, with as much again to spare.
    pub fn grown(&self, relative: f64) -> Self {
        let largest = self.min.iter().chain(&self.max).fold(0.0_f64, |m, x| m.max(x.abs()));
        let by = largest * relative;
        Self { min: self.min.map(|x| x - by), max: self.max.map(|x| x + by) }
    }
}

/// A ray made ready for box tests: its direction's reciprocals.
#[derive(Clone, Copy, Debug)]
pub struct SlabRay {
    origin: [f64; 3],
    direction: [f64; 3],
    inverse: [f64; 3],
}

impl SlabRay {
    /// Three roundings (difference, reciprocal, product) are below a relative 3u + 3u^2; this covers them, and its own use.
    pub const SLACK: f64 = 4.0 * f64::EPSILON;

    /// The ray in f64; its components convert exactly.
    pub fn new<R: Real>(ray: &Ray<R>) -> Self {
        let direction = ray.direction.to_f64();
        Self { origin: ray.origin.to_f64(), direction, inverse: direction.map(|d| 1.0 / d) }
    }

    /// The ray's direction.
    #[inline(always)]
    pub fn direction(&self) -> [f64; 3] {
        self.direction
    }

    /// Where the ray enters and leaves a box: `t_in` not above, `t_out` not below the true value, `t_in >= 0`; the ray
    /// surely misses where `t_in > t_out`. Beside a slab that it runs along, `t_in` is infinite and `t_out` -infinite.
    ///
    /// Monotone: a box around this one gives a span around this one's, computed values included. That is what makes a
    /// hierarchy find exactly what a list finds.
    #[inline(always)]
    pub fn span(&self, bounds: &Bounds) -> (f64, f64) {
        let (mut t_in, mut t_out) = (0.0_f64, f64::INFINITY);
        for k in 0..3 {
            let inverse = self.inverse[k];
            if self.direction[k] == 0.0 {
                // The direction has no component along this axis.
                if self.origin[k] < bounds.min[k] || self.origin[k] > bounds.max[k] {
                    return (f64::INFINITY, f64::NEG_INFINITY);
                }
                continue;
            }
            let (near, far) =
                if inverse >= 0.0 { (bounds.min[k], bounds.max[k]) } else { (bounds.max[k], bounds.min[k]) };
            let near = (near - self.origin[k]) * inverse;
            let far = (far - self.origin[k]) * inverse;
            t_in = if near > t_in { near } else { t_in };
            t_out = if far < t_out { far } else { t_out };
        }
        (t_in * (1.0 - Self::SLACK), t_out * (1.0 + Self::SLACK))
    }
}
