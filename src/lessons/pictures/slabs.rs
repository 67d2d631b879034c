//! Lesson 04: when a ray is between two lines, in a rectangle, in a box.

use glam::{DVec2, DVec3};

use super::view::{View, oblique};
use super::{Answer, Page, Shown};
use crate::lessons::{Aabb, Ray, shown};
use crate::pictures::diagrams::{Sketch, elided};
use crate::pictures::drawing::{Align, Color, Dash, Drawing, Level, Path, Pen, Rect, Text, Words};
use crate::pictures::theme::{Hue, Theme};

const LETTERS: [&str; 3] = ["x", "y", "z"];

fn color(axis: usize, theme: &Theme) -> Color {
    theme.hue([Hue::Blue, Hue::Purple, Hue::Amber][axis])
}

/// One coordinate of a ray over t, and the slab between two values of it.
pub fn slab(origin: f64, direction: f64, low: f64, high: f64, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "Upwards the coordinate o + t d, to the right t. The band is the slab.");
    let ends = |answer: &Answer| ["t_in", "t_out"].map(|name| answer.number(name));
    let right = ends(&what.expected);
    let wrong = what.wrong().map_or([None; 2], ends).map(|t| t.filter(|t| t.abs() < 60.0));
    let mut times = vec![-1.0, 1.0];
    times.extend(right.into_iter().flatten());
    times.extend(wrong.into_iter().flatten());
    let (first, last) = (times.iter().fold(0.0_f64, |m, t| m.min(*t)), times.iter().fold(0.0_f64, |m, t| m.max(*t)));
    let margin = 0.12 * (last - first);
    let (first, last) = (first - margin, last + margin);
    let at_t = |t: f64| origin + t * direction;
    let mut heights = vec![low, high, origin, at_t(1.0)];
    heights.extend(right.into_iter().chain(wrong).flatten().map(at_t).filter(|y| (y - origin).abs() < 60.0));
    let (bottom, top) =
        (heights.iter().fold(f64::MAX, |m, y| m.min(*y)), heights.iter().fold(f64::MIN, |m, y| m.max(*y)));
    let room = Rect { min: page.room.min + DVec2::new(20.0, 24.0), max: page.room.max - DVec2::new(20.0, 44.0) };
    let view = View::stretched(DVec2::new(first, bottom), DVec2::new(last, top), room);
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |t: f64, y: f64| view.at(DVec2::new(t, y));
    let (a, b) = (at(first, high), at(last, low));
    sketch.drawing.fill(Path::rect(Rect { min: a, max: b }), sketch.theme.hue(Hue::Sky).fade(0.16));
    for (y, words) in [(low, "low"), (high, "high")] {
        sketch.line(at(first, y), at(last, y), Pen::new(sketch.theme.axis, 1.3));
        sketch.name_in(at(first, y), format!("{words} {}", shown(y)), sketch.theme.muted);
    }
    sketch.line(at(0.0, bottom), at(0.0, top), sketch.guide());
    sketch.name_in(at(0.0, bottom), Words::default().tex("t = 0"), sketch.theme.muted);
    sketch.line(at(first, at_t(first)), at(0.0, origin), Pen { width: 1.4, ..given }.dashed(Dash::Short));
    sketch.line(at(0.0, origin), at(last, at_t(last)), given);
    sketch.dot(at(0.0, origin), given.color);
    sketch.name_in(at(0.0, origin), format!("o = {}", shown(origin)), given.color);
    for (t, name) in right.into_iter().zip([r"t_{\mathrm{in}}", r"t_{\mathrm{out}}"]) {
        let Some(t) = t else { continue };
        sketch.line(at(t, bottom), at(t, top), Pen { width: 1.8, ..green });
        sketch.disk(at(t, at_t(t)), 5.0, green.color);
        let words = Words::from("true ").tex(&format!("{name} = {}", shown(t)));
        sketch.name_in(at(t, at_t(t)), words, green.color);
    }
    for (t, name) in wrong.into_iter().zip([r"t_{\mathrm{in}}", r"t_{\mathrm{out}}"]) {
        let Some(t) = t else { continue };
        sketch.line(at(t, bottom), at(t, top), Pen { width: 1.8, ..red });
        let words = Words::from("your ").tex(&format!("{name} = {}", shown(t)));
        sketch.name_in(at(t, top), words, red.color);
    }
    sketch.finish();
    page.drawing
}

/// A ray and a rectangle in the plane, and the spans of t of its two slabs.
pub fn rectangle_span(origin: DVec2, direction: DVec2, min: DVec2, max: DVec2, what: &Shown) -> Drawing {
    let mut page = Page::new(
        what,
        "Above: the rectangle. Below: when the ray is in each slab; the rectangle is where it is in both.",
    );
    let lower = split(&mut page);
    let points: Vec<DVec2> = ends(&what.expected).into_iter().flatten().map(|t| origin + t * direction).collect();
    let wrong = what.wrong().map_or([None; 2], ends);
    let axes = [0, 1].map(|k| axis_span(origin[k], direction[k], min[k], max[k]));
    let mut crossings: Vec<(usize, f64)> = Vec::new();
    for (axis, span) in axes.iter().enumerate() {
        crossings.extend(span.iter().flatten().filter(|t| t.is_finite()).map(|t| (axis, *t)));
    }
    let wished = wrong.into_iter().flatten().chain(crossings.iter().map(|(_, t)| *t));
    let wished: Vec<DVec2> = wished.map(|t| origin + t * direction).collect();
    let needed = [min, max, origin, origin + direction].into_iter().chain(points.iter().copied()).collect::<Vec<_>>();
    let (view, _) = View::new(&needed, &wished, page.room);
    let given = page.given();
    let [green, red] = [page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    let room = sketch.room;
    for axis in 0..2 {
        let hue = color(axis, sketch.theme);
        let (low, high) = (at(min), at(max));
        let band = match axis {
            0 => Rect { min: DVec2::new(low.x, room.min.y), max: DVec2::new(high.x, room.max.y) },
            _ => Rect { min: DVec2::new(room.min.x, high.y), max: DVec2::new(room.max.x, low.y) },
        };
        let band = Rect { min: band.min.clamp(room.min, room.max), max: band.max.clamp(room.min, room.max) };
        sketch.drawing.fill(Path::rect(band), hue.fade(0.1));
    }
    let rect = Rect::around([at(min), at(max)]).unwrap_or(room);
    sketch.drawing.stroke(Path::rect(rect), Pen::new(sketch.theme.ink, 2.2));
    let [a, b, c, d] = rect.corners();
    sketch.keep_off(&[a, b, c, d, a]);
    the_ray(&mut sketch, at(origin), at(origin + direction), given);
    for (axis, t) in crossings {
        sketch.disk(at(origin + t * direction), 3.0, color(axis, sketch.theme));
    }
    marks(&mut sketch, &|t| at(origin + t * direction), ends(&what.expected), green, "true");
    marks(&mut sketch, &|t| at(origin + t * direction), wrong, red, "your");
    sketch.finish();
    bars(&mut page, lower, &axes, what);
    page.drawing
}

/// A ray and a box in space, and the spans of t of its three slabs.
pub fn box_span(ray: &Ray, aabb: &Aabb, what: &Shown) -> Drawing {
    let mut page = Page::new(
        what,
        "Above: in space, z towards you. Below: when the ray is in each slab; the box is where it is in all.",
    );
    let lower = split(&mut page);
    let corner = |i: u32| {
        let of = |k: u32, axis: usize| if i >> k & 1 == 0 { aabb.min[axis] } else { aabb.max[axis] };
        DVec3::new(of(0, 0), of(1, 1), of(2, 2))
    };
    let point = |t: f64| oblique(ray.at(t));
    let mut needed: Vec<DVec2> = (0..8).map(corner).map(oblique).collect();
    needed.extend([oblique(ray.origin), oblique(ray.origin + ray.direction)]);
    needed.extend(ends(&what.expected).into_iter().flatten().map(point));
    let wrong = what.wrong().map_or([None; 2], ends);
    let wished: Vec<DVec2> = wrong.into_iter().flatten().map(point).collect();
    let (view, _) = View::new(&needed, &wished, page.room);
    let given = page.given();
    let [green, red] = [page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    for i in 0..8u32 {
        for k in 0..3 {
            let j = i | 1 << k;
            if j != i {
                let (p, q) = (view.at(oblique(corner(i))), view.at(oblique(corner(j))));
                // The corner at the back, below, left is hidden.
                let hidden = i == 0;
                let pen = Pen::new(sketch.theme.ink, if hidden { 1.0 } else { 1.8 });
                sketch.line(p, q, if hidden { pen.dashed(Dash::Short) } else { pen });
            }
        }
    }
    the_ray(&mut sketch, view.at(oblique(ray.origin)), view.at(oblique(ray.origin + ray.direction)), given);
    marks(&mut sketch, &|t| view.at(point(t)), ends(&what.expected), green, "true");
    marks(&mut sketch, &|t| view.at(point(t)), wrong, red, "your");
    sketch.finish();
    let (o, d) = (ray.origin, ray.direction);
    let axes = [0, 1, 2].map(|k| axis_span(o[k], d[k], aabb.min[k], aabb.max[k]));
    bars(&mut page, lower, &axes, what);
    page.drawing
}

/// Both ends of a span, or a single t.
fn ends(answer: &Answer) -> [Option<f64>; 2] {
    match answer.number("t") {
        Some(t) => [Some(t), None],
        None => ["t_in", "t_out"].map(|name| answer.number(name)),
    }
}

/// Cuts the lower part off the room.
fn split(page: &mut Page) -> Rect {
    let mut lower = page.room;
    lower.min.y = lower.max.y - 156.0;
    page.room.max.y = lower.min.y - 8.0;
    lower
}

fn the_ray(sketch: &mut Sketch<'_>, eye: DVec2, tip: DVec2, pen: Pen) {
    let way = (tip - eye).normalize_or_zero();
    sketch.line(eye, eye - 3e3 * way, sketch.guide());
    sketch.line(eye, eye + 3e3 * way, Pen { width: 1.2, ..pen });
    sketch.arrow(eye, tip, pen);
    sketch.dot(eye, pen.color);
    sketch.name_in(eye, Words::default().tex(r"\mathbf{o}"), pen.color);
}

fn marks(sketch: &mut Sketch<'_>, at: &dyn Fn(f64) -> DVec2, times: [Option<f64>; 2], pen: Pen, whose: &str) {
    for (t, name) in times.into_iter().zip(["t_in", "t_out"]) {
        let Some(t) = t else { continue };
        sketch.disk(at(t), 5.0, pen.color);
        let words = if times[1].is_none() { format!("{whose} t") } else { format!("{whose} {name}") };
        sketch.name_in(at(t), words, pen.color);
    }
}

/// When a coordinate is between two values: nothing where never.
fn axis_span(origin: f64, direction: f64, low: f64, high: f64) -> Option<[f64; 2]> {
    if direction == 0.0 {
        return (low <= origin && origin <= high).then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let (a, b) = ((low - origin) / direction, (high - origin) / direction);
    Some([a.min(b), a.max(b)])
}

/// A bar for each slab over a common axis of t, and below them the answers.
fn bars(page: &mut Page, room: Rect, axes: &[Option<[f64; 2]>], what: &Shown) {
    let theme = page.theme;
    let finite = |t: &f64| t.is_finite() && t.abs() < 1e3;
    let right = ends(&what.expected);
    let wrong = what.wrong().map_or([None; 2], ends);
    let times: Vec<f64> = axes.iter().flatten().flatten().copied().filter(finite).collect();
    let low = times.iter().fold(-0.5_f64, |m, t| m.min(*t));
    let high = times.iter().fold(1.0_f64, |m, t| m.max(*t));
    let margin = 0.08 * (high - low);
    let (low, high) = (low - margin, high + margin);
    let (left, end) = (room.min.x + 128.0, room.max.x - 12.0);
    let at = |t: f64| left + (t.clamp(low, high) - low) / (high - low) * (end - left);
    let rows = axes.len() + 2;
    let step = (room.size().y - 26.0) / rows as f64;
    let y_of = |row: usize| room.min.y + step * (row as f64 + 0.5);
    let text = Text::new(12.5, theme.muted).anchor(Align::End, Level::Middle);
    let drawing = &mut page.drawing;
    let zero = at(0.0);
    drawing.line((zero, room.min.y), (zero, room.max.y - 20.0), Pen::new(theme.axis, 1.1).dashed(Dash::Short));
    drawing.text((zero, room.max.y - 4.0), Words::default().tex("t = 0"), text.anchor(Align::Middle, Level::Baseline));
    for (axis, span) in axes.iter().enumerate() {
        let hue = color(axis, theme);
        let y = y_of(axis);
        let told = match span {
            Some([a, b]) if a.is_finite() || b.is_finite() => {
                format!("{}: {} to {}", LETTERS[axis], shown(*a), shown(*b))
            }
            Some(_) => format!("{}: always", LETTERS[axis]),
            None => format!("{}: never", LETTERS[axis]),
        };
        drawing.text((left - 10.0, y), elided(&told, &text, left - 12.0 - room.min.x), text.color(hue));
        if let Some([a, b]) = span {
            let bar = Rect { min: DVec2::new(at(*a), y - 6.0), max: DVec2::new(at(*b).max(at(*a) + 1.0), y + 6.0) };
            drawing.fill(Path::rect(bar), hue.fade(0.75));
        }
    }
    let (green, red) = (page.theme.hue(Hue::Green), page.theme.hue(Hue::Vermilion));
    let answers = [(right, green, "true", true), (wrong, red, "yours", what.wrong().is_some())];
    for (i, ([first, second], hue, words, is_there)) in answers.into_iter().enumerate() {
        if !is_there {
            continue;
        }
        let y = y_of(axes.len() + i);
        drawing.text((left - 10.0, y), words, text.color(hue));
        match (first, second) {
            (Some(a), Some(b)) => {
                let (p, q) = (at(a.min(b)), at(a.max(b)));
                drawing.line((p, y), (q, y), Pen::new(hue, 3.0));
                for x in [at(a), at(b)] {
                    drawing.line((x, y - 7.0), (x, y + 7.0), Pen::new(hue, 3.0));
                }
                if a > b {
                    let start = text.color(hue).anchor(Align::Start, Level::Middle);
                    drawing.text((q + 12.0, y), "t_in > t_out", start);
                }
            }
            (Some(t), None) => drawing.disk((at(t), y), 5.0, hue),
            _ => {
                let told =
                    if matches!(if i == 0 { Some(&what.expected) } else { what.wrong() }, Some(Answer::Nothing(_))) {
                        "no hit"
                    } else {
                        "not to be drawn"
                    };
                drawing.text((left, y), told, text.color(hue).anchor(Align::Start, Level::Middle));
            }
        }
    }
}
