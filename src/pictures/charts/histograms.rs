//! Small multiples of histograms with logarithmic counts.

use glam::DVec2;

use super::frame::{self, Heading, MARGIN, Plot};
use super::scale::{Axis, Scale};
use crate::pictures::drawing::{Align, Color, Drawing, Face, Level, Path, Rect, Text, Words};
use crate::pictures::theme::Theme;

/// Several histograms over the same bins, on the same scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Histograms {
    /// What stands above.
    pub heading: Heading,
    /// What the bins are of, with the unit.
    pub bins_title: String,
    /// What the bins are called. Where there is no room for all, some are left out.
    pub bins: Vec<Words>,
    /// What is counted.
    pub counts_title: String,
    /// The histograms.
    pub series: Vec<Histogram>,
    /// How many stand side by side.
    pub columns: usize,
}

/// One of [`Histograms`].
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// Its name.
    pub name: String,
    /// What it amounts to, in a few words; may be empty.
    pub note: String,
    /// The colour of its bars.
    pub color: Color,
    /// The counts, one a bin.
    pub counts: Vec<u64>,
}

const PANEL: DVec2 = DVec2::new(270.0, 176.0);
const GAP: DVec2 = DVec2::new(26.0, 18.0);

/// Draws [`Histograms`], 270 by 176 each.
pub fn histograms(chart: &Histograms, theme: &Theme) -> Drawing {
    let columns = chart.columns.clamp(1, chart.series.len().max(1));
    let rows = chart.series.len().div_ceil(columns);
    let width = 2.0 * MARGIN + columns as f64 * (PANEL.x + GAP.x) - GAP.x;
    let top = frame::heading_height(width, &chart.heading, theme) + 30.0;
    let height = top + rows as f64 * (PANEL.y + GAP.y) - GAP.y + 18.0 + MARGIN;
    let (mut drawing, _) = frame::begin(width, height, &chart.heading, theme);
    let name = Text::new(frame::TEXT, theme.ink);
    drawing.text((MARGIN, top - 12.0), chart.counts_title.as_str(), name);
    let below = name.anchor(Align::End, Level::Baseline);
    drawing.text((width - MARGIN, height - MARGIN + 4.0), chart.bins_title.as_str(), below);

    let most = chart.series.iter().flat_map(|s| &s.counts).max().copied().unwrap_or(1).max(10);
    // A single count has to be seen: the scale begins below one.
    let y = Axis { title: String::new(), scale: Scale::Log(0.6, most as f64 * 1.4) };
    for (i, series) in chart.series.iter().enumerate() {
        let cell = DVec2::new((i % columns) as f64, (i / columns) as f64);
        let corner = DVec2::new(MARGIN, top) + cell * (PANEL + GAP);
        panel(&mut drawing, Rect::new(corner, PANEL), series, &chart.bins, &y, theme);
    }
    drawing
}

fn panel(drawing: &mut Drawing, room: Rect, series: &Histogram, bins: &[Words], y: &Axis, theme: &Theme) {
    let title = Text::new(frame::TEXT, theme.ink).face(Face::Bold);
    let note = Text::new(frame::SMALL, theme.muted).anchor(Align::End, Level::Baseline);
    drawing.text(room.min + DVec2::new(0.0, 12.0), series.name.as_str(), title);
    drawing.text((room.max.x, room.min.y + 12.0), series.note.as_str(), note);
    let below = Rect { min: room.min + DVec2::new(0.0, 20.0), max: room.max };
    let no_ticks = Axis { title: String::new(), scale: Scale::Linear(0.0, bins.len() as f64) };
    let plot = Plot::without_x_ticks(drawing, below, &no_ticks, y, theme);
    let bottom = plot.area.max.y;
    for (i, count) in series.counts.iter().enumerate().filter(|(_, count)| **count > 0) {
        let (left, right) = (plot.x.at(i as f64), plot.x.at((i + 1) as f64));
        let bar = Rect { min: DVec2::new(left + 1.5, plot.y.at(*count as f64)), max: DVec2::new(right - 1.5, bottom) };
        drawing.fill(Path::rect(bar), series.color);
    }
    plot.axes(drawing, theme);
    let text = Text::new(frame::SMALL - 1.0, theme.muted).anchor(Align::Middle, Level::Top);
    let mut taken: Vec<Rect> = Vec::new();
    // The first and the last bin name the range; the others come in as far as there is room.
    let last = bins.len().saturating_sub(1);
    for i in [0, last].into_iter().chain(1..last.max(1)) {
        let at = DVec2::new(plot.x.at(i as f64 + 0.5), bottom + 7.0);
        let Some(words) = bins.get(i) else { continue };
        let Some(ink) = text.ink(at, words.clone()) else { continue };
        if taken.iter().all(|rect| !rect.overlaps(ink.grown(7.0))) {
            taken.push(ink);
            drawing.text(at, words.clone(), text);
        }
    }
}
