//! A ray and a box: the slabs of the two axes that decide, and where the ray is inside each of the three.

mod bars;
mod picture;

use glam::{DVec2, DVec3};

use super::formulas::{Line, column, operand, triple};
use super::frame;
use super::numbers::tex;
use super::sketch::{beside, note};
use super::subject::{Subject, subject};
use super::{Input, Kind, NotApplicable};
use crate::pictures::drawing::{Color, Drawing, Rect};
use crate::pictures::theme::{Hue, Theme};
use crate::scene::Shape;

/// The letters of the axes.
const LETTERS: [&str; 3] = ["x", "y", "z"];

/// The names of the faces' values, as the tree has them.
const FACES: [&str; 6] = ["t_-x", "t_+x", "t_-y", "t_+y", "t_-z", "t_+z"];

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let subject = subject(input, Kind::Box, |shape| matches!(shape, Shape::Box { .. }))?;
    let Shape::Box { min, max } = *subject.shape else {
        return Err(NotApplicable { kind: Kind::Box, why: "what is chosen is no box".into() });
    };
    let slabs = Slabs::new(&subject, min, max);
    let [i, j] = slabs.pair();
    let (x, y) = (LETTERS[i], LETTERS[j]);
    let about = format!("Seen along the third axis, {x} to the right and {y} up: the slabs of the axes that decide.");
    let (mut drawing, room) = frame::begin(input.size, &subject.title, &about, theme);
    let [left, right] = beside(room, 0.36);
    let middle = left.min.y + 0.6 * left.size().y;
    let upper = Rect { max: DVec2::new(left.max.x, middle - 8.0), ..left };
    let lower = Rect { min: DVec2::new(left.min.x, middle), ..left };
    let remark = picture::remark(&slabs, upper);
    let upper = note(&mut drawing, upper, &remark, theme);
    picture::draw(&mut drawing, upper, &slabs, &subject, theme);
    bars::draw(&mut drawing, lower, &slabs, &subject, theme);
    column(&mut drawing, right, &lines(&subject, &slabs), theme);
    drawing.describe(format!("The slabs of a box and where a ray is inside each: {}.", subject.verdict().1));
    Ok(drawing)
}

/// The color of an axis.
fn color(axis: usize, theme: &Theme) -> Color {
    theme.hue([Hue::Purple, Hue::Sky, Hue::Amber][axis])
}

/// A face of an axis in TeX: `t_{-x}`.
fn face_tex(face: usize) -> String {
    let sign = if face.is_multiple_of(2) { '-' } else { '+' };
    format!("t_{{{sign}{}}}", LETTERS[face / 2])
}

/// The slabs in numbers. The values of t that are drawn are computed here; those that are printed are the tree's.
#[derive(Clone, Copy, Debug)]
struct Slabs {
    origin: [f64; 3],
    direction: [f64; 3],
    min: [f64; 3],
    max: [f64; 3],
    /// Where the ray enters and leaves each slab; infinite where it runs along. Empty, the first larger than the second, where
    /// it runs beside it.
    spans: [[f64; 2]; 3],
    /// The axis entered last and the one left first.
    entry: usize,
    exit: usize,
}

impl Slabs {
    fn new(subject: &Subject<'_>, min: DVec3, max: DVec3) -> Self {
        let (origin, direction) = (subject.node.origin, subject.node.direction);
        let (min, max) = (min.to_array(), max.to_array());
        let span = |k: usize| {
            if direction[k] == 0.0 {
                let is_inside = min[k] <= origin[k] && origin[k] <= max[k];
                return if is_inside { [f64::NEG_INFINITY, f64::INFINITY] } else { [f64::INFINITY, f64::NEG_INFINITY] };
            }
            let ends = [min[k], max[k]].map(|side| (side - origin[k]) / direction[k]);
            if ends[0] <= ends[1] { ends } else { [ends[1], ends[0]] }
        };
        let spans: [[f64; 2]; 3] = std::array::from_fn(span);
        let entry = (0..3).fold(0, |best, k| if spans[k][0] > spans[best][0] { k } else { best });
        let exit = (0..3).fold(0, |best, k| if spans[k][1] < spans[best][1] { k } else { best });
        Slabs { origin, direction, min, max, spans, entry, exit }
    }

    /// The two axes that decide, in order.
    fn pair(&self) -> [usize; 2] {
        let other = match self.entry == self.exit {
            false => self.exit,
            // One axis decides alone: beside it the one that is next to do so.
            true => {
                let others = (0..3).filter(|k| *k != self.entry);
                let width = |k: usize| self.spans[k][1] - self.spans[k][0];
                others.min_by(|a, b| width(*a).total_cmp(&width(*b))).unwrap_or((self.entry + 1) % 3)
            }
        };
        [self.entry.min(other), self.entry.max(other)]
    }

    /// The face through which the ray enters or leaves the slab of an axis; nothing where it runs along.
    fn face(&self, axis: usize, leaving: bool) -> Option<usize> {
        let up = self.direction[axis] > 0.0;
        (self.direction[axis] != 0.0).then_some(2 * axis + usize::from(up == leaving))
    }

    /// The latest entry and the earliest exit.
    fn overlap(&self) -> [f64; 2] {
        [self.spans[self.entry][0], self.spans[self.exit][1]]
    }
}

/// What the tree says of `t_in` or `t_out`; the test of a bounding box has them as well.
fn recorded(subject: &Subject<'_>, leaving: bool) -> Option<f64> {
    let bounds = subject.bounds.and_then(|b| if leaving { b.t_out } else { b.t_in });
    match subject.record {
        Some(_) => subject.number(if leaving { "t_out" } else { "t_in" }),
        None => bounds,
    }
}

fn lines(subject: &Subject<'_>, slabs: &Slabs) -> Vec<Line> {
    let node = subject.node;
    let mut lines = vec![
        Line::heading("the box, from corner to corner"),
        Line::formula(&format!(r"\mathbf{{p}}_- = {}", triple(slabs.min))),
        Line::formula(&format!(r"\mathbf{{p}}_+ = {}", triple(slabs.max))),
        Line::heading("the ray"),
        Line::formula(&format!(r"\mathbf{{o}} = {}", triple(node.origin))),
        Line::formula(&format!(r"\mathbf{{d}} = {}", triple(node.direction))),
        Line::heading("where it crosses the sides that decide"),
    ];
    for (axis, leaving) in [(slabs.entry, false), (slabs.exit, true)] {
        let Some(face) = slabs.face(axis, leaving) else {
            lines.push(Line::formula(&format!(r"d_{{{}}} = 0", LETTERS[axis])));
            continue;
        };
        let side = if face.is_multiple_of(2) { slabs.min[axis] } else { slabs.max[axis] };
        let (o, d) = (slabs.origin[axis], slabs.direction[axis]);
        let value = subject.number(FACES[face]).map_or(String::new(), |t| format!(" = {}", tex(t)));
        let fraction = format!(r"\frac{{{} - {}}}{{{}}}", tex(side), operand(o), tex(d));
        lines.push(Line::result(&format!("{} = {fraction}{value}", face_tex(face))));
    }
    let names = |leaving: bool| {
        let faces = (0..3).filter_map(|axis| slabs.face(axis, leaving)).map(face_tex);
        faces.collect::<Vec<_>>().join(r",\, ")
    };
    for (leaving, letters, of) in [(false, r"t_{\mathrm{in}}", r"\max"), (true, r"t_{\mathrm{out}}", r"\min")] {
        if let Some(t) = recorded(subject, leaving) {
            let of_them = match subject.record {
                Some(_) => format!(r"{of}({})", names(leaving)),
                // The bounding box's span begins at 0.
                None if !leaving => format!(r"{of}(0,\, {})", names(leaving)),
                None => format!(r"{of}({})", names(leaving)),
            };
            lines.push(Line::result(&format!("{letters} = {of_them} = {}", tex(t))));
        }
    }
    lines.push(Line::verdict(subject.verdict()));
    lines
}
