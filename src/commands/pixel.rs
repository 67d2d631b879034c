//! `raytree pixel`: one pixel's recursion.

use super::failure::Failure;
use super::options::{TraceArgs, find_pixel};
use super::{files, output, render};
use crate::numbers::{Precision, Real};
use crate::scene::Loaded;
use crate::tree::{Keep, Ledger, Origin, RayTree, Show, record_pixel};

/// Prints the ray tree of one pixel: one line a ray, or as JSON
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  raytree pixel scenes/whitted.json \"glass edge\"
  raytree pixel scenes/whitted.json 120,80 --steps
  raytree pixel scenes/whitted.json 120,80 --json -o tree.json")]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// x,y from the top left, or a name from the scene
    pixel: String,
    #[command(flatten)]
    show: ShowArgs,
    /// Write the scene's picture to this file as well
    #[arg(long, value_name = "FILE")]
    render: Option<String>,
    /// Threads to trace the picture on [default: one a core]
    #[arg(long, value_name = "N", requires = "render", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    trace: TraceArgs,
}

/// What to show of a tree, and where.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct ShowArgs {
    /// As JSON
    #[arg(long)]
    json: bool,
    /// With every box and shape test
    #[arg(long, conflicts_with = "ledger")]
    steps: bool,
    /// Which ray brought how much of the colour, instead of the tree
    #[arg(long, conflicts_with = "certificates")]
    ledger: bool,
    /// With the stage that decided each hit and its margin (JSON always has them)
    #[arg(long)]
    certificates: bool,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<String>,
}

impl ShowArgs {
    /// What the tree has to keep for this.
    pub(super) fn keep(&self) -> Keep {
        if self.steps { Keep::Steps } else { Keep::Outcomes }
    }

    /// Writes the tree.
    pub(super) fn write(&self, tree: &RayTree, name: Option<&str>) -> Result<(), Failure> {
        let ledger = self.ledger.then(|| Ledger::of(tree));
        let text = match (&ledger, self.json) {
            (Some(ledger), true) => ledger.to_json(),
            (Some(ledger), false) => ledger.to_string(),
            (None, true) => tree.to_json(),
            (None, false) => tree.to_text(Show { name, certificates: self.certificates }),
        };
        output::write(self.output.as_deref(), text.as_bytes())?;
        match ledger {
            Some(ledger) if !ledger.balances() => Err(Failure::No),
            _ => Ok(()),
        }
    }
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let format = args.render.as_deref().map(render::format_of).transpose()?;
    let loaded = files::load_scene(&args.scene)?;
    let ([x, y], name) = find_pixel(&loaded.scene, &args.pixel)?;
    let tree = match args.trace.precision(&loaded.scene) {
        Precision::F32 => record::<f32>(&loaded, args, x, y)?,
        Precision::F64 => record::<f64>(&loaded, args, x, y)?,
    };
    args.show.write(&tree, name)?;
    if let (Some(file), Some(format)) = (&args.render, format) {
        render::write_picture(&loaded, &args.trace, args.threads, format, file)?;
    }
    Ok(())
}

fn record<R: Real>(loaded: &Loaded, args: &Args, x: u32, y: u32) -> Result<RayTree, Failure> {
    let tracer = args.trace.tracer::<R>(loaded)?;
    Ok(record_pixel(&tracer, Origin { loaded, keep: args.show.keep() }, x, y))
}
