//! A scene, its picture and the recordings of some of its pixels as one file, for a browser without a server.
//!
//! The data is JSON in the page: `{"format": "raytree-export/1", "scene": SCENE, "geometry": .., "render": "data:image/png;..",
//! "overlays": {"rays": BLOCK, ..}, "glyphs": BLOCK, "pixels": [{"x", "y", "block": BLOCK}]}`. A BLOCK is gzip in base64: of
//! an overlay f32 row by row, of a pixel JSON with its recording and its diagrams by the query that asks the server for them.
//! The outlines of letters stand in `glyphs` once, by their names in the drawings, which have `<path id="NAME"/>` for them.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use rayon::prelude::{IntoParallelRefIterator, ParallelIterator};
use serde::Serialize;

use super::answer::Refusal;
use super::bands::rows;
use super::bundle;
use super::description::Description;
use super::diagram::{Wanted, svg};
use super::geometry::Geometry;
use super::query::inside;
use super::recording::record;
use super::scenes::{Held, Inspector};
use super::tracing::Show;
use crate::input::Problem;
use crate::pictures::Format;
use crate::pictures::diagrams::{Chosen, Kind};
use crate::pictures::theme::Theme;
use crate::scene::{Numerics, Scene};
use crate::steps::Recording;

/// The pixels that a page keeps.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// With their diagrams.
    pub drawn: Vec<[u32; 2]>,
    /// Those of the whole picture as well, without diagrams.
    pub all: bool,
}

impl Kept {
    /// Pixels of a picture that a page can keep all of, at most.
    pub const MOST: u64 = 1 << 12;
}

/// Diagrams of single tests that a page keeps of a pixel, in both themes.
const MOST_TESTS_DRAWN: usize = 256;

/// Outlines of letters by their names in drawings.
type Glyphs = BTreeMap<String, String>;

impl Inspector {
    /// The page of the scene that was given, with what it keeps; nothing if `stop` was set meanwhile. `done` is called after
    /// each pixel, on any thread. The same input gives the same bytes.
    ///
    /// # Errors
    /// One [`Problem`]: a pixel outside the picture, a tree too large to be stepped through, all of more than [`Kept::MOST`]
    /// pixels.
    pub fn export(&self, kept: &Kept, done: &(dyn Fn() + Sync), stop: &AtomicBool) -> Result<Option<String>, Problem> {
        let held = self.first();
        let wrong = |message: String, help: &str| Problem::new(&held.loaded.file, message, help);
        page(held, kept, done, stop).map_err(|refusal| match refusal {
            Refusal::Scene(problem) => *problem,
            Refusal::Why(why) => wrong(why, "other pixels, or less depth"),
            Refusal::Request(_, message, help) => wrong(message, help),
        })
    }

    /// How many pixels a page keeps.
    pub fn count(&self, kept: &Kept) -> u64 {
        pixels(self.scene(), kept).map_or(0, |pixels| pixels.len() as u64)
    }

    /// The scene that was given.
    pub fn scene(&self) -> &Scene {
        &self.first().loaded.scene
    }
}

#[derive(Serialize)]
struct Page<'a> {
    format: &'static str,
    scene: Description<'a>,
    geometry: Geometry<'a>,
    render: String,
    overlays: BTreeMap<&'static str, String>,
    glyphs: String,
    pixels: Vec<Pixel>,
}

#[derive(Serialize)]
struct Pixel {
    x: u32,
    y: u32,
    block: String,
}

/// The page; nothing if stopped.
///
/// # Errors
/// As [`Inspector::export`] has them.
pub(super) fn page(
    held: &Held,
    kept: &Kept,
    done: &(dyn Fn() + Sync),
    stop: &AtomicBool,
) -> Result<Option<String>, Refusal> {
    let scene = &held.loaded.scene;
    let pixels = pixels(scene, kept)?;
    let stopped = || stop.load(Ordering::Relaxed);
    let pixel = |&([x, y], drawn): &([u32; 2], bool)| {
        if stopped() {
            return Ok(None);
        }
        let tree = record(held, [x, y], stop)?;
        if stopped() {
            return Ok(None);
        }
        let recording = Recording::of(scene, &tree);
        let mut glyphs = Glyphs::new();
        let mut diagrams = BTreeMap::new();
        if drawn {
            for (query, wanted) in wanted(&recording) {
                if stopped() {
                    return Ok(None);
                }
                // What does not apply to a node is not kept.
                if let Ok(svg) = svg(scene, &tree, wanted) {
                    diagrams.insert(query, without_glyphs(&svg, &mut glyphs));
                }
            }
        }
        let block = block(&json(&Block { recording: &recording, diagrams }));
        done();
        Ok::<_, Refusal>(Some((Pixel { x, y, block }, glyphs)))
    };
    let done_pixels: Vec<Option<(Pixel, Glyphs)>> = pixels.par_iter().map(pixel).collect::<Result<_, _>>()?;
    let mut glyphs = Glyphs::new();
    let mut blocks = Vec::with_capacity(done_pixels.len());
    for pixel in done_pixels {
        let Some((pixel, own)) = pixel else { return Ok(None) };
        blocks.push(pixel);
        glyphs.extend(own);
    }
    let Some(film) = held.world.tracer(scene, held.options, stop).film(stop) else { return Ok(None) };
    let png = film.encode(Format::Png).map_err(|_| Refusal::broken())?;
    let mut overlays = BTreeMap::new();
    for (name, show) in Show::KEPT {
        if show == Show::Stage && held.options.numerics != Numerics::Certified {
            continue;
        }
        overlays.insert(name, block(&rows(held, show, 0, scene.image.height, stop)));
    }
    if stopped() {
        return Ok(None);
    }
    let data = Page {
        format: "raytree-export/1",
        scene: Description::of(held),
        geometry: Geometry::of(scene),
        render: format!("data:image/png;base64,{}", BASE64_STANDARD.encode(png)),
        overlays,
        glyphs: block(&json(&glyphs)),
        pixels: blocks,
    };
    Ok(Some(bundle::page(&String::from_utf8(json(&data)).unwrap_or_default())))
}

/// The pixels in the order of the page, each once, and whether diagrams are kept of them.
fn pixels(scene: &Scene, kept: &Kept) -> Result<Vec<([u32; 2], bool)>, Refusal> {
    let image = scene.image;
    let count = u64::from(image.width) * u64::from(image.height);
    if kept.all && count > Kept::MOST {
        let why = format!("a page keeps all pixels of a picture of at most {}, and this one has {count}", Kept::MOST);
        return Err(Refusal::Why(why));
    }
    let mut pixels: BTreeMap<[u32; 2], bool> = BTreeMap::new();
    if kept.all {
        pixels.extend((0..image.height).flat_map(|y| (0..image.width).map(move |x| ([y, x], false))));
    }
    for &[x, y] in &kept.drawn {
        inside(image, [x, y]).ok_or_else(|| Refusal::Why(format!("pixel {x},{y} lies outside the image")))?;
        pixels.insert([y, x], true);
    }
    Ok(pixels.into_iter().map(|([y, x], drawn)| ([x, y], drawn)).collect())
}

#[derive(Serialize)]
struct Block<'a> {
    recording: &'a Recording<'a>,
    diagrams: BTreeMap<String, String>,
}

/// The diagrams of a pixel by their queries: of each node what a surface does and the section, of the tree as a whole what
/// is of the whole, and of the steps what they name, the first of them if there are many.
fn wanted(recording: &Recording<'_>) -> Vec<(String, Wanted)> {
    let whole = Kind::ALL.into_iter().filter(|kind| kind.is_of_the_whole_tree()).map(|kind| (kind, 0, None));
    let each = [Kind::Surface, Kind::Section].into_iter();
    let each = each.flat_map(|kind| (0..recording.nodes.len()).map(move |node| (kind, node, None)));
    let mut all: Vec<(Kind, usize, Option<Chosen>)> = whole.chain(each).collect();
    let mut tests = 0;
    let mut known: BTreeSet<_> = all.iter().map(|&(kind, node, _)| (kind, node, None)).collect();
    for step in &recording.steps {
        let Some(picture) = step.diagram else { continue };
        let Ok(kind) = picture.kind.parse::<Kind>() else { continue };
        let node = picture.node.unwrap_or(step.node);
        let chosen = picture.shape.map(|shape| Chosen { shape, primitive: picture.primitive });
        if !known.insert((kind, node, picture.shape.map(|shape| (shape, picture.primitive)))) {
            continue;
        }
        tests += usize::from(chosen.is_some());
        if chosen.is_none() || tests <= MOST_TESTS_DRAWN {
            all.push((kind, node, chosen));
        }
    }
    let themes = [("light", &Theme::LIGHT), ("dark", &Theme::DARK)];
    let diagrams = all.into_iter().flat_map(|one| themes.map(|theme| (one, theme)));
    let diagrams = diagrams.map(|((kind, node, chosen), (name, theme))| {
        let path = &recording.nodes[node].path;
        let mut query = form_urlencoded::Serializer::new(String::new());
        query.append_pair("kind", kind.name()).append_pair("node", &path.to_string());
        if let Some(Chosen { shape, primitive }) = chosen {
            query.append_pair("shape", &shape.to_string());
            primitive.map(|primitive| query.append_pair("primitive", &primitive.to_string()));
        }
        (query.append_pair("theme", name).finish(), Wanted { kind, node: path.clone(), chosen, theme })
    });
    diagrams.collect()
}

/// The drawing with the outlines of its letters taken out.
fn without_glyphs(svg: &str, glyphs: &mut Glyphs) -> String {
    let mut rest = String::with_capacity(svg.len());
    for line in svg.split_inclusive('\n') {
        let outline = line.strip_prefix("<path id=\"").and_then(|line| line.strip_suffix("\"/>\n"));
        match outline.and_then(|line| line.split_once("\" d=\"")) {
            Some((name, outline)) => {
                glyphs.entry(name.to_owned()).or_insert_with(|| outline.to_owned());
                rest.push_str(&format!("<path id=\"{name}\"/>\n"));
            }
            None => rest.push_str(line),
        }
    }
    rest
}

fn json(value: &impl Serialize) -> Vec<u8> {
    // Plain data under text keys: writing it cannot fail.
    serde_json::to_vec(value).unwrap_or_default()
}

/// Bytes as gzip in base64.
fn block(bytes: &[u8]) -> String {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    // A vector takes everything.
    packed.write_all(bytes).ok();
    BASE64_STANDARD.encode(packed.finish().unwrap_or_default())
}
