//! Lesson 02: a plane in Hesse form, a point's distance, a ray that meets it. All seen along the plane, which is a line then.

use glam::{DVec2, DVec3};

use super::view::{Cut, View};
use super::{Page, Shown};
use crate::lessons::{Plane, Ray, shown};
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Dash, Drawing, Pen, Words};

const ALONG: &str = "Seen along the true plane, which is a line here; its normal points up.";

fn bold(letter: &str) -> Words {
    Words::default().tex(&format!(r"\mathbf{{{letter}}}"))
}

/// The line of a plane in a cut, as a point of it and the normal there; nothing where the cut is parallel to the plane.
fn line_of(cut: &Cut, normal: DVec3, distance: f64) -> Option<[DVec2; 2]> {
    let n = cut.way(normal);
    let length = n.length_squared();
    let foot = n * (distance / length);
    // With respect to the world's origin, which is that of the cut.
    (length > 1e-12 && foot.is_finite()).then_some([foot, n])
}

/// The plane through a point with a normal, in Hesse form.
pub fn plane_from(point: DVec3, normal: DVec3, what: &Shown) -> Drawing {
    let mut page = Page::new(what, ALONG);
    let unit = normal.normalize_or_zero();
    let along = point - point.dot(unit) * unit;
    let right = along.try_normalize().unwrap_or_else(|| unit.any_orthonormal_vector());
    let cut = Cut::through(DVec3::ZERO, right, unit);
    let distance = point.dot(unit);
    let wrong = what.wrong().and_then(|got| Some((got.vector("n")?, got.number("D")?)));
    let yours = wrong.and_then(|(n, d)| line_of(&cut, n, d));
    let p = cut.at(point);
    let foot = DVec2::new(0.0, distance);
    let needed = [DVec2::ZERO, p, foot, foot + DVec2::Y, DVec2::new(0.0, -0.6)];
    let wished: Vec<DVec2> = yours.map(|[at, n]| vec![at, at + n]).unwrap_or_default();
    let (view, is_near) = View::new(&needed, &wished, page.room);
    if !is_near {
        page.note("Your plane lies too far away, or its normal is too long, to be drawn whole.");
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    sketch.line(view.beyond(foot, -DVec2::X), view.beyond(foot, DVec2::X), Pen { width: 3.2, ..green });
    sketch.arrow(at(foot), at(foot + DVec2::Y), green);
    sketch.name_in(at(foot + DVec2::Y), Words::from("true ").tex(r"\mathbf{n}"), green.color);
    sketch.dot(at(DVec2::ZERO), sketch.theme.ink);
    sketch.name(at(DVec2::ZERO), "origin");
    if at(foot).distance(at(DVec2::ZERO)) > 24.0 {
        let words = Words::default().tex(&format!("D = {}", shown(distance)));
        sketch.length(at(DVec2::ZERO), at(foot), 16.0, words, green.color);
    }
    if let Some([start, n]) = yours {
        sketch.line(view.beyond(start, -n.perp()), view.beyond(start, n.perp()), red);
        sketch.arrow(at(start), at(start + n), Pen { dash: Dash::Solid, ..red });
        sketch.name_in(at(start + n), Words::from("your ").tex(r"\mathbf{n}"), red.color);
    }
    sketch.dot(at(p), given.color);
    sketch.name_in(at(p), bold("p"), given.color);
    sketch.finish();
    page.drawing
}

/// The signed distance of a point.
pub fn signed_distance(point: DVec3, plane: &Plane, what: &Shown) -> Drawing {
    let mut page = Page::new(what, ALONG);
    let unit = plane.normal;
    let along = point - point.dot(unit) * unit;
    let right = along.try_normalize().unwrap_or_else(|| unit.any_orthonormal_vector());
    let cut = Cut::through(DVec3::ZERO, right, unit);
    let (p, level) = (cut.at(point), DVec2::new(0.0, plane.distance));
    let foot = DVec2::new(p.x, plane.distance);
    let got = what.wrong().and_then(|got| got.number("distance"));
    let aside = DVec2::new(0.45 * (p.distance(foot) + 1.0), 0.0);
    let yours = got.map(|d| foot + aside + DVec2::new(0.0, d));
    let needed = [DVec2::ZERO, p, level, foot + 1.4 * aside, foot - aside, level + DVec2::Y];
    let (view, is_near) = View::new(&needed, &yours.into_iter().collect::<Vec<_>>(), page.room);
    if !is_near {
        page.note("Your distance is too large to be drawn.");
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    sketch.line(view.beyond(level, -DVec2::X), view.beyond(level, DVec2::X), Pen::new(sketch.theme.ink, 2.4));
    sketch.arrow(at(level), at(level + DVec2::Y), Pen::new(sketch.theme.ink, 1.8));
    sketch.name(at(level + DVec2::Y), bold("n"));
    sketch.dot(at(DVec2::ZERO), sketch.theme.muted);
    sketch.name_in(at(DVec2::ZERO), "origin", sketch.theme.muted);
    sketch.arrow(at(foot), at(p), green);
    let d = what.expected.number("distance").unwrap_or_default();
    sketch.beside(at(foot), at(p), format!("true {}", shown(d)), green.color);
    if let (Some(yours), Some(d), true) = (yours, got, is_near) {
        sketch.arrow(at(foot + aside), at(yours), red);
        sketch.name_in(at(yours), format!("yours {}", shown(d)), red.color);
    }
    sketch.dot(at(p), given.color);
    sketch.name_in(at(p), bold("p"), given.color);
    sketch.finish();
    page.drawing
}

/// A ray and a plane.
pub fn plane_hit(ray: &Ray, plane: &Plane, what: &Shown) -> Drawing {
    let mut page = Page::new(what, ALONG);
    let unit = plane.normal.normalize_or_zero();
    let along = ray.direction - ray.direction.dot(unit) * unit;
    let right = along.try_normalize().unwrap_or_else(|| unit.any_orthonormal_vector());
    let height = ray.origin.dot(unit) - plane.distance;
    let cut = Cut::through(ray.origin, right, unit);
    let (eye, way) = (DVec2::ZERO, cut.way(ray.direction));
    let level = DVec2::new(0.0, -height);
    let t_of = |answer: &super::Answer| answer.number("t");
    let right = t_of(&what.expected).map(|t| eye + t * way);
    let got = what.wrong().and_then(t_of);
    let yours = got.map(|t| eye + t * way);
    let back = way * (-0.8 / way.length().max(1e-9));
    let needed: Vec<DVec2> = [eye, level, level + DVec2::Y, eye + way, back].into_iter().chain(right).collect();
    let (view, is_near) = View::new(&needed, &yours.into_iter().collect::<Vec<_>>(), page.room);
    match what.wrong() {
        Some(super::Answer::Nothing(_)) => page.note("Your function finds no hit."),
        Some(_) if !is_near || got.is_none() => page.note("Your hit lies too far away to be drawn."),
        _ => {}
    }
    if right.is_none() {
        page.note("The ray does not meet the plane: what there is of its line behind the origin is dashed.");
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    sketch.line(view.beyond(level, -DVec2::X), view.beyond(level, DVec2::X), Pen::new(sketch.theme.ink, 2.4));
    sketch.arrow(at(level), at(level + DVec2::Y), Pen::new(sketch.theme.ink, 1.8));
    sketch.name(at(level + DVec2::Y), bold("n"));
    sketch.line(at(eye), view.beyond(eye, -way), sketch.guide());
    sketch.line(at(eye), view.beyond(eye, way), Pen { width: 1.2, ..given });
    sketch.arrow(at(eye), at(eye + way), given);
    sketch.name_in(at(eye + way), bold("d"), given.color);
    if let (Some(p), Some(t)) = (right, t_of(&what.expected)) {
        sketch.disk(at(p), 5.5, green.color);
        sketch.name_in(at(p), Words::from("true ").tex(&format!("t = {}", shown(t))), green.color);
    }
    if let (Some(p), Some(t), true) = (yours, got, is_near) {
        sketch.disk(at(p), 5.5, red.color);
        sketch.name_in(at(p), Words::from("yours ").tex(&format!("t = {}", shown(t))), red.color);
    }
    sketch.dot(at(eye), given.color);
    sketch.name_in(at(eye), bold("o"), given.color);
    sketch.finish();
    page.drawing
}
