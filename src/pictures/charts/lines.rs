//! Lines with marks, each named where it ends.

use glam::DVec2;

use super::frame::{self, Heading, MARGIN, Plot};
use super::scale::Axis;
use crate::pictures::drawing::{Align, Color, Dash, Drawing, Level, Path, Pen, Rect, Text};
use crate::pictures::theme::{Mark, Theme};

/// A chart of lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// What stands above.
    pub heading: Heading,
    /// The axis across.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// The lines.
    pub lines: Vec<Line>,
}

/// One of [`Lines`].
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name, written at its end.
    pub name: String,
    /// Its colour.
    pub color: Color,
    /// Its dash pattern.
    pub dash: Dash,
    /// The mark of its points.
    pub mark: Mark,
    /// Its points in order: x and y.
    pub points: Vec<(f64, f64)>,
}

const SPACING: f64 = 19.0;

/// Draws [`Lines`], 860 by 480.
pub fn lines(chart: &Lines, theme: &Theme) -> Drawing {
    let (width, height) = (860.0, 480.0);
    let (mut drawing, top) = frame::begin(width, height, &chart.heading, theme);
    let name = Text::new(frame::TEXT, theme.ink).anchor(Align::Start, Level::Middle);
    let names = chart.lines.iter().map(|line| name.width(line.name.as_str())).fold(0.0, f64::max);
    let right = width - MARGIN - names - 26.0;
    let room = Rect { min: DVec2::new(MARGIN, top + 8.0), max: DVec2::new(right, height - 10.0) };
    let plot = Plot::draw(&mut drawing, room, &chart.x, &chart.y, theme);

    let mut ends = Vec::new();
    for line in &chart.lines {
        let points: Vec<DVec2> = line.points.iter().map(|(x, y)| plot.at(*x, *y)).collect();
        drawing.stroke(Path::open(points.iter().copied()), Pen::new(line.color, 2.0).dashed(line.dash));
        for at in &points {
            frame::draw_mark(&mut drawing, line.mark, *at, 4.0, line.color, theme);
        }
        ends.extend(points.last().map(|end| (*end, line)));
    }
    // Names from the top, pushed apart, and back up where they would leave the plot.
    ends.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
    let mut heights: Vec<f64> = ends.iter().map(|(end, _)| end.y).collect();
    for i in 1..heights.len() {
        heights[i] = heights[i].max(heights[i - 1] + SPACING);
    }
    let mut limit = plot.area.max.y;
    for y in heights.iter_mut().rev() {
        *y = y.min(limit);
        limit = *y - SPACING;
    }
    for ((end, line), y) in ends.iter().zip(heights) {
        let at = DVec2::new(plot.area.max.x + 22.0, y);
        let bend = DVec2::new(plot.area.max.x + 6.0, end.y);
        let pen = Pen::new(line.color, 1.0);
        if plot.area.max.x - end.x < 40.0 {
            drawing.stroke(Path::open([*end, bend, at - DVec2::new(4.0, 0.0)]), pen.dashed(Dash::Solid));
        } else {
            drawing.line(*end, at - DVec2::new(4.0, 0.0), pen.dashed(Dash::Dotted));
        }
        drawing.text(at, line.name.as_str(), name.color(line.color));
    }
    drawing
}
