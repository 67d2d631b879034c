//! `raytree step`: the recursion of a pixel, step by step, in the manner of a debugger.

mod draw;
mod session;
mod show;

use std::io::{self, IsTerminal};

use super::failure::Failure;
use super::files;
use super::options::{TraceArgs, find_pixel};
use super::output::Target;
use super::picture::record;
use crate::input::Problem;
use crate::steps::Recording;
use session::Session;

/// Steps through the recursion of one pixel, in the manner of a debugger
#[derive(Debug, clap::Args)]
#[command(after_help = "Commands come from standard input, one a line; ? lists them.

Examples:
  raytree step scenes/whitted.json \"glass edge\"
  printf 'until tir\\nwhere\\n' | raytree step scenes/total-internal-reflection.json \"critical angle\"
  raytree step scenes/whitted.json 388,190 --json -o steps.json")]
pub(super) struct Args {
    /// Scene file; - for standard input only with --json
    scene: String,
    /// x,y from the top left, or a name from the scene
    pixel: String,
    /// Write all steps as JSON instead, for others to play
    #[arg(long)]
    json: bool,
    /// Write the JSON to this file instead of standard output
    #[arg(short, long, value_name = "FILE", requires = "json")]
    output: Option<String>,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    if args.scene == "-" && !args.json {
        let message = "the scene and the commands cannot both come from standard input";
        return Err(Problem::new("-", message, "a scene file, or --json").into());
    }
    let target = Target::new(args.output.as_deref(), &[&args.scene])?;
    let loaded = files::load_scene(&args.scene)?;
    let (pixel, name) = find_pixel(&loaded.scene, &args.pixel)?;
    let tree = record(&loaded, &args.trace, pixel)?;
    let recording = Recording::of(&loaded.scene, &tree);
    if args.json {
        return target.write(|out| recording.write_json(out));
    }
    let (input, output) = (io::stdin(), io::stdout());
    let is_watched = output.is_terminal();
    let no_color = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let look = show::Look { colored: is_watched && !no_color };
    let prompts = is_watched && input.is_terminal();
    let mut session = Session::new(&loaded, &recording, name, look);
    session.play(&mut input.lock(), &mut output.lock(), prompts)
}
