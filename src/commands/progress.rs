//! Long work: a bar on a terminal's standard error, and a way to stop.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::failure::Failure;

/// Set by Ctrl-C; looked at by work that can stop in the middle.
static STOP: AtomicBool = AtomicBool::new(false);
/// Whether such work is going on.
static LOOKING: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C sets a flag while [`stoppable`] work goes on, and ends the program at once at other times.
pub(super) fn watch() {
    ctrlc::set_handler(|| {
        // Whoever asks twice does not want to wait.
        if STOP.swap(true, Ordering::SeqCst) || !LOOKING.load(Ordering::SeqCst) {
            Failure::Interrupted.exit();
        }
    })
    // Without a handler Ctrl-C still ends the program, if less politely.
    .ok();
}

/// Runs work that looks at the flag it is given, and returns nothing if that made it stop.
pub(super) fn stoppable<T>(work: impl FnOnce(&AtomicBool) -> Option<T>) -> Result<T, Failure> {
    LOOKING.store(true, Ordering::SeqCst);
    let done = work(&STOP);
    LOOKING.store(false, Ordering::SeqCst);
    done.ok_or(Failure::Interrupted)
}

/// A bar over `steps` steps; invisible unless standard error is a terminal.
pub(super) fn bar(what: &str, steps: u64) -> ProgressBar {
    let target = match std::io::stderr().is_terminal() {
        true => ProgressDrawTarget::stderr(),
        false => ProgressDrawTarget::hidden(),
    };
    let bar = ProgressBar::with_draw_target(Some(steps), target);
    if let Ok(style) = ProgressStyle::with_template("{prefix} {wide_bar} {percent}% {eta}") {
        bar.set_style(style);
    }
    bar.set_prefix(what.to_owned());
    bar
}

/// Runs `work` on this many threads, or on one a core.
pub(super) fn on_threads<T: Send>(threads: Option<u16>, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    Ok(pool(threads)?.install(work))
}

/// This many threads, or one a core.
pub(super) fn pool(threads: Option<u16>) -> Result<rayon::ThreadPool, Failure> {
    let mut pool = rayon::ThreadPoolBuilder::new();
    if let Some(threads) = threads {
        pool = pool.num_threads(threads.into());
    }
    pool.build().map_err(|error| Failure::Machine(format!("no threads could be started: {error}")))
}
