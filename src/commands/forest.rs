//! `raytree forest`: every pixel's tree.

use std::io;
use std::sync::atomic::Ordering;

use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use super::failure::Failure;
use super::options::{TraceArgs, thread_counts};
use super::output::Target;
use super::{files, progress};
use crate::numbers::{Precision, Real};
use crate::scene::Loaded;
use crate::tree::{Keep, Origin, record_pixel};

/// Writes the ray tree of every pixel, one JSON tree a line, rows from the top
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  raytree forest scenes/whitted.json -o trees.ndjson

The file is large: some kilobytes a pixel. Any tool for JSON lines reads it; `raytree diff` compares two of them.")]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// Where to: a path, or - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: String,
    /// With every box and shape test
    #[arg(long)]
    steps: bool,
    /// Threads to trace on [default: one a core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = thread_counts())]
    threads: Option<u16>,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let target = Target::new(Some(&args.output), &[&args.scene])?;
    let loaded = files::load_scene(&args.scene)?;
    match args.trace.precision(&loaded.scene) {
        Precision::F32 => write::<f32>(&loaded, args, &target),
        Precision::F64 => write::<f64>(&loaded, args, &target),
    }
}

/// Pixels that a thread traces before the next are begun; so many trees a thread are kept at a time.
const BLOCK: u64 = 128;

fn write<R: Real>(loaded: &Loaded, args: &Args, target: &Target) -> Result<(), Failure> {
    let tracer = args.trace.tracer::<R>(loaded)?;
    let keep = if args.steps { Keep::Steps } else { Keep::Outcomes };
    let (width, height) = (u64::from(loaded.scene.image.width), u64::from(loaded.scene.image.height));
    let line = |i: u64| {
        let tree = record_pixel(&tracer, Origin { loaded, keep }, (i % width) as u32, (i / width) as u32);
        tree.to_json_line()
    };
    let pool = progress::pool(args.threads)?;
    let block = BLOCK * pool.current_num_threads() as u64;
    let pixels = width * height;
    let bar = progress::bar("tracing", pixels);
    let mut interrupted = false;
    let written = target.write(|out| {
        for start in (0..pixels).step_by(block as usize) {
            let trace = || (start..pixels.min(start + block)).into_par_iter().map(line).collect();
            let traced = progress::stoppable(|stop| {
                let lines: Vec<String> = pool.install(trace);
                (!stop.load(Ordering::Relaxed)).then_some(lines)
            });
            let Ok(lines) = traced else {
                interrupted = true;
                return Err(io::ErrorKind::Interrupted.into());
            };
            lines.iter().try_for_each(|line| out.write_all(line.as_bytes()))?;
            bar.inc(lines.len() as u64);
        }
        Ok(())
    });
    bar.finish_and_clear();
    if interrupted { Err(Failure::Interrupted) } else { written }
}
