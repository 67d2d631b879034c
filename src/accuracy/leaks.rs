//! Leaks: rays that find nothing where there is no way past.
//!
//! Inside a closed mesh every ray has to hit something, and so has every parallel ray that meets a square. A kernel
//! that decides each triangle for itself, by rounded numbers, lets some through between two neighbours.

use glam::DVec3;

use super::bare_scene::bare_scene;
use super::random::{Random, rounded, stored};
use crate::hits::{Departure, Limit, World};
use crate::kernels::Ray;
use crate::numbers::Real;
use crate::scene::{Mesh, Numerics, Shape};

/// What came of rays each of which has to hit something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Leaks {
    /// How many rays there were.
    pub rays: usize,
    /// How many of them found nothing.
    pub leaked: usize,
}

impl Leaks {
    fn count<R: Real>(&mut self, world: &World<R>, ray: &Ray<R>) {
        self.rays += 1;
        self.leaked += usize::from(!world.valid_is_hit(ray, Limit::None, Departure::default()));
    }
}

/// What the rays from inside were aimed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Nothing: every direction equally likely.
    Anywhere,
    /// A corner of the mesh.
    Vertex,
    /// A point on an edge.
    Edge,
}

impl Aim {
    /// All of them, the easy one first.
    pub const ALL: [Self; 3] = [Self::Anywhere, Self::Vertex, Self::Edge];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Anywhere => "in any direction",
            Self::Vertex => "at vertices",
            Self::Edge => "at points on edges",
        }
    }
}

/// A place where f32 has steps of 1/64 in two coordinates and of 1/8192 in the third.
pub const FAR_AWAY: DVec3 = DVec3::new(148_376.0, 1_234.0, -223_423.0);

/// A closed surface around the origin, a unit sphere with waves on it: `12 cells^2` triangles wound outward.
///
/// The surface of a cube, each face cut into `cells` by `cells` squares of two triangles, drawn onto the sphere. A corner
/// is a function of its place in that grid alone, so that neighbours agree on it bit for bit.
pub fn bumpy_sphere(cells: u32) -> Vec<[DVec3; 3]> {
    let n = f64::from(cells);
    let corner = |on_cube: DVec3| {
        let p = on_cube.normalize();
        let waves = libm::sin(5.0 * p.x) + libm::sin(5.0 * p.y) + libm::sin(5.0 * p.z);
        p * (1.0 + 0.06 * waves)
    };
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (u, v) = (DVec3::AXES[(axis + 1) % 3], DVec3::AXES[(axis + 2) % 3]);
        for side in [-n, n] {
            let at = |i: u32, j: u32| {
                let [i, j] = [i, j].map(|k| 2.0 * f64::from(k) - n);
                // Turned round on the lower side, so that both look outward.
                let (i, j) = if side > 0.0 { (i, j) } else { (j, i) };
                corner(DVec3::AXES[axis] * side + u * i + v * j)
            };
            for (i, j) in (0..cells).flat_map(|i| (0..cells).map(move |j| (i, j))) {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    triangles
}

/// Rays from inside a [`bumpy_sphere`] of 2352 triangles that is moved to `center`: `count` of them, half in any direction
/// and half at vertices, and half as many again at points on edges; in the order of [`Aim::ALL`].
///
/// The mesh is rounded to the precision after it was moved, so that far away it is rough, but closed all the same.
pub fn from_inside<R: Real>(numerics: Numerics, center: DVec3, count: usize, seed: u64) -> [Leaks; 3] {
    let moved = |triangle: [DVec3; 3]| triangle.map(|corner| rounded::<R>(corner + center));
    let triangles: Vec<[DVec3; 3]> = bumpy_sphere(14).into_iter().map(moved).collect();
    let mesh = Shape::Mesh(Mesh { triangles: triangles.clone(), corner_normals: None, closed: true });
    let scene = bare_scene(vec![mesh]);
    let world = World::<R>::new(&scene, numerics, Default::default());
    let mut random = Random::new(seed);
    let g = &mut random;
    let mut leaks = [Leaks::default(); 3];
    for i in 0..count + count / 2 {
        let aim = Aim::ALL[if i < count { i % 2 } else { 2 }];
        // On a coarse grid, where the precision has one: then the way to a vertex is exact, and meets it.
        let on_grid = |x: f64| (x * 4096.0).round() / 4096.0;
        let origin = rounded::<R>(center + g.vector(|g| on_grid(0.3 * g.signed())));
        let [a, b, _] = triangles[g.below(triangles.len())];
        let direction = match aim {
            Aim::Anywhere => g.direction(),
            Aim::Vertex => a - origin,
            Aim::Edge => a + (b - a) * g.unit() - origin,
        };
        let ray = Ray::<R> { origin: stored::<R>(origin), direction: stored::<R>(direction) };
        leaks[aim as usize].count(&world, &ray);
    }
    leaks
}

/// Where parallel rays meet the square of [`through_square`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Square {
    /// In the plane z = 0 seen straight on.
    Upright,
    /// Leaning, seen at an angle. All numbers have few bits: the points that are aimed at are met exactly, on vertices,
    /// edges and the boundary too.
    Leaning,
    /// Turned so that no coordinate is a round number: the corners, rounded, no longer lie in one plane, and rays meet
    /// vertices and edges but for rounding. Its boundary is left out, as it is no longer known who meets it.
    Turned,
}

impl Square {
    /// All of them, the easy one first.
    pub const ALL: [Self; 3] = [Self::Upright, Self::Leaning, Self::Turned];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Upright => "upright",
            Self::Leaning => "leaning",
            Self::Turned => "turned",
        }
    }

    /// The vectors along both sides, the direction of the rays, and the way from where they meet the square to where they
    /// start.
    fn frame(self) -> [DVec3; 4] {
        let turned = |v: DVec3| glam::DMat3::from_cols(TURN[0], TURN[1], TURN[2]) * v;
        match self {
            Self::Upright => [DVec3::X, DVec3::Y, -DVec3::Z, 2.0 * DVec3::Z],
            Self::Leaning => {
                let (across, upwards) = (DVec3::new(1.0, 0.0, 0.25), DVec3::new(0.0, 1.0, -0.375));
                // The origin is exact, while t = 2/3 is not.
                let direction = DVec3::new(0.375, -0.75, -3.0);
                [across, upwards, direction, DVec3::new(-0.25, 0.5, 2.0)]
            }
            Self::Turned => [turned(DVec3::X), turned(DVec3::Y), turned(-DVec3::Z), turned(2.0 * DVec3::Z)],
        }
    }
}

/// A rotation, made of the integers of 2^2 + 3^2 + 6^2 = 7^2.
const TURN: [DVec3; 3] = [
    DVec3::new(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0),
    DVec3::new(3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0),
    DVec3::new(6.0 / 7.0, 2.0 / 7.0, -3.0 / 7.0),
];

/// Cells of the square across and upwards; two triangles each make 65,536.
const CELLS: [u32; 2] = [256, 128];

/// The places of rays in units of 1/256: at vertices and along edges, with two sides of the boundary; the same with the
/// other two; through the middles of the diagonals.
const SHIFTS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 1.0], [0.5, 0.0]];

/// Three times 256 x 256 parallel rays at a unit square of 65,536 triangles: through its vertices, edges and diagonals, and
/// on its boundary.
pub fn through_square<R: Real>(numerics: Numerics, square: Square) -> Leaks {
    let [across, upwards, direction, back] = square.frame();
    let [columns, rows] = CELLS;
    let at = |i: u32, j: u32| {
        let (x, y) = (f64::from(i) / f64::from(columns), f64::from(j) / f64::from(rows));
        rounded::<R>(across * x + upwards * y)
    };
    let mut triangles = Vec::new();
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        triangles.extend([[a, b, c], [a, c, d]]);
    }
    let scene = bare_scene(vec![Shape::Mesh(Mesh { triangles, corner_normals: None, closed: false })]);
    let world = World::<R>::new(&scene, numerics, Default::default());
    let mut leaks = Leaks::default();
    let direction = stored::<R>(direction);
    for [right, up] in SHIFTS {
        for (i, j) in (0..256_u32).flat_map(|j| (0..256_u32).map(move |i| (i, j))) {
            let [x, y] = [(f64::from(i) + right) / 256.0, (f64::from(j) + up) / 256.0];
            let on_boundary = [x, y].into_iter().any(|x| x == 0.0 || x == 1.0);
            if on_boundary && square == Square::Turned {
                continue;
            }
            let origin = stored::<R>(across * x + upwards * y + back);
            leaks.count(&world, &Ray { origin, direction });
        }
    }
    leaks
}
