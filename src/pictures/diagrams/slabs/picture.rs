//! The box in two axes, its slabs, and the ray with the places where it crosses their sides.

use glam::DVec2;

use super::{LETTERS, Slabs, color, face_tex};
use crate::pictures::diagrams::numbers::tex;
use crate::pictures::diagrams::sketch::Sketch;
use crate::pictures::diagrams::subject::Subject;
use crate::pictures::drawing::{Align, Dash, Drawing, Level, Path, Pen, Placement, Rect, Words};
use crate::pictures::theme::Theme;

/// From two axes of the world to the canvas.
#[derive(Clone, Copy, Debug)]
struct Frame {
    axes: [usize; 2],
    /// What stands in the middle.
    center: DVec2,
    /// Units a world unit along both.
    scale: DVec2,
    middle: DVec2,
    is_uneven: bool,
}

/// The least side of the box on the canvas, if it is not flat.
const LEAST: f64 = 46.0;

impl Frame {
    fn new(slabs: &Slabs, room: Rect) -> Self {
        let axes = slabs.pair();
        let of = |v: [f64; 3]| DVec2::new(v[axes[0]], v[axes[1]]);
        let (min, max) = (of(slabs.min), of(slabs.max));
        let origin = of(slabs.origin);
        let size = (max - min).max(DVec2::ZERO);
        // The eye is seen where it is near.
        let reach = 1.6 * size.max_element();
        let is_near = |k: usize| min[k] - reach <= origin[k] && origin[k] <= max[k] + reach;
        let (low, high) = if is_near(0) && is_near(1) { (min.min(origin), max.max(origin)) } else { (min, max) };
        let span = high - low;
        let most = 0.6 * room.size();
        let even = (most / span).min_element();
        let even = if even.is_finite() && even > 0.0 { even } else { most.min_element() };
        let mut scale = DVec2::splat(even);
        let mut is_uneven = false;
        for k in 0..2 {
            if size[k] > 0.0 && size[k] * even < LEAST {
                scale[k] = (LEAST / size[k]).min(most[k] / span[k]);
                is_uneven = true;
            }
        }
        Frame { axes, center: low.midpoint(high), scale, middle: room.center(), is_uneven }
    }

    fn at(&self, p: DVec2) -> DVec2 {
        let off = ((p - self.center) * self.scale).clamp(DVec2::splat(-1e9), DVec2::splat(1e9));
        self.middle + DVec2::new(off.x, -off.y)
    }

    fn origin(&self, slabs: &Slabs) -> DVec2 {
        self.at(DVec2::new(slabs.origin[self.axes[0]], slabs.origin[self.axes[1]]))
    }

    /// The direction of the ray on the canvas.
    fn along(&self, slabs: &Slabs) -> DVec2 {
        let d = DVec2::new(slabs.direction[self.axes[0]], -slabs.direction[self.axes[1]]);
        (d * self.scale).try_normalize().unwrap_or(DVec2::ZERO)
    }

    /// Where the ray is at the face of a slab: on the line of that face.
    fn crossing(&self, slabs: &Slabs, t: f64) -> DVec2 {
        let of = |k: usize| slabs.origin[self.axes[k]] + t * slabs.direction[self.axes[k]];
        self.at(DVec2::new(of(0), of(1)))
    }
}

/// What is not as it looks.
pub(super) fn remark(slabs: &Slabs, room: Rect) -> String {
    let frame = Frame::new(slabs, room);
    let is_far = !room.contains(Rect { min: frame.origin(slabs), max: frame.origin(slabs) });
    let all = [
        (frame.is_uneven, "The two axes have different scales."),
        (is_far, "The origin is far away: the ray is broken at the marks, not to scale there."),
    ];
    all.into_iter().filter(|(is, _)| *is).map(|(_, words)| words).collect::<Vec<_>>().join(" ")
}

pub(super) fn draw(drawing: &mut Drawing, room: Rect, slabs: &Slabs, subject: &Subject<'_>, theme: &Theme) {
    let frame = Frame::new(slabs, room);
    let mut sketch = Sketch::new(drawing, room, theme);
    sides(&mut sketch, slabs, &frame);
    let (eye, along) = (frame.origin(slabs), frame.along(slabs));
    let pen = theme.ray(subject.node.kind, 2.4);
    let reach = 4.0 * (room.size().x + room.size().y);
    let sees_eye = sketch.sees(eye);
    if along == DVec2::ZERO {
        sketch.disk(eye, 6.0, pen.color);
        sketch.name(eye, "the ray, end on");
    } else if sees_eye {
        sketch.line(eye, eye - reach * along, sketch.guide());
        sketch.ray(eye, eye + reach * along, pen);
    } else if let Some((a, b)) = through(&sketch, eye, along, reach) {
        sketch.ray(a, b, pen);
        let (p, q) = (a + 16.0 * along, a + 18.0 * along);
        sketch.broken(p, q, theme.axis);
        sketch.dot(a, theme.ink);
        sketch.name(a, Words::default().tex(r"\mathbf{o}"));
    }
    if sees_eye && along != DVec2::ZERO {
        sketch.dot(eye, theme.ink);
        sketch.name(eye, Words::default().tex(r"\mathbf{o}"));
    }
    let from = if sees_eye { None } else { through(&sketch, eye, along, reach).map(|(a, _)| a) };
    crossings(&mut sketch, slabs, &frame, from);
    if let Some(hit) = subject.hit {
        let p = frame.at(DVec2::new(hit.point[frame.axes[0]], hit.point[frame.axes[1]]));
        if sketch.sees(p) {
            sketch.drawing.stroke(Path::circle(p, 8.0), Pen::new(pen.color, 2.0));
        }
    }
    sketch.finish();
}

/// The part of the ray that is seen, where its origin is not. Far away its place is not known to a unit, but its line is.
fn through(sketch: &Sketch<'_>, eye: DVec2, along: DVec2, reach: f64) -> Option<(DVec2, DVec2)> {
    let inner = sketch.room.grown(-6.0);
    let near = eye + along * (sketch.room.center() - eye).dot(along);
    let forward = (near - eye).dot(along) >= 0.0;
    let from = if forward { near - reach * along } else { eye };
    inner.clip(from, near + reach * along)
}

/// The slabs of both axes, and the box where they meet.
fn sides(sketch: &mut Sketch<'_>, slabs: &Slabs, frame: &Frame) {
    let (theme, room) = (sketch.theme, sketch.room);
    let corner = |v: [f64; 3]| frame.at(DVec2::new(v[frame.axes[0]], v[frame.axes[1]]));
    let (low, high) = (corner(slabs.min), corner(slabs.max));
    let seen = |p: DVec2| p.clamp(room.min, room.max);
    for (k, axis) in frame.axes.into_iter().enumerate() {
        let hue = color(axis, theme);
        let band = match k {
            0 => [DVec2::new(low.x, room.min.y), DVec2::new(high.x, room.max.y)],
            _ => [DVec2::new(room.min.x, high.y), DVec2::new(room.max.x, low.y)],
        };
        let band = Rect { min: seen(band[0]), max: seen(band[1]) };
        sketch.drawing.fill(Path::rect(band), hue.fade(0.1));
        for (side, value) in [(low, slabs.min[axis]), (high, slabs.max[axis])] {
            let (a, b) = match k {
                0 => (DVec2::new(side.x, room.min.y), DVec2::new(side.x, room.max.y)),
                _ => (DVec2::new(room.min.x, side.y), DVec2::new(room.max.x, side.y)),
            };
            sketch.line(a, b, Pen::new(hue, 1.4).dashed(Dash::Short));
            side_name(sketch, axis, k, side, value);
        }
    }
    let rect = Rect { min: seen(DVec2::new(low.x, high.y)), max: seen(DVec2::new(high.x, low.y)) };
    sketch.drawing.fill(Path::rect(rect), theme.panel);
    sketch.drawing.stroke(Path::rect(rect), Pen::new(theme.ink, 2.0));
    let [a, b, c, d] = rect.corners();
    sketch.keep_off(&[a, b, c, d, a]);
}

/// Writes `x = -1` at an end of a side's line.
fn side_name(sketch: &mut Sketch<'_>, axis: usize, k: usize, side: DVec2, value: f64) {
    let room = sketch.room;
    let words = Words::default().tex(&format!("{} = {}", LETTERS[axis], tex(value)));
    let mut places = Vec::new();
    for aside in [4.0, -4.0] {
        let (align, level) = match aside > 0.0 {
            true => (Align::Start, Level::Top),
            false => (Align::End, Level::Baseline),
        };
        for step in 0..4 {
            let along = 4.0 + 20.0 * f64::from(step);
            let at = match k {
                0 => [DVec2::new(side.x + aside, room.max.y - along), DVec2::new(side.x + aside, room.min.y + along)],
                _ => [DVec2::new(room.max.x - along, side.y + aside), DVec2::new(room.min.x + along, side.y + aside)],
            };
            let anchors = match k {
                0 => [(align, Level::Baseline), (align, Level::Top)],
                _ => [(Align::End, level), (Align::Start, level)],
            };
            for (at, (align, level)) in at.into_iter().zip(anchors) {
                places.push(Placement { of: None, at, align, level });
            }
        }
    }
    let hue = color(axis, sketch.theme);
    sketch.want(words, hue, places, None);
}

/// The six places where the ray crosses the sides of a slab, as far as they are seen and do not stand in the break after
/// `from`.
fn crossings(sketch: &mut Sketch<'_>, slabs: &Slabs, frame: &Frame, from: Option<DVec2>) {
    let theme = sketch.theme;
    if frame.along(slabs) == DVec2::ZERO {
        return;
    }
    for axis in 0..3 {
        for leaving in [false, true] {
            let (Some(face), t) = (slabs.face(axis, leaving), slabs.spans[axis][usize::from(leaving)]) else {
                continue;
            };
            let at = frame.crossing(slabs, t);
            if !sketch.sees(at) || from.is_some_and(|from| at.distance(from) < 32.0) {
                continue;
            }
            let decides = (leaving && axis == slabs.exit) || (!leaving && axis == slabs.entry);
            sketch.disk(at, if decides { 4.5 } else { 3.0 }, color(axis, theme));
            sketch.name_in(at, Words::default().tex(&face_tex(face)), color(axis, theme));
        }
    }
}
