//! How a ray leaves a surface. By default by identity: the origin is the hit point itself, and the surfaces it left are
//! not hit again. The lecture's epsilon and the offset by an error bound stand beside it.

use super::recorder::Secondary;
use super::surface::Surface;
use super::trace::Tracer;
use crate::hits::{Candidate, Departure, Detail, Left};
use crate::kernels::{Ray, offset_origin};
use crate::numbers::{Real, Vector3, flush_tiny, power_of_two};
use crate::scene::Numerics;

/// What keeps a new ray from hitting the surface it starts on.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum LeavingPolicy {
    /// The ray starts at the hit point, and hits at `t` up to this do not count: what most lectures teach. Too small
    /// far from the origin, where surfaces shadow themselves; too large for contact shadows.
    FixedEpsilon(f64),
    /// The ray starts beside the hit point, as far off as rounding may have put that: what good renderers do. No
    /// surface shadows itself; a gap below the bound is not seen.
    ErrorBound,
    /// The ray starts at the hit point and knows the surface it left: nothing shadows itself, at any scale, and no gap
    /// is too small.
    Provenance,
}

impl LeavingPolicy {
    /// The lecture's epsilon.
    pub const LECTURE_EPSILON: f64 = 1e-4;

    /// The policy that goes with a set of kernels.
    pub fn of(numerics: Numerics) -> Self {
        match numerics {
            Numerics::Lecture => Self::FixedEpsilon(Self::LECTURE_EPSILON),
            Numerics::Robust => Self::ErrorBound,
            Numerics::Certified => Self::Provenance,
        }
    }
}

/// How a new ray leaves.
#[derive(Clone, Debug)]
pub struct Leaving {
    /// The surface it starts on; nothing where the policy does not go by identity.
    first: Option<Left>,
    /// All of them, where there are several.
    several: Vec<Left>,
    epsilon: Option<f64>,
}

impl Leaving {
    /// Of a ray towards `direction`; shadow rays leave like reflected ones.
    ///
    /// Surfaces at exactly equal `t` are left together, as far as the ray stays on their near side (reflected), or
    /// passes them and they let it through (refracted). The others stand in its way and are tested as stored. Where the
    /// hit lies at `t = 0`, in a corner, what the incident ray had left at that same point (`departure`) stays left as
    /// far as the new ray is on the same side of it.
    pub fn new<R: Real>(
        tracer: &Tracer<'_, R>,
        incident: &Ray<R>,
        departure: Departure<'_>,
        surface: &Surface<R>,
        direction: R::Vec3,
        way: Secondary,
    ) -> Self {
        let none = Self { first: None, several: Vec::new(), epsilon: None };
        match tracer.leaving() {
            LeavingPolicy::FixedEpsilon(epsilon) => return Self { epsilon: Some(epsilon), ..none },
            // Strictly beyond the origin: a face at 0 has no rounding to be moved by.
            LeavingPolicy::ErrorBound => return Self { epsilon: Some(0.0), ..none },
            LeavingPolicy::Provenance => {}
        }
        let nearest = &surface.hit.nearest;
        let left = |hit: &Candidate<R>| left(tracer, incident, hit, way);
        let first = left(nearest);
        let mut several = Vec::new();
        let spawned = Ray { origin: surface.point, direction };
        if !surface.hit.tied.is_empty() {
            several.push(first);
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
        if nearest.t == 0.0 {
            let world = tracer.world();
            let stays = |old: &&Left| {
                let at = old.at_start();
                (old.object, old.primitive) != (first.object, first.primitive)
                    && world.facing_of(incident, &at) == world.facing_of(&spawned, &at)
            };
            let staying: Vec<Left> = departure.left.iter().filter(stays).copied().collect();
            if several.is_empty() && !staying.is_empty() {
                several.push(first);
            }
            several.extend(staying);
        }
        Self { first: Some(first), several, epsilon: None }
    }

    /// What a hit query asks for.
    pub fn departure(&self) -> Departure<'_> {
        let left = if self.several.is_empty() { self.first.as_slice() } else { &self.several };
        Departure { left, epsilon: self.epsilon }
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

impl<R: Real> Surface<R> {
    /// Where a ray in this direction starts: at the hit point, or as far beside it as rounding may have put that.
    pub fn origin_towards(&self, direction: R::Vec3) -> R::Vec3 {
        match self.point_error {
            None => self.point,
            Some(error) => offset_origin::<R>(self.point, error, self.geometric_normal, direction),
        }
    }
}

/// The ray from `origin` towards `direction`, components below 2^-126 stored as 0 and those of the origin
/// beyond 2^128 as 2^128, so that exact arithmetic stays exact.
pub fn spawn<R: Real>(origin: R::Vec3, direction: R::Vec3) -> Ray<R> {
    let largest = R::PRECISION.largest().min(power_of_two(128));
    let origin = origin.to_f64().map(|x| flush_tiny(x).clamp(-largest, largest));
    let direction = direction.to_f64().map(flush_tiny);
    Ray { origin: R::Vec3::from_f64(origin), direction: R::Vec3::from_f64(direction) }
}
