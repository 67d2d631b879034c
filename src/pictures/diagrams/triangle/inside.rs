//! A triangle in its own plane: the barycentric grid, the edges, and the weights as areas.

use glam::{DVec2, DVec3};

use crate::pictures::diagrams::numbers::tex;
use crate::pictures::diagrams::sketch::Sketch;
use crate::pictures::diagrams::subject::Subject;
use crate::pictures::drawing::{Color, Dash, Drawing, Path, Pen, Rect, Words};
use crate::pictures::theme::{Hue, Theme};

/// Where the corners and the point are on the canvas.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    corners: [DVec2; 3],
    /// The point, where it is seen.
    point: Option<DVec2>,
    /// Where the way to the point leaves the picture, where it is not, and its direction there.
    exit: Option<[DVec2; 2]>,
    is_stretched: bool,
}

/// The least height of a triangle over its longest edge, in units.
const LEAST: f64 = 96.0;

impl View {
    pub(super) fn new(vertices: [DVec3; 3], weights: Option<[f64; 3]>, room: Rect) -> Self {
        let flat = flatten(vertices);
        let size = flat[0].max(flat[1]).max(flat[2]) - flat[0].min(flat[1]).min(flat[2]);
        let all = |w: [f64; 3]| flat[0] * w[0] + flat[1] * w[1] + flat[2] * w[2];
        // A point far outside is only pointed at.
        let near = |w: [f64; 3]| w.iter().all(|x| (-1.6..=2.6).contains(x));
        let seen = weights.filter(|w| near(*w)).map(all);
        let points = flat.into_iter().chain(seen);
        let rect = Rect::around(points).unwrap_or(Rect { min: DVec2::ZERO, max: DVec2::ONE });
        let room = Rect { min: room.min + DVec2::new(26.0, 20.0), max: room.max - DVec2::new(26.0, 20.0) };
        let span = rect.size().max(size * 1e-9);
        let even = (room.size() / span).min_element();
        let mut scale = DVec2::splat(even);
        let is_stretched = size.y * even < LEAST.min(0.6 * room.size().y);
        if is_stretched {
            scale.y = (LEAST / size.y).max(even).min(room.size().y / span.y);
        }
        let place = |p: DVec2| {
            let off = (p - rect.center()) * scale;
            room.center() + DVec2::new(off.x, -off.y)
        };
        let corners = flat.map(place);
        let center = (corners[0] + corners[1] + corners[2]) / 3.0;
        let exit = weights.filter(|w| !near(*w)).and_then(|w| {
            // Relative to the centre, so that large weights do not cancel.
            let way: DVec2 = (0..3).map(|k| (w[k] - 1.0 / 3.0) * (corners[k] - center)).sum();
            let way = way.try_normalize()?;
            let (_, end) = room.clip(center, center + 3.0 * (room.size().x + room.size().y) * way)?;
            Some([end - 46.0 * way, end])
        });
        View { corners, point: seen.map(place), exit, is_stretched }
    }

    pub(super) fn remark(&self) -> String {
        let far = "The point is far outside: the arrow shows the way to it.";
        let all = [
            (self.is_stretched, "The triangle is drawn wider than it is: its areas keep their ratios."),
            (self.exit.is_some(), far),
        ];
        all.into_iter().filter(|(is, _)| *is).map(|(_, words)| words).collect::<Vec<_>>().join(" ")
    }
}

/// The corners in the plane of the triangle, its longest edge along x and the third corner above: lengths and angles are kept.
fn flatten(vertices: [DVec3; 3]) -> [DVec2; 3] {
    let length = |k: usize| (vertices[(k + 1) % 3] - vertices[k]).length();
    let longest = (0..3).fold(0, |best, k| if length(k) > length(best) { k } else { best });
    let (i, j, k) = (longest, (longest + 1) % 3, (longest + 2) % 3);
    let along = (vertices[j] - vertices[i]).normalize_or_zero();
    let third = vertices[k] - vertices[i];
    // By the cross product: a needle's height is the difference of nearly equal lengths.
    let up = along.cross(third).length();
    let mut flat = [DVec2::ZERO; 3];
    flat[j] = DVec2::new(length(i), 0.0);
    flat[k] = DVec2::new(along.dot(third), up);
    flat
}

/// The colours of the weights.
fn colors(theme: &Theme) -> [Color; 3] {
    [Hue::Sky, Hue::Amber, Hue::Purple].map(|hue| theme.hue(hue))
}

pub(super) fn draw(
    drawing: &mut Drawing,
    room: Rect,
    view: &View,
    weights: Option<[f64; 3]>,
    subject: &Subject<'_>,
    theme: &Theme,
) {
    let mut sketch = Sketch::new(drawing, room, theme);
    let v = view.corners;
    let colors = colors(theme);
    let is_inside = weights.is_some_and(|w| w.iter().all(|x| *x >= -1e-9));
    if let (Some(p), true) = (view.point, is_inside) {
        for k in 0..3 {
            let (next, last) = (v[(k + 1) % 3], v[(k + 2) % 3]);
            sketch.drawing.fill(Path::polygon([p, next, last]), colors[k].fade(0.34));
        }
    } else {
        sketch.drawing.fill(Path::polygon(v), theme.panel);
    }
    grid(&mut sketch, v);
    edges(&mut sketch, view, subject);
    let pen = theme.ray(subject.node.kind, 1.0);
    if let Some(p) = view.point {
        for corner in v {
            sketch.line(p, corner, Pen::new(theme.ink, 1.2).dashed(Dash::Short));
        }
        sketch.dot(p, pen.color);
        sketch.name_in(p, Words::default().tex(r"\mathbf{p}"), pen.color);
        shares(&mut sketch, view, p, weights, is_inside);
    }
    if let Some([from, to]) = view.exit {
        let center = (v[0] + v[1] + v[2]) / 3.0;
        sketch.faint(center, from, sketch.guide());
        sketch.broken(from - (to - from).normalize_or_zero() * 14.0, from, theme.axis);
        sketch.arrow(from, to, Pen::new(pen.color, 2.2));
        sketch.name_in(to, Words::from("to ").tex(r"\mathbf{p}"), pen.color);
    }
    for (k, corner) in v.into_iter().enumerate() {
        sketch.dot(corner, theme.ink);
        sketch.name(corner, Words::default().tex(&format!(r"\mathbf{{v}}_{k}")));
    }
    sketch.finish();
}

/// The lines on which a weight is a multiple of a fifth.
fn grid(sketch: &mut Sketch<'_>, v: [DVec2; 3]) {
    let pen = Pen::new(sketch.theme.axis.fade(0.55), 0.8);
    for k in 0..3 {
        let (next, last) = (v[(k + 1) % 3], v[(k + 2) % 3]);
        for i in 1..5 {
            let share = f64::from(i) / 5.0;
            sketch.faint(next.lerp(v[k], share), last.lerp(v[k], share), pen);
        }
    }
}

/// The edges as the vectors of the inside tests, those that fail in red.
fn edges(sketch: &mut Sketch<'_>, view: &View, subject: &Subject<'_>) {
    let theme = sketch.theme;
    let v = view.corners;
    let reason = subject.record.and_then(|r| r.reason.as_deref());
    let failed = match reason {
        Some("a < 0") => Some(0),
        Some("b < 0") => Some(1),
        Some("a + b > 1") => Some(2),
        _ => None,
    };
    for k in 0..3 {
        // The weight of a corner is decided by the edge across.
        let (from, to) = (v[(k + 1) % 3], v[(k + 2) % 3]);
        let is_failed = failed == Some(k);
        let pen = match is_failed {
            true => Pen::new(theme.hue(Hue::Vermilion), 3.2),
            false => Pen::new(theme.ink, 1.8),
        };
        sketch.ray(from, to, pen);
        if !is_failed {
            continue;
        }
        let letter = ["a", "b", "1-a-b"][k];
        sketch.beside(from, to, Words::default().tex(&format!("{letter} < 0")).then(" beyond"), pen.color);
        // How far beyond: at a right angle, where the picture is true.
        if let Some(p) = view.point.filter(|_| !view.is_stretched) {
            let along = (to - from).normalize_or_zero();
            let foot = from + along * (p - from).dot(along);
            sketch.faint(from, foot, sketch.guide());
            sketch.line(p, foot, Pen::new(pen.color, 1.8));
            if p.distance(foot) > 20.0 {
                sketch.drawing.right_angle(foot, along, p - foot, 8.0, Pen::new(theme.axis, 1.1));
            }
        }
    }
}

/// The values of the weights: in their areas where there is a hit, by the point where there is none.
fn shares(sketch: &mut Sketch<'_>, view: &View, p: DVec2, weights: Option<[f64; 3]>, is_inside: bool) {
    let Some(weights) = weights else { return };
    let v = view.corners;
    for k in 0..3 {
        let letter = ["a", "b", "1-a-b"][k];
        let words = Words::default().tex(&format!("{letter} = {}", tex(weights[k])));
        let (next, last) = (v[(k + 1) % 3], v[(k + 2) % 3]);
        let middle = (p + next + last) / 3.0;
        let at = if is_inside { middle } else { v[k].lerp(p, 0.3) };
        sketch.in_area(at, words, sketch.theme.ink);
    }
}
