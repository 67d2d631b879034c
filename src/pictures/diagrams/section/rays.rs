//! The rays of a section: lines by kind, marks where they end, and what they are called.

use glam::DVec2;

use super::plane::{Plane, Ray};
use super::window::Window;
use crate::input::printable;
use crate::pictures::diagrams::frame::{SMALL, elided, ring};
use crate::pictures::diagrams::labels::{Place, Taken, around, beside};
use crate::pictures::diagrams::numbers::{rough, shown};
use crate::pictures::drawing::{Color, Drawing, Path, Pen, Rect, Text};
use crate::pictures::theme::Theme;
use crate::tree::{Kind, Outcome};

/// How much of the ground is mixed into a ray that leaves the plane.
const PALE: f64 = 0.42;
/// How long a ray that was not traced is drawn.
const STUB: f64 = 30.0;

/// How many rays, the weightiest first, are named with their length; the others by their number alone, where there is room.
const SPELT_OUT: usize = 12;

/// A ray on the canvas.
struct Shown<'r, 't> {
    ray: &'r Ray<'t>,
    /// What is seen of it, from start to end.
    from: DVec2,
    to: DVec2,
    /// Whether its true end is seen.
    ends_here: bool,
    starts_here: bool,
    in_plane: bool,
}

pub(super) fn draw(
    drawing: &mut Drawing,
    window: &Window,
    plane: &Plane,
    rays: &[Ray<'_>],
    taken: &mut Taken,
    theme: &Theme,
) {
    let shown: Vec<Shown<'_, '_>> = rays.iter().filter_map(|ray| clip(window, plane, ray)).collect();
    // Light ones first, so that heavy ones lie on top.
    let mut order: Vec<&Shown<'_, '_>> = shown.iter().collect();
    order.sort_by(|a, b| a.ray.importance.total_cmp(&b.ray.importance));
    for ray in &order {
        drawing.about(&ray.ray.path, |drawing| line(drawing, ray, theme));
        taken.take_line(ray.from, ray.to);
    }
    for ray in order.iter().rev() {
        drawing.about(&ray.ray.path, |drawing| mark(drawing, plane, ray, taken, theme));
    }
    name_the_ends(drawing, &shown, taken, theme);
    for (rank, ray) in order.iter().rev().enumerate() {
        drawing.about(&ray.ray.path, |drawing| number(drawing, plane, ray, rank < SPELT_OUT, taken, theme));
    }
}

/// What is seen of a ray.
fn clip<'r, 't>(window: &Window, plane: &Plane, ray: &'r Ray<'t>) -> Option<Shown<'r, 't>> {
    let [start, mut end] = window.ends(plane, ray);
    if !ray.node.outcome.is_traced() {
        end = start + (end - start).normalize_or_zero() * STUB;
    }
    let (from, to) = window.frame.clip(start, end)?;
    let inside = |p: DVec2| window.frame.contains(Rect { min: p, max: p });
    let finite = ray.end.is_some() || !ray.node.outcome.is_traced();
    let in_plane = plane.contains_ray(ray);
    Some(Shown { ray, from, to, ends_here: finite && inside(end), starts_here: inside(start), in_plane })
}

fn color(ray: &Shown<'_, '_>, theme: &Theme) -> Color {
    let color = theme.ray(ray.ray.node.kind, 1.0).color;
    if ray.in_plane { color } else { color.mix(theme.background, PALE) }
}

fn line(drawing: &mut Drawing, ray: &Shown<'_, '_>, theme: &Theme) {
    let width = if ray.ray.node.kind == Kind::Shadow { 1.6 } else { 2.2 };
    let pen = Pen { color: color(ray, theme), ..theme.ray(ray.ray.node.kind, width) };
    let along = (ray.to - ray.from).normalize_or_zero();
    match (ray.ends_here, ray.ray.end) {
        // It goes on for ever: the head is at the frame.
        (false, None) => drawing.arrow(ray.from, ray.to, pen),
        (true, _) if ray.from.distance(ray.to) > 34.0 => drawing.directed(ray.from, ray.to, 0.55, pen),
        _ => drawing.line(ray.from, ray.to, pen),
    }
    // Two strokes where a ray with an end is cut off by the frame.
    let cuts = [(!ray.starts_here, ray.from, along), (!ray.ends_here && ray.ray.end.is_some(), ray.to, -along)];
    for (_, at, inward) in cuts.into_iter().filter(|(cut, ..)| *cut) {
        for gap in [6.0, 10.0] {
            let (middle, across) = (at + gap * inward, 5.0 * (inward.perp() + 0.4 * inward));
            drawing.line(middle - across, middle + across, Pen::new(theme.ink, 1.2));
        }
    }
}

/// Marks where a ray ends: a dot for a hit, a bar where it was not traced, hollow off the plane.
fn mark(drawing: &mut Drawing, plane: &Plane, ray: &Shown<'_, '_>, taken: &mut Taken, theme: &Theme) {
    let own = theme.ray(ray.ray.node.kind, 1.0).color;
    let around = |at: DVec2, r: f64| Rect { min: at, max: at }.grown(r);
    if ray.ends_here && !ray.ray.node.outcome.is_traced() {
        let across = 4.5 * (ray.to - ray.from).normalize_or_zero().perp();
        drawing.line(ray.to - across, ray.to + across, Pen::new(own, 2.0));
        taken.take(around(ray.to, 5.0));
    } else if let (true, Some(end)) = (ray.ends_here, ray.ray.end) {
        match ray.ray.node.outcome {
            Outcome::Lit => {}
            _ if plane.contains(end) => drawing.disk(ray.to, 3.4, theme.ink),
            _ => ring(drawing, ray.to, 3.6, own, theme),
        }
        taken.take(around(ray.to, 4.5));
    }
}

/// The eye and the lights: signs and names, or names alone at the frame where they lie beyond it.
fn name_the_ends(drawing: &mut Drawing, rays: &[Shown<'_, '_>], taken: &mut Taken, theme: &Theme) {
    let text = Text::new(SMALL, theme.ink);
    for ray in rays.iter().filter(|ray| ray.ray.node.kind == Kind::Camera) {
        let words = if ray.starts_here { "eye" } else { "from the eye" };
        if ray.starts_here {
            eye(drawing, ray.from, (ray.to - ray.from).normalize_or(DVec2::X), theme);
            taken.take(Rect { min: ray.from, max: ray.from }.grown(9.0));
        }
        let places = end_places(ray.from, ray.to);
        taken.write(drawing, words, text, &places, true);
    }
    let mut named: Vec<(&str, DVec2)> = Vec::new();
    for ray in rays.iter().filter(|ray| ray.ray.node.outcome == Outcome::Lit) {
        let Some(light) = ray.ray.node.light.as_deref() else { continue };
        if named.iter().any(|(name, at)| *name == light && at.distance(ray.to) < 60.0) {
            continue;
        }
        named.push((light, ray.to));
        let name = elided(&printable(light), &text, 120.0);
        if ray.ends_here {
            lamp(drawing, ray.to, theme);
            taken.take(Rect { min: ray.to, max: ray.to }.grown(9.0));
        }
        let words = if ray.ends_here { name } else { format!("to {name}") };
        taken.write(drawing, words, text, &end_places(ray.to, ray.from), true);
    }
}

/// Places for the name of an end, away from the ray.
fn end_places(end: DVec2, other: DVec2) -> Vec<Place> {
    let away = (end - other).normalize_or(DVec2::X);
    let mut places = around(end, 13.0, 6);
    places.sort_by(|a, b| {
        let cost = |p: &Place| p.0.distance(end) - 6.0 * (p.0 - end).normalize_or_zero().dot(away);
        cost(a).total_cmp(&cost(b))
    });
    places
}

/// Writes a ray's number and, spelt out, its length and how far off the plane it ends.
fn number(
    drawing: &mut Drawing,
    plane: &Plane,
    ray: &Shown<'_, '_>,
    is_spelt_out: bool,
    taken: &mut Taken,
    theme: &Theme,
) {
    let node = ray.ray.node;
    let text = Text::new(SMALL, theme.ray(node.kind, 1.0).color);
    let mut words = ray.ray.number.to_string();
    if !is_spelt_out {
        let places = beside(ray.from, ray.to, 6.0);
        taken.write(drawing, words, text, &places, false);
        return;
    }
    if let Some(hit) = &node.hit {
        words += &format!(": t {}", shown(hit.t));
    }
    let full = match ray.ray.end {
        Some(end) if !plane.contains(end) => {
            let height = plane.height(end);
            format!("{words}, {} {}", rough(height.abs()), if height > 0.0 { "in front" } else { "behind" })
        }
        _ => words.clone(),
    };
    let mut places = beside(ray.from, ray.to, 6.0);
    places.extend(beside(ray.from, ray.to, 16.0));
    places.extend(around(ray.from.lerp(ray.to, 0.5), 14.0, 5));
    let long = ray.from.distance(ray.to) > 12.0;
    for (words, needed) in [(full, false), (words.clone(), false), (words, true)] {
        if let Some(rect) = taken.write(drawing, words, text, &places, needed && long) {
            let pen = Pen::new(text.color.mix(theme.background, 0.3), 0.8);
            taken.lead(drawing, nearest(ray.from, ray.to, rect.center()), rect, 15.0, pen);
            return;
        }
    }
}

/// The point of a segment nearest to `p`.
fn nearest(a: DVec2, b: DVec2, p: DVec2) -> DVec2 {
    let way = b - a;
    let share = (p - a).dot(way) / way.length_squared().max(1e-12);
    a + share.clamp(0.0, 1.0) * way
}

/// An eye that looks along `way`.
fn eye(drawing: &mut Drawing, at: DVec2, way: DVec2, theme: &Theme) {
    let back = at - 11.0 * way;
    let across = 6.5 * way.perp();
    let pen = Pen::new(theme.ink, 1.5);
    drawing.stroke(Path::open([at + across * 0.9, back, at - across * 0.9]), pen);
    drawing.stroke(Path::circle(at - 2.5 * way, 4.2), pen);
    drawing.disk(at - 0.8 * way, 1.9, theme.ink);
}

/// A light.
fn lamp(drawing: &mut Drawing, at: DVec2, theme: &Theme) {
    let color = theme.ray(Kind::Shadow, 1.0).color;
    drawing.disk(at, 4.6, color);
    for i in 0..8 {
        let angle = f64::from(i) * std::f64::consts::FRAC_PI_4;
        let way = DVec2::new(libm::cos(angle), libm::sin(angle));
        drawing.line(at + 6.6 * way, at + 9.4 * way, Pen::new(color, 1.5));
    }
}
