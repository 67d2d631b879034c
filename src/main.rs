//! The `raytree` command; everything it does is in [`raytree::commands`].

fn main() -> std::process::ExitCode {
    raytree::commands::run(std::env::args_os()).into()
}
