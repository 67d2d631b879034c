//! `raytree check`: is this file valid?

use super::failure::Failure;
use super::{files, output};
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
    let text = files::read_text(&args.file)?;
    let shown = files::shown(&args.file);
    let said = if is_tree(&text) {
        let tree = read_tree(shown, &text).map_err(Failure::Invalid)?;
        format!("{shown}: a valid tree of {} rays\n", tree.rays)
    } else {
        let loaded = files::scene_of(&args.file, &text).map_err(Failure::Invalid)?;
        let scene = &loaded.scene;
        let (objects, lights, pixels) = (scene.objects.len(), scene.lights.len(), scene.pixels.len());
        format!("{shown}: a valid scene of {objects} objects, {lights} lights and {pixels} named pixels\n")
    };
    output::write(None, said.as_bytes())
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
