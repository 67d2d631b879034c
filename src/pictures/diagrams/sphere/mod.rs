//! A ray and a sphere in the plane of the ray and the centre: the foot of the perpendicular, the half chord, both roots.

mod section;
mod zoom;

use glam::DVec3;

use super::formulas::{Line, column, operand, triple};
use super::frame;
use super::numbers::tex;
use super::sketch::{beside, note};
use super::subject::{Subject, subject};
use super::{Input, Kind, NotApplicable};
use crate::pictures::drawing::{Drawing, Rect};
use crate::pictures::theme::Theme;
use crate::scene::Shape;

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let subject = subject(input, Kind::Sphere, |shape| matches!(shape, Shape::Sphere { .. }))?;
    let Shape::Sphere { center, radius } = *subject.shape else {
        return Err(NotApplicable { kind: Kind::Sphere, why: "what is chosen is no sphere".into() });
    };
    let cut = Cut::new(&subject, center, radius);
    let about = "The plane of the ray and the centre; lengths and angles are true.";
    let (mut drawing, room) = frame::begin(input.size, &subject.title, about, theme);
    let [mut left, right] = beside(room, 0.36);
    let frame = section::Frame::new(&cut, left);
    if frame.is_broken {
        left = note(&mut drawing, left, "The ray is broken at the marks: not to scale there.", theme);
    }
    let zoom = zoom::wanted(&cut, &section::Frame::new(&cut, left));
    let (main, inset) = match zoom {
        None => (left, None),
        Some(zoom) => {
            let height = (0.34 * left.size().y).max(90.0);
            let middle = left.max.y - height;
            let main = Rect { max: glam::DVec2::new(left.max.x, middle - 16.0), ..left };
            (main, Some((zoom, Rect { min: glam::DVec2::new(left.min.x, middle), ..left })))
        }
    };
    let frame = section::Frame::new(&cut, main);
    section::draw(&mut drawing, main, &cut, &frame, &subject, theme);
    if let Some((zoom, room)) = inset {
        zoom::draw(&mut drawing, room, &cut, &frame, zoom, subject.node.kind, theme);
    }
    column(&mut drawing, right, &lines(&subject, center, radius), theme);
    drawing.describe(format!("A section through a ray and the centre of a sphere: {}.", subject.verdict().1));
    Ok(drawing)
}

/// The section in numbers, all lengths in world units: x along the ray from its origin, y from the ray towards the centre.
#[derive(Clone, Copy, Debug)]
struct Cut {
    radius: f64,
    /// Where the foot of the perpendicular is, and how far the centre is from it.
    foot: f64,
    away: f64,
    /// Half of the chord; nothing where the ray's line passes the sphere.
    half: Option<f64>,
    /// Where the line enters and leaves.
    roots: Option<[f64; 2]>,
    /// What lies between the line and the sphere that it passes.
    gap: f64,
    /// Which of the roots is the hit: `t_in` or `t_out`.
    taken: Option<usize>,
}

impl Cut {
    fn new(subject: &Subject<'_>, center: DVec3, radius: f64) -> Self {
        let (o, d) = (DVec3::from(subject.node.origin), DVec3::from(subject.node.direction));
        let length = d.length();
        let f = o - center;
        let foot = -f.dot(d) / length;
        let away = f.cross(d).length() / length;
        // The stable form of the discriminant, over that of a ray of unit length.
        let disc = (radius - away) * (radius + away);
        let t = [subject.number("t_in"), subject.number("t_out")];
        let roots = match (t, subject.t()) {
            ([Some(t_in), Some(t_out)], _) => Some([t_in * length, t_out * length]),
            // Decided exactly, where the rounded discriminant says otherwise: the line touches.
            (_, Some(t)) => Some([t * length; 2]),
            _ => None,
        };
        let half = roots.map(|_| disc.max(0.0).sqrt());
        let gap = if roots.is_some() { 0.0 } else { (away - radius).max(0.0) };
        let taken = subject.t().zip(roots).map(|(t, roots)| {
            let apart = roots.map(|root| (root - t * length).abs());
            usize::from(apart[1] < apart[0])
        });
        Cut { radius, foot, away, half, roots, gap, taken }
    }
}

fn lines(subject: &Subject<'_>, center: DVec3, radius: f64) -> Vec<Line> {
    let node = subject.node;
    let is_naive = subject.number("l_dot_l").is_none();
    let mut lines = vec![
        Line::heading("the sphere"),
        Line::formula(r"|\mathbf{p} - \mathbf{c}|^2 = r^2"),
        Line::formula(&format!(r"\mathbf{{c}} = {}", triple(center.to_array()))),
        Line::formula(&format!("r = {}", tex(radius))),
        Line::heading("the ray"),
        Line::formula(&format!(r"\mathbf{{o}} = {}", triple(node.origin))),
        Line::formula(&format!(r"\mathbf{{d}} = {}", triple(node.direction))),
        Line::heading(if is_naive { "the quadratic equation" } else { "the quadratic equation, stable" }),
        Line::formula(r"\mathbf{f} = \mathbf{o} - \mathbf{c}"),
    ];
    let shown = |name: &str, left: &str| subject.number(name).map(|x| format!("{left} = {}", tex(x)));
    let b = if is_naive { r"b = 2\,\mathbf{f}\cdot\mathbf{d}" } else { r"b = \mathbf{f}\cdot\mathbf{d}" };
    lines.extend(shown("a", r"a = \mathbf{d}\cdot\mathbf{d}").map(|line| Line::formula(&line)));
    lines.extend(shown("b", b).map(|line| Line::formula(&line)));
    lines.extend(shown("c", r"c = \mathbf{f}\cdot\mathbf{f} - r^2").map(|line| Line::formula(&line)));
    let root = |sign: &str| match is_naive {
        true => format!(r"\frac{{-b {sign} \sqrt{{\Delta}}}}{{2a}}"),
        false => format!(r"\frac{{-b {sign} \sqrt{{\Delta}}}}{{a}}"),
    };
    let (form, with_numbers) = match (subject.number("a"), subject.number("b"), subject.number("c")) {
        (Some(a), Some(b), Some(c)) if is_naive => {
            (r"\Delta = b^2 - 4ac", Some(format!(r"{}^2 - 4\cdot {}\cdot {}", operand(b), operand(a), operand(c))))
        }
        (Some(a), ..) => {
            let numbers =
                subject.number("l_dot_l").map(|l| format!(r"({})^2\cdot {} - {}", tex(radius), tex(a), tex(l)));
            (r"\Delta = r^2 a - \mathbf{l}\cdot\mathbf{l}, \quad \mathbf{l} = \mathbf{f}\times\mathbf{d}", numbers)
        }
        _ => (r"\Delta", None),
    };
    lines.push(Line::formula(form));
    lines.extend(with_numbers.map(|numbers| Line::formula(&format!(r"\phantom{{\Delta}} = {numbers}"))));
    lines.extend(shown("disc", r"\Delta").map(|line| Line::result(&line)));
    for (name, sign, left) in [("t_in", "-", r"t_{\mathrm{in}}"), ("t_out", "+", r"t_{\mathrm{out}}")] {
        let line = shown(name, &format!("{left} = {}", root(sign)));
        lines.extend(line.map(|line| Line::result(&line)));
    }
    if let Some(c) = subject.number("c") {
        let is = if c > 0.0 { "c > 0: the ray starts outside" } else { "c ≤ 0: the ray starts inside" };
        lines.push(Line::heading(is));
    }
    lines.push(Line::verdict(subject.verdict()));
    lines
}
