//! Rays that leave a surface: do they hit it again, and do they see what is very near?

use glam::DVec3;

use super::bare_scene::bare_scene;
use super::random::{Random, rounded, stored};
use crate::hits::{Departure, Limit};
use crate::kernels::Ray;
use crate::numbers::{Real, Vector3};
use crate::scene::{Numerics, Scene, Shape};
use crate::transport::{Leaving, LeavingPolicy, Options, Secondary, Surface, Tracer, spawn};

/// What rays start from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// A plane in any position.
    Plane,
    /// A sphere of radius 1.
    Sphere,
    /// A triangle in any position, of edges about 3 long.
    Triangle,
    /// A cube of edge 1.
    Box,
}

impl Ground {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Plane, Self::Sphere, Self::Triangle, Self::Box];

    /// What it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Sphere => "sphere",
            Self::Triangle => "triangle",
            Self::Box => "box",
        }
    }

    /// The shape at `place`, and a point on it that the eye at `eye` from `place` sees.
    fn draw(self, g: &mut Random, place: DVec3, eye: DVec3) -> (Shape, DVec3) {
        match self {
            Self::Plane => {
                let normal = g.direction();
                let across = normal.cross(g.direction());
                (Shape::Plane { normal, distance: normal.dot(place) }, place + across)
            }
            Self::Sphere => {
                let out = g.direction();
                let towards = if out.dot(eye) < 0.0 { -out } else { out };
                (Shape::Sphere { center: place, radius: 1.0 }, place + towards)
            }
            Self::Triangle => {
                let a = g.direction() * 2.0;
                let across = a.cross(g.direction()).normalize() * 2.0;
                let vertices = [a, across - a * 0.5, -across - a * 0.5].map(|v| v + place);
                let [u, v] = [g.unit(), g.unit()].map(|x| 0.45 * x);
                (Shape::Triangle { vertices }, vertices[0] * (1.0 - u - v) + vertices[1] * u + vertices[2] * v)
            }
            Self::Box => {
                let mut point = g.point(0.5);
                let axis = g.below(3);
                point[axis] = if eye[axis] < 0.0 { -0.5 } else { 0.5 };
                (Shape::Box { min: place - 0.5, max: place + 0.5 }, place + point)
            }
        }
    }
}

/// How rays are found and how they leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manner {
    /// The kernels.
    pub numerics: Numerics,
    /// What keeps rays from the surface they start on.
    pub leaving: LeavingPolicy,
}

impl Manner {
    /// The kernels with the policy that goes with them.
    pub fn of(numerics: Numerics) -> Self {
        Self { numerics, leaving: LeavingPolicy::of(numerics) }
    }

    fn tracer<R: Real>(self, scene: &Scene) -> Option<Tracer<'_, R>> {
        let Self { numerics, leaving } = self;
        Tracer::new(scene, Options { numerics, leaving: Some(leaving), ..Options::of(scene) }).ok()
    }
}

/// A ray that leaves a surface towards `direction`, on the side that it was seen from, and whether it meets anything.
fn meets<R: Real>(
    seen: &Tracer<'_, R>,
    asked: &Tracer<'_, R>,
    incident: &Ray<R>,
    surface: &Surface<R>,
    direction: R::Vec3,
) -> bool {
    let leaving = Leaving::new(seen, incident, Departure::default(), surface, direction, Secondary::Reflected);
    let ray = spawn(surface.origin_towards(direction), direction);
    asked.world().valid_is_hit(&ray, Limit::None, leaving.departure())
}

/// What came of rays that leave a surface which they cannot meet again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelfHits {
    /// How many rays there were.
    pub rays: usize,
    /// How many of them hit the surface that they left.
    pub hits: usize,
}

impl SelfHits {
    /// Of a hundred rays.
    pub fn percent(self) -> f64 {
        100.0 * self.hits as f64 / self.rays.max(1) as f64
    }
}

/// `count` rays that leave a ground about `scale` away from the world's origin, into the half of space that it was seen from:
/// one in two to a light in any direction, the others mirrored.
///
/// The ground lies in a new place for every ray; it is seen from 1 to 5 away.
pub fn self_hits<R: Real>(ground: Ground, manner: Manner, scale: f64, count: usize, seed: u64) -> SelfHits {
    let mut random = Random::new(seed);
    let g = &mut random;
    let mut found = SelfHits::default();
    while found.rays < count {
        let place = rounded::<R>(g.direction() * scale);
        let eye = g.direction() * (2.0 + 3.0 * g.unit());
        let (shape, target) = ground.draw(g, place, eye);
        let scene = bare_scene(vec![shape]);
        let Some(tracer) = manner.tracer::<R>(&scene) else { continue };
        let origin = rounded::<R>(place + eye);
        let ray = Ray::<R> { origin: stored::<R>(origin), direction: stored::<R>((target - origin).normalize()) };
        let Ok(flight) = tracer.flight(ray) else { continue };
        let Some(bounce) = tracer.bounce(&flight) else { continue };
        let normal = bounce.surface.shading_normal;
        let direction = match &bounce.reflected {
            Some(mirrored) if found.rays % 2 == 1 => mirrored.ray.direction,
            _ => stored::<R>(g.direction()),
        };
        let above = direction.dot(normal);
        if above == R::ZERO {
            continue;
        }
        let direction = if above < R::ZERO { -direction } else { direction };
        found.rays += 1;
        found.hits += usize::from(meets(&tracer, &tracer, &flight.ray, &bounce.surface, direction));
    }
    found
}

/// What came of rays from a ground to the light, past a card that lies on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactShadows {
    /// How many rays there were; all of them are in the card's shadow.
    pub rays: usize,
    /// How many of them found the way free.
    pub lost: usize,
}

/// `count` shadow rays from the plane y = `height` at a card that lies `gap` above it, at angles of up to 60 degrees.
///
/// Nothing is there to be counted if the gap is lost when both are stored in the precision.
pub fn contact_shadows<R: Real>(manner: Manner, height: f64, gap: f64, count: usize, seed: u64) -> ContactShadows {
    let [below, above] = [height, height + gap].map(|y| R::from_f64(y).to_f64());
    let mut shadows = ContactShadows::default();
    if !(below < above) {
        return shadows;
    }
    let ground = Shape::Plane { normal: DVec3::Y, distance: below };
    let corner = |x: f64, z: f64| DVec3::new(x, above, z);
    let card = Shape::Triangle { vertices: [corner(-64.0, -64.0), corner(64.0, -64.0), corner(0.0, 64.0)] };
    let (bare, covered) = (bare_scene(vec![ground.clone()]), bare_scene(vec![ground, card]));
    let (Some(bare), Some(covered)) = (manner.tracer::<R>(&bare), manner.tracer::<R>(&covered)) else { return shadows };
    let mut random = Random::new(seed);
    let g = &mut random;
    while shadows.rays < count {
        let origin = DVec3::new(4.0 * g.signed(), below + 1.0 + g.unit(), 4.0 * g.signed());
        let mut direction = g.direction();
        direction.y = -direction.y.abs().max(0.5);
        let ray = Ray::<R> { origin: stored::<R>(origin), direction: stored::<R>(direction) };
        let Ok(flight) = bare.flight(ray) else { continue };
        let Some(bounce) = bare.bounce(&flight) else { continue };
        let mut light = g.direction();
        light.y = light.y.abs().max(0.5);
        shadows.rays += 1;
        shadows.lost += usize::from(!meets(&bare, &covered, &flight.ray, &bounce.surface, stored::<R>(light)));
    }
    shadows
}

/// What came of rays in a closed box of mirrors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Chains {
    /// How many rays there were.
    pub rays: usize,
    /// How many of them got out.
    pub escaped: usize,
    /// How many of all points where they hit lie outside of the box.
    pub outside: usize,
    /// The largest distance from 1 that the length of a direction came to.
    pub length_error: f64,
}

/// `count` rays of length 1 from anywhere in the unit cube in any direction, each mirrored `bounces` times by its walls.
pub fn mirrored_cube<R: Real>(manner: Manner, count: usize, bounces: usize, seed: u64) -> Chains {
    let scene = bare_scene(vec![Shape::Box { min: DVec3::ZERO, max: DVec3::ONE }]);
    let mut chains = Chains::default();
    let Some(tracer) = manner.tracer::<R>(&scene) else { return chains };
    let mut random = Random::new(seed);
    let g = &mut random;
    while chains.rays < count {
        let origin = DVec3::splat(0.5) + g.point(0.5);
        let ray = Ray::<R> { origin: stored::<R>(origin), direction: stored::<R>(g.direction()) };
        let Ok(mut flight) = tracer.flight(ray) else { continue };
        chains.rays += 1;
        for _ in 0..bounces {
            let Some(bounce) = tracer.bounce(&flight) else {
                chains.escaped += 1;
                break;
            };
            let point = bounce.surface.point.to_f64();
            chains.outside += usize::from(point.iter().any(|x| !(0.0..=1.0).contains(x)));
            let Some(next) = bounce.reflected else { break };
            flight = next;
        }
        let [x, y, z] = flight.ray.direction.to_f64();
        let length = DVec3::new(x, y, z).length();
        chains.length_error = chains.length_error.max((length - 1.0).abs());
    }
    chains
}
