//! A ray and a plane in Hesse normal form, from the side, with the heights along the normal at a ruler.

use glam::{DVec2, DVec3};

use super::formulas::{Line, column, operand, triple};
use super::frame;
use super::numbers::tex;
use super::side::{self, Placed, Side};
use super::sketch::{Sketch, beside, note};
use super::subject::subject;
use super::{Input, Kind, NotApplicable};
use crate::pictures::drawing::{Drawing, Pen, Rect, Words};
use crate::pictures::theme::{Hue, Theme};
use crate::scene::Shape;

/// The room that the ruler takes at the left.
const RULER: f64 = 150.0;

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let subject = subject(input, Kind::Plane, |shape| matches!(shape, Shape::Plane { .. }))?;
    let Shape::Plane { normal, distance } = *subject.shape else {
        return Err(NotApplicable { kind: Kind::Plane, why: "what is chosen is no plane".into() });
    };
    let node = subject.node;
    let n_dot_o = subject.number("n_dot_o").unwrap_or_else(|| normal.dot(DVec3::from(node.origin)));
    let about = "From the side, in the plane of ray and normal; heights along the normal at the left.";
    let (mut drawing, room) = frame::begin(input.size, &subject.title, about, theme);
    let [left, right] = beside(room, 0.36);
    let side = Side::new(node, normal, n_dot_o - distance, subject.t());
    let ruler = RULER.min(0.32 * left.size().x);
    let view = |room: Rect| Rect { min: DVec2::new(room.min.x + ruler, room.min.y), ..room };
    let placed = Placed::new(&side, view(left));
    let is_broken = Ruler::new(&placed, view(left), distance).is_broken;
    let left = note(&mut drawing, left, &remark(placed.is_stretched, is_broken), theme);
    let placed = Placed::new(&side, view(left));

    let mut sketch = Sketch::new(&mut drawing, view(left), theme);
    side::draw(&mut sketch, &side, &placed, node, true);
    if let (Some(hit), Some(t)) = (placed.hit, subject.t()) {
        let words = Words::default().tex(&format!("t = {}", tex(t)));
        sketch.beside(placed.eye, hit, words, theme.ray(node.kind, 1.0).color);
    }
    sketch.room = left;
    heights(&mut sketch, &placed, [distance, n_dot_o], ruler);
    sketch.finish();

    let mut lines = vec![
        Line::heading("the plane in Hesse normal form"),
        Line::formula(r"\mathbf{n}\cdot\mathbf{p} = D"),
        Line::formula(&format!(r"\mathbf{{n}} = {}", triple(normal.to_array()))),
        Line::formula(&format!("D = {}", tex(distance))),
        Line::heading("the ray"),
        Line::formula(r"\mathbf{p} = \mathbf{o} + t\,\mathbf{d}"),
        Line::formula(&format!(r"\mathbf{{o}} = {}", triple(node.origin))),
        Line::formula(&format!(r"\mathbf{{d}} = {}", triple(node.direction))),
        Line::heading("one in the other"),
        Line::result(r"t = \frac{D - \mathbf{n}\cdot\mathbf{o}}{\mathbf{n}\cdot\mathbf{d}}"),
    ];
    if let Some(n_dot_d) = subject.number("n_dot_d") {
        let value = subject.t().map_or(String::new(), |t| format!(" = {}", tex(t)));
        let fraction = format!(r"\frac{{{} - {}}}{{{}}}", tex(distance), operand(n_dot_o), tex(n_dot_d));
        lines.push(Line::result(&format!(r"\phantom{{t}} = {fraction}{value}")));
    }
    if let Some(hit) = subject.hit {
        lines.push(Line::formula(&format!(r"\mathbf{{p}} = {}", triple(hit.point))));
    }
    let (yes, words) = subject.verdict();
    lines.push(Line::verdict((yes, words.clone())));
    column(&mut drawing, right, &lines, theme);
    let t = subject.t().map_or("no t".to_owned(), |t| format!("t = {}", super::shown(t)));
    drawing.describe(format!("A ray and a plane from the side: {t}, {words}."));
    Ok(drawing)
}

/// What is not as it looks.
fn remark(is_stretched: bool, is_broken: bool) -> String {
    let stretched = "Heights are enlarged, so angles are not true.";
    let broken = "The ruler is broken at the marks: not to scale there.";
    let all = [(is_stretched, stretched), (is_broken, broken)];
    all.into_iter().filter(|(is, _)| *is).map(|(_, words)| words).collect::<Vec<_>>().join(" ")
}

/// Where the height 0, that of the world's origin, stands.
struct Ruler {
    origin: f64,
    is_broken: bool,
}

impl Ruler {
    fn new(placed: &Placed, room: Rect, distance: f64) -> Self {
        let origin = placed.ground + placed.down(-distance);
        let (top, bottom) = (room.min.y + 14.0, room.max.y - 14.0);
        Ruler { origin: origin.clamp(top, bottom), is_broken: !(top <= origin && origin <= bottom) }
    }
}

/// Draws the ruler along the normal: the height of the world's origin, of the plane, of the ray's origin.
fn heights(sketch: &mut Sketch<'_>, placed: &Placed, [distance, n_dot_o]: [f64; 2], width: f64) {
    let theme = sketch.theme;
    let room = sketch.room;
    let Ruler { origin, is_broken } = Ruler::new(placed, room, distance);
    let (ground, eye) = (placed.ground, placed.eye.y);
    let axis = room.min.x + 0.8 * width;
    sketch.line(DVec2::new(axis, ground), DVec2::new(room.min.x + width, ground), sketch.guide());
    let purple = theme.hue(Hue::Purple);
    let pen = Pen::new(theme.axis, 1.2);
    let [low, high] = [origin.max(ground).max(eye), origin.min(ground).min(eye)];
    let (low, high) = ((low + 34.0).min(room.max.y), (high - 40.0).max(room.min.y));
    sketch.arrow(DVec2::new(axis, low), DVec2::new(axis, high), pen);
    let guide = sketch.guide();
    sketch.line(DVec2::new(axis, eye), placed.eye, guide);
    if (origin - ground).abs() > 3.0 {
        let end = DVec2::new(room.min.x + width + 40.0, origin);
        sketch.line(DVec2::new(axis, origin), end, guide);
    }
    let level = |y: f64| DVec2::new(axis, y);
    for y in [ground, eye] {
        sketch.drawing.line(level(y) - DVec2::X * 5.0, level(y) + DVec2::X * 5.0, Pen::new(theme.ink, 1.4));
    }
    let mut span = |to: f64, aside: f64, words: Words, color| {
        let (a, b) = (level(origin), level(to));
        if (origin - to).abs() < 2.0 {
            sketch.name_in(b - DVec2::X * 6.0, words, color);
            return;
        }
        // Always to the left.
        let aside = if to < origin { -aside } else { aside };
        sketch.length(a, b, aside, words, color);
    };
    span(ground, 0.34 * width, Words::default().tex(&format!("D = {}", tex(distance))), purple);
    let words = Words::default().tex(&format!(r"\mathbf{{n}}\cdot\mathbf{{o}} = {}", tex(n_dot_o)));
    span(eye, 0.14 * width, words, theme.ink);
    if is_broken {
        // Between the world's origin and what is nearest to it.
        let near = if origin > ground.max(eye) { ground.max(eye) } else { ground.min(eye) };
        let middle = origin + 0.35 * (near - origin);
        for x in [axis, axis - 0.34 * width, axis - 0.14 * width] {
            let at = DVec2::new(x, middle);
            sketch.broken(at - DVec2::Y, at + DVec2::Y, theme.axis);
        }
    }
    sketch.dot(level(origin), theme.ink);
    sketch.name(level(origin), Words::default().tex("0"));
}
