//! The colours, dashes and marks of all pictures, by what they stand for, on light and on dark ground.
//!
//! The hues are those of Okabe and Ito ("Color Universal Design", 2008), darkened or lightened until each has a contrast of
//! at least 3 against its ground; a test holds them to it. What a hue says is said again by a dash pattern, a mark or a word.

use super::drawing::{Color, Dash, Pen};
use crate::numbers::Stage;
use crate::tree::Kind;

/// The palette of one ground.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Theme {
    /// The ground.
    pub background: Color,
    /// A panel that stands out from the ground.
    pub panel: Color,
    /// Text and outlines.
    pub ink: Color,
    /// Text that explains.
    pub muted: Color,
    /// Lines of axes.
    pub axis: Color,
    /// Lines behind the data.
    pub grid: Color,
    /// The hues, to tell things apart: see [`Hue`].
    hues: [Color; 7],
    /// From [`Stage::Filter`] to [`Stage::Expansion`].
    stages: [Color; 4],
    /// From cold to hot.
    heat: [Color; 6],
}

/// A hue of the palette.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hue {
    /// Blue.
    Blue,
    /// Red-orange.
    Vermilion,
    /// Blue-green.
    Green,
    /// Red-purple.
    Purple,
    /// Sky blue.
    Sky,
    /// Yellow-orange.
    Amber,
    /// Grey.
    Grey,
}

impl Hue {
    /// All of them.
    pub const ALL: [Hue; 7] = [Hue::Blue, Hue::Vermilion, Hue::Green, Hue::Purple, Hue::Sky, Hue::Amber, Hue::Grey];
}

/// A way to decide whether a ray hits, whatever the shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// As the lecture writes it.
    Lecture,
    /// What most renderers use: Möller and Trumbore's test of a triangle, explicit zeros in the slabs of a box.
    MollerTrumbore,
    /// Woop, Benthin and Wald's test of a triangle.
    Watertight,
    /// A stable formula, like Haines's for the sphere.
    Stable,
    /// A filter with a proven bound, exact where it cannot decide.
    Certified,
    /// Exact throughout.
    Exact,
}

/// The shape of a mark in a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A filled circle.
    Disk,
    /// A circle with the ground inside.
    Ring,
    /// A square.
    Square,
    /// A triangle, point up.
    Triangle,
    /// A square on its corner.
    Diamond,
    /// An x.
    Cross,
}

/// What a test said, against what is true.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A hit, rightly.
    Hit,
    /// A miss, rightly.
    Miss,
    /// A hit, wrongly.
    FalseHit,
    /// A miss, wrongly.
    FalseMiss,
}

impl Theme {
    /// For paper and light pages.
    pub const LIGHT: Theme = Theme {
        background: Color::hex(0xffffff),
        panel: Color::hex(0xf4f6f8),
        ink: Color::hex(0x1b2026),
        muted: Color::hex(0x59636e),
        axis: Color::hex(0x868f99),
        grid: Color::hex(0xe4e8ec),
        hues: [
            Color::hex(0x0067a5),
            Color::hex(0xc94f00),
            Color::hex(0x00805d),
            Color::hex(0xa8487f),
            Color::hex(0x3390c8),
            Color::hex(0xb07800),
            Color::hex(0x6b747e),
        ],
        stages: [Color::hex(0xc9dceb), Color::hex(0x3390c8), Color::hex(0xe69f00), Color::hex(0xb23c00)],
        heat: [
            Color::hex(0xf4f6f8),
            Color::hex(0xfbdc9c),
            Color::hex(0xf29b45),
            Color::hex(0xcf4a52),
            Color::hex(0x76286f),
            Color::hex(0x1e1246),
        ],
    };

    /// For dark pages and projectors.
    pub const DARK: Theme = Theme {
        background: Color::hex(0x14181d),
        panel: Color::hex(0x1d2329),
        ink: Color::hex(0xe9ecef),
        muted: Color::hex(0xa3adb8),
        axis: Color::hex(0x76818c),
        grid: Color::hex(0x2b323a),
        hues: [
            Color::hex(0x4aa3e0),
            Color::hex(0xff7f3f),
            Color::hex(0x2fc294),
            Color::hex(0xdc86b5),
            Color::hex(0x8fd0f5),
            Color::hex(0xf0b73a),
            Color::hex(0x98a2ad),
        ],
        stages: [Color::hex(0x2c4358), Color::hex(0x56b4e9), Color::hex(0xe69f00), Color::hex(0xff6a2b)],
        heat: [
            Color::hex(0x1d2329),
            Color::hex(0x4b1d6b),
            Color::hex(0xa52c60),
            Color::hex(0xe9662a),
            Color::hex(0xf8b73d),
            Color::hex(0xfcffc4),
        ],
    };

    /// The colour of a hue on this ground.
    pub fn hue(&self, hue: Hue) -> Color {
        self.hues[hue as usize]
    }

    /// The line of a ray: every kind has its own hue and its own dashes.
    pub fn ray(&self, kind: Kind, width: f64) -> Pen {
        let (hue, dash) = match kind {
            Kind::Camera => (Hue::Blue, Dash::Solid),
            Kind::Reflected => (Hue::Vermilion, Dash::Dashed),
            Kind::Refracted => (Hue::Green, Dash::DashDot),
            Kind::Shadow => (Hue::Amber, Dash::Dotted),
        };
        Pen::new(self.hue(hue), width).dashed(dash)
    }

    /// The colour of a stage: the dearer, the hotter.
    pub fn stage(&self, stage: Stage) -> Color {
        self.stages[stage as usize]
    }

    /// The colour and the mark of a method.
    pub fn method(&self, method: Method) -> (Color, Mark) {
        let (hue, mark) = match method {
            Method::Lecture => (Hue::Vermilion, Mark::Square),
            Method::MollerTrumbore => (Hue::Amber, Mark::Triangle),
            Method::Watertight => (Hue::Purple, Mark::Diamond),
            Method::Stable => (Hue::Sky, Mark::Ring),
            Method::Certified => (Hue::Blue, Mark::Disk),
            Method::Exact => (Hue::Green, Mark::Cross),
        };
        (self.hue(hue), mark)
    }

    /// The colour of a verdict: right ones are quiet, wrong ones stand out.
    pub fn verdict(&self, verdict: Verdict) -> Color {
        match verdict {
            Verdict::Hit => self.hue(Hue::Sky).mix(self.background, 0.45),
            Verdict::Miss => self.grid,
            Verdict::FalseHit => self.hue(Hue::Vermilion),
            Verdict::FalseMiss => self.ink,
        }
    }

    /// A heat, from 0 (cold, close to the ground) to 1 (hot): luminance changes in one direction only, so that it reads in
    /// grey too.
    pub fn heat(&self, x: f64) -> Color {
        let at = x.clamp(0.0, 1.0) * (self.heat.len() - 1) as f64;
        let below = (at as usize).min(self.heat.len() - 2);
        self.heat[below].mix(self.heat[below + 1], at - below as f64)
    }
}
