//! Scenes and meshes from the file system. The only place of the library that opens a file for reading.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use super::json::{Loaded, load};
use crate::input::Problem;

/// No file is read beyond this: 1 GiB.
pub const LARGEST_FILE: u64 = 1 << 30;

/// The scene in the file at `path`, its meshes looked up beside it.
///
/// # Errors
/// One [`Problem`]: the file cannot be read or is larger than [`LARGEST_FILE`], is not UTF-8, or is not a scene.
///
/// # Example
/// ```
/// let loaded = raytree::scene::load_file("scenes/whitted.json").unwrap();
/// assert!(loaded.scene.pixels.len() > 1);
/// assert!(raytree::scene::load_file("scenes").unwrap_err().message.ends_with("it is a directory"));
/// ```
pub fn load_file(path: &str) -> Result<Loaded, Problem> {
    load_beside(path, &read_text(path, path, open(path))?)
}

/// The scene that `text` holds, its meshes looked up beside the file at `path`.
///
/// # Errors
/// As [`load`] has them.
pub fn load_beside(path: &str, text: &str) -> Result<Loaded, Problem> {
    load(path, text, &mut meshes_beside(path))
}

/// What gives the bytes of the meshes that the scene at `path` names.
pub fn meshes_beside(path: &str) -> impl FnMut(&str) -> Result<Vec<u8>, String> {
    let folder = Path::new(path).parent().unwrap_or(Path::new(""));
    move |name| open(&folder.join(name).to_string_lossy()).and_then(read_all)
}

/// Opens a file that is not a directory; the error is a sentence on why it cannot be.
pub fn open(path: &str) -> Result<File, String> {
    let file = File::open(path).map_err(|error| sentence(&error))?;
    match file.metadata() {
        Ok(data) if data.is_dir() => Err("it is a directory".to_owned()),
        Ok(_) => Ok(file),
        Err(error) => Err(sentence(&error)),
    }
}

/// The scene files that a path names: itself, or all in the folder and in those within, sorted: what ends in `.json`, schemas
/// aside.
///
/// # Errors
/// One [`Problem`]: there is no such path, or a folder cannot be read.
pub fn scene_files(path: &str) -> Result<Vec<String>, Problem> {
    let cannot = |path: &Path, error: &std::io::Error| {
        let message = format!("{} cannot be read: {}", path.display(), sentence(error));
        Problem::new(path.to_string_lossy(), message, "a scene file, or a folder with scene files")
    };
    let mut files = Vec::new();
    let mut open = vec![Path::new(path).to_owned()];
    while let Some(path) = open.pop() {
        let data = std::fs::metadata(&path).map_err(|error| cannot(&path, &error))?;
        if !data.is_dir() {
            files.push(path.to_string_lossy().into_owned());
            continue;
        }
        for entry in std::fs::read_dir(&path).map_err(|error| cannot(&path, &error))? {
            let entry = entry.map_err(|error| cannot(&path, &error))?;
            let inner = entry.path();
            let name = inner.to_string_lossy();
            // A link to a folder is not followed: it may lead back here.
            let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
            if is_folder || !inner.is_dir() && (name.ends_with(".json") && !name.ends_with(".schema.json")) {
                open.push(inner);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// The text that a reader gives, named `shown` in messages.
///
/// # Errors
/// One [`Problem`]: there is no reader, it fails, gives more than [`LARGEST_FILE`], or bytes that are not UTF-8.
pub fn read_text(shown: &str, path: &str, reader: Result<impl Read, String>) -> Result<String, Problem> {
    let bytes = reader.and_then(read_all).map_err(|why| {
        let help = "the path of a readable file, or - for standard input";
        Problem::new(shown, format!("{path} cannot be read: {why}"), help)
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let start = error.utf8_error().valid_up_to();
        let text = String::from_utf8_lossy(error.as_bytes());
        let message = format!("byte {start} is not UTF-8");
        Problem::new(shown, message, "JSON is UTF-8 text").at(&text, start..start + 1)
    })
}

fn read_all(reader: impl Read) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    reader.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(|error| sentence(&error))?;
    match bytes.len() as u64 > LARGEST_FILE {
        true => Err(format!("it is larger than {LARGEST_FILE} bytes")),
        false => Ok(bytes),
    }
}

fn sentence(error: &std::io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::PermissionDenied => "permission denied".to_owned(),
        ErrorKind::IsADirectory => "it is a directory".to_owned(),
        _ => error.to_string(),
    }
}
