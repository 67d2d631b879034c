use glam::DVec3;

use super::{ray, until};
use crate::accuracy::random::{Random, rounded, stored};
use crate::kernels::{Ray, Triangle};
use crate::numbers::{Real, power_of_two};

/// A kind of pairs of a ray and a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangleSet {
    /// Anything in a cube, half of the rays at the triangle, half past it.
    Random,
    /// A triangle of a sphere of 200 segments either way, slivers at the poles included.
    Mesh200,
    /// The same of 2000 segments.
    Mesh2000,
    /// A millionth of the distance across.
    Tiny,
    /// A hundred thousand times as long as wide.
    Needles,
    /// Random, around (148376, 1234, -223423).
    FarAway,
    /// Aimed at a point of an edge.
    Edge,
    /// Aimed at a vertex.
    Vertex,
    /// Aimed at a vertex, where `vertex - origin` is exact: every hit is a tie.
    VertexExact,
    /// All coordinates integers of at most 4.
    SmallIntegers,
    /// From a point of the triangle, half of them back at it.
    Secondary,
    /// From a point near the triangle's plane, along it.
    NearlyCoplanar,
    /// Every coordinate with its own exponent, up to 20.
    Exponents20,
    /// Every coordinate with its own exponent, up to 126.
    Exponents126,
}

impl TriangleSet {
    /// All of them, the easy ones first.
    pub const ALL: [Self; 14] = [
        Self::Random,
        Self::Mesh200,
        Self::Mesh2000,
        Self::Tiny,
        Self::Needles,
        Self::FarAway,
        Self::Edge,
        Self::Vertex,
        Self::VertexExact,
        Self::SmallIntegers,
        Self::Secondary,
        Self::NearlyCoplanar,
        Self::Exponents20,
        Self::Exponents126,
    ];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Mesh200 => "sphere mesh, 200 segments",
            Self::Mesh2000 => "sphere mesh, 2000 segments",
            Self::Tiny => "tiny",
            Self::Needles => "needles",
            Self::FarAway => "far away",
            Self::Edge => "aimed at edges",
            Self::Vertex => "aimed at vertices",
            Self::VertexExact => "aimed at vertices, exactly",
            Self::SmallIntegers => "small integers",
            Self::Secondary => "secondary rays",
            Self::NearlyCoplanar => "nearly coplanar",
            Self::Exponents20 => "exponents to 20",
            Self::Exponents126 => "exponents to 126",
        }
    }

    /// The next pair, as stored in the precision.
    pub fn next<R: Real>(self, g: &mut Random) -> (Ray<R>, Triangle<R>) {
        until(|| self.draw(g))
    }

    fn draw<R: Real>(self, g: &mut Random) -> Option<(Ray<R>, Triangle<R>)> {
        let shift = if self == Self::FarAway { DVec3::new(148_376.0, 1234.0, -223_423.0) } else { DVec3::ZERO };
        let mut v = self.corners(g).map(|p| rounded::<R>(p + shift));
        let mut o = rounded::<R>(g.point(3.0) + shift);
        let d = match self {
            Self::Edge => edge_point(g, v) - o,
            Self::Vertex => v[g.below(3)] - o,
            Self::VertexExact => {
                o = on_grid(o);
                v = v.map(on_grid);
                v[g.below(3)] - o
            }
            Self::SmallIntegers => {
                o = g.small_integers();
                match g.below(3) {
                    0 => g.small_integers(),
                    1 => v[g.below(3)] - o,
                    _ => v[g.below(3)] + v[g.below(3)] - 2.0 * o,
                }
            }
            Self::Secondary => {
                o = rounded::<R>(inner_point(g, v));
                if g.one_in(2) { g.point(1.0) } else { inner_point(g, v) - o }
            }
            Self::NearlyCoplanar => {
                o = rounded::<R>(v[0].lerp(v[1], 3.0 * g.signed()).lerp(v[2], 3.0 * g.signed()));
                inner_point(g, v) - o
            }
            Self::Exponents20 | Self::Exponents126 => {
                o = rounded::<R>(g.wild_vector(self.exponents()));
                match g.below(4) {
                    0 => g.wild_vector(self.exponents()),
                    1 => v[g.below(3)] - o,
                    2 => edge_point(g, v) - o,
                    _ => inner_point(g, v) - o,
                }
            }
            _ if g.one_in(2) => inner_point(g, v) - o,
            _ => inner_point(g, v).lerp(edge_point(g, v), 1.5 * g.unit()) - o,
        };
        Some((ray(o, d)?, Triangle { vertices: v.map(stored::<R>) }))
    }

    fn exponents(self) -> i32 {
        if self == Self::Exponents20 { 20 } else { 126 }
    }

    fn corners(self, g: &mut Random) -> [DVec3; 3] {
        match self {
            Self::Mesh200 => sphere_triangle(g, 200),
            Self::Mesh2000 => sphere_triangle(g, 2000),
            Self::Tiny => {
                let at = g.point(1.0);
                [(); 3].map(|()| at.lerp(g.point(1.0), 1e-6))
            }
            Self::Needles => {
                let (a, b) = (g.point(1.0), g.point(1.0));
                [a, b, b.lerp(g.point(1.0), 1e-5)]
            }
            Self::SmallIntegers => [(); 3].map(|()| g.small_integers()),
            Self::Exponents20 | Self::Exponents126 => [(); 3].map(|()| g.wild_vector(self.exponents())),
            _ => [(); 3].map(|()| g.point(1.0)),
        }
    }
}

/// A multiple of 2^-20: below 4, differences of such numbers are exact in either precision.
fn on_grid(p: DVec3) -> DVec3 {
    (p * power_of_two(20)).trunc() * power_of_two(-20)
}

fn edge_point(g: &mut Random, v: [DVec3; 3]) -> DVec3 {
    let i = g.below(3);
    v[i].lerp(v[(i + 1) % 3], g.unit())
}

fn inner_point(g: &mut Random, v: [DVec3; 3]) -> DVec3 {
    let (x, y) = (g.unit(), g.unit());
    v[0].lerp(v[1], x).lerp(v[2], y)
}

/// One of the triangles of a unit sphere made of circles of latitude and longitude.
fn sphere_triangle(g: &mut Random, segments: usize) -> [DVec3; 3] {
    let point = |i: usize, j: usize| {
        let theta = std::f64::consts::PI * i as f64 / segments as f64;
        let phi = std::f64::consts::TAU * j as f64 / segments as f64;
        DVec3::new(libm::sin(theta) * libm::cos(phi), libm::cos(theta), libm::sin(theta) * libm::sin(phi))
    };
    let (i, j) = (g.below(segments), g.below(segments));
    if g.one_in(2) {
        [point(i, j), point(i, j + 1), point(i + 1, j)]
    } else {
        [point(i + 1, j), point(i, j + 1), point(i + 1, j + 1)]
    }
}
