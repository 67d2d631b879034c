//! A program run with limits on its time, its memory and what it prints.

use std::ffi::OsStr;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// What a program may use.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Time on the clock, in seconds.
    pub(super) seconds: u64,
    /// Memory that it may ask for, in MiB. Kept by the system: on Linux for each process; macOS does not keep it.
    pub(super) memory: u64,
    /// What it may print, in KiB.
    pub(super) output: usize,
    /// The largest file that it may write, in MiB, where the system keeps it.
    pub(super) files: u64,
}

/// How a program ended.
#[derive(Debug)]
pub(super) enum End {
    /// By itself, or by a signal.
    Exited(ExitStatus),
    /// It had no time left.
    TimedOut,
    /// It printed too much.
    TooMuchOutput,
}

/// A program that has ended.
#[derive(Debug)]
pub(super) struct Ended {
    pub(super) end: End,
    /// What it printed on standard output.
    pub(super) out: Vec<u8>,
    /// What it printed on standard error.
    pub(super) error: Vec<u8>,
}

impl Ended {
    /// Whether the system refused it memory, by its own last words.
    pub(super) fn is_out_of_memory(&self) -> bool {
        let words = String::from_utf8_lossy(&self.error);
        let is_refused = words.contains("memory allocation of ") && words.contains(" bytes failed");
        matches!(&self.end, End::Exited(status) if !status.success()) && is_refused
    }
}

/// How often a program is looked after.
const PULSE: Duration = Duration::from_millis(5);

/// Runs a program in a folder with nothing on its standard input. It leads a group of processes of its own, which is
/// ended with it. Nothing if stopped before it has ended.
pub(super) fn run(
    program: &Path,
    args: &[&OsStr],
    folder: &Path,
    environment: &[(&str, &OsStr)],
    limits: Limits,
    stop: &AtomicBool,
) -> io::Result<Option<Ended>> {
    let mut command = limited(program, limits);
    command.args(args).current_dir(folder).env_clear().envs(environment.iter().copied());
    let mut child = Group(command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?);
    let room = Arc::new(AtomicUsize::new(limits.output.saturating_mul(1024)));
    let is_full = Arc::new(AtomicBool::new(false));
    let out = child.0.stdout.take().map(|pipe| Listener::new(pipe, &room, &is_full));
    let error = child.0.stderr.take().map(|pipe| Listener::new(pipe, &room, &is_full));
    let deadline = Instant::now() + Duration::from_secs(limits.seconds);
    let end = loop {
        if stop.load(Ordering::SeqCst) {
            return Ok(None);
        }
        if is_full.load(Ordering::SeqCst) {
            break End::TooMuchOutput;
        }
        if let Some(status) = child.0.try_wait()? {
            break End::Exited(status);
        }
        if Instant::now() >= deadline {
            break End::TimedOut;
        }
        thread::sleep(PULSE);
    };
    // Whatever it has started ends too, and with it the pipes.
    drop(child);
    let end = match end {
        End::Exited(_) if is_full.load(Ordering::SeqCst) => End::TooMuchOutput,
        end => end,
    };
    let heard = |listener: Option<Listener>| listener.map(Listener::heard).unwrap_or_default();
    Ok(Some(Ended { end, out: heard(out), error: heard(error) }))
}

/// A process that leads a group; the whole group is ended when this is dropped.
struct Group(Child);

impl Drop for Group {
    fn drop(&mut self) {
        #[cfg(unix)]
        {
            use rustix::process::{Pid, Signal, kill_process_group};
            // There may be nobody left.
            kill_process_group(Pid::from_child(&self.0), Signal::KILL).ok();
        }
        self.0.kill().ok();
        self.0.wait().ok();
    }
}

/// The command that runs a program with a limit on its memory and on the files it writes.
#[cfg(unix)]
fn limited(program: &Path, limits: Limits) -> Command {
    use std::os::unix::process::CommandExt;
    // A limit that the system does not know is left out: macOS has none on memory.
    // Files are counted in blocks of 512 bytes; for some shells of 1024.
    let (files, memory) = (limits.files.saturating_mul(2048), limits.memory.saturating_mul(1024));
    let script = format!("ulimit -c 0; ulimit -f {files}; ulimit -v {memory} 2>/dev/null; exec \"$0\" \"$@\"");
    let mut command = Command::new("/bin/sh");
    command.arg("-c").arg(script).arg(program).process_group(0);
    command
}

/// The command that runs a program: there is no limit on memory.
#[cfg(not(unix))]
fn limited(program: &Path, _limits: Limits) -> Command {
    Command::new(program)
}

/// A thread that keeps what comes out of a pipe, as long as there is room.
struct Listener {
    heard: Arc<Mutex<Vec<u8>>>,
    thread: thread::JoinHandle<()>,
}

impl Listener {
    fn new(mut pipe: impl Read + Send + 'static, room: &Arc<AtomicUsize>, is_full: &Arc<AtomicBool>) -> Self {
        let heard = Arc::new(Mutex::new(Vec::new()));
        let (into, room, is_full) = (heard.clone(), room.clone(), is_full.clone());
        let thread = thread::spawn(move || {
            let mut piece = [0; 1 << 14];
            while let Ok(length @ 1..) = pipe.read(&mut piece) {
                let left = room.fetch_update(Ordering::SeqCst, Ordering::SeqCst, |left| left.checked_sub(length));
                if left.is_err() {
                    return is_full.store(true, Ordering::SeqCst);
                }
                into.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(&piece[..length]);
            }
        });
        Listener { heard, thread }
    }

    /// What has come. A process that has left the group may keep the pipe open: it is not waited for.
    fn heard(self) -> Vec<u8> {
        let patience = Instant::now() + Duration::from_secs(1);
        while !self.thread.is_finished() && Instant::now() < patience {
            thread::sleep(PULSE);
        }
        std::mem::take(&mut *self.heard.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
