//! `raytree ray`: the recursion of any ray.

use super::failure::Failure;
use super::files;
use super::options::{TraceArgs, make_ray};
use super::pixel::ShowArgs;
use crate::input::Problem;
use crate::numbers::{Precision, Real};
use crate::scene::Loaded;
use crate::tree::{Origin, RayTree, record_ray};

/// Prints the ray tree of any ray, traced as if it came from the eye
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  raytree ray scenes/sphere.json 0,0,-5 0,0,1\n\nA vector may begin with a minus sign."
)]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// Where the ray starts: x,y,z
    origin: String,
    /// Where it goes: x,y,z, of any length but zero; t is in units of its length
    direction: String,
    #[command(flatten)]
    show: ShowArgs,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let target = args.show.target(&args.scene)?;
    let loaded = files::load_scene(&args.scene)?;
    let tree = match args.trace.precision(&loaded.scene) {
        Precision::F32 => record::<f32>(&loaded, args)?,
        Precision::F64 => record::<f64>(&loaded, args)?,
    };
    args.show.write(&target, &tree, None)
}

fn record<R: Real>(loaded: &Loaded, args: &Args) -> Result<RayTree, Failure> {
    let ray = make_ray::<R>(&args.origin, &args.direction)?;
    let tracer = args.trace.tracer::<R>(loaded)?;
    record_ray(&tracer, Origin { loaded, keep: args.show.keep() }, &ray).map_err(|invalid| {
        Problem::new("RAY", invalid.to_string(), "finite numbers, and a direction that is not zero").into()
    })
}
