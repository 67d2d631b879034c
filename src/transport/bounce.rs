//! One bounce at a time, for loops that follow a ray as far as they like.

use super::leaving::{Leaving, spawn};
use super::media::Inside;
use super::recorder::Secondary;
use super::secondary::{Split, Way};
use super::surface::Surface;
use super::trace::Tracer;
use crate::hits::{Departure, Limit};
use crate::kernels::{InvalidRay, Ray};
use crate::numbers::Real;

/// A ray under way: itself, the surface it left, and the media it is in.
#[derive(Clone, Debug)]
pub struct Flight<R: Real> {
    /// The ray.
    pub ray: Ray<R>,
    /// How it left the surface it starts on; nothing at the start of the chain.
    pub leaving: Option<Leaving>,
    /// The media it travels in.
    pub inside: Inside,
}

/// What becomes of a ray at the nearest surface.
#[derive(Clone, Debug)]
pub struct Bounce<R: Real> {
    /// The surface.
    pub surface: Surface<R>,
    /// How its material splits the light, with the weights.
    pub split: Split<R>,
    /// The ray back from it, where there is one.
    pub reflected: Option<Flight<R>>,
    /// The ray through it, where there is one.
    pub refracted: Option<Flight<R>>,
}

impl<R: Real> Tracer<'_, R> {
    /// The start of a chain of bounces.
    ///
    /// # Errors
    /// [`InvalidRay`] for what is no ray, or out of the range of exact arithmetic.
    pub fn flight(&self, ray: Ray<R>) -> Result<Flight<R>, InvalidRay> {
        ray.check()?;
        let inside =
            if self.has_media() { Inside::at_start(self.scene(), self.world(), &ray) } else { Inside::default() };
        Ok(Flight { ray, leaving: None, inside })
    }

    /// One bounce: the nearest surface and the rays that leave it, none of them traced. Nothing where the ray meets no
    /// surface.
    ///
    /// The recursion's limits do not count here: a loop may go on for as long as it likes.
    ///
    /// ```
    /// # use raytree::{kernels::Ray, transport::{Options, Tracer}};
    /// # use glam::dvec3;
    /// let text = r#"{
    ///     "image": { "width": 1, "height": 1 },
    ///     "camera": { "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 40 },
    ///     "materials": { "mirror": { "reflection": 1 } },
    ///     "objects": [ { "material": "mirror", "shape": { "box": { "min": [-1, -1, -1], "max": [1, 1, 1] } } } ]
    /// }"#;
    /// let loaded = raytree::scene::load("room.json", text, &mut |_| Err("no mesh".into()))?;
    /// let tracer = Tracer::<f64>::new(&loaded.scene, Options::of(&loaded.scene)).expect("f64 holds it");
    /// let mut flight = tracer.flight(Ray { origin: dvec3(0.1, 0.2, 0.3), direction: dvec3(0.6, 0.0, 0.8) })?;
    /// for _ in 0..1000 {
    ///     flight = tracer.bounce(&flight).and_then(|bounce| bounce.reflected).expect("no way out");
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bounce(&self, flight: &Flight<R>) -> Option<Bounce<R>> {
        let departure = flight.leaving.as_ref().map_or(Departure::default(), Leaving::departure);
        let hit = self.world().nearest_of_valid(&flight.ray, Limit::None, departure, &mut ())?;
        let surface = Surface::new(self, &flight.ray, hit, &flight.inside);
        let split = self.split(&flight.ray, &surface);
        let follow = |way: &Way<R>| Flight {
            ray: spawn(surface.origin_towards(way.direction), way.direction),
            leaving: Some(Leaving::new(self, &flight.ray, departure, &surface, way.direction, way.kind)),
            inside: match way.kind {
                Secondary::Reflected => flight.inside.clone(),
                Secondary::Refracted => surface.beyond.clone(),
            },
        };
        let (reflected, refracted) = (split.reflected.as_ref().map(follow), split.refracted.as_ref().map(follow));
        Some(Bounce { surface, split, reflected, refracted })
    }
}
