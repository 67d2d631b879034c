//! The page about one pixel: the picture with the pixel marked and magnified, the text of its tree, and its diagrams.

use glam::DVec2;

use super::charts::wrap;
use super::diagrams::{Input, Kind, diagram, elided, light, shown_vector};
use super::drawing::{Align, Color, Drawing, Face, Level, Path, Pen, Raster, Rect, Sampling, Text};
use super::film::Film;
use super::theme::Theme;
use crate::input::printable;
use crate::tree::Show;

/// The page: 16 : 9, which also leaves a margin on A4 across.
const PAGE: DVec2 = DVec2::new(1680.0, 945.0);
const MARGIN: f64 = 24.0;
const GAP: f64 = 14.0;
/// The column of the picture and the text.
const COLUMN: f64 = 500.0;
/// The side of what is magnified, in pixels, and on the page.
const MAGNIFIED: u32 = 13;
const MAGNIFIER: f64 = 143.0;
/// A raster wider than this gains nothing on the page.
const WIDEST: u32 = 1280;

/// The page about the pixel of `input`, which has to be that of a finished tree, in the picture `film`.
pub fn sheet(input: &Input<'_>, film: &Film, theme: &Theme) -> Drawing {
    let title = format!("{} of {}", input.of_what(), scene_name(input));
    let mut page = Drawing::new(PAGE.x, PAGE.y, theme.background, title);
    page.describe(format!(
        "The picture, the ray tree and its diagrams. {}",
        input.scene.about.as_deref().unwrap_or("")
    ));
    let top = heading(&mut page, input, theme);
    let column = Rect { min: DVec2::new(MARGIN, top), max: DVec2::new(MARGIN + COLUMN, PAGE.y - MARGIN) };
    let below = picture(&mut page, column, input, film, theme);
    listing(&mut page, Rect { min: DVec2::new(column.min.x, below), ..column }, input, theme);
    let right = Rect { min: DVec2::new(column.max.x + GAP + 4.0, top), max: PAGE - MARGIN };
    panels(&mut page, right, input, theme);
    page
}

/// The scene's file without folders and ending.
fn scene_name(input: &Input<'_>) -> String {
    let file = input.tree.scene.as_ref().map_or("", |scene| scene.file.as_str());
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    printable(name.strip_suffix(".json").unwrap_or(name)).into_owned()
}

/// What the page is about; returns where the rest begins.
fn heading(page: &mut Drawing, input: &Input<'_>, theme: &Theme) -> f64 {
    let bold = Text::new(21.0, theme.ink).face(Face::Bold);
    let rays = input.tree.rays;
    let title = format!("{}: {}", scene_name(input), input.of_what());
    let right = format!("{rays} ray{}", if rays == 1 { "" } else { "s" });
    let small = Text::new(13.0, theme.muted);
    let title = elided(&title, &bold, PAGE.x - 2.0 * MARGIN - 120.0);
    page.text((MARGIN, MARGIN + 16.0), title, bold);
    page.text((PAGE.x - MARGIN, MARGIN + 16.0), right, small.anchor(Align::End, Level::Baseline));
    let mut y = MARGIN + 22.0;
    let about = input.scene.about.as_deref().map(printable).unwrap_or_default();
    let lines = wrap(&about, &small, PAGE.x - 2.0 * MARGIN);
    for line in lines.iter().take(2) {
        y += 18.0;
        page.text((MARGIN, y), elided(line, &small, PAGE.x - 2.0 * MARGIN), small);
    }
    y + 16.0
}

/// The picture with the pixel marked, and below it what is around the pixel, and its colour; returns where the rest begins.
fn picture(page: &mut Drawing, column: Rect, input: &Input<'_>, film: &Film, theme: &Theme) -> f64 {
    let size = DVec2::new(film.size.width.into(), film.size.height.into());
    let scale = (DVec2::new(column.size().x, 375.0) / size).min_element();
    let rect = Rect::new(column.min, size * scale);
    let (raster, factor) = raster(film);
    let sampling = if scale * f64::from(factor) >= 1.0 { Sampling::Nearest } else { Sampling::Smooth };
    page.image(raster, rect, sampling);
    page.stroke(Path::rect(rect), Pen::new(theme.axis, 1.0));
    let Some([x, y]) = input.tree.pixel else { return rect.max.y + GAP };
    let at = rect.min + scale * (DVec2::new(x.into(), y.into()) + 0.5);
    let half = (0.5 * f64::from(MAGNIFIED) * scale).max(6.0);
    let around = Rect { min: (at - half).max(rect.min), max: (at + half).min(rect.max) };
    for (color, width) in [(Color::BLACK, 3.6), (Color::WHITE, 1.6)] {
        page.stroke(Path::rect(around), Pen::new(color, width));
    }

    let zoom = Rect::new((rect.min.x, rect.max.y + GAP), (MAGNIFIER, MAGNIFIER));
    magnify(page, zoom, film, [x, y], theme);
    let text = Text::new(13.0, theme.ink);
    let left = zoom.max.x + 16.0;
    let color = Rect::new((left, zoom.min.y), (44.0, 44.0));
    page.fill(Path::rect(color), light(input.tree.color));
    page.stroke(Path::rect(color), Pen::new(theme.axis, 1.0));
    let mut y = zoom.min.y + 12.0;
    let room = column.max.x - color.max.x - 14.0;
    let lines = [
        (input.of_what(), text.face(Face::Bold)),
        (format!("rgb {}", shown_vector(input.tree.color)), text.face(Face::Mono)),
        ("linear light, before it is clamped".to_owned(), text.color(theme.muted)),
    ];
    for (words, text) in lines {
        page.text((color.max.x + 14.0, y), elided(&words, &text, room), text);
        y += 19.0;
    }
    y = zoom.min.y + 78.0;
    for words in settings(input) {
        let text = text.color(theme.muted);
        page.text((left, y), elided(&words, &text, column.max.x - left), text);
        y += 19.0;
    }
    zoom.max.y + GAP
}

/// How it was traced.
fn settings(input: &Input<'_>) -> Vec<String> {
    let Some(settings) = input.tree.settings else { return Vec::new() };
    let precision = settings.precision.map_or(String::new(), |precision| format!(" in {precision}"));
    let numerics = settings.numerics.map_or(String::new(), |numerics| format!("{numerics} kernels{precision}"));
    let depth = settings.max_depth.map_or(String::new(), |depth| format!("max_depth {depth}"));
    let weight = settings.min_weight.map_or(String::new(), |least| format!("min_weight {least}"));
    [numerics, depth, weight].into_iter().filter(|words| !words.is_empty()).collect()
}

/// The pixels around one, each a square, the one in the middle framed.
fn magnify(page: &mut Drawing, rect: Rect, film: &Film, [x, y]: [u32; 2], theme: &Theme) {
    let (width, height) = (i64::from(film.size.width), i64::from(film.size.height));
    let half = i64::from(MAGNIFIED / 2);
    let color = |column: u32, row: u32| {
        let (x, y) = (i64::from(x) + i64::from(column) - half, i64::from(y) + i64::from(row) - half);
        match (0..width).contains(&x) && (0..height).contains(&y) {
            true => light(film.pixels[(y * width + x) as usize].to_array()),
            false => theme.panel,
        }
    };
    page.image(Raster::from_fn(MAGNIFIED, MAGNIFIED, color), rect, Sampling::Nearest);
    page.stroke(Path::rect(rect), Pen::new(theme.axis, 1.0));
    let side = rect.size().x / f64::from(MAGNIFIED);
    let middle = Rect { min: rect.center(), max: rect.center() }.grown(side / 2.0 + 1.0);
    for (color, width) in [(Color::BLACK, 4.0), (Color::WHITE, 1.8)] {
        page.stroke(Path::rect(middle), Pen::new(color, width));
    }
}

/// The picture as a raster, made smaller by a whole factor where it is very large.
fn raster(film: &Film) -> (Raster, u32) {
    let (width, height) = (film.size.width, film.size.height);
    let factor = width.max(height).div_ceil(WIDEST);
    let mean = |x: u32, y: u32| {
        let (xs, ys) = (factor * x..(factor * (x + 1)).min(width), factor * y..(factor * (y + 1)).min(height));
        let count = f64::from((xs.end - xs.start) * (ys.end - ys.start));
        let row = |y: u32| xs.clone().map(move |x| film.pixels[(y * width + x) as usize]);
        light((ys.flat_map(row).sum::<glam::DVec3>() / count).to_array())
    };
    (Raster::from_fn(width.div_ceil(factor), height.div_ceil(factor), mean), factor)
}

/// The text of the tree, each line with the number that the diagrams use.
fn listing(page: &mut Drawing, room: Rect, input: &Input<'_>, theme: &Theme) {
    const LINE: f64 = 13.6;
    let (mono, bold) = (Text::new(10.5, theme.ink).face(Face::Mono), Text::new(13.0, theme.ink).face(Face::Bold));
    page.text((room.min.x, room.min.y + 12.0), "The tree as text", bold);
    let outcomes = input.tree.to_text(Show::default());
    let all: Vec<&str> = outcomes.lines().skip(1).filter(|line| is_ray(line)).collect();
    let most = ((room.size().y - 22.0) / LINE).floor().max(2.0) as usize;
    let shown = if all.len() > most { most - 1 } else { all.len() };
    let digits = all.len().to_string().len();
    let column = mono.width("0".repeat(digits + 2).as_str());
    let letters = ((room.size().x - column) / mono.width("0")).floor() as usize;
    for (i, line) in all[..shown].iter().enumerate() {
        let y = room.min.y + 22.0 + LINE * (i as f64 + 0.75);
        let number = mono.color(theme.muted).anchor(Align::End, Level::Baseline);
        page.text((room.min.x + mono.width("0") * digits as f64, y), (i + 1).to_string(), number);
        page.text((room.min.x + column, y), cut(line, letters), mono);
    }
    if shown < all.len() {
        let y = room.min.y + 22.0 + LINE * (shown as f64 + 0.75);
        page.text((room.min.x + column, y), format!("… and {} more", all.len() - shown), mono.color(theme.muted));
    }
}

/// Blanks squeezed to two, the graphics aside, and the end cut off where it is too long.
fn cut(line: &str, letters: usize) -> String {
    let (graphics, rest) = line.split_at(line.find(|c: char| c.is_alphabetic()).unwrap_or(0));
    let rest: Vec<&str> = rest.split("  ").map(str::trim).filter(|part| !part.is_empty()).collect();
    let line = graphics.chars().chain(rest.join("  ").chars()).collect::<Vec<_>>();
    match line.len() > letters {
        true => line[..letters.saturating_sub(1)].iter().chain(&['…']).collect(),
        false => line.into_iter().collect(),
    }
}

/// Whether a line of a tree's text is a ray, and not one of its tests.
fn is_ray(line: &str) -> bool {
    let word = line.trim_start_matches(['|', '`', '-', ' ']).split(' ').next();
    matches!(word, Some("camera" | "shadow" | "reflected" | "refracted"))
}

/// The section, the diagrams of the first hit, the tree and the ledger: the first four that there are, and the ledger
/// below a small tree.
fn panels(page: &mut Drawing, room: Rect, input: &Input<'_>, theme: &Theme) {
    let half = (room.size() - GAP) / 2.0;
    let applies = |kind: &Kind| diagram(*kind, &input.clone().on_page(half.x, half.y), theme).is_ok();
    let of_the_hit = Kind::ALL.into_iter().filter(|kind| !kind.is_of_the_whole_tree() && *kind != Kind::Section);
    let order = [Kind::Section].into_iter().chain(of_the_hit).chain([Kind::Tree, Kind::Ledger]);
    let kinds: Vec<Kind> = order.filter(applies).take(4).collect();
    // The lower row takes what it needs, the upper one the rest.
    let in_a_row = |count: usize| DVec2::new((room.size().x - GAP * (count - 1) as f64) / count as f64, half.y);
    let draw = |kind: Kind, size: DVec2| diagram(kind, &input.clone().on_page(size.x, size.y), theme).ok();
    let (upper, lower) = kinds.split_at(if kinds.len() == 4 { 2 } else { kinds.len().min(1) });
    let lower_drawings: Vec<Option<Drawing>> = lower.iter().map(|kind| draw(*kind, in_a_row(lower.len()))).collect();
    let heights = lower_drawings.iter().flatten().map(|drawing| drawing.canvas().size().y);
    let lower_height = heights.fold(0.0, f64::max);
    let upper_height = room.size().y - if lower.is_empty() { 0.0 } else { lower_height + GAP };
    let upper_size = DVec2::new(in_a_row(upper.len().max(1)).x, upper_height);
    let upper_drawings = upper.iter().map(|kind| draw(*kind, upper_size));
    let rows = [
        (room.min.y, upper_size, upper_drawings.collect()),
        (room.min.y + upper_height + GAP, DVec2::new(in_a_row(lower.len().max(1)).x, lower_height), lower_drawings),
    ];
    let framed = |page: &mut Drawing, panel: Rect, drawing: &Drawing| {
        page.stroke(Path::rounded(panel, 6.0), Pen::new(theme.grid, 1.2));
        page.place(drawing, panel.min, 1.0);
    };
    let has_ledger = kinds.contains(&Kind::Ledger);
    for (y, size, drawings) in rows {
        for (i, drawing) in drawings.iter().flatten().enumerate() {
            let corner = DVec2::new(room.min.x + i as f64 * (size.x + GAP), y);
            let needed = drawing.canvas().size().y;
            let left = size.y - needed - GAP;
            // Below a small tree there is room for the ledger.
            let is_last = y > room.min.y && i + 1 == lower.len();
            let ledger = (is_last && !has_ledger && left > 0.0).then(|| draw(Kind::Ledger, DVec2::new(size.x, left)));
            match ledger.flatten().filter(|ledger| ledger.canvas().size().y <= left) {
                Some(ledger) => {
                    framed(page, Rect::new(corner, (size.x, needed)), drawing);
                    framed(page, Rect::new(corner + DVec2::new(0.0, needed + GAP), (size.x, left)), &ledger);
                }
                None => framed(page, Rect::new(corner, size), drawing),
            }
        }
    }
}
