//! Everything that is measured for one report.

use std::sync::atomic::AtomicBool;

use super::departures::{self, Departures};
use super::forms::{Boxes, Planes, Refractions, Spheres, Subject, Triangles};
use super::images::{self, ImageError, Reference};
use super::maps::{Map, Place};
use super::surfaces::Surfaces;
use super::timing::{FormTime, Quartiles, time_set};
use super::verdicts::{Effort, SetCount, count_set};
use crate::numbers::{Precision, Stage};
use crate::scene::{Loaded, Resolution, Scene};
use crate::transport::Unfit;

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Plan {
    /// Where all random numbers start.
    pub seed: u64,
    /// Pairs of a ray and a triangle, over all sets of a precision.
    pub triangles: usize,
    /// Pairs of a ray and a sphere.
    pub spheres: usize,
    /// Pairs of a ray and a box.
    pub boxes: usize,
    /// Pairs of a ray and a plane.
    pub planes: usize,
    /// Crossings of a boundary.
    pub crossings: usize,
    /// The referee decides every case that the filter leaves open, and one in this many of the rest.
    pub refereed_one_in: usize,
    /// At most so many values of `t` of a set are held against the referee's.
    pub values: usize,
    /// Rays from inside a closed mesh; half as many far away.
    pub leaks: usize,
    /// Rays that leave a surface, for each kind of surface and each scale.
    pub spawned: usize,
    /// Rays in a closed box of mirrors.
    pub chains: usize,
    /// Plain kernels get at most so many rays.
    pub sample: usize,
    /// Pairs that are timed.
    pub timed: usize,
    /// Rounds of timing.
    pub rounds: usize,
    /// The scene is traced with at most so many pixels.
    pub pixels: u32,
    /// Rounds of timing the scene.
    pub image_rounds: usize,
    /// Samples along a pixel's side in the reference.
    pub samples: u32,
}

impl Plan {
    /// A run of seconds.
    pub const QUICK: Self = Self {
        seed: 1,
        triangles: 28_000,
        spheres: 9_000,
        boxes: 7_000,
        planes: 5_000,
        crossings: 6_000,
        refereed_one_in: 100,
        values: 200,
        leaks: 2_000,
        spawned: 500,
        chains: 20,
        sample: 500,
        timed: 500,
        rounds: 9,
        pixels: 6_000,
        image_rounds: 3,
        samples: 5,
    };

    /// A run of minutes.
    pub const USUAL: Self = Self {
        triangles: 1_400_000,
        spheres: 450_000,
        boxes: 350_000,
        planes: 250_000,
        crossings: 300_000,
        values: 2_000,
        leaks: 100_000,
        spawned: 20_000,
        chains: 1_000,
        sample: 20_000,
        timed: 2_000,
        rounds: 31,
        pixels: 40_000,
        image_rounds: 7,
        samples: 8,
        ..Self::QUICK
    };

    /// A run that leaves no doubt.
    pub const FULL: Self = Self {
        triangles: 10_000_000,
        spheres: 10_000_000,
        boxes: 1_000_000,
        planes: 1_000_000,
        crossings: 4_000_000,
        leaks: 2_000_000,
        spawned: 1_000_000,
        chains: 100_000,
        ..Self::USUAL
    };

    fn effort(&self, cases: usize, sets: usize) -> Effort {
        Effort { cases: cases.div_ceil(sets), one_in: self.refereed_one_in, values: self.values, seed: self.seed }
    }
}

/// What was measured.
#[derive(Clone, Debug)]
pub struct Report {
    /// How much was asked for.
    pub plan: Plan,
    /// Who is right.
    pub counts: Vec<SetCount>,
    /// How long it takes.
    pub times: Vec<FormTime>,
    /// What each form says around the places where a verdict changes.
    pub maps: Vec<(Place, Vec<Map>)>,
    /// Whether surfaces hold.
    pub surfaces: Surfaces,
    /// The scene, if there is one.
    pub scene: Option<SceneReport>,
}

/// What was measured of a scene.
#[derive(Clone, Debug)]
pub struct SceneReport {
    /// Its file as it was named.
    pub file: String,
    /// The size it was traced at.
    pub size: Resolution,
    /// What it was held against.
    pub reference: Reference,
    /// How far each variant was from it, and its time over the reference's with one sample a pixel.
    pub images: Vec<(ImageError, Quartiles)>,
    /// The dearest stage in each pixel's tree.
    pub stages: Vec<Stage>,
    /// How rays leave surfaces.
    pub departures: Vec<Departures>,
}

/// Told what is being done, and how far it is.
pub trait Progress {
    /// Something new begins, of so many steps.
    fn begin(&self, what: &str, steps: u64);
    /// So many more of its steps are done.
    fn step(&self, steps: u64);
}

impl Report {
    /// Measures; nothing if `stop` was set meanwhile.
    ///
    /// # Errors
    /// [`Unfit`] where the scene does not fit f64.
    pub fn measure(
        plan: Plan,
        scene: Option<&Loaded>,
        progress: &dyn Progress,
        stop: &AtomicBool,
    ) -> Result<Option<Self>, Unfit> {
        let mut report = Self {
            plan,
            counts: Vec::new(),
            times: Vec::new(),
            maps: Vec::new(),
            surfaces: Surfaces::default(),
            scene: None,
        };
        let done = report.subject::<Triangles>(plan.triangles, progress, stop)
            && report.subject::<Spheres>(plan.spheres, progress, stop)
            && report.subject::<Boxes>(plan.boxes, progress, stop)
            && report.subject::<Planes>(plan.planes, progress, stop)
            && report.subject::<Refractions>(plan.crossings, progress, stop);
        if !done {
            return Ok(None);
        }
        progress.begin("predicate maps", Place::ALL.len() as u64);
        for place in Place::ALL {
            let forms: Vec<_> = place.forms().collect();
            let maps = place.maps::<f32>(&forms).into_iter().chain(place.maps::<f64>(&forms)).collect();
            report.maps.push((place, maps));
            progress.step(1);
        }
        let Some(surfaces) = Surfaces::measure(plan, progress, stop) else { return Ok(None) };
        report.surfaces = surfaces;
        if let Some(loaded) = scene {
            let Some(scene) = SceneReport::measure(plan, loaded, progress, stop)? else { return Ok(None) };
            report.scene = Some(scene);
        }
        Ok(Some(report))
    }

    /// Counts and times one subject; false if it was stopped.
    fn subject<S: Subject>(&mut self, cases: usize, progress: &dyn Progress, stop: &AtomicBool) -> bool {
        let effort = self.plan.effort(cases, S::SETS.len());
        progress.begin(&format!("{}: verdicts", S::NAME), (2 * effort.cases * S::SETS.len()) as u64);
        for &set in S::SETS {
            let done = |cases| progress.step(cases as u64);
            let Some(single) = count_set::<S, f32>(set, effort, stop, &done) else { return false };
            let Some(double) = count_set::<S, f64>(set, effort, stop, &done) else { return false };
            self.counts.extend([single, double]);
        }
        progress.begin(&format!("{}: times", S::NAME), S::SETS.len() as u64);
        for &set in S::SETS {
            let Plan { timed, rounds, seed, .. } = self.plan;
            let Some(times) = time_set::<S>(set, timed, rounds, seed, stop) else { return false };
            self.times.extend(times);
            progress.step(1);
        }
        true
    }

    /// The counts of a subject in one precision.
    pub fn counts_of(&self, subject: &str, precision: Precision) -> impl Iterator<Item = &SetCount> {
        let is_asked = move |c: &&SetCount| c.precision == precision;
        let subject = subject.to_owned();
        self.counts.iter().filter(is_asked).filter(move |c| c.subject == subject)
    }
}

impl SceneReport {
    fn measure(plan: Plan, loaded: &Loaded, progress: &dyn Progress, stop: &AtomicBool) -> Result<Option<Self>, Unfit> {
        let scene: Scene = images::reduced(&loaded.scene, plan.pixels);
        let reference = Reference::of(&scene, plan.samples);
        let variants = reference.variants(&scene);
        progress.begin("scene: errors", 2 + variants.len() as u64);
        let Some(errors) = images::errors(&scene, reference, stop, &|| progress.step(1))? else { return Ok(None) };
        progress.begin("scene: times", 1);
        let variants: Vec<_> = errors.iter().map(|error| error.variant).collect();
        let Some(times) = images::times(&scene, reference, &variants, plan.image_rounds, stop) else {
            return Ok(None);
        };
        progress.step(1);
        progress.begin("scene: stages", 1);
        let Some(stages) = images::stages(&scene, stop)? else { return Ok(None) };
        progress.step(1);
        progress.begin("scene: how rays leave surfaces", 2 * (2 + departures::EPSILONS.len() as u64));
        let Some(departures) = departures::sweep(&scene, stop, &|| progress.step(1))? else { return Ok(None) };
        Ok(Some(Self {
            file: loaded.file.clone(),
            size: scene.image,
            reference,
            images: errors.into_iter().zip(times).collect(),
            stages,
            departures,
        }))
    }
}
