//! When the ray is inside each slab, as bars over one axis of t, and their overlap.

use glam::DVec2;

use super::{FACES, LETTERS, Slabs, color, face_tex, recorded};
use crate::pictures::diagrams::frame::elided;
use crate::pictures::diagrams::numbers::tex;
use crate::pictures::diagrams::sketch::Sketch;
use crate::pictures::diagrams::subject::Subject;
use crate::pictures::drawing::{Align, Dash, Drawing, Level, Path, Pen, Placement, Rect, Text, Words};
use crate::pictures::theme::{Hue, Theme};

/// The part of the axis that is shown.
#[derive(Clone, Copy, Debug)]
struct Window {
    low: f64,
    high: f64,
    left: f64,
    right: f64,
}

impl Window {
    /// Around the overlap or the gap, with the other ends where they are not too far.
    fn new(slabs: &Slabs, left: f64, right: f64) -> Self {
        let [t_in, t_out] = slabs.overlap();
        let ends = || slabs.spans.iter().flatten().copied().chain([0.0]).filter(|t| t.is_finite());
        let of_both = || [t_in, t_out].into_iter().filter(|t| t.is_finite());
        let (low, high) = (of_both().fold(f64::INFINITY, f64::min), of_both().fold(f64::NEG_INFINITY, f64::max));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        let core = high - low;
        let core = if core > 1e-9 * low.abs().max(high.abs()) { core } else { low.abs().max(1e-300) };
        let near = ends().filter(|t| low - 3.5 * core <= *t && *t <= high + 3.5 * core);
        let (mut from, mut to) = (low, high);
        for t in near {
            (from, to) = (from.min(t), to.max(t));
        }
        let margin = (0.08 * (to - from)).max(0.2 * core);
        Window { low: from - margin, high: to + margin, left, right }
    }

    fn x(&self, t: f64) -> f64 {
        let share = ((t - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        self.left + share * (self.right - self.left)
    }

    fn shows(&self, t: f64) -> bool {
        self.low <= t && t <= self.high
    }
}

pub(super) fn draw(drawing: &mut Drawing, room: Rect, slabs: &Slabs, subject: &Subject<'_>, theme: &Theme) {
    let size = if room.size().x < 420.0 { 10.0 } else { 12.0 };
    let numbers = numbers(drawing, room, slabs, subject, size, theme);
    let window = Window::new(slabs, room.min.x + numbers + 14.0, room.max.x - 6.0);
    let row = row(room);
    let [t_in, t_out] = slabs.overlap();
    let y = |i: usize| room.min.y + row * (i as f64 + 0.5);
    let base = room.min.y + 3.0 * row;
    let is_hit = t_in <= t_out;
    let bottom = base + 0.9 * row;
    let hue = theme.hue(if is_hit { Hue::Green } else { Hue::Vermilion });
    // The overlap, or the gap, behind everything.
    let (a, b) = (window.x(t_in.min(t_out)), window.x(t_in.max(t_out)));
    let band = Rect { min: DVec2::new(a, room.min.y), max: DVec2::new(b.max(a + 1.0), bottom) };
    drawing.fill(Path::rect(band), hue.fade(0.14));
    if !is_hit {
        drawing.hatch(Path::rect(band), DVec2::new(1.0, -1.0), 7.0, Pen::new(hue.fade(0.5), 1.0));
    }
    for axis in 0..3 {
        bar(drawing, &window, y(axis), slabs.spans[axis], axis, 0.3 * row, theme);
    }
    let says = if is_hit { "in all three" } else { "gap" };
    let text = Text::new(12.0, hue).anchor(Align::Start, Level::Middle);
    drawing.text((room.min.x, base + 0.45 * row), elided(says, &text, numbers), text);
    let mut sketch = Sketch::new(drawing, room, theme);
    let axis = Pen::new(theme.axis, 1.2);
    sketch.arrow(DVec2::new(window.left, bottom), DVec2::new(window.right + 4.0, bottom), axis);
    // The number 0 would stand on that of an end that is there.
    let is_clear = |t: f64| !t.is_finite() || (window.x(t) - window.x(0.0)).abs() > 16.0;
    if window.shows(0.0) && is_clear(t_in) && is_clear(t_out) {
        let x = window.x(0.0);
        sketch.faint(DVec2::new(x, room.min.y), DVec2::new(x, bottom), sketch.guide());
        sketch.line(DVec2::new(x, bottom - 4.0), DVec2::new(x, bottom + 4.0), axis);
        let place = |align| Placement { of: None, at: DVec2::new(x, bottom + 7.0), align, level: Level::Top };
        let places = [Align::Middle, Align::End, Align::Start].map(place).to_vec();
        sketch.want(Words::default().tex("0"), theme.muted, places, None);
    }
    let name = |words| Words::default().tex(words);
    let at_end = |dx: f64, align| Placement {
        of: None,
        at: DVec2::new(window.right + dx, bottom + 7.0),
        align,
        level: Level::Top,
    };
    sketch.want(name("t"), theme.muted, vec![at_end(0.0, Align::End), at_end(-30.0, Align::End)], None);
    let is_one = t_in == t_out && recorded(subject, false) == recorded(subject, true);
    let both = r"t_{\mathrm{in}} = t_{\mathrm{out}}";
    let t_in_letters = if is_one { both } else { r"t_{\mathrm{in}}" };
    let ends = [(false, t_in, t_in_letters), (true, t_out, r"t_{\mathrm{out}}")];
    for (leaving, t, letters) in ends.into_iter().take(if is_one { 1 } else { 2 }) {
        if !t.is_finite() {
            continue;
        }
        let x = window.x(t);
        sketch.faint(DVec2::new(x, room.min.y), DVec2::new(x, bottom + 5.0), Pen::new(hue, 1.4).dashed(Dash::Short));
        // The test of a bounding box begins at 0, whatever lies behind.
        let is_it = |value: f64| subject.record.is_some() || (value - t).abs() <= 1e-9 * t.abs();
        let value = recorded(subject, leaving).filter(|value| is_it(*value));
        let words = match value {
            Some(value) => format!("{letters} = {}", tex(value)),
            None => letters.to_owned(),
        };
        let outward = (t_in <= t_out) == leaving;
        let mut places = Vec::new();
        for step in 0..5 {
            let at = DVec2::new(x, bottom + 8.0 + 17.0 * f64::from(step));
            let (near, far) = if outward { (Align::Start, Align::End) } else { (Align::End, Align::Start) };
            places.extend([near, Align::Middle, far].map(|align| Placement { of: None, at, align, level: Level::Top }));
        }
        sketch.want(Words::default().tex(&words), theme.ink, places, None);
    }
    sketch.finish();
}

/// The height of a row: three bars, the overlap, and room for the numbers below.
fn row(room: Rect) -> f64 {
    ((room.size().y - 44.0) / 4.0).clamp(14.0, 40.0)
}

/// Writes the six values beside the bars; returns how much room they take.
fn numbers(drawing: &mut Drawing, room: Rect, slabs: &Slabs, subject: &Subject<'_>, size: f64, theme: &Theme) -> f64 {
    let row = row(room);
    let mut x = room.min.x;
    for leaving in [false, true] {
        let mut widest = 0.0_f64;
        for axis in 0..3 {
            let words = match slabs.face(axis, leaving) {
                Some(face) => {
                    let value = subject.number(FACES[face]).map_or(String::new(), |t| format!(" = {}", tex(t)));
                    format!("{}{value}", face_tex(face))
                }
                None if leaving => continue,
                None => format!(r"d_{{{}}} = 0", LETTERS[axis]),
            };
            let text = Text::new(size, color(axis, theme)).anchor(Align::Start, Level::Middle);
            let words = Words::default().tex(&words);
            drawing.text((x, room.min.y + row * (axis as f64 + 0.5)), words.clone(), text);
            widest = widest.max(text.width(words));
        }
        x += widest + 12.0;
    }
    (x - 12.0 - room.min.x).max(78.0)
}

/// Draws the bar of one slab, with a break where it goes on beyond the window.
fn bar(drawing: &mut Drawing, window: &Window, y: f64, [from, to]: [f64; 2], axis: usize, half: f64, theme: &Theme) {
    let hue = color(axis, theme);
    if from > to {
        let text = Text::new(12.0, theme.muted).anchor(Align::Middle, Level::Middle);
        let words = elided("the ray runs beside this slab", &text, window.right - window.left);
        drawing.text(((window.left + window.right) / 2.0, y), words, text);
        return;
    }
    if to < window.low || window.high < from {
        // Far off to one side: an arrow to where it is.
        let (at, way) = if to < window.low { (window.left, -1.0) } else { (window.right, 1.0) };
        drawing.arrow((at - 30.0 * way, y), (at, y), Pen::new(hue, 2.4));
        return;
    }
    let (a, b) = (window.x(from), window.x(to));
    let rect = Rect { min: DVec2::new(a, y - half), max: DVec2::new(b.max(a + 1.5), y + half) };
    drawing.fill(Path::rect(rect), hue.fade(0.45));
    for (t, x) in [(from, a), (to, b)] {
        if window.shows(t) {
            drawing.line((x, y - half - 2.0), (x, y + half + 2.0), Pen::new(hue, 2.2));
        } else {
            let inward = if x > (window.left + window.right) / 2.0 { -1.0 } else { 1.0 };
            for k in [8.0, 13.0] {
                let x = x + inward * k;
                drawing.line((x - 3.0, y + half + 2.0), (x + 3.0, y - half - 2.0), Pen::new(theme.background, 2.2));
            }
        }
    }
}
