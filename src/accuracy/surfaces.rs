//! Whether surfaces hold, and what becomes of rays that leave them: the experiments of [`leaks`] and [`spawning`], kernel by
//! kernel and policy by policy.

use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;

use super::leaks::{self, Aim, FAR_AWAY, Square};
use super::report::{Plan, Progress};
use super::spawning::{self, Ground, Manner};
use crate::numbers::{Precision, Real};
use crate::scene::Numerics;
use crate::transport::LeavingPolicy;

/// What was counted of surfaces.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Surfaces {
    /// Rays that each have to hit something.
    pub leaks: Vec<LeakCount>,
    /// Rays that leave a surface and cannot meet it again.
    pub self_hits: Vec<SelfHitCount>,
    /// Rays to the light that something very near shadows.
    pub contacts: Vec<ContactCount>,
    /// Rays in a closed box of mirrors.
    pub cubes: Vec<CubeCount>,
}

/// Rays that each have to hit something.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct LeakCount {
    /// The kernels.
    pub numerics: Numerics,
    /// Of geometry and plain arithmetic.
    pub precision: Precision,
    /// The surface, and what the rays were aimed at.
    pub what: String,
    /// How many rays there were.
    pub rays: usize,
    /// How many of them found nothing.
    pub leaked: usize,
}

/// Rays that leave a surface and cannot meet it again.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct SelfHitCount {
    /// The kernels.
    pub numerics: Numerics,
    /// Of geometry and plain arithmetic.
    pub precision: Precision,
    /// What keeps a ray from its surface.
    pub leaving: LeavingPolicy,
    /// What it left.
    pub ground: &'static str,
    /// How far from the world's origin that is.
    pub scale: f64,
    /// How many rays there were.
    pub rays: usize,
    /// How many of them hit what they left.
    pub hits: usize,
}

/// Rays to the light that something very near shadows.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct ContactCount {
    /// The kernels.
    pub numerics: Numerics,
    /// Of geometry and plain arithmetic.
    pub precision: Precision,
    /// What keeps a ray from its surface.
    pub leaving: LeavingPolicy,
    /// The floor's height above the world's origin.
    pub height: f64,
    /// How near.
    pub gap: f64,
    /// How many rays there were.
    pub rays: usize,
    /// How many of them found the way free.
    pub lost: usize,
}

/// Rays in a closed box of mirrors.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct CubeCount {
    /// The kernels.
    pub numerics: Numerics,
    /// Of geometry and plain arithmetic.
    pub precision: Precision,
    /// What keeps a ray from its surface.
    pub leaving: LeavingPolicy,
    /// How many rays there were.
    pub rays: usize,
    /// How often each was to be mirrored.
    pub bounces: usize,
    /// How many of them got out.
    pub escaped: usize,
}

/// Distances from the world's origin.
pub const SCALES: [f64; 4] = [1.0, 1e2, 1e4, 1e6];

/// Heights of a floor.
pub const HEIGHTS: [f64; 2] = [0.0, 1.0];

/// Gaps between a floor and what shadows it: those below a ball of radius 1 at 0.0001, 0.001, 0.01 and 0.1 from where it
/// touches, and those between.
pub const GAPS: [f64; 7] = [5e-9, 5e-8, 5e-7, 5e-6, 5e-5, 5e-4, 5e-3];

/// How often rays are mirrored in the cube.
const BOUNCES: usize = 1000;

/// Each set of kernels with its own policy.
const MANNERS: [Numerics; 3] = [Numerics::Lecture, Numerics::Robust, Numerics::Certified];

impl Surfaces {
    /// Counts; nothing if `stop` was set meanwhile.
    pub fn measure(plan: Plan, progress: &dyn Progress, stop: &AtomicBool) -> Option<Self> {
        let mut surfaces = Self::default();
        progress.begin("surfaces: leaks, self-hits, shadows", 2 * MANNERS.len() as u64);
        for numerics in MANNERS {
            surfaces.measure_in::<f32>(numerics, plan, stop)?;
            progress.step(1);
            surfaces.measure_in::<f64>(numerics, plan, stop)?;
            progress.step(1);
        }
        Some(surfaces)
    }

    fn measure_in<R: Real>(&mut self, numerics: Numerics, plan: Plan, stop: &AtomicBool) -> Option<()> {
        let go_on = || (!stop.load(Ordering::Relaxed)).then_some(());
        let (precision, manner) = (R::PRECISION, Manner::of(numerics));
        let leaving = manner.leaving;
        // The others are wrong so often that a sample tells.
        let sample = |count: usize| if numerics == Numerics::Certified { count } else { count.min(plan.sample) };
        let leak = |what: String, leaks: leaks::Leaks| LeakCount {
            numerics,
            precision,
            what,
            rays: leaks.rays,
            leaked: leaks.leaked,
        };
        for (center, place) in [(DVec3::ZERO, "bumpy sphere"), (FAR_AWAY, "bumpy sphere far away")] {
            go_on()?;
            let count = sample(if center == DVec3::ZERO { plan.leaks } else { plan.leaks / 2 });
            for (aim, leaks) in Aim::ALL.into_iter().zip(leaks::from_inside::<R>(numerics, center, count, plan.seed)) {
                self.leaks.push(leak(format!("{place}, {}", aim.name()), leaks));
            }
        }
        for square in Square::ALL {
            go_on()?;
            let what = format!("square of 65536 triangles, {}", square.name());
            self.leaks.push(leak(what, leaks::through_square::<R>(numerics, square)));
        }
        for ground in Ground::ALL {
            for scale in SCALES {
                go_on()?;
                let found = spawning::self_hits::<R>(ground, manner, scale, sample(plan.spawned), plan.seed);
                let (rays, hits) = (found.rays, found.hits);
                let ground = ground.name();
                self.self_hits.push(SelfHitCount { numerics, precision, leaving, ground, scale, rays, hits });
            }
        }
        for height in HEIGHTS {
            for gap in GAPS {
                go_on()?;
                let found = spawning::contact_shadows::<R>(manner, height, gap, sample(plan.spawned), plan.seed);
                let (rays, lost) = (found.rays, found.lost);
                self.contacts.push(ContactCount { numerics, precision, leaving, height, gap, rays, lost });
            }
        }
        go_on()?;
        let chains = spawning::mirrored_cube::<R>(manner, sample(plan.chains), BOUNCES, plan.seed);
        let (rays, escaped) = (chains.rays, chains.escaped);
        self.cubes.push(CubeCount { numerics, precision, leaving, rays, bounces: BOUNCES, escaped });
        Some(())
    }
}
