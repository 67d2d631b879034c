//! `raytree schema`: the JSON Schemas.

use super::failure::Failure;
use super::output::Target;
use crate::scene::json::SceneFile;
use crate::tree::RayTree;

/// Prints the JSON Schema of scenes or of trees, for editors and for other programs
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  raytree schema scene > scene.schema.json")]
pub(super) struct Args {
    /// Of what
    #[arg(value_enum)]
    of: Of,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<String>,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Of {
    /// Of scene files
    Scene,
    /// Of tree files
    Tree,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let schema = match args.of {
        Of::Scene => SceneFile::schema(),
        Of::Tree => RayTree::schema(),
    };
    Target::new(args.output.as_deref(), &[])?.write_all(format!("{:#}\n", schema.as_value()).as_bytes())
}
