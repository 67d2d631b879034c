//! A part of the section magnified, where two points of it are too close to be told apart.

use glam::DVec2;

use super::Cut;
use super::section::Frame;
use crate::pictures::diagrams::sketch::Sketch;
use crate::pictures::drawing::{Drawing, Path, Pen, Rect, Words};
use crate::pictures::theme::{Hue, Theme};
use crate::tree::Kind;

/// What is magnified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Zoom {
    /// Both roots, at a chord that is short.
    Chord,
    /// The origin of the ray and a root: the first or the second.
    Start(usize),
    /// The gap between the ray and a sphere that it hardly misses.
    Gap,
}

/// Points closer than this look like one.
const CLOSE: f64 = 22.0;

/// What has to be magnified, if anything.
pub(super) fn wanted(cut: &Cut, frame: &Frame) -> Option<Zoom> {
    let close = |world: f64| world > 0.0 && world * frame.scale < CLOSE;
    let Some([t_in, t_out]) = cut.roots else {
        return close(cut.gap).then_some(Zoom::Gap);
    };
    let start = |i: usize, x: f64| (!frame.is_broken && close(x.abs())).then_some(Zoom::Start(i));
    let chord = cut.half.filter(|half| close(2.0 * half)).map(|_| Zoom::Chord);
    chord.or(start(0, t_in)).or(start(1, t_out))
}

/// Draws the magnified part into `room`, and where it is in the picture above.
pub(super) fn draw(drawing: &mut Drawing, room: Rect, cut: &Cut, frame: &Frame, zoom: Zoom, kind: Kind, theme: &Theme) {
    let [t_in, t_out] = cut.roots.unwrap_or([cut.foot; 2]);
    let half = cut.half.unwrap_or(0.0);
    // The span that is to fill a third of the room, and where on the circle it lies, from the centre.
    let (span, out) = match zoom {
        Zoom::Chord => (2.0 * half, DVec2::new(-half, -cut.away)),
        Zoom::Start(0) => (t_in.abs(), DVec2::new(-half, -cut.away)),
        Zoom::Start(_) => (t_out.abs(), DVec2::new(half, -cut.away)),
        Zoom::Gap => (cut.gap, DVec2::new(0.0, -1.0)),
    };
    let size = room.size();
    let scale = if zoom == Zoom::Gap { 0.3 * size.y / span } else { 0.36 * size.x / span };
    let middle = room.center();
    let line = middle.y - if zoom == Zoom::Gap { 0.15 * size.y } else { 0.0 };
    // The anchor: a point of the circle.
    let anchor = match zoom {
        Zoom::Chord => DVec2::new(middle.x - 0.5 * scale * span, line),
        Zoom::Start(0) => DVec2::new(middle.x + 0.5 * scale * t_in, line),
        Zoom::Start(_) => DVec2::new(middle.x + 0.5 * scale * t_out, line),
        Zoom::Gap => DVec2::new(middle.x, line + scale * cut.gap),
    };

    let place = match zoom {
        Zoom::Chord | Zoom::Gap => frame.foot,
        Zoom::Start(i) => frame.on_ray(cut, 0.5 * [t_in, t_out][i]),
    };
    let ring = Pen::new(theme.hue(Hue::Amber), 1.6);
    drawing.stroke(Path::circle(place, 11.0), ring);

    drawing.fill(Path::rect(room), theme.background);
    let arc = arc(cut.radius, scale, anchor, out, size.length());
    let inside = arc.iter().copied().chain(arc.iter().rev().map(|p| *p - 3.0 * size.length() * away(out)));
    let panel = theme.panel;
    let (fill, rim) = (Path::polygon(inside), Path::open(arc.iter().copied()));
    drawing.clipped(Path::rect(room), |drawing| {
        drawing.fill(fill, panel);
        drawing.stroke(rim, Pen::new(theme.ink, 1.8));
    });
    let mut sketch = Sketch::new(drawing, room.grown(-3.0), theme);
    for pair in arc.windows(2) {
        if let Some((a, b)) = sketch.cut(pair[0], pair[1]) {
            sketch.keep_off(&[a, b]);
        }
    }
    points(&mut sketch, cut, zoom, line, anchor, scale, kind);
    sketch.finish();
    drawing.stroke(Path::rect(room), ring);
}

/// The ray and what is on it.
fn points(sketch: &mut Sketch<'_>, cut: &Cut, zoom: Zoom, line: f64, anchor: DVec2, scale: f64, kind: Kind) {
    let (theme, room) = (sketch.theme, sketch.room);
    let pen = theme.ray(kind, 2.4);
    let guide = sketch.guide();
    let (west, east) = (DVec2::new(room.min.x, line), DVec2::new(room.max.x, line));
    let caption = |sketch: &mut Sketch<'_>, words: &str| {
        let text = crate::pictures::drawing::Text::new(12.0, theme.muted);
        sketch.drawing.text(room.min + DVec2::new(6.0, 15.0), words, text);
    };
    caption(sketch, "what is in the ring, magnified");
    let in_out = [r"t_{\mathrm{in}}", r"t_{\mathrm{out}}"];
    let roots = cut.roots.unwrap_or_default();
    match zoom {
        Zoom::Gap => {
            sketch.ray(west, east, pen);
            let red = theme.hue(Hue::Vermilion);
            let foot = DVec2::new(anchor.x, line);
            sketch.drawing.dimension(foot, anchor, 0.0, Pen::new(red, 1.6));
            sketch.beside(foot, anchor, Words::from("missed by this"), red);
        }
        Zoom::Chord => {
            sketch.ray(west, east, pen);
            let far = anchor + DVec2::new(2.0 * scale * cut.half.unwrap_or(0.0), 0.0);
            for (i, at) in [anchor, far].into_iter().enumerate() {
                let color = if cut.taken == Some(i) { pen.color } else { theme.muted };
                sketch.dot(at, color);
                sketch.name_in(at, Words::default().tex(in_out[i]), color);
            }
        }
        Zoom::Start(i) => {
            let eye = anchor - DVec2::new(scale * roots[i], 0.0);
            sketch.faint(west, eye, guide);
            sketch.ray(eye, east, pen);
            let color = if cut.taken == Some(i) { pen.color } else { theme.muted };
            sketch.dot(anchor, color);
            sketch.name_in(anchor, Words::default().tex(in_out[i]), color);
            sketch.dot(eye, theme.ink);
            sketch.name(eye, Words::default().tex(r"\mathbf{o}"));
        }
    }
}

/// The unit vector from the centre outward.
fn away(out: DVec2) -> DVec2 {
    out.try_normalize().unwrap_or(DVec2::NEG_X)
}

/// Points of the circle around `anchor` as far as `reach` units, without computing anything from its centre, which may be
/// millions of units off.
fn arc(radius: f64, scale: f64, anchor: DVec2, out: DVec2, reach: f64) -> Vec<DVec2> {
    let r = radius * scale;
    let out = away(out);
    // The chord over the angle x is 2 r sin(x / 2).
    let most = if r > reach / 2.0 { libm::asin(reach / (2.0 * r)) } else { std::f64::consts::FRAC_PI_2 };
    let point = |i: i32| {
        let half = most * f64::from(i) / 32.0;
        let chord = 2.0 * r * libm::sin(half);
        anchor + chord * (out.perp() * libm::cos(half) - out * libm::sin(half))
    };
    (-32..=32).map(point).collect()
}
