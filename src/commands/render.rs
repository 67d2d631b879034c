//! `raytree render`: the picture.

use super::failure::Failure;
use super::options::{TraceArgs, thread_counts};
use super::output::Target;
use super::{files, progress};
use crate::input::Problem;
use crate::numbers::{Precision, Real};
use crate::pictures::{self, Film, Format};
use crate::scene::Loaded;

/// Writes the picture of a scene: PNG (8-bit sRGB), or OpenEXR or PFM (linear floats)
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  raytree render scenes/whitted.json -o image.png")]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// Where to: a path ending in .png, .exr or .pfm
    #[arg(short, long, value_name = "FILE")]
    output: String,
    /// Threads to trace on [default: one a core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = thread_counts())]
    threads: Option<u16>,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let format = format_of(&args.output)?;
    let target = Target::new(Some(&args.output), &[&args.scene])?;
    let loaded = files::load_scene(&args.scene)?;
    target.write_all(&picture(&loaded, &args.trace, args.threads, format)?)
}

/// The format of a picture's file name; standard output, a device and a pipe take PNG.
pub(super) fn format_of(file: &str) -> Result<Format, Failure> {
    let is_special = || std::fs::metadata(file).is_ok_and(|data| !data.is_file() && !data.is_dir());
    let format = if file == "-" || is_special() { Some(Format::Png) } else { Format::of(file) };
    format.ok_or_else(|| {
        let message = "no picture format goes with this ending";
        Problem::new(file, message, "a path that ends in .png, .exr or .pfm, or - for a PNG on standard output").into()
    })
}

/// The bytes of the scene's picture.
pub(super) fn picture(
    loaded: &Loaded,
    trace: &TraceArgs,
    threads: Option<u16>,
    format: Format,
) -> Result<Vec<u8>, Failure> {
    film(loaded, trace, threads)?.encode(format).map_err(Failure::Machine)
}

/// The scene's picture.
pub(super) fn film(loaded: &Loaded, trace: &TraceArgs, threads: Option<u16>) -> Result<Film, Failure> {
    match trace.precision(&loaded.scene) {
        Precision::F32 => film_in::<f32>(loaded, trace, threads),
        Precision::F64 => film_in::<f64>(loaded, trace, threads),
    }
}

fn film_in<R: Real>(loaded: &Loaded, trace: &TraceArgs, threads: Option<u16>) -> Result<Film, Failure> {
    let tracer = trace.tracer::<R>(loaded)?;
    let bar = progress::bar("tracing", loaded.scene.image.height.into());
    let film =
        progress::on_threads(threads, || progress::stoppable(|stop| pictures::render(&tracer, &|| bar.inc(1), stop)))??;
    bar.finish_and_clear();
    Ok(film)
}
