//! What a drawing is a list of.

use glam::DVec2;

use super::path::{Path, Segment};
use super::pen::{Color, Pen};
use super::rect::Rect;
use super::text::Placed;

/// A picture made of pixels: sRGB with opacity, 8 bits each, not premultiplied, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `4 * width * height` samples.
    pub rgba: Vec<u8>,
}

impl Raster {
    /// The raster whose pixel in column x and row y is `color(x, y)`.
    pub fn from_fn(width: u32, height: u32, mut color: impl FnMut(u32, u32) -> Color) -> Self {
        let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
        for y in 0..height {
            for x in 0..width {
                let Color { r, g, b, a } = color(x, y);
                rgba.extend([r, g, b, a]);
            }
        }
        Raster { width, height, rgba }
    }
}

/// How a raster is enlarged or made smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// Each pixel a sharp rectangle.
    Nearest,
    /// Blended between pixels.
    Smooth,
}

/// One thing that was drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    /// The inside of a path, by the nonzero winding rule.
    Fill { path: Path, color: Color },
    /// A line along a path.
    Stroke { path: Path, pen: Pen },
    /// A line of text with the fraction bars and roots of its formulas, from `origin` along the unit vector `along`.
    Glyphs { glyphs: Vec<Placed>, pieces: Vec<Path>, origin: DVec2, along: DVec2, color: Color, text: String },
    /// A raster stretched over a rectangle.
    Image { raster: Raster, rect: Rect, sampling: Sampling },
    /// Items that are scaled, then moved, then cut to a path in the frame around the group.
    Group { clip: Option<Path>, offset: DVec2, scale: f64, items: Vec<Item> },
    /// Items that show the node of a ray tree at this path.
    About { node: String, items: Vec<Item> },
}

impl Item {
    /// Every number of the item that ends up in a picture; those of a group's items were looked at before.
    fn numbers(&self) -> Vec<f64> {
        fn of(path: &Path) -> Vec<f64> {
            path.segments.iter().flat_map(Segment::points).flat_map(|p| p.to_array()).collect()
        }
        match self {
            Self::Fill { path, .. } => of(path),
            Self::Stroke { path, pen } => {
                let mut numbers: Vec<f64> = of(path);
                numbers.push(pen.width);
                numbers
            }
            Self::Glyphs { glyphs, pieces, origin, along, .. } => {
                let glyphs = glyphs.iter().flat_map(|g| [g.at.x, g.at.y, g.size]);
                glyphs.chain(pieces.iter().flat_map(of)).chain(origin.to_array()).chain(along.to_array()).collect()
            }
            Self::Image { rect, .. } => [rect.min.to_array(), rect.max.to_array()].concat(),
            Self::Group { clip, offset, scale, .. } => {
                let mut numbers: Vec<f64> = clip.as_ref().map(of).unwrap_or_default();
                numbers.extend([offset.x, offset.y, *scale]);
                numbers
            }
            Self::About { .. } => Vec::new(),
        }
    }

    /// The first number that cannot be drawn. This is the one place where NaN, infinities and absurdly far points are
    /// turned away: [`Drawing`](super::Drawing) does not keep such an item, and its outputs are errors from then on.
    pub(super) fn unfit_number(&self) -> Option<f64> {
        self.numbers().into_iter().find(|x| !(x.abs() <= LARGEST))
    }
}

/// Coordinates are at most this in magnitude: far beyond any page, and still a hundredth of a unit in f32.
pub(super) const LARGEST: f64 = 100_000.0;
