//! Lines of text: how they look, where they go, how much room they take.

use glam::DVec2;

use super::fonts::{Face, GlyphRef};
use super::maths;
use super::path::Path;
use super::pen::Color;
use super::rect::Rect;

/// Where a text stands beside its anchor, along the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    /// It begins at the anchor.
    #[default]
    Start,
    /// Its middle is at the anchor.
    Middle,
    /// It ends at the anchor.
    End,
}

/// Where a text stands beside its anchor, across the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Level {
    /// It stands on the anchor.
    #[default]
    Baseline,
    /// The middle of its capitals is at the anchor.
    Middle,
    /// Its capitals hang from the anchor.
    Top,
}

/// The look of a text, and how it is anchored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Text {
    /// The font.
    pub face: Face,
    /// The em in user units.
    pub size: f64,
    /// The colour.
    pub color: Color,
    /// Where it stands along the line.
    pub align: Align,
    /// Where it stands across the line.
    pub level: Level,
    /// The direction of the line, of unit length: `DVec2::X` to read as usual, `-DVec2::Y` to read upwards.
    pub along: DVec2,
}

impl Text {
    /// Labels in the sans serif, from the anchor to the right.
    pub fn new(size: f64, color: Color) -> Self {
        Text { face: Face::Sans, size, color, align: Align::Start, level: Level::Baseline, along: DVec2::X }
    }

    /// The same in another font.
    pub fn face(self, face: Face) -> Self {
        Text { face, ..self }
    }

    /// The same, anchored otherwise.
    pub fn anchor(self, align: Align, level: Level) -> Self {
        Text { align, level, ..self }
    }

    /// The same, reading upwards.
    pub fn upwards(self) -> Self {
        Text { along: DVec2::NEG_Y, ..self }
    }

    /// The same in another colour.
    pub fn color(self, color: Color) -> Self {
        Text { color, ..self }
    }

    /// How far the pen moves on over `words`.
    pub fn width(&self, words: impl Into<Words>) -> f64 {
        self.set(&words.into()).advance
    }

    /// Where `words` would put ink with this anchor; nothing if they have none.
    pub fn ink(&self, anchor: impl Into<DVec2>, words: impl Into<Words>) -> Option<Rect> {
        let run = self.set(&words.into());
        Some(self.frame(&run)?.at(self, anchor.into()))
    }

    /// The height of capitals.
    pub fn cap_height(&self) -> f64 {
        CAP_HEIGHT * self.size
    }

    /// What is needed to know where `run` has its ink with any anchor.
    pub(super) fn frame(&self, run: &Run) -> Option<Frame> {
        let turned = |p: DVec2| self.along * p.x + self.along.perp() * p.y;
        Some(Frame { advance: run.advance, ink: Rect::around(run.ink?.corners().map(turned))? })
    }

    /// From the anchor to where the baseline of a line that is `advance` long begins, in the frame of the line.
    pub(super) fn offset(&self, advance: f64) -> DVec2 {
        let x = match self.align {
            Align::Start => 0.0,
            Align::Middle => -advance / 2.0,
            Align::End => -advance,
        };
        let y = match self.level {
            Level::Baseline => 0.0,
            Level::Middle => self.cap_height() / 2.0,
            Level::Top => self.cap_height(),
        };
        DVec2::new(x, y)
    }

    /// The glyphs of `words` with their pen positions.
    pub(super) fn set(&self, words: &Words) -> Run {
        let mut run = Run::default();
        for span in &words.spans {
            let (share, shift) = match span.rise {
                Rise::Level => (1.0, 0.0),
                Rise::Raised => (SCRIPT, -RAISED),
                Rise::Lowered => (SCRIPT, LOWERED),
                Rise::Formula(style) => {
                    if let Err(reason) = maths::set(&span.text, style, self.size, &mut run) {
                        run.refused.get_or_insert(reason);
                    }
                    continue;
                }
            };
            let size = share * self.size;
            let mut before: Option<GlyphRef> = None;
            for glyph in span.text.chars().map(|c| span.face.unwrap_or(self.face).glyph(c)) {
                if let Some(before) = before {
                    run.advance += size * before.kerning(glyph);
                }
                run.push(Placed { glyph, at: DVec2::new(run.advance, shift * self.size), size });
                run.advance += size * glyph.advance();
                before = Some(glyph);
            }
        }
        run
    }
}

/// The room of a line that has been set, to be moved about without setting it again.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    advance: f64,
    /// With the baseline beginning at the origin.
    ink: Rect,
}

impl Frame {
    /// Where the ink is with the anchoring of `text` at `anchor`.
    pub(super) fn at(&self, text: &Text, anchor: DVec2) -> Rect {
        let offset = text.offset(self.advance);
        self.ink.moved(anchor + text.along * offset.x + text.along.perp() * offset.y)
    }
}

/// The height of capitals in ems, the same in all three faces of IBM Plex.
const CAP_HEIGHT: f64 = 0.698;
/// The size of raised and lowered text, and how far it is moved, in ems.
const SCRIPT: f64 = 0.72;
const RAISED: f64 = 0.36;
const LOWERED: f64 = 0.16;

/// How a part of a text stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rise {
    Level,
    Raised,
    Lowered,
    Formula(maths::Style),
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Span {
    text: String,
    rise: Rise,
    face: Option<Face>,
}

/// A line of text, parts of which may be raised, lowered, in another font, or formulas.
///
/// # Example
/// `Words::from("10").raised("−3")` is a power of ten, and reads `10^−3`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Words {
    spans: Vec<Span>,
}

impl Words {
    fn and(mut self, text: &str, rise: Rise, face: Option<Face>) -> Self {
        self.spans.push(Span { text: text.to_owned(), rise, face });
        self
    }

    /// Followed by `text` on the line.
    pub fn then(self, text: &str) -> Self {
        self.and(text, Rise::Level, None)
    }

    /// Followed by `text` in `face`, whatever the font of the rest.
    pub fn then_in(self, face: Face, text: &str) -> Self {
        self.and(text, Rise::Level, Some(face))
    }

    /// Followed by a superscript.
    pub fn raised(self, text: &str) -> Self {
        self.and(text, Rise::Raised, None)
    }

    /// Followed by a formula in TeX, set to fit into a line. One that cannot be set makes the drawing unfit.
    pub fn tex(self, tex: &str) -> Self {
        self.and(tex, Rise::Formula(maths::Style::Inline), None)
    }

    /// Followed by a formula in TeX, set as on a line of its own: fractions are large.
    pub fn display_tex(self, tex: &str) -> Self {
        self.and(tex, Rise::Formula(maths::Style::Display), None)
    }

    /// Followed by a subscript.
    pub fn lowered(self, text: &str) -> Self {
        self.and(text, Rise::Lowered, None)
    }
}

impl From<&str> for Words {
    fn from(text: &str) -> Self {
        Words::default().then(text)
    }
}

impl From<String> for Words {
    fn from(text: String) -> Self {
        Words::from(text.as_str())
    }
}

impl From<&String> for Words {
    fn from(text: &String) -> Self {
        Words::from(text.as_str())
    }
}

impl std::fmt::Display for Words {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for span in &self.spans {
            match span.rise {
                Rise::Level => write!(f, "{}", span.text)?,
                Rise::Raised => write!(f, "^{}", span.text)?,
                Rise::Lowered => write!(f, "_{}", span.text)?,
                Rise::Formula(_) => write!(f, "${}$", span.text)?,
            }
        }
        Ok(())
    }
}

/// A glyph on a line: its pen position, y down, and its em.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placed {
    pub(super) glyph: GlyphRef,
    pub(super) at: DVec2,
    pub(super) size: f64,
}

/// A line that has been set: baseline along x from the origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Run {
    pub(super) glyphs: Vec<Placed>,
    /// What is filled beside the glyphs: fraction bars, roots.
    pub(super) pieces: Vec<Path>,
    pub(super) advance: f64,
    pub(super) ink: Option<Rect>,
    /// Why a part of it could not be set.
    pub(super) refused: Option<String>,
}

impl Run {
    /// Adds a glyph that is there already placed; blanks take room but are not kept.
    pub(super) fn push(&mut self, placed: Placed) {
        let Some(bounds) = placed.glyph.bounds() else { return };
        let k = placed.size / placed.glyph.face.units_per_em();
        let ink = Rect {
            min: placed.at + DVec2::new(bounds.min.x, -bounds.max.y) * k,
            max: placed.at + DVec2::new(bounds.max.x, -bounds.min.y) * k,
        };
        self.add_ink(ink);
        self.glyphs.push(placed);
    }

    /// Adds a path that is filled.
    pub(super) fn push_piece(&mut self, piece: Path) {
        if let Some(ink) = piece.bounds() {
            self.add_ink(ink);
            self.pieces.push(piece);
        }
    }

    fn add_ink(&mut self, ink: Rect) {
        self.ink = Some(self.ink.map_or(ink, |before| before.union(ink)));
    }
}
