//! Files that commands read: scenes with their meshes, trees; `-` is standard input.

use super::failure::Failure;
use crate::input::Problem;
use crate::scene::{self, Loaded};

/// The scene in `file`, its meshes looked up beside it.
pub(super) fn load_scene(file: &str) -> Result<Loaded, Failure> {
    Ok(scene_of(file, &read_text(file)?)?)
}

/// The scene that the text of `file` holds, its meshes looked up beside it.
pub(super) fn scene_of(file: &str, text: &str) -> Result<Loaded, Problem> {
    scene::load_beside(shown(file), text)
}

/// The text of `file`.
pub(super) fn read_text(file: &str) -> Result<String, Problem> {
    match file {
        "-" => scene::read_text(shown(file), "standard input", Ok(std::io::stdin().lock())),
        _ => scene::read_text(file, file, scene::open(file)),
    }
}

/// How messages and trees name the file.
pub(super) fn shown(file: &str) -> &str {
    if file == "-" { "<stdin>" } else { file }
}
