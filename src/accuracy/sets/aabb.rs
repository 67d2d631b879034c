use glam::DVec3;

use super::{ray, until};
use crate::accuracy::random::{Random, rounded, stored};
use crate::kernels::{Aabb, Ray};
use crate::numbers::{Real, Vector3};

/// A kind of pairs of a ray and a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoxSet {
    /// Anything in a cube, the rays at the box.
    Random,
    /// From a point of a face.
    OnFace,
    /// Aimed at a point of an edge.
    Edge,
    /// Aimed at a corner.
    Corner,
    /// The ray in the plane of a face or along an edge, components of the direction 0 or -0.
    InFace,
    /// Any of [`box_lattice`].
    Lattice,
    /// Every coordinate with its own exponent, up to 126; aimed at corners.
    Exponents126,
}

impl BoxSet {
    /// All of them, the easy ones first.
    pub const ALL: [Self; 7] =
        [Self::Random, Self::OnFace, Self::Edge, Self::Corner, Self::InFace, Self::Lattice, Self::Exponents126];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::OnFace => "from a face",
            Self::Edge => "aimed at edges",
            Self::Corner => "aimed at corners",
            Self::InFace => "in the plane of a face",
            Self::Lattice => "small-integer lattice",
            Self::Exponents126 => "exponents to 126",
        }
    }

    /// The next pair, as stored in the precision.
    pub fn next<R: Real>(self, g: &mut Random) -> (Ray<R>, Aabb<R>) {
        until(|| self.draw(g))
    }

    fn draw<R: Real>(self, g: &mut Random) -> Option<(Ray<R>, Aabb<R>)> {
        if self == Self::Lattice {
            let o = g.vector(|g| g.below(5) as f64 - 2.0);
            let d = g.vector(|g| [-1.0, -0.0, 0.0, 1.0][g.below(4)]);
            let max = stored::<R>(DVec3::from_array(LATTICE_CORNERS[g.below(3)]));
            return Some((ray(o, d)?, Aabb { min: -max, max }));
        }
        let mut corner = || match self {
            Self::Exponents126 => rounded::<R>(g.wild_vector(126)),
            _ => rounded::<R>(g.point(1.0)),
        };
        let (a, b) = (corner(), corner());
        let (min, max) = (a.min(b), a.max(b));
        let pick = |g: &mut Random, k: usize| if g.one_in(2) { min[k] } else { max[k] };
        let between = |g: &mut Random, k: usize| min[k] + g.unit() * (max[k] - min[k]);
        let free = if self == Self::Edge { g.below(3) } else { 3 };
        let mut target = DVec3::ZERO;
        for k in 0..3 {
            let on_boundary = matches!(self, Self::Edge | Self::Corner | Self::Exponents126) && k != free;
            target[k] = if on_boundary { pick(g, k) } else { between(g, k) };
        }
        let mut o = rounded::<R>(g.point(4.0));
        let mut d = target - o;
        let face = g.below(3);
        match self {
            Self::OnFace => {
                o = rounded::<R>(DVec3::new(between(g, 0), between(g, 1), between(g, 2)));
                o[face] = pick(g, face);
                d = g.point(1.0);
            }
            Self::InFace => {
                o[face] = pick(g, face);
                d[face] = if g.one_in(2) { 0.0 } else { -0.0 };
                if g.one_in(3) {
                    let other = (face + 1) % 3;
                    o[other] = pick(g, other);
                    d[other] = if g.one_in(2) { 0.0 } else { -0.0 };
                }
            }
            // Else t at the target would be 1 without any rounding.
            _ if g.one_in(2) => d *= 0.5 + g.unit(),
            _ => {}
        }
        Some((ray(o, d)?, Aabb { min: stored::<R>(min), max: stored::<R>(max) }))
    }
}

/// The upper corners of the lattice's boxes; the lower ones lie opposite.
const LATTICE_CORNERS: [[f64; 3]; 3] = [[1.0, 1.0, 1.0], [1.0, 1.0, 0.0], [0.0, 0.0, 0.0]];

/// Origins {-2..2}^3, directions {-1, -0, 0, 1}^3 but those of length 0, and three boxes: [-1, 1]^3, [-1, 1]^2 x {0} and
/// {0}. 21,000 cases that part the slab codes.
pub fn box_lattice<R: Real>() -> impl Iterator<Item = (Ray<R>, Aabb<R>)> {
    let triples = |values: &'static [f64]| {
        values.iter().flat_map(move |&x| values.iter().flat_map(move |&y| values.iter().map(move |&z| [x, y, z])))
    };
    triples(&[-2.0, -1.0, 0.0, 1.0, 2.0]).flat_map(move |origin| {
        triples(&[-1.0, -0.0, 0.0, 1.0]).filter(|d| *d != [0.0; 3]).flat_map(move |direction| {
            LATTICE_CORNERS.map(|max| {
                let ray = Ray { origin: R::Vec3::from_f64(origin), direction: R::Vec3::from_f64(direction) };
                (ray, Aabb { min: R::Vec3::from_f64(max.map(|x: f64| -x)), max: R::Vec3::from_f64(max) })
            })
        })
    })
}
