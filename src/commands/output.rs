//! Results that are written: to standard output, or whole to a file, or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use super::failure::Failure;

/// Writes a result to `file`, or to standard output where there is none or it is `-`.
pub(super) fn write(file: Option<&str>, bytes: &[u8]) -> Result<(), Failure> {
    match file {
        None | Some("-") => {
            let mut out = io::stdout().lock();
            out.write_all(bytes).and_then(|()| out.flush()).map_err(|e| Failure::from_write("standard output", &e))
        }
        Some(file) => write_file(Path::new(file), bytes).map_err(|e| Failure::from_write(file, &e)),
    }
}

/// Writes under a temporary name beside the file, then renames: the file is whole, or as it was.
fn write_file(file: &Path, bytes: &[u8]) -> io::Result<()> {
    // A device or a pipe is written to as it is; a link's target is what is replaced.
    let target = match fs::metadata(file) {
        Ok(data) if data.is_file() => fs::canonicalize(file)?,
        Ok(data) if data.is_dir() => return Err(io::Error::other("it is a directory")),
        Ok(_) => return File::options().write(true).open(file)?.write_all(bytes),
        Err(_) => file.to_owned(),
    };
    let folder = match target.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".raytree-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What a new file gets, less the user's mask; an existing one keeps what it has.
        let mode = fs::metadata(&target).map_or(0o666, |data| data.permissions().mode());
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    let mut temporary = builder.tempfile_in(folder)?;
    temporary.write_all(bytes)?;
    temporary.flush()?;
    temporary.persist(&target).map_err(|error| error.error)?;
    Ok(())
}
