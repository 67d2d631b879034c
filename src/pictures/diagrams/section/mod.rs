//! A cut through the scene along a ray, with as much of the tree as lies in it: lengths and angles in the plane are true.
//!
//! What leaves the plane is drawn where its foot is, paler, with a hollow mark at its end and how far off that is.

mod cut;
mod matter;
mod plane;
mod rays;
mod window;

use glam::DVec2;

use super::frame::{self, Key, SMALL, Sign, elided};
use super::labels::{Place, Taken, around};
use super::numbers::shown;
use super::{Input, NotApplicable};
use crate::input::printable;
use crate::pictures::drawing::{Align, Drawing, Level, Path, Pen, Text};
use crate::pictures::theme::Theme;
use crate::scene::ObjectId;
use crate::tree::Kind;
use cut::Cut;
use matter::Matter;
use plane::{Plane, Ray};
use window::Window;

/// The most rays that are drawn; of more the heaviest are.
const MOST: usize = 40;

pub(super) fn draw(input: &Input<'_>, theme: &Theme) -> Result<Drawing, NotApplicable> {
    let rays = rays_of(input);
    let plane = Plane::choose(input, &rays);
    let title = input.title(&format!("Section along ray {}", input.number()));
    let note = note(&plane, &rays, input);
    let (mut drawing, room) = frame::begin(input.size, &title, &note, theme);
    drawing.describe(describe(input, &rays));
    let kinds = [Kind::Camera, Kind::Reflected, Kind::Refracted, Kind::Shadow];
    let present: Vec<Kind> = kinds.into_iter().filter(|kind| rays.iter().any(|ray| ray.node.kind == *kind)).collect();
    let mut keys = vec![Key { words: "number of a ray: its t at the hit", sign: Sign::None }];
    if rays.iter().any(|ray| !plane.contains_ray(ray)) {
        keys.insert(0, Key { words: "off the plane", sign: Sign::Hollow });
    }
    let area = frame::key(&mut drawing, room, &present, &keys, theme);

    let scene = input.scene;
    let cuts: Vec<(ObjectId, Cut)> =
        scene.object_ids().filter_map(|id| Some((id, Cut::of(&scene.object(id).shape, &plane)?))).collect();
    let hit_by_the_tree = |id: &ObjectId| rays.iter().any(|ray| ray.node.hit.as_ref().is_some_and(|h| h.shape == id.0));
    let sizes: Vec<&Cut> = cuts.iter().map(|(_, cut)| cut).collect();
    let window = Window::choose(area, &plane, &rays, &sizes);
    let mut taken = Taken::new(&drawing, area.grown(-3.0));
    let mut names = Vec::new();
    // All within one clip: each costs a mask as large as the picture.
    drawing.clipped(Path::rect(area), |drawing| {
        for (id, cut) in &cuts {
            let matter = if scene.is_medium(*id) { Matter::Medium } else { Matter::Opaque };
            let places = matter::draw(drawing, &window, cut, matter, &mut taken, theme);
            names.push((*id, places));
        }
    });
    // A shape that the plane does not cut is named where it was hit.
    for ray in &rays {
        let Some(hit) = ray.node.hit.as_ref().filter(|hit| (hit.shape as usize) < scene.objects.len()) else {
            continue;
        };
        if names.iter().all(|(id, places)| id.0 != hit.shape || places.is_empty()) {
            names.push((ObjectId(hit.shape), vec![window.at(plane.at(hit.point.into()))]));
        }
    }
    drawing.stroke(Path::rect(area), Pen::new(theme.grid, 1.5));
    rays::draw(&mut drawing, &window, &plane, &rays, &mut taken, theme);
    scale_bar(&mut drawing, &window, &mut taken, theme);

    // Names of what the tree met come first.
    names.sort_by_key(|(id, _)| !hit_by_the_tree(id));
    for (id, places) in names {
        let met = hit_by_the_tree(&id);
        let text = Text::new(SMALL, if met { theme.ink } else { theme.muted });
        let name = elided(&printable(&scene.object(id).name), &text, 150.0);
        let spots: Vec<Place> = places.iter().flat_map(|at| name_places(*at)).collect();
        taken.write(&mut drawing, name, text, &spots, met);
    }
    Ok(drawing)
}

/// The rays of the tree, the one the diagram is about among them.
fn rays_of<'t>(input: &Input<'t>) -> Vec<Ray<'t>> {
    let nodes = input.tree.nodes();
    let mut rays: Vec<Ray<'_>> =
        nodes.iter().enumerate().map(|(i, (path, node))| Ray::new(i + 1, path, node)).collect();
    if rays.len() > MOST {
        let about = |ray: &Ray<'_>| if std::ptr::eq(ray.node, input.node) { f64::INFINITY } else { ray.importance };
        rays.sort_by(|a, b| about(b).total_cmp(&about(a)));
        rays.truncate(MOST);
        rays.sort_by_key(|ray| ray.number);
    }
    rays
}

/// What plane it is, and how much of the tree lies in it.
fn note(plane: &Plane, rays: &[Ray<'_>], input: &Input<'_>) -> String {
    let within = rays.iter().filter(|ray| ray.node.outcome.is_traced() && plane.contains_ray(ray)).count() as u64;
    let number = input.number();
    let which = match plane.is_of_incidence {
        true => format!("The plane of incidence of ray {number}"),
        false => format!("A plane through ray {number}"),
    };
    match input.tree.rays {
        0 | 1 => format!("{which}."),
        2 if within == 2 => format!("{which}; both rays lie in it."),
        all if within == all => format!("{which}; all {all} rays lie in it."),
        all => format!("{which}; {within} of {all} rays lie in it."),
    }
}

fn describe(input: &Input<'_>, rays: &[Ray<'_>]) -> String {
    let met = rays.iter().filter_map(|ray| ray.node.hit.as_ref()?.object.as_deref());
    let mut names: Vec<&str> = met.collect();
    names.dedup();
    match names.is_empty() {
        true => format!("A cut through the scene along ray {}, which meets nothing.", input.number()),
        false => format!("A cut through the scene along ray {}; its tree meets {}.", input.number(), names.join(", ")),
    }
}

/// Where the name of a shape may stand beside a place on it.
fn name_places(at: DVec2) -> Vec<Place> {
    let mut places = vec![(at, Align::Middle, Level::Middle)];
    places.extend(around(at, 9.0, 2));
    places
}

/// Draws a length to compare with, in the corner that is free.
fn scale_bar(drawing: &mut Drawing, window: &Window, taken: &mut Taken, theme: &Theme) {
    let most = 0.22 * window.frame.size().x / window.scale;
    let power = libm::pow(10.0, libm::log10(most).floor());
    if !(power.is_finite() && power > 0.0) {
        return;
    }
    let length = [5.0, 2.0, 1.0].into_iter().map(|times| times * power).find(|l| *l <= most).unwrap_or(power);
    let width = length * window.scale;
    let (pen, text) = (Pen::new(theme.muted, 1.4), Text::new(SMALL, theme.muted));
    let frame = window.frame.grown(-10.0);
    let left = DVec2::new(frame.min.x, frame.max.y);
    let right = DVec2::new(frame.max.x - width, frame.max.y);
    let corners = [left, right, DVec2::new(frame.min.x, frame.min.y + 14.0), DVec2::new(right.x, frame.min.y + 14.0)];
    for at in corners {
        let place = [(at + DVec2::new(width / 2.0, -6.0), Align::Middle, Level::Baseline)];
        if taken.write(drawing, format!("length {}", shown(length)), text, &place, false).is_some() {
            for x in [0.0, width] {
                drawing.line(at + DVec2::new(x, -3.0), at + DVec2::new(x, 3.0), pen);
            }
            drawing.line(at, at + DVec2::new(width, 0.0), pen);
            taken.take_line(at, at + DVec2::new(width, 0.0));
            return;
        }
    }
}
