//! `raytree check`: is this file valid?

use super::failure::Failure;
use super::files;
use super::output::Target;
use crate::input::printable;
use crate::scene::{Scene, Shape};
use crate::tree::check::read_tree;

/// Says whether a scene or a tree file is valid, and where not
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  raytree check scenes/whitted.json

A file is taken for a tree where it is an object with a key `format` or `root`, else for a scene.
Exits with 1 for an invalid file, with 2 where it cannot be read.")]
pub(super) struct Args {
    /// Scene or tree file, or - for standard input
    file: String,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let shown = files::shown(&args.file);
    // What can be read but is no text has a place, and is as invalid as any other.
    let text = files::read_text(&args.file).map_err(|problem| match problem.place {
        Some(_) => Failure::Invalid(problem),
        None => Failure::Input(problem),
    })?;
    let said = if is_tree(&text) {
        let tree = read_tree(shown, &text).map_err(Failure::Invalid)?;
        format!("{}: a valid tree of {}\n", printable(shown), count(tree.rays as usize, "ray"))
    } else {
        let loaded = files::scene_of(&args.file, &text).map_err(Failure::Invalid)?;
        about(shown, &loaded.scene)
    };
    Target::Stdout.write_all(said.as_bytes())
}

fn about(shown: &str, scene: &Scene) -> String {
    let objects = count(scene.objects.len(), "object");
    let (lights, pixels) = (count(scene.lights.len(), "light"), count(scene.pixels.len(), "named pixel"));
    let mut said = format!("{}: a valid scene of {objects}, {lights} and {pixels}\n", printable(shown));
    for id in scene.object_ids() {
        let object = scene.object(id);
        if let (Shape::Mesh(mesh), true) = (&object.shape, scene.material_of(id).transmission.is_some())
            && !mesh.closed
        {
            let name = printable(&object.name);
            said += &format!(
                "note: the mesh of \"{name}\" is not closed with all normals outward, so it bounds no medium\n"
            );
        }
    }
    said
}

fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// Whether this is rather meant to be a tree than a scene.
fn is_tree(text: &str) -> bool {
    #[derive(serde::Deserialize)]
    struct Keys {
        format: Option<serde::de::IgnoredAny>,
        root: Option<serde::de::IgnoredAny>,
    }
    serde_json::from_str::<Keys>(text).is_ok_and(|keys| keys.format.is_some() || keys.root.is_some())
}
