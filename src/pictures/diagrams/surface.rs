//! What a surface does to a ray, in the plane of incidence: angles, media, Snell's law, Fresnel's split, total reflection.

use glam::{DVec2, DVec3};

use super::formulas::{Line, column};
use super::frame;
use super::numbers::tex;
use super::sketch::{Sketch, beside};
use super::subject::ray_name;
use super::{Input, Kind, NotApplicable};
use crate::input::printable;
use crate::pictures::drawing::{Align, Color, Dash, Drawing, Face, Level, Path, Pen, Rect, Text, Words};
use crate::pictures::theme::{Hue, Theme};
use crate::tree::{HitRecord, Kind as RayKind, RayNode};

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let refuse = |why: &str| NotApplicable { kind: Kind::Surface, why: why.to_owned() };
    let node = input.node;
    let hit = node.hit.as_ref().ok_or_else(|| refuse("the ray hits nothing"))?;
    let incidence = Incidence::new(node, hit).ok_or_else(|| refuse("the surface sends no ray on"))?;
    let name = hit.object.as_deref().map_or_else(|| format!("object {}", hit.shape), |name| printable(name).into());
    let name = super::subject::short(&name);
    let title = format!("{} at the surface of “{name}”", ray_name(input));
    let about = "The plane of incidence; angles are true, lengths say nothing.";
    let (mut drawing, room) = frame::begin(input.size, &title, about, theme);
    let [left, right] = beside(room, 0.36);
    let bars = Rect { min: DVec2::new(left.min.x, left.max.y - 66.0), ..left };
    let upper = Rect { max: DVec2::new(left.max.x, bars.min.y - 10.0), ..left };
    picture(&mut drawing, upper, &incidence, theme);
    split(&mut drawing, bars, node, theme);
    column(&mut drawing, right, &lines(&incidence), theme);
    drawing.describe(match incidence.node.total_reflection {
        true => "A ray and a surface that reflects it totally.",
        false => "A ray and a surface with the rays that go on from it.",
    });
    Ok(drawing)
}

/// A ray at a surface. Angles are in radians, from the normal.
#[derive(Clone, Copy, Debug)]
struct Incidence<'a> {
    node: &'a RayNode,
    /// Of incidence, and of the reflected and the refracted ray.
    first: f64,
    reflected: Option<f64>,
    second: Option<f64>,
    /// Indices of refraction on both sides, where light may pass from one into the other or a coat splits it.
    ior: Option<[f64; 2]>,
    /// Whether anything passes, or would.
    is_opaque: bool,
    /// How far the true normal is turned from the one that is shaded with, to the right; where that is seen.
    tilt: Option<f64>,
}

impl<'a> Incidence<'a> {
    /// Nothing where no ray goes on.
    fn new(node: &'a RayNode, hit: &'a HitRecord) -> Option<Self> {
        if node.reflected.is_none() && node.refracted.is_none() {
            return None;
        }
        let n = DVec3::from(hit.shading_normal.unwrap_or(hit.geometric_normal));
        let d = DVec3::from(node.direction);
        let angle = |v: DVec3, from: DVec3| libm::atan2(v.cross(from).length(), v.dot(from));
        let direction = |child: &Option<Box<RayNode>>| child.as_ref().map(|child| DVec3::from(child.direction));
        let is_opaque = node.refracted.is_none() && !node.total_reflection;
        let ior = hit.ior.filter(|_| !is_opaque || node.fresnel.is_some());
        let right = (d - n * d.dot(n)).try_normalize();
        let tilt = right.and_then(|right| {
            let true_normal = DVec3::from(hit.geometric_normal);
            let turned = if true_normal.dot(n) < 0.0 { -true_normal } else { true_normal };
            let tilt = libm::atan2(turned.dot(right), turned.dot(n));
            (tilt.abs() > 0.03).then_some(tilt)
        });
        Some(Incidence {
            node,
            first: angle(-d, n),
            reflected: direction(&node.reflected).map(|r| angle(r, n)),
            second: direction(&node.refracted).map(|r| angle(r, -n)),
            ior,
            is_opaque,
            tilt,
        })
    }

    /// The angle from which on everything is reflected.
    fn critical(&self) -> Option<f64> {
        let [incident, transmitted] = self.ior.filter(|_| !self.is_opaque)?;
        (incident > transmitted).then(|| libm::asin(transmitted / incident))
    }
}

/// A unit vector so many radians from `up`, towards positive x.
fn turned(angle: f64, up: f64) -> DVec2 {
    DVec2::new(libm::sin(angle), -up * libm::cos(angle))
}

/// An angle in degrees, in TeX.
fn degrees(angle: f64) -> String {
    format!(r"{}^\circ", tex(angle.to_degrees()))
}

fn picture(drawing: &mut Drawing, room: Rect, incidence: &Incidence<'_>, theme: &Theme) {
    let Incidence { node, first, .. } = *incidence;
    // Below a surface that nothing passes there is nothing to be seen.
    let share = if incidence.is_opaque { 0.84 } else { 0.52 };
    let at = DVec2::new(room.center().x, room.min.y + share * room.size().y);
    let reach = ((share - 0.06) * room.size().y).min(0.47 * room.size().x);
    ground(drawing, room, at, incidence, theme);
    let mut sketch = Sketch::new(drawing, room, theme);
    let edge = |x: f64| DVec2::new(x, at.y);
    sketch.line(edge(room.min.x), edge(room.max.x), Pen::new(theme.ink, 1.8));
    let purple = theme.hue(Hue::Purple);
    let guide = sketch.guide();
    let below = DVec2::new(at.x, (at.y + 0.92 * reach).min(room.max.y - 4.0));
    sketch.line(at, below, guide);
    sketch.arrow(at, at - DVec2::new(0.0, 0.92 * reach), Pen::new(purple, 2.0));
    sketch.name_in(at - DVec2::new(0.0, 0.92 * reach), Words::default().tex(r"\mathbf{n}"), purple);
    if let Some(tilt) = incidence.tilt {
        let tip = at + 0.7 * reach * turned(tilt, 1.0);
        sketch.arrow(at, tip, Pen::new(theme.muted, 1.4).dashed(Dash::Short));
        sketch.name_in(tip, "normal of the triangle", theme.muted);
    }
    if let Some(critical) = incidence.critical() {
        let way = turned(-critical, 1.0);
        sketch.line(at, at + 0.86 * reach * way, Pen::new(theme.muted, 1.3).dashed(Dash::Short));
        let words = Words::default().tex(r"\theta_c");
        let middle = sketch.drawing.angle(at, DVec2::NEG_Y, way, 0.7 * reach, Pen::new(theme.muted, 1.3));
        sketch.keep_off_arc(at, DVec2::NEG_Y, way, 0.7 * reach);
        sketch.name_without_line(middle, words, theme.muted);
    }
    let pen = theme.ray(node.kind, 3.0);
    let from = turned(-first, 1.0);
    sketch.ray(at + reach * from, at, pen);
    arc(&mut sketch, at, DVec2::NEG_Y, from, 0.4 * reach, (r"\theta_1", first), pen.color);
    if let Some(angle) = incidence.reflected {
        let pen = theme.ray(RayKind::Reflected, 3.0);
        let way = turned(angle, 1.0);
        sketch.arrow(at, at + reach * way, pen);
        // The reflected angle is the other, but for rounding.
        arc(&mut sketch, at, DVec2::NEG_Y, way, 0.4 * reach, (r"\theta_1'", angle), pen.color);
        sketch.beside(at + 0.55 * reach * way, at + reach * way, "reflected", pen.color);
    }
    if let Some(angle) = incidence.second {
        let pen = theme.ray(RayKind::Refracted, 3.0);
        let way = turned(angle, -1.0);
        sketch.arrow(at, at + reach * way, pen);
        arc(&mut sketch, at, DVec2::Y, way, 0.4 * reach, (r"\theta_2", angle), pen.color);
        sketch.beside(at + 0.55 * reach * way, at + reach * way, "refracted", pen.color);
    }
    sketch.beside(at + reach * from, at + 0.55 * reach * from, frame::kind_name(node.kind), pen.color);
    sketch.dot(at, theme.ink);
    sketch.name(at, Words::default().tex(r"\mathbf{p}"));
    sketch.finish();
}

/// The media, or what no light gets into.
fn ground(drawing: &mut Drawing, room: Rect, at: DVec2, incidence: &Incidence<'_>, theme: &Theme) {
    let lower = Rect { min: DVec2::new(room.min.x, at.y), ..room };
    let upper = Rect { max: DVec2::new(room.max.x, at.y), ..room };
    if incidence.is_opaque {
        drawing.ground((room.min.x, at.y), (room.max.x, at.y), 14.0, Pen::new(theme.axis, 0.8));
    }
    let Some([incident, transmitted]) = incidence.ior else { return };
    let denser = if incident > transmitted { upper } else { lower };
    if incident != transmitted && !incidence.is_opaque {
        drawing.fill(Path::rect(denser), theme.hue(Hue::Sky).fade(0.13));
    }
    // In the corners, where no ray gets to.
    let text = Text::new(14.0, theme.ink).anchor(Align::End, Level::Top);
    let corner = DVec2::new(room.max.x - 8.0, room.min.y + 12.0);
    drawing.text(corner, Words::default().tex(&format!("n_1 = {}", tex(incident))), text);
    let (corner, level) = match incidence.is_opaque {
        true => (DVec2::new(corner.x, at.y + 22.0), Level::Top),
        false => (DVec2::new(corner.x, room.max.y - 12.0), Level::Baseline),
    };
    let words = Words::default().tex(&format!("n_2 = {}", tex(transmitted)));
    drawing.text(corner, words, text.anchor(Align::End, level));
}

/// An angle with its arc and its value.
fn arc(sketch: &mut Sketch<'_>, at: DVec2, up: DVec2, way: DVec2, radius: f64, what: (&str, f64), color: Color) {
    let (letter, angle) = what;
    let middle = sketch.drawing.angle(at, up, way, radius, Pen::new(color, 1.4));
    sketch.keep_off_arc(at, up, way, radius);
    sketch.name_without_line(middle, Words::default().tex(&format!("{letter} = {}", degrees(angle))), color);
}

/// How the light is split: a bar each.
fn split(drawing: &mut Drawing, room: Rect, node: &RayNode, theme: &Theme) {
    let largest = |w: [f64; 3]| w.into_iter().fold(0.0, f64::max);
    let share = |child: &RayNode| {
        let (own, parent) = (child.weight.map(largest)?, node.weight.map(largest)?);
        (parent > 0.0).then(|| own / parent)
    };
    let passes = node.refracted.is_some() || node.total_reflection;
    let second = if passes { "refracted" } else { "not reflected" };
    let rows = [
        ("reflected", RayKind::Reflected, node.reflected.as_deref(), node.fresnel, "R"),
        (second, RayKind::Refracted, node.refracted.as_deref(), node.fresnel.map(|r| 1.0 - r), "1 - R"),
    ];
    let count = if passes || node.fresnel.is_some() { 2 } else { 1 };
    let text = Text::new(12.0, theme.ink).anchor(Align::Start, Level::Middle);
    let names = 86.0;
    let values = 0.44 * room.size().x;
    let full = room.size().x - names - values - 12.0;
    let caption = if node.fresnel.is_some() { "Fresnel's split of the light" } else { "how the light is split" };
    drawing.text(room.min + DVec2::new(0.0, 9.0), caption, text.face(Face::Bold).anchor(Align::Start, Level::Baseline));
    for (i, (name, kind, child, fresnel, letters)) in rows.into_iter().take(count).enumerate() {
        let y = room.min.y + 30.0 + 24.0 * i as f64;
        let color = if i == 1 && !passes { theme.muted } else { theme.ray(kind, 1.0).color };
        drawing.text((room.min.x, y), name, text.color(color));
        let bar = Rect::new((room.min.x + names, y - 7.0), (full, 14.0));
        drawing.fill(Path::rect(bar), theme.panel);
        let part = fresnel.or_else(|| child.and_then(share)).unwrap_or(0.0).clamp(0.0, 1.0);
        let filled = Rect { max: DVec2::new(bar.min.x + full * part, bar.max.y), ..bar };
        if part > 0.0 {
            drawing.fill(Path::rect(filled), color);
        }
        drawing.stroke(Path::rect(bar), Pen::new(theme.axis, 1.0));
        let weight = match child.and_then(|child| child.weight) {
            Some([r, g, b]) if r == g && g == b => format!(r"\quad w = {}", tex(r)),
            Some(w) => format!(r"\quad w = {}", super::formulas::triple(w)),
            None => String::new(),
        };
        let words = match (fresnel, child) {
            (Some(part), _) => format!("{letters} = {}{weight}", tex(part)),
            (None, Some(_)) => weight.trim_start_matches(r"\quad ").to_owned(),
            (None, None) => r"\text{none}".to_owned(),
        };
        let words = Words::default().tex(&words);
        let fits = (values / text.width(words.clone()).max(1.0)).min(1.0);
        drawing.text((bar.max.x + 12.0, y), words, Text { size: text.size * fits, ..text });
    }
}

fn lines(incidence: &Incidence<'_>) -> Vec<Line> {
    let node = incidence.node;
    let first = incidence.first;
    let mut lines = vec![
        Line::heading("the law of reflection"),
        Line::formula(r"\mathbf{r} = \mathbf{d} - 2\,(\mathbf{d}\cdot\mathbf{n})\,\mathbf{n}"),
    ];
    if let Some(angle) = incidence.reflected {
        lines.push(Line::result(&format!(r"\theta_1' = {} = \theta_1", degrees(angle))));
    } else {
        lines.push(Line::result(&format!(r"\theta_1 = {}", degrees(first))));
    }
    let Some([incident, transmitted]) = incidence.ior.filter(|_| !incidence.is_opaque) else {
        let words = if node.fresnel.is_some() { "a clear coat: nothing passes it" } else { "no light passes here" };
        lines.push(Line::heading(words));
        return lines;
    };
    lines.push(Line::heading("Snell's law"));
    lines.push(Line::formula(r"n_1 \sin\theta_1 = n_2 \sin\theta_2"));
    let side = |n: f64, angle: f64| format!(r"{} \cdot \sin {}", tex(n), degrees(angle));
    if let Some(second) = incidence.second {
        lines.push(Line::result(&format!(r"{} = {}", side(incident, first), side(transmitted, second))));
        lines.push(Line::result(&format!(r"\theta_2 = {}", degrees(second))));
    }
    if node.total_reflection {
        let sine = incident / transmitted * libm::sin(first);
        let form = r"\sin\theta_2 = \frac{n_1}{n_2}\,\sin\theta_1";
        let value = match tex(sine) {
            // So little more than 1 that it does not show, or that only exact arithmetic can tell.
            one if one == "1" && sine > 1.0 => format!("1 + {}", tex(sine - 1.0)),
            one if one == "1" || sine < 1.0 => r"1 + \varepsilon".to_owned(),
            value => value,
        };
        lines.push(Line::result(&format!("{form} = {value} > 1")));
    }
    if let Some(critical) = incidence.critical() {
        lines.push(Line::heading("the critical angle"));
        let form = r"\theta_c = \arcsin\frac{n_2}{n_1}";
        lines.push(Line::result(&format!("{form} = {}", degrees(critical))));
        let relation = if node.total_reflection { ">" } else { r"\le" };
        lines.push(Line::formula(&format!(r"\theta_1 {relation} \theta_c")));
    }
    if let Some(r) = node.fresnel {
        lines.push(Line::heading("Fresnel's reflectance"));
        lines.push(Line::result(&format!("R = {}", tex(r))));
    }
    let words = if node.total_reflection { "total reflection" } else { "light passes" };
    lines.push(Line::sentence(words));
    lines
}
