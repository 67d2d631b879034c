//! A tracer in whichever precision a scene is traced in.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use crate::hits::{Departure, Limit, World};
use crate::input::Problem;
use crate::numbers::{Precision, Real};
use crate::pictures::{Film, render, srgb8};
use crate::scene::{Limits, Loaded, Scene};
use crate::transport::{Options, Tracer};
use crate::tree::{Cost, Costs, Deepest, Keep, Origin, RayTree, record_pixel};

/// The geometry of a scene, kept from one request to the next.
#[derive(Debug)]
pub(super) enum AnyWorld {
    /// In single precision.
    F32(Arc<World<f32>>),
    /// In double precision.
    F64(Arc<World<f64>>),
}

/// A tracer in one of the precisions.
#[derive(Debug)]
pub(super) enum AnyTracer<'s> {
    /// In single precision.
    F32(Tracer<'s, f32>),
    /// In double precision.
    F64(Tracer<'s, f64>),
}

/// What is shown of every pixel, in four bytes each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Show {
    /// Its colour: sRGB and an opaque alpha.
    Picture,
    /// How many rays it took.
    Rays,
    /// How deep the recursion went.
    Depth,
    /// How many boxes and shapes were tested.
    Tests,
    /// How what it shows was decided: the number of the stage, or -1 where nothing is hit.
    Stage,
    /// Nanoseconds that it took.
    Time,
}

impl Show {
    /// The overlays that are the same every time, by name.
    pub(super) const KEPT: [(&'static str, Show); 4] =
        [("rays", Show::Rays), ("depth", Show::Depth), ("tests", Show::Tests), ("stage", Show::Stage)];
}

impl AnyWorld {
    /// The geometry of a scene.
    ///
    /// # Errors
    /// One [`Problem`] where it does not fit the precision.
    pub(super) fn new(loaded: &Loaded, precision: Precision, options: Options) -> Result<Self, Problem> {
        Ok(match precision {
            Precision::F32 => Self::F32(tracer(loaded, options)?.shared_world()),
            Precision::F64 => Self::F64(tracer(loaded, options)?.shared_world()),
        })
    }

    /// Its precision.
    pub(super) fn precision(&self) -> Precision {
        match self {
            Self::F32(_) => Precision::F32,
            Self::F64(_) => Precision::F64,
        }
    }

    /// A tracer that stops when `stop` is set.
    pub(super) fn tracer<'s>(&self, scene: &'s Scene, options: Options, stop: &'s AtomicBool) -> AnyTracer<'s> {
        match self {
            Self::F32(world) => AnyTracer::F32(Tracer::with_world(scene, world.clone(), options).with_stop(stop)),
            Self::F64(world) => AnyTracer::F64(Tracer::with_world(scene, world.clone(), options).with_stop(stop)),
        }
    }
}

fn tracer<R: Real>(loaded: &Loaded, options: Options) -> Result<Tracer<'_, R>, Problem> {
    Tracer::new(&loaded.scene, options).map_err(|unfit| {
        let message = format!("{} is too far out for {}", unfit.name(&loaded.scene), R::PRECISION);
        let help =
            format!("coordinates up to {:e} in magnitude, or the precision f64", R::PRECISION.largest_coordinate());
        Problem::new(&loaded.file, message, help)
    })
}

impl AnyTracer<'_> {
    /// The pixel in four bytes.
    pub(super) fn show(&self, show: Show, x: u32, y: u32) -> [u8; 4] {
        match self {
            Self::F32(tracer) => shown(tracer, show, x, y),
            Self::F64(tracer) => shown(tracer, show, x, y),
        }
    }

    /// The picture, unless it is stopped.
    pub(super) fn film(&self, stop: &AtomicBool) -> Option<Film> {
        match self {
            Self::F32(tracer) => render(tracer, &|| {}, stop),
            Self::F64(tracer) => render(tracer, &|| {}, stop),
        }
    }

    /// What the pixel takes.
    pub(super) fn costs(&self, x: u32, y: u32) -> Costs {
        match self {
            Self::F32(tracer) => tracer.pixel(x, y, &Cost).1,
            Self::F64(tracer) => tracer.pixel(x, y, &Cost).1,
        }
    }

    /// The tree of the pixel, with every test.
    pub(super) fn record(&self, loaded: &Loaded, x: u32, y: u32) -> RayTree {
        let origin = Origin { loaded, keep: Keep::Steps };
        match self {
            Self::F32(tracer) => record_pixel(tracer, origin, x, y),
            Self::F64(tracer) => record_pixel(tracer, origin, x, y),
        }
    }
}

fn shown<R: Real>(tracer: &Tracer<'_, R>, show: Show, x: u32, y: u32) -> [u8; 4] {
    let number = match show {
        Show::Picture => {
            let [r, g, b] = tracer.pixel_color(x, y).to_array().map(srgb8);
            return [r, g, b, 255];
        }
        Show::Rays => tracer.pixel(x, y, &Cost).1.rays() as f32,
        Show::Depth => tracer.pixel(x, y, &Deepest).1 as f32,
        Show::Tests => tracer.pixel(x, y, &Cost).1.tests as f32,
        Show::Stage => stage(tracer, x, y),
        Show::Time => {
            let start = Instant::now();
            tracer.pixel_color(x, y);
            start.elapsed().as_nanos() as f32
        }
    };
    number.to_le_bytes()
}

/// The number of the stage that decided the camera ray's hit, or -1.
fn stage<R: Real>(tracer: &Tracer<'_, R>, x: u32, y: u32) -> f32 {
    let ray = tracer.ray_of_pixel(x, y);
    match tracer.world().nearest(&ray, Limit::None, Departure::default(), &mut ()) {
        Ok(Some(hit)) => f32::from(tracer.world().certificate(&ray, &hit.nearest).stage as u8),
        Ok(None) | Err(_) => -1.0,
    }
}

/// `limits` with a budget of at most so many rays.
pub(super) fn at_most(limits: Limits, rays: u64) -> Limits {
    Limits { ray_budget: limits.ray_budget.min(rays), ..limits }
}
