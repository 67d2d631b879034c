//! `raytree diagram`: what one ray did, as a drawing.

use super::failure::Failure;
use super::files;
use super::options::{TraceArgs, find_pixel};
use super::output::Target;
use super::picture::{Format, LookArgs, record};
use crate::input::{Problem, nearest, one_of, printable};
use crate::pictures::diagrams::{Chosen, Input, Kind, diagram};
use crate::scene::Scene;
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
    /// A shape that the ray was tested against, by name, of a mesh with a triangle: gem:17 [default: what the ray hits]
    #[arg(long, value_name = "NAME")]
    shape: Option<String>,
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
  raytree diagram scenes/whitted.json \"glass edge\" --kind section --node refracted -o section.png --dark
  raytree diagram scenes/triangle.json \"just outside\" --kind triangle --shape triangle -o miss.png"
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
    let input = match &args.shape {
        Some(word) => input.about(find_shape(&loaded.scene, word)?),
        None => input,
    };
    let drawing = diagram(kind, &input, args.look.theme()).map_err(|not| {
        let others = Kind::ALL.into_iter().filter(|kind| diagram(*kind, &input, args.look.theme()).is_ok());
        let help = format!("of this ray there is {}", one_of(others.map(Kind::name)));
        Failure::Input(Problem::new("--kind", format!("this ray has no {kind} diagram: {}", not.why), help))
    })?;
    target.write_all(&format.encode(&drawing, args.look.scale)?)
}

/// The shape that a name stands for, or a name, a colon and the number of a mesh's triangle.
fn find_shape(scene: &Scene, word: &str) -> Result<Chosen, Failure> {
    let place = |name: &str| scene.objects.iter().position(|object| object.name == name);
    let of_mesh = || {
        let (name, number) = word.rsplit_once(':')?;
        Some(Chosen { shape: place(name)? as u32, primitive: Some(number.parse().ok()?) })
    };
    let whole = place(word).map(|i| Chosen { shape: i as u32, primitive: None });
    whole.or_else(of_mesh).ok_or_else(|| {
        let names = || scene.objects.iter().map(|object| object.name.as_str());
        let near = nearest(word, names()).map_or(String::new(), |near| format!("did you mean `{near}`? "));
        let message = format!("the scene has no shape `{}`", printable(word));
        Failure::Input(Problem::new("--shape", message, format!("{near}{}", one_of(names()))))
    })
}

fn no_node(no: crate::tree::NoSuchNode) -> Failure {
    Failure::Input(Problem::new("--node", no.message, no.help))
}
