//! `raytree sheet`: everything about one pixel on one page.

use super::failure::Failure;
use super::options::{TraceArgs, find_pixel, thread_counts};
use super::output::Target;
use super::picture::{Format, LookArgs, record};
use super::{files, render};
use crate::input::Problem;
use crate::pictures::diagrams::Input;
use crate::pictures::sheet::sheet;
use crate::tree::{NodePath, Show};

/// Draws everything about a pixel on one page, next to the picture, and prints its ray tree
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  raytree sheet scenes/whitted.json \"glass edge\" -o sheet.png
  raytree sheet scenes/whitted.json 120,80 -o sheet.svg --dark")]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// x,y from the top left, or a name from the scene
    pixel: String,
    /// Where to: a path ending in .png or .svg
    #[arg(short, long, value_name = "FILE")]
    output: String,
    #[command(flatten)]
    look: LookArgs,
    /// Threads to trace the picture on [default: one a core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = thread_counts())]
    threads: Option<u16>,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let format = Format::of(&args.output)?;
    let target = Target::new(Some(&args.output), &[&args.scene])?;
    if target.is_same(&Target::Stdout) {
        let message = "the page and the tree would go to the same place";
        return Err(Problem::new("-", message, "a file for the page").into());
    }
    let loaded = files::load_scene(&args.scene)?;
    let (pixel, name) = find_pixel(&loaded.scene, &args.pixel)?;
    let tree = record(&loaded, &args.trace, pixel)?;
    let film = render::film(&loaded, &args.trace, args.threads)?;
    let input = Input::new(&loaded.scene, &tree, NodePath::ROOT)
        .map_err(|no| Failure::Input(Problem::new("PIXEL", no.message, no.help)))?;
    let page = format.encode(&sheet(&input, &film, args.look.theme()), args.look.scale)?;
    Target::Stdout.write_all(tree.without_tests().to_text(Show { name, certificates: false }).as_bytes())?;
    target.write_all(&page)
}
