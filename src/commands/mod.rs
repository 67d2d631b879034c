//! Floor 7: what people run. Only this floor prints, and only `main` and Ctrl-C exit. One command a file.

mod accuracy;
mod check;
mod completions;
mod diagram;
mod diff;
mod effects;
mod exercise;
mod failure;
mod files;
mod forest;
mod gallery;
mod grade;
mod inspect;
pub mod lesson;
mod options;
mod output;
mod picture;
mod pixel;
mod progress;
mod ray;
mod render;
mod schema;
mod sheet;
mod step;
mod trees;
mod typeset;

use std::ffi::OsString;

use clap::{Parser, Subcommand};

use failure::Failure;

/// Traces rays through a scene and keeps the tree of every ray it shoots.
#[derive(Debug, Parser)]
#[command(name = "raytree", version, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "Results go to standard output or to the file after -o, everything else to standard error.
\"-\" as a file is standard input or output.

Exit codes:
  0    fine; also when the reader of a pipe has gone
  1    the answer is no: `check` found the file invalid, trees part, a ledger does not balance
  2    the input is at fault: a file, a value, the command line
  3    the machine is at fault: a result cannot be written
  130  interrupted by Ctrl-C";

#[derive(Debug, Subcommand)]
enum Command {
    Render(render::Args),
    Pixel(pixel::Args),
    Ray(ray::Args),
    Step(step::Args),
    Diagram(diagram::Args),
    Sheet(sheet::Args),
    Inspect(inspect::Args),
    Gallery(gallery::Args),
    Forest(forest::Args),
    Diff(diff::Args),
    Effects(effects::Args),
    Accuracy(accuracy::Args),
    Grade(grade::Args),
    Exercise(exercise::Args),
    Check(check::Args),
    Schema(schema::Args),
    Typeset(typeset::Args),
    Completions(completions::Args),
}

/// Runs the command line `args`, the program's name first, and returns the exit code.
pub fn run(args: impl IntoIterator<Item = OsString>) -> u8 {
    progress::watch();
    let cli = match Cli::try_parse_from(args.into_iter().map(options::shield_vector)) {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version are no errors: clap prints them on standard output, and the rest on standard error.
            let code = if error.use_stderr() { 2 } else { 0 };
            return match error.print() {
                Err(error) if code == 0 => Failure::from_write("standard output", &error).report(),
                _ => code,
            };
        }
    };
    let done = match cli.command {
        Command::Render(args) => render::run(&args),
        Command::Pixel(args) => pixel::run(&args),
        Command::Ray(args) => ray::run(&args),
        Command::Step(args) => step::run(&args),
        Command::Diagram(args) => diagram::run(&args),
        Command::Sheet(args) => sheet::run(&args),
        Command::Inspect(args) => inspect::run(&args),
        Command::Gallery(args) => gallery::run(&args),
        Command::Forest(args) => forest::run(&args),
        Command::Diff(args) => diff::run(&args),
        Command::Effects(args) => effects::run(&args),
        Command::Accuracy(args) => accuracy::run(&args),
        Command::Grade(args) => grade::run(&args),
        Command::Exercise(args) => exercise::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Schema(args) => schema::run(&args),
        Command::Typeset(args) => typeset::run(&args),
        Command::Completions(args) => completions::run(&args),
    };
    match done {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}
