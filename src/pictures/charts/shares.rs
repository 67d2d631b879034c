//! Horizontal bars of shares that add up to one, with the figures beside them.

use glam::DVec2;

use super::frame::{self, Heading, MARGIN};
use super::scale::plain;
use crate::pictures::drawing::{Align, Color, Drawing, Face, Level, Path, Pen, Rect, Text};
use crate::pictures::theme::Theme;

/// Bars that are divided alike.
#[derive(Clone, Debug, PartialEq)]
pub struct Shares {
    /// What stands above.
    pub heading: Heading,
    /// What the bars are divided into, from left to right.
    pub parts: Vec<Part>,
    /// The bars, from the top.
    pub rows: Vec<ShareRow>,
}

/// A part of every bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its colour.
    pub color: Color,
}

/// A bar.
#[derive(Clone, Debug, PartialEq)]
pub struct ShareRow {
    /// Its name.
    pub name: String,
    /// The share of each part, from 0 to 1.
    pub shares: Vec<f64>,
}

const ROW: f64 = 26.0;
/// The least room between columns of figures.
const BETWEEN: f64 = 24.0;

/// Draws [`Shares`], 900 wide. The heads of the columns of figures are the key to the colours.
pub fn shares(chart: &Shares, theme: &Theme) -> Drawing {
    let width = 900.0;
    let top = frame::heading_height(width, &chart.heading, theme) + 8.0;
    let height = top + 30.0 + chart.rows.len() as f64 * ROW + MARGIN;
    let (mut drawing, _) = frame::begin(width, height, &chart.heading, theme);
    let name = Text::new(frame::TEXT, theme.ink).anchor(Align::Start, Level::Middle);
    let names = chart.rows.iter().map(|row| name.width(row.name.as_str())).fold(0.0, f64::max);
    let left = MARGIN + names + 16.0;
    let head = Text::new(frame::SMALL, theme.ink).face(Face::Bold).anchor(Align::End, Level::Middle);
    // The right ends of the columns, from the last.
    let mut ends = vec![width - MARGIN];
    for part in chart.parts.iter().rev() {
        ends.push(ends[ends.len() - 1] - head.width(part.name.as_str()).max(58.0) - 17.0 - BETWEEN);
    }
    ends.reverse();
    let bars = ends[0] - left;
    for (part, right) in chart.parts.iter().zip(&ends[1..]) {
        let right = *right;
        let text = drawing.text((right, top + 12.0), part.name.as_str(), head);
        if let Some(text) = text {
            let swatch = Rect::new((text.min.x - 17.0, top + 6.0), (12.0, 12.0));
            drawing.fill(Path::rounded(swatch, 2.0), part.color);
        }
    }
    for (i, row) in chart.rows.iter().enumerate() {
        let middle = top + 30.0 + (i as f64 + 0.5) * ROW;
        if i > 0 {
            let y = middle - ROW / 2.0;
            drawing.line((MARGIN, y), (width - MARGIN, y), Pen::new(theme.grid, 1.0));
        }
        drawing.text((MARGIN, middle), row.name.as_str(), name);
        let mut from = 0.0;
        for (k, (share, part)) in row.shares.iter().zip(&chart.parts).enumerate() {
            let share = share.clamp(0.0, 1.0);
            let a = DVec2::new(left + bars * from, middle - 7.5);
            drawing.fill(Path::rect(Rect::new(a, (bars * share, 15.0))), part.color);
            from += share;
            let color = if share > 0.0 { theme.ink } else { theme.axis };
            let figure = Text::new(frame::SMALL, color).anchor(Align::End, Level::Middle);
            drawing.text((ends[k + 1], middle), percent(share), figure);
        }
    }
    drawing
}

/// A share in percent: exactly 0 and 100 without decimals, and never rounded to them.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent {
        0.0 => "0".to_owned(),
        100.0 => "100 %".to_owned(),
        p if p < 0.001 => "< 0.001 %".to_owned(),
        p if !(0.1..=99.9).contains(&p) => format!("{} %", plain(p.min(99.999), 3).trim_end_matches('0')),
        p => format!("{} %", plain(p, 1)),
    }
}
