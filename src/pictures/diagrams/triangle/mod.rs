//! A ray and a triangle: from the side, and in the triangle's own plane with the barycentric coordinates as areas.

mod inside;

use glam::{DVec2, DVec3};

use super::formulas::{Line, column, operand, triple};
use super::frame;
use super::numbers::tex;
use super::side::{self, Placed, Side};
use super::sketch::{Sketch, beside, note};
use super::subject::{Subject, subject};
use super::{Input, Kind, NotApplicable};
use crate::kernels::{Triangle, triangle_normal};
use crate::pictures::drawing::{Drawing, Pen, Rect, Words};
use crate::pictures::theme::{Hue, Theme};
use crate::scene::Shape;

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let refuse = |why: &str| NotApplicable { kind: Kind::Triangle, why: why.to_owned() };
    let is_flat = |shape: &Shape| matches!(shape, Shape::Triangle { .. } | Shape::Mesh(_));
    let subject = subject(input, Kind::Triangle, is_flat)?;
    let vertices = match subject.shape {
        Shape::Triangle { vertices } => Some(*vertices),
        Shape::Mesh(mesh) => subject.primitive.and_then(|i| mesh.triangles.get(i as usize).copied()),
        _ => None,
    };
    let vertices = vertices.ok_or_else(|| refuse("the mesh has no such triangle"))?;
    let unit = triangle_normal(&Triangle::<f64> { vertices });
    if unit == DVec3::ZERO {
        return Err(refuse("the triangle has no area, and so lies in no one plane"));
    }
    let weights = weights(&subject);
    let about = "Above: the triangle in its own plane, the weights as areas. Below: ray and plane from the side.";
    let (mut drawing, room) = frame::begin(input.size, &subject.title, about, theme);
    let [left, right] = beside(room, 0.36);
    let middle = left.min.y + 0.64 * left.size().y;
    let upper = Rect { max: DVec2::new(left.max.x, middle - 10.0), ..left };
    let lower = Rect { min: DVec2::new(left.min.x, middle), ..left };

    let view = inside::View::new(vertices, weights, upper);
    let upper = note(&mut drawing, upper, &view.remark(), theme);
    let view = inside::View::new(vertices, weights, upper);
    inside::draw(&mut drawing, upper, &view, weights, &subject, theme);
    from_the_side(&mut drawing, lower, vertices, unit, &subject, theme);
    column(&mut drawing, right, &lines(&subject, vertices, weights), theme);
    drawing.describe(format!("A ray and a triangle in its own plane and from the side: {}.", subject.verdict().1));
    Ok(drawing)
}

/// The weights of v0, v1, v2 at the point where the ray meets the plane.
fn weights(subject: &Subject<'_>) -> Option<[f64; 3]> {
    if let Some(of_hit) = subject.hit.and_then(|hit| hit.barycentrics) {
        return Some(of_hit);
    }
    Some([subject.number("a")?, subject.number("b")?, subject.number("c")?])
}

/// Draws the ray and the plane of the triangle; the triangle in it as a thick line.
fn from_the_side(
    drawing: &mut Drawing,
    room: Rect,
    vertices: [DVec3; 3],
    unit: DVec3,
    subject: &Subject<'_>,
    theme: &Theme,
) {
    let origin = DVec3::from(subject.node.origin);
    let height = unit.dot(origin - vertices[0]);
    let side = Side::new(subject.node, unit, height, subject.t());
    let mut placed = Placed::new(&side, room);
    let mut room = room;
    if placed.is_stretched {
        room = note(drawing, room, "Heights are enlarged, so angles are not true.", theme);
        placed = Placed::new(&side, room);
    }
    let mut sketch = Sketch::new(drawing, room, theme);
    side::draw(&mut sketch, &side, &placed, subject.node, false);
    if let Some(t) = subject.t() {
        let point = origin + t * DVec3::from(subject.node.direction);
        let at = |v: DVec3| side.right.dot(v - point);
        let pen = Pen::new(theme.hue(Hue::Sky), 5.0);
        if let Some([from, to]) = cut(vertices, point, unit.cross(side.right), at) {
            let (a, b) = (placed.on_ground(from), placed.on_ground(to));
            if let Some((a, b)) = sketch.cut(a, b) {
                sketch.drawing.line(a, b, Pen { color: pen.color.fade(0.6), ..pen });
            }
        }
    }
    if let (Some(hit), Some(t)) = (placed.hit, subject.t()) {
        let words = Words::default().tex(&format!("t = {}", tex(t)));
        sketch.beside(placed.eye, hit, words, theme.ray(subject.node.kind, 1.0).color);
    }
    sketch.finish();
}

/// Where the plane through `point` with the normal `across` cuts the triangle, by `at`; nothing where it passes it.
fn cut(vertices: [DVec3; 3], point: DVec3, across: DVec3, at: impl Fn(DVec3) -> f64) -> Option<[f64; 2]> {
    let off = vertices.map(|v| across.dot(v - point));
    let mut ends: Option<[f64; 2]> = None;
    for k in 0..3 {
        let (i, j) = (k, (k + 1) % 3);
        if (off[i] <= 0.0) == (off[j] <= 0.0) {
            continue;
        }
        let share = off[i] / (off[i] - off[j]);
        let x = at(vertices[i].lerp(vertices[j], share));
        ends = Some(ends.map_or([x, x], |[a, b]| [a.min(x), b.max(x)]));
    }
    ends
}

fn lines(subject: &Subject<'_>, vertices: [DVec3; 3], weights: Option<[f64; 3]>) -> Vec<Line> {
    let node = subject.node;
    let mut lines = vec![
        Line::heading("the triangle"),
        Line::formula(r"\mathbf{p} = a\,\mathbf{v}_0 + b\,\mathbf{v}_1 + (1{-}a{-}b)\,\mathbf{v}_2"),
    ];
    let vertex = |(i, v): (usize, DVec3)| Line::formula(&format!(r"\mathbf{{v}}_{i} = {}", triple(v.to_array())));
    lines.extend(vertices.into_iter().enumerate().map(vertex));
    lines.push(Line::heading("the ray"));
    lines.push(Line::formula(&format!(r"\mathbf{{o}} = {}", triple(node.origin))));
    lines.push(Line::formula(&format!(r"\mathbf{{d}} = {}", triple(node.direction))));
    let t = subject.t();
    let is_lecture = subject.number("det").is_none();
    if is_lecture {
        lines.push(Line::heading("the plane first"));
        if let Some(n_dot_d) = subject.number("n_dot_d") {
            lines.push(Line::formula(&format!(r"\mathbf{{n}}\cdot\mathbf{{d}} = {}", tex(n_dot_d))));
        }
        let value = t.map_or(String::new(), |t| format!(" = {}", tex(t)));
        let fraction = r"\frac{\mathbf{n}\cdot\mathbf{v}_0 - \mathbf{n}\cdot\mathbf{o}}{\mathbf{n}\cdot\mathbf{d}}";
        lines.push(Line::result(&format!("t = {fraction}{value}")));
    } else {
        lines.push(Line::heading("one linear system, by Cramer's rule"));
        let edges = r"\mathbf{e}_1 = \mathbf{v}_1 - \mathbf{v}_0,\quad \mathbf{e}_2 = \mathbf{v}_2 - \mathbf{v}_0";
        lines.push(Line::formula(edges));
        if let Some(det) = subject.number("det") {
            let form = r"\det = \mathbf{e}_1 \cdot (\mathbf{d} \times \mathbf{e}_2)";
            lines.push(Line::formula(&format!("{form} = {}", tex(det))));
        }
        lines.extend(t.map(|t| Line::result(&format!("t = {}", tex(t)))));
    }
    if let Some([a, b, c]) = weights {
        lines.push(Line::heading("the three inside tests"));
        let tests = [
            (a >= 0.0, format!(r"a = {} \ {}\  0", tex(a), relation(a))),
            (b >= 0.0, format!(r"b = {} \ {}\  0", tex(b), relation(b))),
            (c >= 0.0, format!(r"1 - {} - {} = {} \ {}\  0", operand(a), operand(b), tex(c), relation(c))),
        ];
        // The verdict is the test's, which may have been decided exactly where the rounded values are not sure.
        let is_hit = subject.record.is_some_and(|r| r.t.is_some()) || subject.hit.is_some();
        for (yes, words) in tests {
            lines.push(Line::verdict((yes || is_hit, Words::default().tex(&words))));
        }
    }
    lines.push(Line::verdict(subject.verdict()));
    lines
}

/// How a number stands to 0.
fn relation(x: f64) -> &'static str {
    if x >= 0.0 { r"\ge" } else { "<" }
}
