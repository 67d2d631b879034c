//! One drawing code, two outputs: a [`Drawing`] is a list of paths, texts and rasters, made by plain calls, and comes out as PNG
//! or as SVG.
//!
//! Coordinates are user units (pixels of the PNG at scale 1), x to the right, y down. They have to be finite and at most
//! 10^5 in magnitude. A call with others draws nothing, and makes [`Drawing::to_png`] and [`Drawing::to_svg`] answer with
//! [`Unfit`], so that a NaN is never part of an output and the calls need no `Result`. The same holds for a formula that is not
//! TeX.

mod canvas;
mod fonts;
mod formulas;
mod item;
mod marks;
mod maths;
mod path;
mod pen;
mod place;
mod rect;
mod svg;
mod text;

use glam::DVec2;

use item::Item;

pub use fonts::Face;
pub use formulas::Formulas;
pub use item::{Raster, Sampling};
pub use marks::{MOST_HATCHES, angle_of};
pub use path::{Path, Segment};
pub use pen::{Color, Dash, Pen};
pub use place::{Placement, Wanted, around, cover};
pub use rect::Rect;
#[cfg(any(feature = "accuracy", feature = "cli"))]
pub(crate) use svg::escape;
pub use text::{Align, Level, Text, Words};

/// A picture as a list of what was drawn, and where its labels are.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    size: DVec2,
    title: String,
    description: String,
    background: Color,
    items: Vec<Item>,
    labels: Vec<Label>,
    unfit: Option<Unfit>,
}

/// A text in a drawing and the rectangle around its ink.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What it says.
    pub text: String,
    /// Where its ink is.
    pub rect: Rect,
}

/// Why a drawing has no picture: a call was given what cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unfit {
    /// The drawing's title.
    pub title: String,
    /// The call.
    pub call: &'static str,
    /// What it was given.
    pub given: String,
}

impl std::fmt::Display for Unfit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Unfit { title, call, given } = self;
        write!(f, "the drawing \"{title}\" has no picture: `{call}` was given {given}")
    }
}

impl std::error::Error for Unfit {}

impl Drawing {
    /// An empty drawing. `title` names it in a few words, for `<title>`; [`Drawing::describe`] says more.
    pub fn new(width: f64, height: f64, background: Color, title: impl Into<String>) -> Self {
        let mut drawing = Drawing {
            size: DVec2::ONE,
            title: title.into(),
            description: String::new(),
            background,
            items: Vec::new(),
            labels: Vec::new(),
            unfit: None,
        };
        match [width, height].into_iter().find(|side| !(1.0 <= *side && *side <= item::LARGEST)) {
            Some(side) => drawing.refuse("new", format!("the side {side}")),
            None => drawing.size = DVec2::new(width, height),
        }
        drawing
    }

    /// Sets what `<desc>` says: what one would tell a listener who does not see the picture.
    pub fn describe(&mut self, description: impl Into<String>) {
        self.description = description.into();
    }

    /// Its title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Its description.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// The canvas.
    pub fn canvas(&self) -> Rect {
        Rect { min: DVec2::ZERO, max: self.size }
    }

    /// Its labels, in the order they were drawn.
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// Fills a path, by the nonzero winding rule.
    pub fn fill(&mut self, path: Path, color: Color) {
        self.push("fill", Item::Fill { path, color });
    }

    /// Draws a line along a path.
    pub fn stroke(&mut self, path: Path, pen: Pen) {
        self.push("stroke", Item::Stroke { path, pen });
    }

    /// Draws a straight line.
    pub fn line(&mut self, a: impl Into<DVec2>, b: impl Into<DVec2>, pen: Pen) {
        self.push("line", Item::Stroke { path: Path::line(a, b), pen });
    }

    /// Fills a circle.
    pub fn disk(&mut self, center: impl Into<DVec2>, radius: f64, color: Color) {
        self.push("disk", Item::Fill { path: Path::circle(center, radius), color });
    }

    /// Writes a line of text, which becomes a label. Returns the rectangle around its ink.
    pub fn text(&mut self, anchor: impl Into<DVec2>, words: impl Into<Words>, text: Text) -> Option<Rect> {
        let (anchor, words) = (anchor.into(), words.into());
        let run = text.set(&words);
        let offset = text.offset(run.advance);
        let origin = anchor + text.along * offset.x + text.along.perp() * offset.y;
        let rect = text.ink(anchor, words.clone());
        if let Some(reason) = run.refused {
            self.refuse("text", reason);
            return None;
        }
        let (along, color) = (text.along, text.color);
        let (glyphs, pieces) = (run.glyphs, run.pieces);
        let item = Item::Glyphs { glyphs, pieces, origin, along, color, text: words.to_string() };
        if self.push("text", item)
            && let Some(rect) = rect
        {
            self.labels.push(Label { text: words.to_string(), rect });
        }
        rect
    }

    /// Stretches a raster over a rectangle.
    ///
    /// # Panics
    /// Where the raster has not four samples a pixel.
    pub fn image(&mut self, raster: Raster, rect: Rect, sampling: Sampling) {
        assert_eq!(raster.rgba.len(), 4 * raster.width as usize * raster.height as usize, "four samples a pixel");
        self.push("image", Item::Image { raster, rect, sampling });
    }

    /// Draws what `draw` draws, cut to the inside of `clip`. Labels are not cut: a label that is only partly seen still
    /// counts with all of its rectangle.
    pub fn clipped(&mut self, clip: Path, draw: impl FnOnce(&mut Drawing)) {
        let before = self.items.len();
        draw(self);
        let items = self.items.split_off(before);
        self.push("clipped", Item::Group { clip: Some(clip), offset: DVec2::ZERO, scale: 1.0, items });
    }

    /// Draws what `draw` draws, as what shows one node of a ray tree: in SVG a group with `data-node="PATH"`, which a page can
    /// hide until that ray is traced. A PNG looks the same with and without.
    pub fn about(&mut self, node: &str, draw: impl FnOnce(&mut Drawing)) {
        let before = self.items.len();
        draw(self);
        let items = self.items.split_off(before);
        if !items.is_empty() {
            self.push("about", Item::About { node: node.to_owned(), items });
        }
    }

    /// Draws another drawing, its upper left corner at `corner`, `scale` times as large, cut to its canvas. Its background is
    /// not drawn; its labels become labels of this one.
    pub fn place(&mut self, other: &Drawing, corner: impl Into<DVec2>, scale: f64) {
        let offset = corner.into();
        self.unfit = self.unfit.take().or_else(|| other.unfit.clone());
        let to = |r: Rect| Rect { min: offset + scale * r.min, max: offset + scale * r.max };
        let group =
            Item::Group { clip: Some(Path::rect(to(other.canvas()))), offset, scale, items: other.items.clone() };
        if self.push("place", group) {
            self.labels.extend(other.labels.iter().map(|l| Label { text: l.text.clone(), rect: to(l.rect) }));
        }
    }

    /// The PNG file, `scale` pixels a user unit.
    ///
    /// # Errors
    /// Where a call was given what cannot be drawn, or the picture would be empty or have more than 16384 pixels a
    /// side.
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>, Unfit> {
        self.fit()?;
        canvas::png(self, scale).ok_or_else(|| self.unfit("to_png", format!("the scale {scale}")))
    }

    /// The picture as a raster, `scale` pixels a user unit.
    ///
    /// # Errors
    /// Those of [`Drawing::to_png`].
    pub fn to_raster(&self, scale: f64) -> Result<Raster, Unfit> {
        self.fit()?;
        canvas::raster(self, scale).ok_or_else(|| self.unfit("to_raster", format!("the scale {scale}")))
    }

    /// The SVG file: text as outlines, rasters as PNG inside, nothing from elsewhere. Several may stand in one page: what
    /// they name the same is the same.
    ///
    /// # Errors
    /// Where a call was given what cannot be drawn.
    pub fn to_svg(&self) -> Result<String, Unfit> {
        self.fit()?;
        Ok(svg::write(self))
    }

    fn fit(&self) -> Result<(), Unfit> {
        self.unfit.clone().map_or(Ok(()), Err)
    }

    fn unfit(&self, call: &'static str, given: String) -> Unfit {
        Unfit { title: self.title.clone(), call, given }
    }

    fn refuse(&mut self, call: &'static str, given: String) {
        let unfit = self.unfit(call, given);
        self.unfit.get_or_insert(unfit);
    }

    /// Keeps an item whose numbers are fit, and says whether they were.
    fn push(&mut self, call: &'static str, item: Item) -> bool {
        match item.unfit_number() {
            Some(number) => self.refuse(call, format!("the coordinate {number}")),
            None => self.items.push(item),
        }
        self.unfit.is_none()
    }
}
