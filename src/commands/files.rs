//! Files that are read: scenes with their meshes, trees. The only file of the commands that opens one for reading.

use std::io::Read;
use std::path::Path;

use super::failure::Failure;
use crate::input::Problem;
use crate::scene::{self, Loaded};

/// No scene, tree or mesh file is read beyond this: 1 GiB.
const LARGEST: u64 = 1 << 30;

/// The scene in `file`, its meshes looked up beside it; `-` is standard input.
pub(super) fn load_scene(file: &str) -> Result<Loaded, Failure> {
    let text = read_text(file)?;
    Ok(load_scene_text(file, &text)?)
}

/// The scene that the text of `file` holds, its meshes looked up beside it.
pub(super) fn load_scene_text(file: &str, text: &str) -> Result<Loaded, Problem> {
    let folder = if file == "-" { Path::new("") } else { Path::new(file).parent().unwrap_or(Path::new("")) };
    let mut read_mesh = |name: &str| read(&folder.join(name).to_string_lossy());
    scene::load(shown(file), text, &mut read_mesh)
}

/// The text of `file`.
pub(super) fn read_text(file: &str) -> Result<String, Failure> {
    let bytes = read(file).map_err(|why| {
        let help = "the path of a readable file, or - for standard input";
        Problem::new(shown(file), format!("it cannot be read: {why}"), help)
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let start = error.utf8_error().valid_up_to();
        let text = String::from_utf8_lossy(error.as_bytes());
        let message = format!("byte {start} is not UTF-8");
        Problem::new(shown(file), message, "JSON is UTF-8 text").at(&text, start..start + 1).into()
    })
}

/// How messages and trees name the file.
pub(super) fn shown(file: &str) -> &str {
    if file == "-" { "<stdin>" } else { file }
}

fn read(file: &str) -> Result<Vec<u8>, String> {
    let words = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        std::io::ErrorKind::IsADirectory => "it is a directory".to_owned(),
        _ => error.to_string(),
    };
    let mut bytes = Vec::new();
    if file == "-" {
        std::io::stdin().lock().take(LARGEST + 1).read_to_end(&mut bytes).map_err(words)?;
    } else {
        let opened = std::fs::File::open(file).map_err(words)?;
        if opened.metadata().is_ok_and(|data| data.is_dir()) {
            return Err("it is a directory".to_owned());
        }
        opened.take(LARGEST + 1).read_to_end(&mut bytes).map_err(words)?;
    }
    match bytes.len() as u64 > LARGEST {
        true => Err(format!("it is larger than {LARGEST} bytes")),
        false => Ok(bytes),
    }
}
