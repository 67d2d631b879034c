//! `raytree inspect`: the step-through page.

use std::io::IsTerminal;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use super::failure::Failure;
use super::options::TraceArgs;
use super::output::Target;
use super::{files, progress};
use crate::input::Problem;
use crate::inspector::{Inspector, Limits, serve};
use crate::scene::meshes_beside;

/// Serves a page that steps through the rays of every pixel, on this machine alone
#[derive(Debug, clap::Args)]
#[command(
    after_help = "The address is printed on standard output, and opened where that is a terminal. Ctrl-C ends it.

Examples:
  raytree inspect scenes/whitted.json
  raytree inspect scenes/whitted.json --port 8080 --no-open"
)]
pub(super) struct Args {
    /// Scene file, or - for standard input
    scene: String,
    /// Port on 127.0.0.1 [default: any that is free]
    #[arg(long, value_name = "N", default_value = "0", hide_default_value = true, allow_negative_numbers = true)]
    port: u16,
    /// Print the address without opening it in a browser
    #[arg(long)]
    no_open: bool,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let text = files::read_text(&args.scene)?;
    let file = files::shown(&args.scene);
    let inspector = Inspector::new(file, &text, args.trace.settings(), &mut meshes_beside(file))?;
    let listener = listen(args.port)?;
    let port = listener.local_addr().map_err(|error| Failure::Machine(error.to_string()))?.port();
    let address = format!("http://127.0.0.1:{port}/");
    Target::Stdout.write(|out| writeln!(out, "{address}"))?;
    if std::io::stdout().is_terminal() && !args.no_open {
        // Where there is no browser, the address that was printed has to do.
        open::that_detached(&address).ok();
    }
    let served = progress::stoppable(|stop| {
        let served = serve(listener, Arc::new(inspector), Limits::default(), stop);
        (!stop.load(Ordering::SeqCst)).then_some(served)
    })?;
    served.map_err(|error| Failure::Machine(format!("the server cannot go on: {error}")))
}

fn listen(port: u16) -> Result<TcpListener, Failure> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
        let message = format!("port {port} cannot be listened on: {error}");
        match port {
            0 => Failure::Machine(message),
            _ => Problem::new("--port", message, "another port, or none for any that is free").into(),
        }
    })
}
