//! The diagram of a step, as a file.

use std::path::{Path, PathBuf};

use super::super::failure::Failure;
use super::super::output::Target;
use super::super::picture::Format;
use crate::input::one_of;
use crate::pictures::diagrams::{Chosen, Input, Kind, diagram};
use crate::pictures::theme::Theme;
use crate::scene::Loaded;
use crate::steps::Recording;

/// Pixels of a PNG for each unit of the drawing.
const SCALE: f64 = 1.5;

/// Draws the diagram of a step; what was written, or why nothing was.
///
/// `words` are a kind, a file, both or neither. A file that this session has not written is left alone.
pub(super) fn draw(
    loaded: &Loaded,
    recording: &Recording<'_>,
    at: usize,
    words: &str,
    written: &mut Vec<PathBuf>,
) -> Result<String, String> {
    let step = &recording.steps[at];
    let (first, rest) = words.split_once(char::is_whitespace).unwrap_or((words, ""));
    let (kind, file) = match first.parse::<Kind>() {
        Ok(kind) => (Some(kind), rest.trim()),
        // A lone word without an ending is a kind that there is not.
        Err(help) if !first.is_empty() && !words.contains('.') => {
            return Err(format!("there is no kind of diagram `{first}`: {help}"));
        }
        Err(_) => (None, words),
    };
    let of_step = step.diagram;
    let node = of_step.and_then(|picture| picture.node).unwrap_or(step.node);
    let path = recording.nodes[node].path.clone();
    let input = Input::new(&loaded.scene, recording.tree, path).map_err(|no| no.to_string())?;
    let kind_of_step = of_step.and_then(|picture| picture.kind.parse().ok());
    let kind = kind.or(kind_of_step).unwrap_or(Kind::Section);
    let chosen = of_step.filter(|_| Some(kind) == kind_of_step).and_then(|picture| {
        let primitive = picture.primitive;
        picture.shape.map(|shape| Chosen { shape, primitive })
    });
    let input = match chosen {
        Some(chosen) => input.about(chosen),
        None => input,
    };
    let drawing = diagram(kind, &input, &Theme::LIGHT).map_err(|not| {
        let others = Kind::ALL.into_iter().filter(|kind| diagram(*kind, &input, &Theme::LIGHT).is_ok());
        format!("{not}; of this ray there is {}", one_of(others.map(Kind::name)))
    })?;
    let file = if file.is_empty() { free_name(at, kind) } else { file.to_owned() };
    let format = match Path::new(&file).extension().and_then(|ending| ending.to_str()) {
        Some("svg") => Format::Svg,
        Some("png") => Format::Png,
        _ => return Err(format!("{file} is no name for a drawing: it has to end in .svg or .png")),
    };
    let is_ours = written.iter().any(|ours| ours == Path::new(&file));
    if Path::new(&file).symlink_metadata().is_ok() && !is_ours {
        return Err(format!("{file} is there already, and was not drawn in this session: give another name"));
    }
    let failed = |failure| match failure {
        Failure::Machine(why) => why,
        Failure::Input(problem) | Failure::Invalid(problem) => problem.message,
        _ => format!("{file} was not written"),
    };
    let target = Target::new(Some(&file), &[&loaded.file]).map_err(failed)?;
    let bytes = format.encode(&drawing, SCALE).map_err(failed)?;
    target.write_all(&bytes).map_err(failed)?;
    if !is_ours {
        written.push(PathBuf::from(&file));
    }
    Ok(format!("the {kind} diagram of {} is in {file}", input.path))
}

/// A name that no file has.
fn free_name(at: usize, kind: Kind) -> String {
    let name = |suffix: &str| format!("step-{:04}-{kind}{suffix}.svg", at + 1);
    let is_free = |name: &String| Path::new(name).symlink_metadata().is_err();
    let numbered = (2..).map(|n| name(&format!("-{n}")));
    std::iter::once(name("")).chain(numbered).find(is_free).unwrap_or_default()
}
