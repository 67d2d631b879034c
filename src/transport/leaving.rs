//! How a ray leaves a surface: by identity. The origin is the hit point itself, and the surfaces it left are not hit
//! again.

use super::recorder::Secondary;
use super::surface::Surface;
use super::trace::Tracer;
use crate::hits::{Candidate, Departure, Detail, Left};
use crate::kernels::Ray;
use crate::numbers::{Real, Vector3, flush_tiny};

/// The surfaces that a new ray starts on.
#[derive(Clone, Debug)]
pub struct Leaving {
    first: [Left; 1],
    /// All of them, where there are several.
    several: Vec<Left>,
}

impl Leaving {
    /// Of a ray towards `direction`; shadow rays leave like reflected ones.
    ///
    /// Surfaces at exactly equal `t` are left together, as far as the ray stays on their near side (reflected), or
    /// passes them and they let it through (refracted). The others stand in its way and are tested as stored.
    pub fn new<R: Real>(
        tracer: &Tracer<'_, R>,
        incident: &Ray<R>,
        surface: &Surface<R>,
        direction: R::Vec3,
        way: Secondary,
    ) -> Self {
        let nearest = &surface.hit.nearest;
        let left = |hit: &Candidate<R>| left(tracer, incident, hit, way);
        let first = left(nearest);
        let mut several = Vec::new();
        if !surface.hit.tied.is_empty() {
            several.push(first);
            let spawned = Ray { origin: surface.point, direction };
            let goes_along = |other: &&Candidate<R>| {
                let (before, after) =
                    (tracer.world().facing(incident, other), tracer.world().facing_of(&spawned, other));
                match way {
                    Secondary::Reflected => before != after,
                    Secondary::Refracted => {
                        before == after && tracer.scene().material_of(other.object).transmission.is_some()
                    }
                }
            };
            several.extend(surface.hit.tied.iter().filter(goes_along).map(left));
        }
        Self { first: [first], several }
    }

    /// What a hit query asks for.
    pub fn departure(&self) -> Departure<'_> {
        Departure(if self.several.is_empty() { &self.first } else { &self.several })
    }
}

fn left<R: Real>(tracer: &Tracer<'_, R>, incident: &Ray<R>, hit: &Candidate<R>, way: Secondary) -> Left {
    let inward = match (hit.detail, way) {
        (Detail::Sphere { near, .. } | Detail::Box { near, .. }, Secondary::Reflected) => !near,
        (Detail::Sphere { .. } | Detail::Box { .. }, Secondary::Refracted) => {
            !tracer.world().leaves_behind(incident, hit)
        }
        (Detail::Plane | Detail::Triangle { .. }, _) => false,
    };
    Left { object: hit.object, primitive: hit.primitive, inward }
}

/// The ray from `origin` towards `direction`, components below 2^-126 stored as 0, so that exact arithmetic stays
/// exact.
pub fn spawn<R: Real>(origin: R::Vec3, direction: R::Vec3) -> Ray<R> {
    let flush = |v: R::Vec3| R::Vec3::from_f64(v.to_f64().map(flush_tiny));
    Ray { origin: flush(origin), direction: flush(direction) }
}
