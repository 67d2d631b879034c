//! Results that are written: to standard output, or whole to a file, or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use super::failure::Failure;
use super::progress;
use crate::input::Problem;

/// What writes a result.
type Writer<'a> = dyn FnOnce(&mut dyn Write) -> io::Result<()> + 'a;

/// Where a result goes, looked at before any work is done for it.
#[derive(Debug)]
pub(super) enum Target {
    /// Standard output.
    Stdout,
    /// A file that is written under a temporary name beside it, then renamed.
    File(PathBuf),
    /// A device or a pipe, written to as it is.
    Device(PathBuf),
}

impl Target {
    /// The target that an argument names: nothing and `-` are standard output. `inputs` are files that must stay as
    /// they are.
    ///
    /// # Errors
    /// A folder that is not there or is itself the target; a target that is one of the inputs.
    pub(super) fn new(file: Option<&str>, inputs: &[&str]) -> Result<Self, Failure> {
        let Some(file) = file.filter(|file| *file != "-") else { return Ok(Self::Stdout) };
        let path = Path::new(file);
        let cannot = |why: &str| Failure::Machine(format!("{file} cannot be written: {why}"));
        let same =
            |input: &&str| fs::canonicalize(input).is_ok_and(|input| fs::canonicalize(path).is_ok_and(|p| p == input));
        if let Some(input) = inputs.iter().find(|input| same(input)) {
            let message = format!("the result would overwrite {input}, which it is made from");
            return Err(Problem::new(file, message, "another name").into());
        }
        match fs::metadata(path) {
            Ok(data) if data.is_dir() => Err(cannot("it is a directory")),
            // A link stays, and what it leads to is replaced.
            Ok(data) if data.is_file() => Ok(Self::File(fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()))),
            Ok(_) => Ok(Self::Device(path.to_owned())),
            Err(_) if file.is_empty() || file.ends_with('/') => Err(cannot("it names no file")),
            Err(_) if !folder_of(path).is_dir() => {
                Err(cannot(&format!("there is no folder {}", folder_of(path).display())))
            }
            Err(_) => {
                // Two names of one file are one target.
                let folder = fs::canonicalize(folder_of(path)).unwrap_or_else(|_| folder_of(path).to_owned());
                Ok(Self::File(folder.join(path.file_name().unwrap_or_default())))
            }
        }
    }

    /// Whether both write to the same place.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Stdout, Self::Stdout) => true,
            (Self::File(a), Self::File(b)) | (Self::Device(a), Self::Device(b)) => a == b,
            _ => false,
        }
    }

    /// Writes a result.
    pub(super) fn write(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        let name = match self {
            Self::Stdout => "standard output".to_owned(),
            Self::File(path) | Self::Device(path) => path.display().to_string(),
        };
        let write: Box<Writer<'_>> = Box::new(write);
        let written = match self {
            Self::Stdout => buffered(io::stdout().lock(), write),
            Self::Device(path) => File::options().write(true).open(path).and_then(|file| buffered(file, write)),
            Self::File(path) => progress::stoppable(|stop| write_file(path, write, stop))?,
        };
        written.map_err(|error| Failure::from_write(&name, &error))
    }

    /// Writes bytes.
    pub(super) fn write_all(&self, bytes: &[u8]) -> Result<(), Failure> {
        self.write(|out| out.write_all(bytes))
    }
}

/// A folder of results: made if it is not there, each file in it written whole or not at all.
#[derive(Debug)]
pub(super) struct Folder(PathBuf);

impl Folder {
    /// The folder at a path.
    pub(super) fn new(path: &Path) -> Result<Self, Failure> {
        let cannot = |error: io::Error| Failure::from_write(&path.display().to_string(), &error);
        fs::create_dir_all(path).map_err(cannot)?;
        Ok(Self(path.to_owned()))
    }

    /// A folder in this one.
    pub(super) fn folder(&self, name: &str) -> Result<Self, Failure> {
        Self::new(&self.0.join(name))
    }

    /// Writes a file.
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        Target::new(Some(&self.0.join(name).to_string_lossy()), &[])?.write_all(bytes)
    }
}

fn buffered(out: impl Write, write: Box<Writer<'_>>) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    write(&mut out)?;
    out.flush()
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Writes under a temporary name beside the file, then renames: the file is whole, or as it was. Nothing if stopped
/// before that.
fn write_file(target: &Path, write: Box<Writer<'_>>, stop: &AtomicBool) -> Option<io::Result<()>> {
    let written = temporary(target, write);
    if stop.load(Ordering::SeqCst) {
        return None;
    }
    Some(written.and_then(|temporary| temporary.persist(target).map(drop).map_err(|error| error.error)))
}

/// The result in a file of its own beside the target, which is gone if it is dropped.
fn temporary(target: &Path, write: Box<Writer<'_>>) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".raytree-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What a new file gets, less the user's mask; an existing one keeps what it has.
        let mode = fs::metadata(target).map_or(0o666, |data| data.permissions().mode());
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    let temporary = builder.tempfile_in(folder_of(target))?;
    buffered(&temporary, write)?;
    Ok(temporary)
}
