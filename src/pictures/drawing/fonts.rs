//! The embedded fonts: outlines, advances and kerning of their glyphs. `src/pictures/fonts/README.md` says where they are
//! from.

use std::sync::LazyLock;

use glam::DVec2;
use ttf_parser::{GlyphId, OutlineBuilder, gpos::PairAdjustment, gpos::PositioningSubtable};

use super::path::{Path, Segment};
use super::rect::Rect;

macro_rules! faces {
    ($($name:ident $prefix:literal $file:literal $what:literal,)*) => {
        /// A font file.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Face { $(#[doc = $what] $name,)* }

        impl Face {
            const ALL: &'static [Face] = &[$(Face::$name,)*];

            /// What the names of its glyphs in an SVG begin with.
            pub(super) fn prefix(self) -> &'static str {
                match self { $(Face::$name => $prefix,)* }
            }

            fn bytes(self) -> &'static [u8] {
                match self { $(Face::$name => include_bytes!(concat!("../fonts/", $file)),)* }
            }
        }
    };
}

faces! {
    Sans "s" "IBMPlexSans-Regular.ttf" "IBM Plex Sans, for labels.",
    Bold "b" "IBMPlexSans-SemiBold.ttf" "IBM Plex Sans SemiBold, for titles.",
    Mono "m" "IBMPlexMono-Regular.ttf" "IBM Plex Mono, for listings.",
    MathMain "kr" "KaTeX_Main-Regular.ttf" "KaTeX: upright letters, digits, signs.",
    MathBold "kb" "KaTeX_Main-Bold.ttf" "KaTeX: bold letters, for vectors.",
    MathItalic "ki" "KaTeX_Math-Italic.ttf" "KaTeX: variables.",
    MathBoldItalic "kj" "KaTeX_Math-BoldItalic.ttf" "KaTeX: bold variables.",
    MathSize1 "k1" "KaTeX_Size1-Regular.ttf" "KaTeX: large signs.",
    MathSize2 "k2" "KaTeX_Size2-Regular.ttf" "KaTeX: larger signs.",
    MathSize3 "k3" "KaTeX_Size3-Regular.ttf" "KaTeX: still larger signs.",
    MathSize4 "k4" "KaTeX_Size4-Regular.ttf" "KaTeX: the largest signs.",
}

/// A glyph of a face, by its number in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct GlyphRef {
    /// The font file.
    pub(super) face: Face,
    /// The number of the glyph.
    pub(super) id: u16,
}

static PARSED: LazyLock<Vec<ttf_parser::Face<'static>>> = LazyLock::new(|| {
    let parse = |face: &Face| ttf_parser::Face::parse(face.bytes(), 0).expect("the embedded fonts are sound");
    Face::ALL.iter().map(parse).collect()
});

impl Face {
    fn parsed(self) -> &'static ttf_parser::Face<'static> {
        &PARSED[self as usize]
    }

    /// The glyph of a character, from this face or else from the first that has it; none has it: a question mark.
    pub(super) fn glyph(self, character: char) -> GlyphRef {
        let found = self.own_glyph(character).or_else(|| Face::ALL.iter().find_map(|face| face.own_glyph(character)));
        found.unwrap_or_else(|| match character {
            '?' => GlyphRef { face: self, id: 0 },
            _ => self.glyph('?'),
        })
    }

    /// The glyph of a character from this face, if it has it.
    pub(super) fn own_glyph(self, character: char) -> Option<GlyphRef> {
        self.parsed().glyph_index(character).map(|id| GlyphRef { face: self, id: id.0 })
    }

    /// Whether some face has the character.
    pub fn covers(character: char) -> bool {
        Face::ALL.iter().any(|face| face.parsed().glyph_index(character).is_some())
    }

    /// Design units per em.
    pub(super) fn units_per_em(self) -> f64 {
        f64::from(self.parsed().units_per_em())
    }
}

impl GlyphRef {
    /// How far the pen moves on, in ems.
    pub(super) fn advance(self) -> f64 {
        let units = self.face.parsed().glyph_hor_advance(GlyphId(self.id)).unwrap_or(0);
        f64::from(units) / self.face.units_per_em()
    }

    /// What is added to the advance before `next`, in ems: the first pair adjustment of the face's GPOS table.
    pub(super) fn kerning(self, next: GlyphRef) -> f64 {
        if self.face != next.face || self.face == Face::Mono {
            return 0.0;
        }
        pair_adjustment(self.face.parsed(), GlyphId(self.id), GlyphId(next.id)).unwrap_or(0.0)
            / self.face.units_per_em()
    }

    /// The rectangle around the outline in design units, y up: `min` is its lower left. Nothing for a blank.
    pub(super) fn bounds(self) -> Option<Rect> {
        let r = self.face.parsed().glyph_bounding_box(GlyphId(self.id))?;
        Some(Rect { min: DVec2::new(r.x_min.into(), r.y_min.into()), max: DVec2::new(r.x_max.into(), r.y_max.into()) })
    }

    /// The outline in design units, y up.
    pub(super) fn outline(self) -> Path {
        let mut outline = Outline::default();
        self.face.parsed().outline_glyph(GlyphId(self.id), &mut outline);
        outline.0
    }
}

fn pair_adjustment(face: &ttf_parser::Face<'_>, first: GlyphId, second: GlyphId) -> Option<f64> {
    let table = face.tables().gpos?;
    let kern = table.features.into_iter().filter(|feature| feature.tag == ttf_parser::Tag::from_bytes(b"kern"));
    let lookups = kern.flat_map(|feature| feature.lookup_indices).filter_map(|i| table.lookups.get(i));
    for lookup in lookups {
        for subtable in lookup.subtables.into_iter::<PositioningSubtable<'_>>() {
            let PositioningSubtable::Pair(pairs) = subtable else { continue };
            let Some(covered) = pairs.coverage().get(first) else { continue };
            let records = match pairs {
                PairAdjustment::Format1 { sets, .. } => sets.get(covered).and_then(|set| set.get(second)),
                PairAdjustment::Format2 { classes, matrix, .. } => {
                    matrix.get((classes.0.get(first), classes.1.get(second)))
                }
            };
            if let Some((record, _)) = records {
                return Some(f64::from(record.x_advance));
            }
        }
    }
    None
}

#[derive(Default)]
struct Outline(Path);

fn point(x: f32, y: f32) -> DVec2 {
    DVec2::new(x.into(), y.into())
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.segments.push(Segment::Move(point(x, y)));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.0.segments.push(Segment::Line(point(x, y)));
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.segments.push(Segment::Quad(point(x1, y1), point(x, y)));
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.segments.push(Segment::Cubic(point(x1, y1), point(x2, y2), point(x, y)));
    }
    fn close(&mut self) {
        self.0.segments.push(Segment::Close);
    }
}
