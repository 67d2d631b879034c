//! `raytree diagram`: what one ray did, as a drawing.

use super::failure::Failure;
use super::files;
use super::options::{TraceArgs, find_pixel};
use super::output::Target;
use super::picture::{Format, LookArgs, record};
use crate::input::Problem;
use crate::pictures::diagrams::{Input, Kind, diagram};
use crate::tree::NodePath;

/// Draws what a ray of a pixel did: PNG or SVG
#[derive(Debug, clap::Args)]
#[command(after_help = kinds(), after_long_help = kinds())]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// x,y from the top left, or a name from the scene
    pixel: String,
    /// What to draw; see below
    #[arg(long)]
    kind: String,
    /// The ray that it is about: reflected.refracted, shadows[0] [default: root, the camera ray]
    #[arg(long, value_name = "PATH", default_value = "root", hide_default_value = true)]
    node: String,
    /// Where to: a path ending in .png or .svg
    #[arg(short, long, value_name = "FILE")]
    output: String,
    #[command(flatten)]
    look: LookArgs,
    #[command(flatten)]
    trace: TraceArgs,
}

/// The example and the list of kinds, for the help.
fn kinds() -> String {
    let lines = Kind::ALL.map(|kind| format!("  {:<10} {}\n", kind.name(), kind.about())).concat();
    format!(
        "Kinds:\n{lines}\nExamples:
  raytree diagram scenes/whitted.json \"glass edge\" --kind tree -o tree.svg
  raytree diagram scenes/whitted.json \"glass edge\" --kind section --node refracted -o section.png --dark"
    )
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let kind: Kind = args.kind.parse().map_err(|help: String| {
        Failure::Input(Problem::new("--kind", format!("there is no kind of diagram `{}`", args.kind), help))
    })?;
    let path: NodePath = args.node.parse().map_err(no_node)?;
    let format = Format::of(&args.output)?;
    let target = Target::new(Some(&args.output), &[&args.scene])?;
    let loaded = files::load_scene(&args.scene)?;
    let (pixel, _) = find_pixel(&loaded.scene, &args.pixel)?;
    let tree = record(&loaded, &args.trace, pixel)?;
    let input = Input::new(&loaded.scene, &tree, path).map_err(no_node)?;
    let drawing = diagram(kind, &input, args.look.theme()).map_err(|not| {
        let others = Kind::ALL.into_iter().filter(|kind| diagram(*kind, &input, args.look.theme()).is_ok());
        let help = format!("of this ray there is {}", crate::input::one_of(others.map(Kind::name)));
        Failure::Input(Problem::new("--kind", format!("this ray has no {kind} diagram: {}", not.why), help))
    })?;
    target.write_all(&format.encode(&drawing, args.look.scale)?)
}

fn no_node(no: crate::tree::NoSuchNode) -> Failure {
    Failure::Input(Problem::new("--node", no.message, no.help))
}
