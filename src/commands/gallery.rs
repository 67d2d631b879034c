//! `raytree gallery`: every diagram of every named pixel, in a folder that a browser opens.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

use super::failure::Failure;
use super::options::TraceArgs;
use super::output::Folder;
use super::picture::{Format, LookArgs, record};
use super::{files, progress};
use crate::input::Problem;
use crate::pictures::diagrams::{Input, Kind, contact_sheet, diagram};
use crate::pictures::drawing::{Color, Drawing, escape};
use crate::pictures::theme::Theme;
use crate::scene::{Loaded, scene_files};
use crate::tree::NodePath;

/// Draws every diagram of every named pixel of scenes, as files, contact sheets and an index.html
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  raytree gallery diagrams
  raytree gallery diagrams scenes/whitted.json --svg
Each scene gets a folder with its diagrams and a contact sheet of all; index.html needs nothing from elsewhere.")]
pub(super) struct Args {
    /// Folder to write to; made if it is not there
    folder: String,
    /// Scene files, or folders with scene files
    #[arg(default_value = "scenes")]
    scenes: Vec<String>,
    /// Diagrams as SVG instead of PNG
    #[arg(long)]
    svg: bool,
    #[command(flatten)]
    look: LookArgs,
    #[command(flatten)]
    trace: TraceArgs,
}

/// The width of a diagram on a contact sheet, in user units.
const THUMBNAIL: f64 = 300.0;

/// A diagram that was written.
struct Entry {
    file: String,
    kind: Kind,
    description: String,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let mut files = BTreeSet::new();
    for path in &args.scenes {
        files.extend(scene_files(path)?);
    }
    // All are read before anything is written.
    let scenes: Vec<Loaded> = files.iter().map(|file| files::load_scene(file)).collect::<Result<_, _>>()?;
    if scenes.is_empty() {
        let help = "scene files, or folders with files that end in .json";
        return Err(Problem::new(&args.scenes[0], "there are no scenes", help).into());
    }
    let folder = Folder::new(Path::new(&args.folder))?;
    let theme = args.look.theme();
    let mut index = String::new();
    let mut names = BTreeSet::new();
    let bar = progress::bar("drawing", scenes.len() as u64);
    for loaded in &scenes {
        let name = unique(&slug(&loaded.file), &mut names);
        folder.folder(&name)?;
        scene_page(args, &folder, loaded, &name, theme, &mut index)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    folder.write("index.html", page(&index, theme).as_bytes())
}

/// Writes the diagrams of a scene and its contact sheet, and adds it to the index.
fn scene_page(
    args: &Args,
    folder: &Folder,
    loaded: &Loaded,
    name: &str,
    theme: &Theme,
    index: &mut String,
) -> Result<(), Failure> {
    let format = if args.svg { Format::Svg } else { Format::Png };
    let ending = if args.svg { "svg" } else { "png" };
    let about = loaded.scene.about.as_deref().unwrap_or_default();
    write!(index, "<h2 id=\"{0}\">{0}</h2>\n<p>{1}</p>\n", escape(name), escape(about)).ok();
    let mut rows: Vec<Vec<Drawing>> = Vec::new();
    let mut names = BTreeSet::new();
    for (pixel, place) in &loaded.scene.pixels {
        let tree = record(loaded, &args.trace, *place)?;
        let input = Input::new(&loaded.scene, &tree, NodePath::ROOT)
            .map_err(|no| Failure::Input(Problem::new(&loaded.file, no.message, no.help)))?;
        let slug = unique(&slug(pixel), &mut names);
        let mut row = Vec::new();
        let mut entries = Vec::new();
        for kind in Kind::ALL {
            let Ok(drawing) = diagram(kind, &input, theme) else { continue };
            let file = format!("{name}/{slug}.{kind}.{ending}");
            folder.write(&file, &format.encode(&drawing, args.look.scale)?)?;
            entries.push(Entry { file, kind, description: drawing.description().to_owned() });
            row.push(drawing);
        }
        add_row(index, pixel, *place, &entries);
        rows.push(row);
    }
    if rows.is_empty() {
        index.push_str("<p>No named pixels.</p>\n");
        return Ok(());
    }
    let contact = contact_sheet(&format!("All diagrams of {name}"), &rows, THUMBNAIL, theme);
    let file = format!("{name}/contact.png");
    folder.write(&file, &Format::Png.encode(&contact, 1.0)?)?;
    writeln!(index, "<p><a href=\"{}\">Contact sheet</a></p>", escape(&file)).ok();
    Ok(())
}

/// A row of the index: a pixel and its diagrams.
fn add_row(index: &mut String, pixel: &str, [x, y]: [u32; 2], entries: &[Entry]) {
    write!(index, "<h3>{} <small>{x},{y}</small></h3>\n<div>\n", escape(pixel)).ok();
    for Entry { file, kind, description } in entries {
        let (file, description) = (escape(file), escape(description));
        writeln!(
            index,
            "<a href=\"{file}\"><img loading=\"lazy\" src=\"{file}\" alt=\"{description}\"><span>{kind}</span></a>"
        )
        .ok();
    }
    index.push_str("</div>\n");
}

/// The whole index.
fn page(body: &str, theme: &Theme) -> String {
    let css = |color: Color| format!("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
    let (ground, ink, muted, line) = (css(theme.panel), css(theme.ink), css(theme.muted), css(theme.grid));
    let paper = css(theme.background);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>raytree gallery</title>\n<style>
body {{ margin: 2rem; background: {ground}; color: {ink}; font: 15px/1.5 system-ui, sans-serif; }}
p {{ max-width: 60rem; }}
h2 {{ margin-top: 3rem; }} h3 {{ margin-bottom: .3rem; }} small, span {{ color: {muted}; font-weight: normal; }}
div {{ display: flex; flex-wrap: wrap; gap: 12px; }}
a {{ color: inherit; }} div a {{ text-decoration: none; }}
img {{ display: block; width: 400px; height: 264px; object-fit: contain; background: {paper}; border: 1px solid {line}; }}
</style>\n<h1>All diagrams</h1>\n{body}</html>\n"
    )
}

/// A name as a file name: small letters, digits, and hyphens for the rest.
fn slug(name: &str) -> String {
    let name = name.strip_suffix(".json").unwrap_or(name);
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let slug: String = name.chars().map(letter).collect();
    let parts: Vec<&str> = slug.split('-').filter(|part| !part.is_empty()).collect();
    if parts.is_empty() { "unnamed".to_owned() } else { parts.join("-") }
}

/// The name, or the name with the first number that makes it new.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let numbered = (2..).map(|i| format!("{name}-{i}"));
    let free = [name.to_owned()].into_iter().chain(numbered).find(|name| !taken.contains(name)).unwrap_or_default();
    taken.insert(free.clone());
    free
}
