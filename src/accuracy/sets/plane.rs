use glam::DVec3;

use super::{ray, until};
use crate::accuracy::random::{Random, rounded, stored};
use crate::kernels::{Plane, Ray};
use crate::numbers::Real;

/// A kind of pairs of a ray and a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneSet {
    /// Anything in a cube.
    Random,
    /// Along the plane, but for rounding; one in four exactly so.
    Parallel,
    /// From the plane, but for rounding.
    FromPlane,
    /// All numbers integers of at most 4.
    SmallIntegers,
    /// Every number with its own exponent, up to 126.
    Exponents126,
}

impl PlaneSet {
    /// All of them, the easy ones first.
    pub const ALL: [Self; 5] = [Self::Random, Self::Parallel, Self::FromPlane, Self::SmallIntegers, Self::Exponents126];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Parallel => "parallel",
            Self::FromPlane => "from the plane",
            Self::SmallIntegers => "small integers",
            Self::Exponents126 => "exponents to 126",
        }
    }

    /// The next pair, as stored in the precision.
    pub fn next<R: Real>(self, g: &mut Random) -> (Ray<R>, Plane<R>) {
        until(|| self.draw(g))
    }

    fn draw<R: Real>(self, g: &mut Random) -> Option<(Ray<R>, Plane<R>)> {
        let (n, o) = match self {
            Self::SmallIntegers => (g.small_integers(), g.small_integers()),
            Self::Exponents126 => (g.wild_vector(126), g.wild_vector(126)),
            _ => (rounded::<R>(g.point(1.0)), rounded::<R>(g.point(100.0))),
        };
        let d = match self {
            Self::SmallIntegers => g.small_integers(),
            Self::Exponents126 => g.wild_vector(126),
            Self::Parallel if g.one_in(4) => DVec3::new(n.y, -n.x, 0.0),
            Self::Parallel => n.cross(g.point(1.0)),
            _ => g.point(1.0),
        };
        let distance = match self {
            Self::SmallIntegers => g.below(9) as f64 - 4.0,
            Self::Exponents126 => g.wild(126),
            Self::FromPlane => n.dot(o),
            _ => g.signed(),
        };
        Some((ray(o, d)?, Plane { normal: stored::<R>(n), distance: R::from_f64(distance) }))
    }
}
