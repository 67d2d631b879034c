//! `raytree inspect`: the step-through page, served or written as one file.

use std::io::IsTerminal;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;

use super::failure::Failure;
use super::options::{TraceArgs, find_pixel};
use super::output::Target;
use super::{files, progress};
use crate::input::Problem;
use crate::inspector::{Inspector, Kept, Limits, serve};
use crate::scene::{Scene, meshes_beside};

/// Serves a page that steps through the rays of any pixel, on this machine alone; or writes it as one file
#[derive(Debug, clap::Args)]
#[command(
    after_help = "The address is printed on standard output, and opened where that is a terminal. Ctrl-C ends the server.

An exported page needs no server and no network. It has the picture, its overlays but the time, and of every pixel that it
keeps all steps and diagrams, in both themes; of the diagrams of single tests the first 256. With `--pixel all` it keeps the
steps of the whole picture, of at most 4096 pixels, and the diagrams of those pixels that have names.

Examples:
  raytree inspect scenes/whitted.json
  raytree inspect scenes/whitted.json --port 8080 --no-open
  raytree inspect scenes/whitted.json --export page.html
  raytree inspect scenes/whitted.json --export page.html --pixel \"glass edge\" --pixel 120,80"
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
    /// Write the page to this file instead
    #[arg(long, value_name = "FILE", conflicts_with_all = ["port", "no_open"])]
    export: Option<String>,
    /// A pixel to keep, x,y or a name from the scene, or all; as often as wanted [default: all that have names]
    #[arg(long, value_name = "PIXEL", requires = "export")]
    pixel: Vec<String>,
    #[command(flatten)]
    trace: TraceArgs,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let target = match &args.export {
        Some(file) => Some(Target::new(Some(file), &[&args.scene])?),
        None => None,
    };
    let text = files::read_text(&args.scene)?;
    let file = files::shown(&args.scene);
    let inspector = Inspector::new(file, &text, args.trace.settings(), &mut meshes_beside(file))?;
    match target {
        Some(target) => export(args, &inspector, &target),
        None => listen(args, inspector),
    }
}

fn listen(args: &Args, inspector: Inspector) -> Result<(), Failure> {
    let listener = bind(args.port)?;
    let port = listener.local_addr().map_err(|error| Failure::Machine(error.to_string()))?.port();
    let address = format!("http://127.0.0.1:{port}/");
    Target::Stdout.write(|out| writeln!(out, "{address}"))?;
    if std::io::stdout().is_terminal() && !args.no_open {
        // Where there is no browser, the address that was printed has to do.
        open::that_detached(&address).ok();
    }
    let inspector = Arc::new(inspector);
    let served = progress::stoppable(|stop| {
        let (served, is_stopped) = thread::scope(|scope| {
            scope.spawn(|| inspector.paint(stop));
            let served = serve(listener, Arc::clone(&inspector), Limits::default(), stop);
            // The picture ends with the server.
            (served, stop.swap(true, Ordering::SeqCst))
        });
        (!is_stopped).then_some(served)
    })?;
    served.map_err(|error| Failure::Machine(format!("the server cannot go on: {error}")))
}

fn bind(port: u16) -> Result<TcpListener, Failure> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
        let message = format!("port {port} cannot be listened on: {error}");
        match port {
            0 => Failure::Machine(message),
            _ => Problem::new("--port", message, "another port, or none for any that is free").into(),
        }
    })
}

fn export(args: &Args, inspector: &Inspector, target: &Target) -> Result<(), Failure> {
    let kept = kept(inspector.scene(), &args.pixel)?;
    let bar = progress::bar("recording", inspector.count(&kept));
    let page = progress::stoppable(|stop| inspector.export(&kept, &|| bar.inc(1), stop).transpose())??;
    bar.finish_and_clear();
    target.write_all(page.as_bytes())
}

/// The pixels that the words name.
fn kept(scene: &Scene, words: &[String]) -> Result<Kept, Failure> {
    let named = || scene.pixels.iter().map(|(_, pixel)| *pixel);
    let mut kept = Kept::default();
    for word in words {
        // A pixel that the scene calls so comes first.
        if word == "all" && !scene.pixels.iter().any(|(name, _)| name == word) {
            kept.all = true;
            kept.drawn.extend(named());
        } else {
            kept.drawn.push(find_pixel(scene, word)?.0);
        }
    }
    if words.is_empty() {
        kept.drawn.extend(named());
    }
    if kept.drawn.is_empty() && !kept.all {
        let help = "--pixel x,y, as often as wanted, or --pixel all";
        return Err(Problem::new("--pixel", "the scene has no named pixels", help).into());
    }
    Ok(kept)
}
