//! `raytree pixel`: one pixel's recursion.

use super::failure::Failure;
use super::options::{TraceArgs, find_pixel, thread_counts};
use super::output::Target;
use super::{files, render};
use crate::input::Problem;
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
    #[arg(long, value_name = "N", requires = "render", allow_negative_numbers = true, value_parser = thread_counts())]
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

    /// Where the tree goes.
    pub(super) fn target(&self, scene: &str) -> Result<Target, Failure> {
        Target::new(self.output.as_deref(), &[scene])
    }

    /// Writes the tree.
    pub(super) fn write(&self, target: &Target, tree: &RayTree, name: Option<&str>) -> Result<(), Failure> {
        if self.ledger {
            let ledger = Ledger::of(tree);
            let text = if self.json { ledger.to_json() } else { ledger.to_string() };
            target.write_all(text.as_bytes())?;
            return if ledger.balances() { Ok(()) } else { Err(Failure::No) };
        }
        match self.json {
            true => target.write(|out| tree.write_json(out)),
            false => target.write_all(tree.to_text(Show { name, certificates: self.certificates }).as_bytes()),
        }
    }
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let target = args.show.target(&args.scene)?;
    let picture = match &args.render {
        None => None,
        Some(file) => {
            let format = render::format_of(file)?;
            let picture = Target::new(Some(file), &[&args.scene])?;
            if picture.is_same(&target) {
                let message = "the tree and the picture would go to the same place";
                return Err(
                    Problem::new(file, message, "two different files, or one of them on standard output").into()
                );
            }
            Some((format, picture))
        }
    };
    let loaded = files::load_scene(&args.scene)?;
    let ([x, y], name) = find_pixel(&loaded.scene, &args.pixel)?;
    let tree = match args.trace.precision(&loaded.scene) {
        Precision::F32 => record::<f32>(&loaded, args, x, y)?,
        Precision::F64 => record::<f64>(&loaded, args, x, y)?,
    };
    // All work before the first result: whoever interrupts it gets none.
    let picture = match picture {
        None => None,
        Some((format, target)) => Some((target, render::picture(&loaded, &args.trace, args.threads, format)?)),
    };
    args.show.write(&target, &tree, name)?;
    match picture {
        None => Ok(()),
        Some((target, bytes)) => target.write_all(&bytes),
    }
}

fn record<R: Real>(loaded: &Loaded, args: &Args, x: u32, y: u32) -> Result<RayTree, Failure> {
    let tracer = args.trace.tracer::<R>(loaded)?;
    Ok(record_pixel(&tracer, Origin { loaded, keep: args.show.keep() }, x, y))
}
