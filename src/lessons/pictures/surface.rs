//! Lessons 07 to 10: directions at a surface, and the way from a point to a light.

use glam::{DVec2, DVec3};

use super::view::{Cut, View};
use super::{Answer, Page, Shown};
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Drawing, Path, Pen, Rect, Words};
use crate::scene::{Light, LightKind};

fn bold(letter: &str) -> Words {
    Words::default().tex(&format!(r"\mathbf{{{letter}}}"))
}

/// A surface seen from the side with its normal up: the ray that arrives, if one does, the directions that leave, by their
/// letters, and that of the answer with this name.
pub fn at_surface(
    normal: DVec3,
    arrives: Option<DVec3>,
    leaves: &[(&str, DVec3)],
    answer: &str,
    what: &Shown,
) -> Drawing {
    let mut page = Page::new(
        what,
        "The surface from the side, its normal up. What leaves the plane of the drawing looks shorter.",
    );
    let size = arrives.map_or(1.0, DVec3::length).max(1e-9);
    let first = arrives.or(leaves.first().map(|(_, v)| *v)).unwrap_or(normal);
    let across = first - first.dot(normal) * normal;
    let is_slanted = across.length() > 1e-6 * first.length();
    let right = if is_slanted { across } else { normal.any_orthonormal_vector() };
    let cut = Cut::through(DVec3::ZERO, right, normal);
    let of = |given: &Answer| given.vector(answer).map(|v| cut.way(v / size));
    let (true_way, own_way) = (of(&what.expected), what.wrong().and_then(of));
    let given_ways = leaves.iter().map(|(_, v)| cut.way(*v));
    let below = [true_way, own_way].into_iter().flatten().chain(given_ways).any(|way| way.y < -0.02);
    let needed = [DVec2::new(-1.15, if below { -1.1 } else { -0.2 }), DVec2::new(1.15, 1.15)];
    let (view, is_near) = View::new(&needed, &own_way.into_iter().collect::<Vec<_>>(), page.room);
    match what.wrong() {
        Some(Answer::Nothing(_)) => page.note("Your function gives no direction."),
        Some(_) if !is_near => page.note("Your direction is too long to be drawn."),
        _ => {}
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    let zero = at(DVec2::ZERO);
    let body = Rect { min: DVec2::new(sketch.room.min.x, zero.y), max: sketch.room.max };
    sketch.drawing.fill(Path::rect(body), sketch.theme.panel);
    sketch.line(DVec2::new(body.min.x, zero.y), DVec2::new(body.max.x, zero.y), Pen::new(sketch.theme.ink, 2.0));
    sketch.arrow(zero, at(DVec2::Y), Pen::new(sketch.theme.muted, 2.0));
    sketch.name_in(at(DVec2::Y), bold("n"), sketch.theme.muted);
    if let Some(d) = arrives {
        let from = at(-cut.way(d / size));
        sketch.ray(from, zero, given);
        sketch.name_in(from, bold("d"), given.color);
    }
    for (letter, v) in leaves {
        sketch.arrow(zero, at(cut.way(*v)), given);
        sketch.name_in(at(cut.way(*v)), bold(letter), given.color);
    }
    if let Some(way) = true_way {
        sketch.arrow(zero, at(way), Pen { width: 4.2, ..green });
        sketch.name_in(at(way), "true", green.color);
    }
    if let Some(way) = own_way.filter(|_| is_near) {
        sketch.arrow(zero, at(way), red);
        sketch.name_in(at(way), "yours", red.color);
    }
    sketch.dot(zero, sketch.theme.ink);
    sketch.finish();
    page.drawing
}

/// The way from a point to a light: the directions of the answers as they are, and where on them the light is, if they tell.
pub fn towards_light(point: DVec3, light: &Light, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "The vertical plane through the point and the light.");
    let (way, is_far) = match light.kind {
        LightKind::Point { position } => (position - point, false),
        LightKind::Directional { direction } => (-4.0 * direction, true),
    };
    let flat = DVec3::new(way.x, 0.0, way.z);
    let right = if flat.length() > 1e-6 * way.length() { flat } else { DVec3::X };
    let cut = Cut::through(point, right, DVec3::Y);
    let lamp = cut.way(way);
    let of = |answer: &Answer| {
        let way = cut.way(answer.vector("direction")?);
        Some((way, answer.number("t_max").map(|t_max| t_max * way)))
    };
    let (true_way, own_way) = (of(&what.expected), what.wrong().and_then(of));
    let ends = |way: Option<(DVec2, Option<DVec2>)>| way.into_iter().flat_map(|(way, end)| [Some(way), end]).flatten();
    let wished: Vec<DVec2> = ends(own_way).collect();
    let needed: Vec<DVec2> = [DVec2::ZERO, lamp].into_iter().chain(ends(true_way)).collect();
    let (view, is_near) = View::new(&needed, &wished, page.room);
    if what.wrong().is_some() && (!is_near || own_way.is_none()) {
        let is_end = own_way.is_some_and(|(way, _)| View::new(&needed, &[way], page.room).1);
        page.note(match is_end {
            true => "The end of your ray, at your t_max, lies beyond the picture.",
            false => "Your answer lies too far away to be drawn whole.",
        });
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    let zero = at(DVec2::ZERO);
    sketch.line(zero, at(lamp), sketch.guide());
    if is_far {
        sketch.arrow(at(lamp), at(0.72 * lamp), given);
        sketch.name_in(at(lamp), "the light's direction", given.color);
    } else {
        sketch.disk(at(lamp), 6.0, given.color);
        sketch.name_in(at(lamp), "light", given.color);
    }
    for (whose, way, pen) in [("true", true_way, Pen { width: 4.2, ..green }), ("yours", own_way, red)] {
        let Some((way, end)) = way else { continue };
        sketch.arrow(zero, at(way), pen);
        sketch.name_in(at(way), whose, pen.color);
        if let Some(end) = end {
            sketch.disk(at(end), 4.0, pen.color);
            sketch.name_in(at(end), Words::from(whose).then(" ").tex(r"t_{\mathrm{max}}"), pen.color);
        }
    }
    sketch.dot(zero, sketch.theme.ink);
    sketch.name(zero, bold("p"));
    sketch.finish();
    page.drawing
}
