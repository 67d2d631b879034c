//! Rasters side by side, with captions and a key to their colours.

use glam::DVec2;

use super::frame::{self, Heading, MARGIN};
use crate::pictures::drawing::{Align, Color, Drawing, Face, Level, Path, Pen, Raster, Rect, Sampling, Text};
use crate::pictures::theme::Theme;

/// A grid of rasters.
#[derive(Clone, Debug, PartialEq)]
pub struct Panels {
    /// What stands above.
    pub heading: Heading,
    /// The rasters, row by row.
    pub panels: Vec<Panel>,
    /// How many stand side by side.
    pub columns: usize,
    /// How many times as wide and as high each pixel is drawn.
    pub factor: u32,
    /// What the colours mean; may be empty.
    pub key: Vec<Key>,
    /// What the colours in between mean.
    pub ramp: Option<Ramp>,
}

/// A raster with what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What it shows, in a few words.
    pub caption: String,
    /// What it amounts to; may be empty.
    pub note: String,
    /// The picture.
    pub raster: Raster,
}

/// A colour and what it means.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// The colour.
    pub color: Color,
    /// What it means.
    pub meaning: String,
}

/// Colours that run from one to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    /// What is measured.
    pub title: String,
    /// The colours, evenly spaced.
    pub colors: Vec<Color>,
    /// What the first colour stands for.
    pub low: String,
    /// What the last colour stands for.
    pub high: String,
}

const GAP: f64 = 22.0;
const CAPTION: f64 = 44.0;

/// Draws [`Panels`], as large as the rasters ask for.
pub fn panels(chart: &Panels, theme: &Theme) -> Drawing {
    let columns = chart.columns.clamp(1, chart.panels.len().max(1));
    let size =
        |panel: &Panel| DVec2::new(panel.raster.width.into(), panel.raster.height.into()) * f64::from(chart.factor);
    let cell = chart.panels.iter().map(size).fold(DVec2::new(150.0, 0.0), DVec2::max);
    let rows = chart.panels.len().div_ceil(columns);
    let width = (2.0 * MARGIN + columns as f64 * (cell.x + GAP) - GAP).max(420.0);
    let top = frame::heading_height(width, &chart.heading, theme) + 10.0;
    let bottom = top + rows as f64 * (cell.y + CAPTION + GAP) - GAP;
    let keys = key_rows(chart, width, theme);
    let height =
        bottom + 14.0 + keys.len() as f64 * 24.0 + if chart.ramp.is_some() { 44.0 } else { 0.0 } + MARGIN - 8.0;
    let (mut drawing, _) = frame::begin(width, height, &chart.heading, theme);

    let caption = Text::new(frame::TEXT, theme.ink).face(Face::Bold);
    let note = Text::new(frame::SMALL, theme.muted);
    for (i, panel) in chart.panels.iter().enumerate() {
        let at = DVec2::new((i % columns) as f64, (i / columns) as f64) * (cell + DVec2::new(GAP, CAPTION + GAP));
        let corner = DVec2::new(MARGIN, top) + at;
        drawing.text(corner + DVec2::new(0.0, 14.0), shortened(&panel.caption, &caption, cell.x), caption);
        drawing.text(corner + DVec2::new(0.0, 32.0), shortened(&panel.note, &note, cell.x), note);
        let rect = Rect::new(corner + DVec2::new(0.0, CAPTION), size(panel));
        drawing.image(panel.raster.clone(), rect, Sampling::Nearest);
        drawing.stroke(Path::rect(rect.grown(0.5)), Pen::new(theme.axis, 1.0));
    }
    let mut y = bottom + 24.0;
    let text = Text::new(frame::SMALL, theme.ink).anchor(Align::Start, Level::Middle);
    for row in &keys {
        let mut x = MARGIN;
        for key in row {
            let swatch = Rect::new((x, y - 7.0), (14.0, 14.0));
            drawing.fill(Path::rounded(swatch, 2.0), key.color);
            drawing.stroke(Path::rounded(swatch, 2.0), Pen::new(theme.axis, 0.8));
            drawing.text((x + 21.0, y), key.meaning.as_str(), text);
            x += key_width(key, theme);
        }
        y += 24.0;
    }
    if let Some(ramp) = &chart.ramp {
        draw_ramp(&mut drawing, DVec2::new(MARGIN, y - 4.0), ramp, theme);
    }
    drawing
}

fn key_width(key: &Key, theme: &Theme) -> f64 {
    21.0 + Text::new(frame::SMALL, theme.ink).width(key.meaning.as_str()) + 22.0
}

fn key_rows<'a>(chart: &'a Panels, width: f64, theme: &Theme) -> Vec<Vec<&'a Key>> {
    let mut rows: Vec<Vec<&Key>> = Vec::new();
    let mut room = 0.0;
    for key in &chart.key {
        let needed = key_width(key, theme);
        match rows.last_mut() {
            Some(row) if needed <= room => row.push(key),
            _ => {
                rows.push(vec![key]);
                room = width - 2.0 * MARGIN + 22.0;
            }
        }
        room -= needed;
    }
    rows
}

/// `words`, cut with an ellipsis where they are wider than `width`.
fn shortened(words: &str, text: &Text, width: f64) -> String {
    if text.width(words) <= width {
        return words.to_owned();
    }
    let mut kept: Vec<char> = words.chars().collect();
    while !kept.is_empty() && text.width(kept.iter().collect::<String>() + "…") > width {
        kept.pop();
    }
    kept.iter().collect::<String>().trim_end().to_owned() + "…"
}

fn draw_ramp(drawing: &mut Drawing, corner: DVec2, ramp: &Ramp, theme: &Theme) {
    let text = Text::new(frame::SMALL, theme.ink);
    drawing.text(corner + DVec2::new(0.0, 8.0), ramp.title.as_str(), text);
    let low = text.width(ramp.low.as_str()) + 8.0;
    let bar = Rect::new(corner + DVec2::new(low, 18.0), (200.0, 12.0));
    let step = bar.size().x / ramp.colors.len().max(1) as f64;
    for (i, color) in ramp.colors.iter().enumerate() {
        // A hair too wide, so that no ground shows between.
        let wide = if i + 1 < ramp.colors.len() { step + 0.5 } else { step };
        drawing.fill(Path::rect(Rect::new(bar.min + DVec2::new(i as f64 * step, 0.0), (wide, 12.0))), *color);
    }
    let beside = text.anchor(Align::Start, Level::Middle);
    drawing.text((corner.x, bar.center().y), ramp.low.as_str(), beside);
    drawing.text((bar.max.x + 8.0, bar.center().y), ramp.high.as_str(), beside);
}
