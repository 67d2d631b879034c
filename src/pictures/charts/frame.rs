//! What all charts share: the heading, the plot with its axes, marks.

use glam::DVec2;

use super::scale::{Axis, Ruler};
use crate::pictures::drawing::{Align, Dash, Drawing, Face, Level, Path, Pen, Rect, Text};
use crate::pictures::theme::{Mark, Theme};

/// The text sizes of charts.
pub(super) const TITLE: f64 = 17.0;
pub(super) const TEXT: f64 = 13.0;
pub(super) const SMALL: f64 = 12.0;

/// The room around a chart.
pub(super) const MARGIN: f64 = 24.0;

/// What stands above a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// What the chart shows, in a few words.
    pub title: String,
    /// How it was made or how to read it; may be empty. Broken into lines where it is too long.
    pub note: String,
}

/// A drawing of a size with a heading; returned with the y where what follows may begin.
pub(super) fn begin(width: f64, height: f64, heading: &Heading, theme: &Theme) -> (Drawing, f64) {
    let mut drawing = Drawing::new(width, height, theme.background, heading.title.clone());
    drawing.describe(heading.note.clone());
    let room = width - 2.0 * MARGIN;
    let title = Text::new(TITLE, theme.ink).face(Face::Bold);
    let note = Text::new(SMALL, theme.muted);
    let mut y = MARGIN - 6.0;
    for (text, words, leading) in [(title, &heading.title, 22.0), (note, &heading.note, 17.0)] {
        for line in wrap(words, &text, room) {
            y += leading;
            drawing.text((MARGIN, y - 5.0), line, text);
        }
    }
    (drawing, y + 6.0)
}

/// The height that [`begin`] takes for a heading.
pub(super) fn heading_height(width: f64, heading: &Heading, theme: &Theme) -> f64 {
    begin(width, 1000.0, heading, theme).1
}

/// `words` in lines that are at most so wide, broken at blanks.
pub fn wrap(words: &str, text: &Text, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text.width(format!("{line} {word}")) <= width => *line = format!("{line} {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The area of the data and its two rulers.
pub(super) struct Plot {
    pub(super) area: Rect,
    pub(super) x: Ruler,
    pub(super) y: Ruler,
}

impl Plot {
    /// Lays out axes in `room` and draws them. The name of the y axis stands above it, to be read without turning one's head.
    pub(super) fn draw(drawing: &mut Drawing, room: Rect, x: &Axis, y: &Axis, theme: &Theme) -> Self {
        let plot = Plot::without_x_ticks(drawing, room, x, y, theme);
        plot.x_ticks(drawing, x, theme);
        plot.axes(drawing, theme);
        plot
    }

    /// The same without what belongs to the x axis, and without the lines of the axes.
    pub(super) fn without_x_ticks(drawing: &mut Drawing, room: Rect, x: &Axis, y: &Axis, theme: &Theme) -> Self {
        let label = Text::new(SMALL, theme.muted);
        let title = if y.title.is_empty() { 4.0 } else { 26.0 };
        let (top, bottom) = (room.min.y + title, room.max.y - if x.title.is_empty() { 24.0 } else { 46.0 });
        let y_ruler = y.scale.between(bottom, top);
        let y_ticks = y_ruler.ticks(52.0);
        let widths = y_ticks.iter().filter_map(|tick| tick.label.clone()).map(|words| label.width(words));
        let left = room.min.x + widths.fold(0.0, f64::max) + 10.0;
        let area = Rect { min: DVec2::new(left, top), max: DVec2::new(room.max.x, bottom) };
        let x_ruler = x.scale.between(area.min.x, area.max.x);

        let (grid, axis) = (Pen::new(theme.grid, 1.0), Pen::new(theme.axis, 1.0));
        if let Some((from, to)) = y_ruler.zero_band() {
            let band = Rect { min: DVec2::new(area.min.x, to), max: DVec2::new(area.max.x, from) };
            drawing.fill(Path::rect(band), theme.panel);
            drawing.line((area.min.x, to), (area.max.x, to), axis.dashed(Dash::Dotted));
        }
        if let Some((from, to)) = x_ruler.zero_band() {
            let band = Rect { min: DVec2::new(from, area.min.y), max: DVec2::new(to, area.max.y) };
            drawing.fill(Path::rect(band), theme.panel);
            drawing.line((to, area.min.y), (to, area.max.y), axis.dashed(Dash::Dotted));
        }
        for tick in &y_ticks {
            if let Some(words) = &tick.label {
                drawing.line((area.min.x, tick.at), (area.max.x, tick.at), grid);
                drawing.text((area.min.x - 9.0, tick.at), words.clone(), label.anchor(Align::End, Level::Middle));
            }
            let length = if tick.label.is_some() { 5.0 } else { 3.0 };
            drawing.line((area.min.x - length, tick.at), (area.min.x, tick.at), axis);
        }
        let name = Text::new(TEXT, theme.ink);
        drawing.text((room.min.x, room.min.y + 12.0), y.title.as_str(), name);
        Plot { area, x: x_ruler, y: y_ruler }
    }

    /// The two lines of the axes, over what is behind the data.
    pub(super) fn axes(&self, drawing: &mut Drawing, theme: &Theme) {
        let Rect { min, max } = self.area;
        drawing.stroke(Path::open([min, DVec2::new(min.x, max.y), max]), Pen::new(theme.axis, 1.0));
    }

    fn x_ticks(&self, drawing: &mut Drawing, x: &Axis, theme: &Theme) {
        let (area, label) = (self.area, Text::new(SMALL, theme.muted));
        let (grid, axis) = (Pen::new(theme.grid, 1.0), Pen::new(theme.axis, 1.0));
        for tick in self.x.ticks(80.0) {
            if let Some(words) = tick.label {
                drawing.line((tick.at, area.min.y), (tick.at, area.max.y), grid);
                let below = label.anchor(Align::Middle, Level::Top);
                drawing.text((tick.at, area.max.y + 10.0), words.clone(), below);
                drawing.line((tick.at, area.max.y), (tick.at, area.max.y + 5.0), axis);
            } else {
                drawing.line((tick.at, area.max.y), (tick.at, area.max.y + 3.0), axis);
            }
        }
        let below = Text::new(TEXT, theme.ink).anchor(Align::End, Level::Top);
        drawing.text((area.max.x, area.max.y + 30.0), x.title.as_str(), below);
    }

    /// Where a pair of values lies.
    pub(super) fn at(&self, x: f64, y: f64) -> DVec2 {
        DVec2::new(self.x.at(x), self.y.at(y))
    }
}

/// Draws a mark, about `2 radius` across, with a rim of the ground so that it stands out from what is behind it.
pub(super) fn draw_mark(drawing: &mut Drawing, mark: Mark, at: DVec2, radius: f64, color: super::Color, theme: &Theme) {
    let around = |points: &[(f64, f64)], r: f64| {
        Path::polygon(points.iter().map(|(x, y)| at + r * DVec2::new(*x, *y)).collect::<Vec<_>>())
    };
    let shape = match mark {
        Mark::Disk | Mark::Ring => Path::circle(at, radius),
        Mark::Square => around(&[(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)], radius),
        Mark::Triangle => around(&[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)], radius),
        Mark::Diamond => around(&[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)], radius),
        Mark::Cross => {
            let (a, b) = (DVec2::splat(0.8 * radius), DVec2::new(0.8, -0.8) * radius);
            Path::line(at - a, at + a).and(Path::line(at - b, at + b))
        }
    };
    match mark {
        Mark::Cross => {
            drawing.stroke(shape.clone(), Pen::new(theme.background, 5.0));
            drawing.stroke(shape, Pen::new(color, 2.4));
        }
        Mark::Ring => {
            drawing.fill(shape.clone(), theme.background);
            drawing.stroke(shape, Pen::new(color, 2.2));
        }
        _ => {
            drawing.stroke(shape.clone(), Pen::new(theme.background, 2.5));
            drawing.fill(shape, color);
        }
    }
}

/// The room that a mark takes.
pub(super) fn mark_room(at: DVec2, radius: f64) -> Rect {
    Rect { min: at, max: at }.grown(radius * 1.25)
}
