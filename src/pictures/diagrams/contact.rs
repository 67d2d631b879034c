//! Many diagrams on one sheet.

use glam::DVec2;

use crate::pictures::drawing::{Drawing, Face, Path, Pen, Rect, Text};
use crate::pictures::theme::Theme;

/// Diagrams made small, a row of them below the other, each at most `width` wide.
pub fn contact_sheet(title: &str, rows: &[Vec<Drawing>], width: f64, theme: &Theme) -> Drawing {
    const GAP: f64 = 12.0;
    const HEAD: f64 = 44.0;
    let scale = |drawing: &Drawing| (width / drawing.canvas().size().x).min(1.0);
    let height = |row: &Vec<Drawing>| row.iter().map(|d| scale(d) * d.canvas().size().y).fold(0.0, f64::max);
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0).max(1);
    let across = GAP + columns as f64 * (width + GAP);
    let down = HEAD + rows.iter().map(|row| height(row) + GAP).sum::<f64>();
    let mut sheet = Drawing::new(across, down, theme.panel, title);
    sheet.text((GAP, 28.0), title, Text::new(17.0, theme.ink).face(Face::Bold));
    let mut y = HEAD;
    for row in rows {
        for (column, drawing) in row.iter().enumerate() {
            let corner = DVec2::new(GAP + column as f64 * (width + GAP), y);
            let card = Rect::new(corner, drawing.canvas().size() * scale(drawing));
            sheet.fill(Path::rect(card), theme.background);
            sheet.place(drawing, corner, scale(drawing));
            sheet.stroke(Path::rect(card), Pen::new(theme.grid, 1.0));
        }
        y += height(row) + GAP;
    }
    sheet
}
