//! Where rays start: on surfaces that were met before, or anywhere.

use super::super::Ray;
use crate::hits::{Departure, Hit};
use crate::transport::{Inside, Leaving, Secondary, Surface, Tracer, spawn};

/// How a ray starts.
#[derive(Clone, Debug)]
pub(super) struct Start {
    /// How it leaves the surface that it starts on; nothing where it starts on none.
    leaving: Option<Leaving>,
    /// The media it is in.
    pub(super) inside: Inside,
}

/// What was met on the way to a pixel.
#[derive(Debug, Default)]
pub(super) struct Starts {
    met: Vec<Meeting>,
    /// What is being shaded: each sends out the ray that has met the next.
    shaded: Vec<usize>,
}

/// A ray and a surface on it.
#[derive(Debug)]
struct Meeting {
    ray: Ray,
    start: Start,
    surface: Surface<f64>,
}

impl Starts {
    /// Shading of a surface that was met begins, or ends.
    pub(super) fn begin_shading(&mut self, place: usize) {
        self.shaded.push(place);
    }

    pub(super) fn end_shading(&mut self) {
        self.shaded.pop();
    }

    /// How a ray starts: if its origin is a point that was met, it leaves that surface, to the side that it points to. Of
    /// several that were met there, in a corner, it is the one that is being shaded.
    pub(super) fn of(&self, tracer: &Tracer<'_, f64>, ray: &Ray) -> Start {
        let shaded = self.shaded.iter().rev().map(|place| &self.met[*place]);
        let mut candidates = shaded.chain(self.met.iter().rev());
        let Some(Meeting { ray: incident, start, surface }) =
            candidates.find(|meeting| meeting.surface.point == ray.origin)
        else {
            let is_known = tracer.has_media() && ray.check().is_ok();
            let inside = match is_known {
                true => Inside::at_start(tracer.scene(), tracer.world(), ray),
                false => Inside::default(),
            };
            return Start { leaving: None, inside };
        };
        let (way, inside) = match ray.direction.dot(surface.shading_normal) < 0.0 {
            true => (Secondary::Refracted, &surface.beyond),
            false => (Secondary::Reflected, &start.inside),
        };
        let departure = start.leaving.as_ref().map_or(Departure::default(), Leaving::departure);
        let leaving = Leaving::new(tracer, incident, departure, surface, ray.direction, way);
        Start { leaving: Some(leaving), inside: inside.clone() }
    }

    /// Keeps what a ray meets, if anything, and says where.
    pub(super) fn meet(
        &mut self,
        tracer: &Tracer<'_, f64>,
        ray: &Ray,
        nearest: impl FnOnce(&Ray, Departure<'_>) -> Option<Hit<f64>>,
    ) -> Option<usize> {
        let start = self.of(tracer, ray);
        let ray = spawn(ray.origin, ray.direction);
        ray.check().ok()?;
        let hit = nearest(&ray, start.leaving.as_ref().map_or(Departure::default(), Leaving::departure))?;
        let surface = Surface::new(tracer, &ray, hit, &start.inside);
        self.met.push(Meeting { ray, start, surface });
        Some(self.met.len() - 1)
    }

    /// A surface that was met.
    pub(super) fn surface(&self, place: usize) -> Surface<f64> {
        self.met[place].surface.clone()
    }
}
