//! Lesson 01: lengths, directions, projections, the cross product.

use glam::{DVec2, DVec3};

use super::view::{Cut, View, oblique};
use super::{Page, Shown};
use crate::lessons::shown;
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Align, Color, Dash, Drawing, Level, Path, Pen, Rect, Text, Words};
use crate::pictures::theme::Hue;

const FAR: &str = "Your answer lies too far away to be drawn.";

fn bold(letter: &str) -> Words {
    Words::default().tex(&format!(r"\mathbf{{{letter}}}"))
}

/// The scalar product as a projection: a onto the line of b, with the answer over |b| as the length of the shadow.
pub fn projection(a: DVec3, b: DVec3, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "The plane of a and b; b points to the right. The part of a along b is a's shadow.");
    let cut = Cut::through(DVec3::ZERO, b, a);
    let along = |x: f64| DVec2::new(x / b.length().max(1e-9), 0.0);
    let number = |answer: &super::Answer| answer.number("a . b").map(along);
    let vector = |answer: &super::Answer| answer.vector("p");
    let is_vector = vector(&what.expected).is_some();
    let got = what.wrong().and_then(|got| vector(got).map(|v| cut.way(v)).or_else(|| number(got)));
    if what.wrong().and_then(vector).is_some_and(|v| !cut.holds(v)) {
        page.note("Your vector does not lie in this plane: you see it from the front.");
    }
    let right = vector(&what.expected).map(|v| cut.way(v)).or_else(|| number(&what.expected)).unwrap_or(DVec2::ZERO);
    let (a2, b2) = (cut.way(a), cut.way(b));
    let wished: Vec<DVec2> = got.into_iter().collect();
    let (view, is_near) = View::new(&[DVec2::ZERO, a2, b2, right], &wished, page.room);
    if !is_near {
        page.note(FAR);
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    let reach = 100.0 * (b2.x.abs() + 1.0);
    sketch.faint(at(DVec2::new(-reach, 0.0)), at(DVec2::new(reach, 0.0)), sketch.guide());
    sketch.line(at(a2), at(right), sketch.guide());
    sketch.arrow(at(DVec2::ZERO), at(b2), given);
    sketch.arrow(at(DVec2::ZERO), at(a2), Pen::new(sketch.theme.ink, 2.4));
    sketch.arrow(at(DVec2::ZERO), at(right), Pen { width: 4.6, ..green });
    sketch.name_in(at(a2), bold("a"), sketch.theme.ink);
    sketch.name_in(at(b2), bold("b"), given.color);
    let letter = |words: &str| match is_vector {
        true => Words::from(words),
        false => Words::from(words).then(" ").tex(r"\mathbf{a}\cdot\mathbf{b}\,/\,|\mathbf{b}|"),
    };
    sketch.name_in(at(right), letter("true"), green.color);
    if let Some(got) = got.filter(|_| is_near) {
        sketch.arrow(at(DVec2::ZERO), at(got), red);
        sketch.name_in(at(got), letter("yours"), red.color);
    }
    sketch.dot(at(DVec2::ZERO), sketch.theme.ink);
    sketch.finish();
    page.drawing
}

/// A length: the vector laid flat, and the answer below it.
pub fn length(a: DVec3, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "Above: the vector with its three components. Below: its length, laid flat.");
    let right = what.expected.number("length").unwrap_or_default();
    let wrong = what.wrong().and_then(|got| got.number("length")).filter(|x| x.abs() <= 6.0 * right.max(0.5));
    if what.wrong().is_some() && wrong.is_none() {
        page.note(FAR);
    }
    let (mut upper, mut lower) = (page.room, page.room);
    upper.max.y = page.room.min.y + 0.66 * page.room.size().y;
    lower.min.y = upper.max.y + 10.0;
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let steps = [DVec3::ZERO, DVec3::new(a.x, 0.0, 0.0), DVec3::new(a.x, a.y, 0.0), a].map(oblique);
    let (view, _) = View::new(&steps, &[], upper);
    let mut sketch = Sketch::new(&mut page.drawing, upper, page.theme);
    for (k, letter) in ["a_x", "a_y", "a_z"].into_iter().enumerate() {
        let (from, to) = (view.at(steps[k]), view.at(steps[k + 1]));
        sketch.line(from, to, Pen::new(sketch.theme.axis, 1.6).dashed(Dash::Short));
        let words = Words::default().tex(&format!("{letter} = {}", shown(a[k])));
        if from.distance(to) > 4.0 {
            sketch.beside(from, to, words, sketch.theme.muted);
        }
    }
    sketch.arrow(view.at(steps[0]), view.at(steps[3]), given);
    sketch.name_in(view.at(steps[3]), bold("a"), given.color);
    sketch.finish();

    let ends = [0.0, right, wrong.unwrap_or_default()];
    let (low, high) = (ends.into_iter().fold(0.0, f64::min), ends.into_iter().fold(1e-6, f64::max));
    let scale = (lower.size().x - 140.0) / (high - low);
    let at = |x: f64, row: f64| DVec2::new(lower.min.x + 20.0 + (x - low) * scale, lower.min.y + 30.0 + 50.0 * row);
    let mut sketch = Sketch::new(&mut page.drawing, lower, page.theme);
    let rows = [(Some(right), green, "true"), (wrong, red, "yours")];
    for (row, (x, pen, words)) in rows.into_iter().enumerate() {
        let Some(x) = x else { continue };
        sketch.arrow(at(0.0, row as f64), at(x, row as f64), Pen { width: 3.4, ..pen });
        sketch.name_in(at(x, row as f64), format!("{words} {}", shown(x)), pen.color);
    }
    sketch.line(at(0.0, -0.4), at(0.0, 1.4), sketch.guide());
    sketch.finish();
    page.drawing
}

/// A unit vector: on the unit circle, in the plane of the vector and the answer.
pub fn normal_vector(a: DVec3, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "In a plane with a: the circle has radius 1, and a unit vector ends on it.");
    let got = what.wrong().and_then(|got| got.vector("n"));
    let cut = Cut::through(DVec3::ZERO, a, got.unwrap_or(a));
    let right = what.expected.vector("n").map_or(DVec2::X, |v| cut.way(v));
    let got = got.map(|v| cut.way(v));
    // A long vector is drawn only as far as there is room for the circle.
    let needed = [DVec2::new(-1.05, -1.05), DVec2::new(1.05, 1.05)];
    let a2 = cut.way(a);
    let wished: Vec<DVec2> = [a2].into_iter().chain(got).collect();
    let (view, _) = View::new(&needed, &wished, page.room);
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    let (zero, radius) = (at(DVec2::ZERO), view.length(1.0));
    sketch.drawing.stroke(Path::circle(zero, radius), sketch.guide());
    sketch.keep_off_arc(zero, DVec2::NEG_Y, DVec2::X, radius);
    sketch.arrow(zero, at(a2), given);
    sketch.arrow(zero, at(right), Pen { width: 4.6, ..green });
    sketch.name_in(at(a2), bold("a"), given.color);
    sketch.name_in(at(right), "true", green.color);
    if let Some(got) = got {
        sketch.arrow(zero, at(got), red);
        sketch.name_in(at(got), "yours", red.color);
    }
    sketch.dot(zero, sketch.theme.ink);
    sketch.finish();
    page.drawing
}

/// The cross product in space, and its scheme after Sarrus.
pub fn cross_product(a: DVec3, b: DVec3, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "In space: x to the right, y up, z towards you. Below: the scheme of Sarrus.");
    let right = what.expected.vector("a x b").unwrap_or_default();
    let got = what.wrong().and_then(|got| got.vector("a x b"));
    let reach = 0.3 * a.abs().max(b.abs()).max(right.abs()).max_element();
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| reach * axis);
    let needed: Vec<DVec2> = [DVec3::ZERO, a, b, right].into_iter().chain(axes).map(oblique).collect();
    let wished: Vec<DVec2> = got.map(oblique).into_iter().collect();
    let mut lower = page.room;
    lower.min.y = lower.max.y - 158.0;
    page.room.max.y = lower.min.y - 8.0;
    let (view, is_near) = View::new(&needed, &wished, page.room);
    if !is_near {
        page.note(FAR);
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec3| view.at(oblique(p));
    let zero = at(DVec3::ZERO);
    for (axis, letter) in axes.into_iter().zip(["x", "y", "z"]) {
        sketch.arrow(zero, at(axis), Pen::new(sketch.theme.axis, 1.2));
        sketch.name_in(at(axis), Words::default().tex(letter), sketch.theme.muted);
    }
    let area = Path::polygon([zero, at(a), at(a + b), at(b)]);
    sketch.drawing.clipped(Path::rect(page.room), |drawing| drawing.fill(area, given.color.fade(0.12)));
    // Beneath the others and wider: as seen here a vector may lie along the result.
    sketch.arrow(zero, at(right), Pen { width: 4.6, ..green });
    sketch.arrow(zero, at(a), given);
    sketch.arrow(zero, at(b), given);
    sketch.name_in(at(a), bold("a"), given.color);
    sketch.name_in(at(b), bold("b"), given.color);
    sketch.name_in(at(right), Words::from("true ").tex(r"\mathbf{a}\times\mathbf{b}"), green.color);
    if let Some(got) = got.filter(|_| is_near) {
        sketch.arrow(zero, at(got), red);
        sketch.name_in(at(got), "yours", red.color);
    }
    sketch.finish();
    sarrus(&mut page, lower, a, b);
    page.drawing
}

/// The three rows of the scheme, the first two columns once more beside them: three diagonals down count plus, three up minus.
fn sarrus(page: &mut Page, room: Rect, a: DVec3, b: DVec3) {
    let theme = page.theme;
    let (plus, minus) = (theme.hue(Hue::Blue), theme.hue(Hue::Amber));
    let column = |k: usize| room.min.x + 60.0 + 74.0 * k as f64;
    let row = |k: usize| room.min.y + 30.0 + 44.0 * k as f64;
    let drawing = &mut page.drawing;
    for k in 0..3 {
        // From gap to gap, so that the numbers stay readable.
        let mut diagonal = |from: (usize, usize), to: (usize, usize), color: Color| {
            let (p, q) = (DVec2::new(column(from.0), row(from.1)), DVec2::new(column(to.0), row(to.1)));
            let way = (q - p).normalize_or_zero();
            drawing.line(p - 16.0 * way, q + 16.0 * way, Pen::new(color.fade(0.35), 11.0));
        };
        diagonal((k, 0), (k + 2, 2), plus);
        diagonal((k, 2), (k + 2, 0), minus);
    }
    let text = Text::new(14.0, theme.ink).anchor(Align::Middle, Level::Middle);
    let units = [r"\mathbf{e}_x", r"\mathbf{e}_y", r"\mathbf{e}_z"];
    for k in 0..5 {
        let color = if k < 3 { theme.ink } else { theme.muted };
        let cells = [units[k % 3].to_owned(), shown(a[k % 3]), shown(b[k % 3])];
        for (i, cell) in cells.into_iter().enumerate() {
            drawing.text((column(k), row(i)), Words::default().tex(&cell), text.color(color));
        }
    }
    let side = text.anchor(Align::End, Level::Middle);
    drawing.text((column(0) - 30.0, row(1)), bold("a"), side);
    drawing.text((column(0) - 30.0, row(2)), bold("b"), side);
    let sign = Text::new(12.0, theme.muted).anchor(Align::Start, Level::Middle);
    drawing.text((column(4) + 46.0, row(2) + 4.0), "blue: plus", sign.color(plus));
    drawing.text((column(4) + 46.0, row(0) - 4.0), "amber: minus", sign.color(minus));
}
