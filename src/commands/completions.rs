//! `raytree completions`: completions for shells.

use clap::CommandFactory;

use super::failure::Failure;
use super::output::Target;

/// Prints the completions for a shell
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  raytree completions bash > ~/.local/share/bash-completion/completions/raytree")]
pub(super) struct Args {
    /// The shell
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut super::Cli::command(), "raytree", &mut script);
    Target::Stdout.write_all(&script)
}
