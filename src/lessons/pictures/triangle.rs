//! Lesson 03: the plane of a triangle, the weights of its corners, the three inside tests.

use glam::{DVec2, DVec3};

use super::view::{Cut, View, oblique};
use super::{Answer, Page, Shown};
use crate::kernels::triangle_lecture_values;
use crate::lessons::{Ray, Triangle, shown};
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Dash, Drawing, Path, Pen, Rect, Words};
use crate::pictures::theme::Hue;

fn vertex(k: usize) -> Words {
    Words::default().tex(&format!(r"\mathbf{{v}}_{k}"))
}

/// The point where a ray meets the plane of a triangle, in space.
pub fn triangle_plane(ray: &Ray, triangle: &Triangle, what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "In space: x to the right, y up, z towards you. The grid lies in the plane of the triangle.");
    let right = what.expected.vector("p");
    let got = what.wrong().and_then(|got| got.vector("p"));
    let vertices = triangle.vertices;
    let end = right.unwrap_or(ray.origin + ray.direction);
    let needed: Vec<DVec2> = vertices.into_iter().chain([ray.origin, end]).map(oblique).collect();
    let (view, is_near) = View::new(&needed, &got.map(oblique).into_iter().collect::<Vec<_>>(), page.room);
    match what.wrong() {
        Some(Answer::Nothing(_)) => page.note("Your function finds no point."),
        Some(_) if !is_near || got.is_none() => page.note("Your point lies too far away to be drawn."),
        _ => {}
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec3| view.at(oblique(p));
    plane_grid(&mut sketch, vertices, &at);
    let corners = vertices.map(at);
    sketch.drawing.fill(Path::polygon(corners), sketch.theme.hue(Hue::Sky).fade(0.3));
    for k in 0..3 {
        sketch.line(corners[k], corners[(k + 1) % 3], Pen::new(sketch.theme.ink, 1.8));
        sketch.name(corners[k], vertex(k));
    }
    let beyond = view.beyond(oblique(ray.origin), oblique(ray.direction));
    sketch.line(at(ray.origin), beyond, Pen { width: 1.2, ..given });
    sketch.arrow(at(ray.origin), at(ray.origin + ray.direction), given);
    sketch.dot(at(ray.origin), given.color);
    sketch.name_in(at(ray.origin), Words::default().tex(r"\mathbf{o}"), given.color);
    if let Some(p) = right {
        sketch.disk(at(p), 5.5, green.color);
        sketch.name_in(at(p), Words::from("true ").tex(r"\mathbf{p}"), green.color);
    }
    if let Some(p) = got.filter(|_| is_near) {
        sketch.disk(at(p), 5.5, red.color);
        sketch.name_in(at(p), Words::from("your ").tex(r"\mathbf{p}"), red.color);
    }
    sketch.finish();
    page.drawing
}

/// Lines of the plane around a triangle, parallel to two of its edges.
fn plane_grid(sketch: &mut Sketch<'_>, [v0, v1, v2]: [DVec3; 3], at: &dyn Fn(DVec3) -> DVec2) {
    let pen = Pen::new(sketch.theme.axis.fade(0.6), 0.9);
    let (e1, e2) = (v1 - v0, v2 - v0);
    for i in -2..=6 {
        let step = f64::from(i) / 4.0 * 1.0;
        sketch.faint(at(v0 + step * e1 - 0.5 * e2), at(v0 + step * e1 + 1.5 * e2), pen);
        sketch.faint(at(v0 - 0.5 * e1 + step * e2), at(v0 + 1.5 * e1 + step * e2), pen);
    }
}

/// Three weights of the corners as a point: the right ones, and where the student's belong.
pub fn triangle_weights(triangle: &Triangle, point: DVec3, what: &Shown) -> Drawing {
    in_its_plane(triangle, Some(point), what, |answer| Some(["a", "b", "c"].map(|letter| answer.number(letter))))
}

/// A ray and a triangle: the point that it hits or misses it at, and the point that the student's weights belong to.
pub fn triangle_hit(ray: &Ray, triangle: &Triangle, what: &Shown) -> Drawing {
    let values = triangle_lecture_values(ray, triangle);
    let is_sound = values.t.is_finite() && values.t.abs() < 1e6;
    in_its_plane(triangle, is_sound.then_some(values.p), what, |answer| match answer {
        Answer::Nothing(_) | Answer::Tree(_) => None,
        Answer::Values(_) => Some(["a", "b", "c"].map(|letter| answer.number(letter))),
    })
}

fn in_its_plane(
    triangle: &Triangle,
    point: Option<DVec3>,
    what: &Shown,
    weights: impl Fn(&Answer) -> Option<[Option<f64>; 3]>,
) -> Drawing {
    let mut page =
        Page::new(what, "The triangle in its own plane. Any three weights that add up to 1 belong to a point of it.");
    let [v0, v1, v2] = triangle.vertices;
    let cut = Cut::through(v0, v1 - v0, v2 - v0);
    let corners = triangle.vertices.map(|v| cut.at(v));
    let whole = |answer: &Answer| {
        let [a, b, c] = weights(answer)?;
        Some([a?, b?, c?])
    };
    let of = |w: [f64; 3]| (0..3).map(|k| w[k] * corners[k]).sum::<DVec2>();
    let own = what.wrong().and_then(whole);
    // Weights that do not add up to 1 belong to a point elsewhere, if to any.
    let sum: f64 = own.map_or(1.0, |w| w.iter().sum());
    let got = own.map(of);
    let mut needed = corners.to_vec();
    needed.extend(point.map(|p| cut.at(p)).filter(|p| p.length() < 6.0 * corners[1].length().max(corners[2].length())));
    let (view, is_near) = View::new(&needed, &got.into_iter().collect::<Vec<_>>(), page.room);
    match what.wrong() {
        Some(Answer::Nothing(_)) => page.note("Your function finds no hit."),
        Some(_) if got.is_none() || !is_near => page.note("The point of your weights lies too far away to be drawn."),
        Some(_) if (sum - 1.0).abs() > 1e-9 => {
            page.note(&format!(
                "Your weights add up to {}, not to 1: their point is off the plane in truth.",
                shown(sum)
            ));
        }
        _ => {}
    }
    if point.is_none() {
        page.note("The ray is parallel to the plane of the triangle.");
    }
    let [_, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let seen = corners.map(|p| view.at(p));
    sketch.drawing.fill(Path::polygon(seen), sketch.theme.panel);
    for k in 0..3 {
        let (next, last) = (seen[(k + 1) % 3], seen[(k + 2) % 3]);
        for i in 1..5 {
            let share = f64::from(i) / 5.0;
            let pen = Pen::new(sketch.theme.axis.fade(0.5), 0.8);
            sketch.faint(next.lerp(seen[k], share), last.lerp(seen[k], share), pen);
        }
        sketch.line(next, last, Pen::new(sketch.theme.ink, 2.0));
        let letter = ["a", "b", "c"][k];
        let words = vertex(k).then(", weight ").tex(letter);
        sketch.name(seen[k], words);
    }
    let dashed = Dash::Short;
    if let Some(p) = point.map(|p| view.at(cut.at(p))) {
        for corner in seen {
            sketch.line(p, corner, Pen { width: 1.2, ..green }.dashed(dashed));
        }
        let color = green.color;
        sketch.disk(p, 5.5, color);
        let is_hit = matches!(what.expected, Answer::Values(_));
        let words = if is_hit { "true " } else { "true: outside, " };
        sketch.name_in(p, Words::from(words).tex(r"\mathbf{p}"), color);
    }
    if let Some(p) = got.map(|p| view.at(p)).filter(|_| is_near) {
        sketch.disk(p, 5.5, red.color);
        sketch.name_in(p, "the point of your weights", red.color);
    }
    sketch.finish();
    page.drawing
}

/// The inside tests as the region that passes them, in the plane of the weights a and b. `ask` is the student's function.
pub fn inside_tests(a: f64, b: f64, what: &Shown, ask: &dyn Fn(f64, f64) -> Option<bool>) -> Drawing {
    let mut page = Page::new(
        what,
        "All weights a (to the right) and b (up). Filled: inside, says the function. Red: it says inside, but it is outside.",
    );
    let reach = [a, b, 1.0 - a - b].into_iter().fold(1.5_f64, |reach, x| reach.max(x.abs() + 0.3)).min(6.0);
    let (low, high) = (DVec2::splat(1.0 - reach), DVec2::splat(reach));
    let room = page.room.grown(-8.0);
    let side = room.size().min_element();
    let square = Rect::new(room.center() - side / 2.0, DVec2::splat(side));
    let view = View::stretched(low, high, square);
    let [_, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, square, page.theme);
    let at = |a: f64, b: f64| view.at(DVec2::new(a, b));
    let corners = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)];
    const CELLS: i32 = 60;
    let cell = (high - low) / f64::from(CELLS);
    for (i, k) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |k| (i, k))) {
        let corner = low + cell * DVec2::new(i.into(), k.into());
        let (a, b) = (corner + 0.5 * cell).into();
        if ask(a, b) == Some(true) {
            let is_true = a >= 0.0 && b >= 0.0 && a + b <= 1.0;
            let color = if is_true { green.color } else { red.color };
            let rect = Rect::around([view.at(corner), view.at(corner + cell)]).unwrap_or(square);
            sketch.drawing.fill(Path::rect(rect), color.fade(0.3));
        }
    }
    let axis = Pen::new(sketch.theme.axis, 1.2);
    sketch.arrow(at(low.x, 0.0), at(high.x, 0.0), axis);
    sketch.arrow(at(0.0, low.y), at(0.0, high.y), axis);
    sketch.name_in(at(high.x, 0.0), Words::default().tex("a"), sketch.theme.muted);
    sketch.name_in(at(0.0, high.y), Words::default().tex("b"), sketch.theme.muted);
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        sketch.line(corners[i], corners[j], green);
    }
    sketch.name_in(corners[1], vertex(0), sketch.theme.ink);
    sketch.name_in(corners[2], vertex(1), sketch.theme.ink);
    sketch.name_in(corners[0], vertex(2), sketch.theme.ink);
    sketch.beside(corners[1], corners[2], Words::default().tex("a + b = 1"), green.color);
    let is_wrong = what.wrong().is_some();
    let color = if is_wrong { red.color } else { green.color };
    sketch.disk(at(a, b), 5.5, color);
    sketch.name_in(at(a, b), "this case", color);
    sketch.finish();
    page.drawing
}
