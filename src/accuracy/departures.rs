//! What becomes of the rays that leave the surfaces seen in a scene, by what keeps them from hitting those again.

use std::sync::atomic::AtomicBool;

use super::images::each_pixel;
use crate::hits::Acceleration;
use crate::numbers::{Precision, Real, Vector3};
use crate::scene::{Numerics, Scene};
use crate::transport::{Children, LeavingPolicy, Options, Recorder, Tracer, Unfit, Visit};

/// The rays that left the surfaces seen from the eye, under one policy, beside the same rays by provenance.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Departures {
    /// What keeps a ray from hitting the surface it starts on.
    pub leaving: LeavingPolicy,
    /// Of the geometry; the kernels are the certified ones.
    pub precision: Precision,
    /// Shadow, reflected and refracted rays.
    pub rays: usize,
    /// Rays that end at something nearer: the surface that they left.
    pub self_hits: usize,
    /// Rays that miss what they should end at: it was nearer than the epsilon.
    pub lost: usize,
}

/// The epsilons of a sweep, two a decade.
pub const EPSILONS: [f64; 33] = [
    1e-16, 3e-16, 1e-15, 3e-15, 1e-14, 3e-14, 1e-13, 3e-13, 1e-12, 3e-12, 1e-11, 3e-11, 1e-10, 3e-10, 1e-9, 3e-9, 1e-8,
    3e-8, 1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1, 3e-1, 1.0,
];

/// Counts for every epsilon, for the offset by an error bound, and for provenance itself, in both precisions; nothing
/// if `stop` was set meanwhile.
///
/// # Errors
/// [`Unfit`] where the scene does not fit f64; where it does not fit f32 there is nothing for f32.
pub fn sweep(scene: &Scene, stop: &AtomicBool, done: &dyn Fn()) -> Result<Option<Vec<Departures>>, Unfit> {
    let Some(mut all) = sweep_in::<f64>(scene, stop, done)? else { return Ok(None) };
    match sweep_in::<f32>(scene, stop, done) {
        Ok(Some(single)) => all.extend(single),
        Ok(None) => return Ok(None),
        Err(_) => {}
    }
    Ok(Some(all))
}

fn sweep_in<R: Real>(scene: &Scene, stop: &AtomicBool, done: &dyn Fn()) -> Result<Option<Vec<Departures>>, Unfit> {
    let Some(truth) = ends::<R>(scene, LeavingPolicy::Provenance, stop)? else { return Ok(None) };
    let policies = EPSILONS.into_iter().map(LeavingPolicy::FixedEpsilon);
    let mut all = Vec::new();
    for leaving in policies.chain([LeavingPolicy::ErrorBound, LeavingPolicy::Provenance]) {
        let Some(ends) = ends::<R>(scene, leaving, stop)? else { return Ok(None) };
        let pairs = || ends.iter().flatten().zip(truth.iter().flatten());
        all.push(Departures {
            leaving,
            precision: R::PRECISION,
            rays: pairs().count(),
            self_hits: pairs().filter(|(end, truth)| **end < **truth * (1.0 - SAME)).count(),
            lost: pairs().filter(|(end, truth)| **end > **truth * (1.0 + SAME)).count(),
        });
        done();
    }
    Ok(Some(all))
}

/// Ends this near, relatively, are the same: an origin that was moved changes `t` a little.
const SAME: f64 = 0.01;

/// For every pixel, how far the rays went that left the first surface.
fn ends<R: Real>(scene: &Scene, leaving: LeavingPolicy, stop: &AtomicBool) -> Result<Option<Vec<Vec<f64>>>, Unfit> {
    // The children of the first hit are traced, theirs are not.
    let mut options = Options {
        numerics: Numerics::Certified,
        leaving: Some(leaving),
        acceleration: Acceleration::Bvh,
        ..Options::of(scene)
    };
    options.limits.max_depth = options.limits.max_depth.min(1);
    let tracer = Tracer::<R>::new(scene, options)?;
    let pixels = each_pixel(&tracer, &Ends, stop);
    Ok(pixels.map(|pixels| pixels.into_iter().map(|(_, (_, children))| children).collect()))
}

/// How far a ray went (infinitely far, where it hit nothing), and its children.
struct Ends;

impl Recorder for Ends {
    type Probe = ();
    type Node = (f64, Vec<f64>);
    const RECORDS: bool = true;
    fn node<R: Real>(&self, visit: Visit<'_, R, ()>, children: Children<Self::Node>) -> Self::Node {
        let length = visit.ray.direction.dot(visit.ray.direction).to_f64().sqrt();
        let end = visit.surface.map_or(f64::INFINITY, |surface| surface.hit.nearest.t * length);
        let children = children.shadows.into_iter().chain(children.reflected).chain(children.refracted);
        (end, children.map(|(end, _)| end).collect())
    }
}
