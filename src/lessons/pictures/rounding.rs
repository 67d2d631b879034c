//! Lesson 11: what rounding does: a verdict over many rays side by side, the error of a root.

use glam::DVec2;

use super::{Page, Shown};
use crate::pictures::drawing::{
    Align, Color, Dash, Drawing, Face, Level, Path, Pen, Raster, Rect, Sampling, Text, Words,
};
use crate::pictures::theme::{Hue, Theme, Verdict};

/// What stands at a point of a [`map`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tile {
    /// Right: there is something.
    Full,
    /// Right: there is nothing.
    Empty,
    /// Wrong: there is more than should be.
    Extra,
    /// Wrong: there is less than should be.
    Hole,
}

impl Tile {
    /// What stands where `is_full` is true and somebody says `own`, or nothing at all.
    pub fn beside(is_full: bool, own: Option<bool>) -> Self {
        match (is_full, own) {
            (true, Some(true)) => Tile::Full,
            (false, Some(false)) => Tile::Empty,
            (false, Some(true)) => Tile::Extra,
            (true, _) | (false, None) => Tile::Hole,
        }
    }

    fn color(self, theme: &Theme) -> Color {
        theme.verdict(match self {
            Tile::Full => Verdict::Hit,
            Tile::Empty => Verdict::Miss,
            Tile::Extra => Verdict::FalseHit,
            Tile::Hole => Verdict::FalseMiss,
        })
    }
}

/// What a [`map`] is of, and what its colours mean; what never occurs is called nothing.
#[derive(Clone, Copy, Debug)]
pub struct Meanings {
    /// How to read it.
    pub about: &'static str,
    /// Of [`Tile::Full`].
    pub full: &'static str,
    /// Of [`Tile::Empty`].
    pub empty: &'static str,
    /// Of [`Tile::Extra`].
    pub extra: &'static str,
    /// Of [`Tile::Hole`].
    pub hole: &'static str,
}

/// Points along a side of a [`map`].
const SIDE: u32 = 97;

/// What is true of many rays around the one of the case, beside what the student's function makes of them: `tile` gives both
/// for a place in -1 ..= 1 to the right and upwards.
pub fn map(tile: &dyn Fn(f64, f64) -> [Tile; 2], meanings: &Meanings, what: &Shown) -> Drawing {
    let mut page = Page::new(what, meanings.about);
    let theme = page.theme;
    let place = |i: u32| 2.0 * f64::from(i) / f64::from(SIDE - 1) - 1.0;
    let tiles: Vec<[Tile; 2]> = (0..SIDE * SIDE).map(|i| tile(place(i % SIDE), -place(i / SIDE))).collect();
    let count = |whose: usize, kind: Tile| tiles.iter().filter(|both| both[whose] == kind).count();
    let is_shown = what.got.is_some();
    let columns = if is_shown { 2 } else { 1 };
    let gap = 18.0;
    let room = page.room;
    let side = ((room.size().x - gap) / 2.0).min(room.size().y - 150.0);
    let caption = Text::new(13.5, theme.ink).face(Face::Bold);
    for whose in 0..columns {
        let x = room.min.x + whose as f64 * (side + gap);
        let rect = Rect::new((x, room.min.y + 34.0), (side, side));
        let words = ["true", "yours"][whose];
        page.drawing.text((x, room.min.y + 24.0), words, caption);
        let raster = Raster::from_fn(SIDE, SIDE, |x, y| tiles[(y * SIDE + x) as usize][whose].color(theme));
        page.drawing.image(raster, rect, Sampling::Nearest);
        page.drawing.stroke(Path::rect(rect), Pen::new(theme.axis, 1.0));
    }
    let mut y = room.min.y + 34.0 + side + 24.0;
    let whose = columns - 1;
    let kinds = [
        (Tile::Full, meanings.full),
        (Tile::Empty, meanings.empty),
        (Tile::Extra, meanings.extra),
        (Tile::Hole, meanings.hole),
    ];
    let text = Text::new(12.5, theme.ink).anchor(Align::Start, Level::Middle);
    for (kind, meaning) in kinds {
        let (occurs, is_wrong) = (count(whose, kind), matches!(kind, Tile::Extra | Tile::Hole));
        // What is in either of both maps.
        let is_seen = occurs > 0 || count(0, kind) > 0;
        if meaning.is_empty() || (is_wrong && !is_shown) || (!is_seen && !is_wrong) {
            continue;
        }
        let swatch = Rect::new((room.min.x, y - 7.0), (14.0, 14.0));
        page.drawing.fill(Path::rect(swatch), kind.color(theme));
        page.drawing.stroke(Path::rect(swatch), Pen::new(theme.axis, 0.8));
        let words = format!("{meaning}: {occurs} of {}", tiles.len());
        page.drawing.text((room.min.x + 24.0, y), words, text);
        y += 24.0;
    }
    page.drawing
}

/// The first and the last exponent of two on the axis of [`small_root`].
const POWERS: [i32; 2] = [6, 48];

/// How far a function's smaller root is off, over the size of the other root: `error` says it for the quadratic
/// `t^2 - L t + 0.3 L` with this L, or nothing where the function has no such root.
pub fn small_root(error: &dyn Fn(f64) -> Option<f64>, what: &Shown) -> Drawing {
    let mut page = Page::new(
        what,
        "The equation t^2 - L t + 0.3 L = 0 for larger and larger L: by how much the root near 0.3 is off.",
    );
    let theme = page.theme;
    let room = page.room;
    let area = Rect { min: room.min + DVec2::new(74.0, 30.0), max: room.max - DVec2::new(14.0, 62.0) };
    let (lowest, highest) = (-18.0, 2.0);
    let [first, last] = POWERS;
    let x_of = |k: f64| area.min.x + (k - f64::from(first)) / f64::from(last - first) * area.size().x;
    let y_of = |power: f64| area.max.y - (power - lowest) / (highest - lowest) * area.size().y;
    let label = Text::new(12.0, theme.muted);
    let (grid, axis) = (Pen::new(theme.grid, 1.0), Pen::new(theme.axis, 1.2));
    for power in [-15, -12, -9, -6, -3, 0] {
        let y = y_of(power.into());
        page.drawing.line((area.min.x, y), (area.max.x, y), grid);
        let words = Words::default().tex(&format!("10^{{{power}}}"));
        page.drawing.text((area.min.x - 10.0, y), words, label.anchor(Align::End, Level::Middle));
    }
    for power in [3, 6, 9, 12] {
        let x = x_of(f64::from(power) * std::f64::consts::LOG2_10);
        page.drawing.line((x, area.max.y), (x, area.max.y + 5.0), axis);
        let words = Words::default().tex(&format!("10^{{{power}}}"));
        page.drawing.text((x, area.max.y + 10.0), words, label.anchor(Align::Middle, Level::Top));
    }
    page.drawing.line((area.min.x, area.max.y), (area.max.x, area.max.y), axis);
    page.drawing.line((area.min.x, area.min.y), (area.min.x, area.max.y), axis);
    page.drawing.text((room.min.x, area.min.y - 14.0), "error", label);
    let below = label.anchor(Align::Middle, Level::Baseline);
    page.drawing.text((area.center().x, area.max.y + 46.0), "the other root, L", below);
    page.drawing.text((area.min.x - 10.0, area.max.y), "none", label.anchor(Align::End, Level::Middle));
    let dot = |k: i32| {
        // An answer that cannot be drawn is as wrong as can be.
        let error = error((1u64 << k) as f64).unwrap_or(f64::MAX);
        let power = if error > 0.0 { libm::log10(error).clamp(lowest, highest) } else { lowest };
        DVec2::new(x_of(k.into()), y_of(power))
    };
    let dots: Vec<DVec2> = (first..=last).map(dot).collect();
    let y = y_of(libm::log10(crate::lessons::TOLERANCE));
    let tolerance = theme.hue(Hue::Green);
    page.drawing.line((area.min.x, y), (area.max.x, y), Pen::new(tolerance, 1.6).dashed(Dash::Short));
    // Its name stands at an end of the line, above or below it, where there are no dots.
    let size = DVec2::new(150.0, 24.0);
    let places = [DVec2::new(area.min.x + 6.0, y - size.y), DVec2::new(area.min.x + 6.0, y)];
    let others = places.map(|p| DVec2::new(area.max.x - 6.0 - size.x, p.y));
    let is_free = |p: &&DVec2| {
        let rect = Rect::new(**p, size).grown(4.0);
        !dots.iter().any(|dot| rect.contains(Rect { min: *dot, max: *dot }))
    };
    let place = *places.iter().chain(&others).find(is_free).unwrap_or(&places[0]);
    let words = Text::new(12.0, tolerance).anchor(Align::Start, Level::Middle);
    page.drawing.text(place + DVec2::new(0.0, size.y / 2.0), "right: below this line", words);
    let color = if what.wrong().is_some() { page.wrong().color } else { page.right().color };
    for dot in dots {
        page.drawing.disk(dot, 3.4, color);
    }
    page.drawing
}
