//! Formulas, written in TeX: laid out by `ratex`, drawn with the fonts of KaTeX.

use glam::DVec2;
use ratex_layout::{LayoutOptions, layout, to_display_list};
use ratex_types::display_item::DisplayItem;
use ratex_types::math_style::MathStyle;
use ratex_types::path_command::PathCommand;

use super::fonts::{Face, GlyphRef};
use super::path::{Path, Segment};
use super::rect::Rect;
use super::text::{Placed, Run};

/// How much larger than the text beside it a formula is set. Its lower-case letters would be as high at 0.516 / 0.431 = 1.20,
/// its capitals and digits at 0.698 / 0.683 = 1.02: in between.
const SIZE: f64 = 1.11;

/// Adds a formula to a line where the line ends, and moves its end behind it.
///
/// # Errors
/// What is wrong with the TeX, or which part of it cannot be drawn: a character that none of the fonts has, `\boxed`,
/// `\cancel`.
pub(super) fn set(tex: &str, style: Style, size: f64, run: &mut Run) -> Result<(), String> {
    let em = SIZE * size;
    let nodes = ratex_parser::parser::parse(tex).map_err(|error| format!("the formula {tex}: {error}"))?;
    let style = match style {
        Style::Inline => MathStyle::Text,
        Style::Display => MathStyle::Display,
    };
    let list = to_display_list(&layout(&nodes, &LayoutOptions { style, ..LayoutOptions::default() }));
    // From the upper left corner of the formula to the line it stands on.
    let start = DVec2::new(run.advance, -em * list.height);
    let at = |x: f64, y: f64| start + em * DVec2::new(x, y);
    for item in list.items {
        match item {
            DisplayItem::GlyphPath { x, y, scale, font, char_code, .. } => {
                let glyph = glyph(&font, char_code).ok_or_else(|| missing(tex, &font, char_code))?;
                run.push(Placed { glyph, at: at(x, y), size: em * scale });
            }
            DisplayItem::Line { x, y, width, thickness, dashed: false, .. } => {
                let rect = Rect::new(at(x, y - thickness / 2.0), em * DVec2::new(width, thickness));
                run.push_piece(Path::rect(rect));
            }
            DisplayItem::Path { x, y, commands, fill: true, .. } => {
                let segment = |command: &PathCommand| match *command {
                    PathCommand::MoveTo { x, y } => Segment::Move(DVec2::new(x, y)),
                    PathCommand::LineTo { x, y } => Segment::Line(DVec2::new(x, y)),
                    PathCommand::QuadTo { x1, y1, x, y } => Segment::Quad(DVec2::new(x1, y1), DVec2::new(x, y)),
                    PathCommand::CubicTo { x1, y1, x2, y2, x, y } => {
                        Segment::Cubic(DVec2::new(x1, y1), DVec2::new(x2, y2), DVec2::new(x, y))
                    }
                    PathCommand::Close => Segment::Close,
                };
                let path = Path { segments: commands.iter().map(segment).collect() };
                run.push_piece(path.map(|p| at(x + p.x, y + p.y)));
            }
            other => return Err(format!("the formula {tex}: nothing here draws {other:?}")),
        }
    }
    run.advance += em * list.width;
    Ok(())
}

/// How a formula is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    /// For a line of text: fractions are small.
    Inline,
    /// For a line of its own.
    Display,
}

fn missing(tex: &str, font: &str, char_code: u32) -> String {
    format!("the formula {tex}: {font} has no glyph U+{char_code:04X}")
}

fn glyph(font: &str, char_code: u32) -> Option<GlyphRef> {
    let face = match font {
        "Main-Regular" => Face::MathMain,
        "Main-Bold" => Face::MathBold,
        "Math-Italic" => Face::MathItalic,
        "Math-BoldItalic" => Face::MathBoldItalic,
        "Size1-Regular" => Face::MathSize1,
        "Size2-Regular" => Face::MathSize2,
        "Size3-Regular" => Face::MathSize3,
        "Size4-Regular" => Face::MathSize4,
        _ => return None,
    };
    face.own_glyph(char::from_u32(char_code)?)
}
