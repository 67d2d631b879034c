use glam::DVec3;

use super::{ray, until};
use crate::accuracy::random::{Random, rounded, stored};
use crate::kernels::{Ray, Sphere};
use crate::numbers::Real;

/// A kind of pairs of a ray and a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereSet {
    /// Anything in a cube, most rays at the sphere.
    Random,
    /// From up to a million radii away.
    Far,
    /// Along a tangent, but for rounding.
    Grazing,
    /// From a point of the surface.
    OnSurface,
    /// A thousandth of the distance across.
    Small,
    /// A ground of radius 10^6 seen from a little above.
    Ground,
    /// All numbers integers of at most 4.
    SmallIntegers,
    /// Every number with its own exponent, up to 126.
    Exponents126,
    /// Exact tangents, along an axis.
    Tangent,
}

impl SphereSet {
    /// All of them, the easy ones first.
    pub const ALL: [Self; 9] = [
        Self::Random,
        Self::Small,
        Self::Far,
        Self::Ground,
        Self::OnSurface,
        Self::Grazing,
        Self::Tangent,
        Self::SmallIntegers,
        Self::Exponents126,
    ];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Far => "far away",
            Self::Grazing => "grazing",
            Self::OnSurface => "from the surface",
            Self::Small => "small",
            Self::Ground => "giant ground sphere",
            Self::SmallIntegers => "small integers",
            Self::Exponents126 => "exponents to 126",
            Self::Tangent => "exact tangents",
        }
    }

    /// The next pair, as stored in the precision.
    pub fn next<R: Real>(self, g: &mut Random) -> (Ray<R>, Sphere<R>) {
        until(|| self.draw(g))
    }

    fn draw<R: Real>(self, g: &mut Random) -> Option<(Ray<R>, Sphere<R>)> {
        // Multiples of 2^-12: sums with them are exact.
        let on_grid = |x: f64| (x * 4096.0).round() / 4096.0;
        let (c, r) = match self {
            Self::Small => (g.point(10.0), 1e-3 * (0.5 + g.unit())),
            Self::Ground => (DVec3::new(0.0, -1e6, 0.0), 1e6),
            Self::SmallIntegers => (g.small_integers(), g.below(5) as f64),
            Self::Exponents126 => (g.wild_vector(126), g.wild(126).abs()),
            Self::Tangent => (g.vector(|g| on_grid(3.0 * g.signed())), 0.1 + g.unit()),
            _ => (g.point(3.0), 0.1 + g.unit()),
        };
        let (c, r) = (rounded::<R>(c), R::from_f64(r).to_f64());
        let (o, d) = match self {
            Self::Far => {
                let o = c + g.direction() * [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6][g.below(7)];
                (o, c + g.direction() * (1.2 * r * g.unit()) - o)
            }
            Self::Grazing => {
                // A point on the sphere and a direction across the normal there, from some way back.
                let (n, v) = (g.direction(), g.direction());
                let d = v - n * n.dot(v);
                (c + n * r - d * (4.0 * g.signed()), d)
            }
            Self::OnSurface => {
                let o = c + g.direction() * r;
                (o, if g.one_in(4) { (o - c) * if g.one_in(2) { 1.0 } else { -1.0 } } else { g.direction() })
            }
            Self::Ground => (
                DVec3::new(10.0 * g.signed(), g.unit(), 10.0 * g.signed()),
                DVec3::new(g.signed(), -0.003 * g.unit(), g.signed()),
            ),
            Self::SmallIntegers => (g.small_integers(), g.small_integers()),
            Self::Exponents126 => {
                let o = g.wild_vector(126);
                (o, if g.one_in(2) { c - o } else { g.wild_vector(126) })
            }
            Self::Tangent => {
                // Along one axis, a radius away from the centre on another.
                let (along, across) = (g.below(3), 1 + g.below(2));
                let (mut o, mut d) = (c, DVec3::ZERO);
                o[(along + across) % 3] += r;
                o[along] += on_grid(4.0 * g.signed());
                d[along] = on_grid(g.signed());
                (o, d)
            }
            Self::Random | Self::Small => {
                let o = g.point(5.0);
                (o, c + g.direction() * (1.5 * r * g.unit()) - o)
            }
        };
        Some((ray(o, d)?, Sphere { center: stored::<R>(c), radius: R::from_f64(r) }))
    }
}
