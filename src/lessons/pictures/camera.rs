//! Lesson 06: the field of view, the pixels of an image, a point on the image plane.

use glam::{DVec2, DVec3};

use super::view::View;
use super::{Page, Shown};
use crate::lessons::{Camera, shown};
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Drawing, Path, Pen, Rect, Words};

/// The eye and the image plane from the side, with half its height.
pub fn field_of_view(fov_y_degrees: f64, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "From the side: the eye, and the image plane at distance 1.");
    let height = |answer: &super::Answer| answer.number("half height");
    let right = height(&what.expected).unwrap_or_default();
    let wrong = what.wrong().and_then(height);
    let top = DVec2::new(1.0, right);
    let needed = [DVec2::new(-0.1, 0.0), top, DVec2::new(1.2, -right)];
    let wished: Vec<DVec2> = wrong.map(|y| DVec2::new(1.0, y)).into_iter().collect();
    let (view, is_near) = View::new(&needed, &wished, page.room);
    if !is_near {
        page.note("Your half height is too large to be drawn.");
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |x: f64, y: f64| view.at(DVec2::new(x, y));
    let (eye, middle) = (at(0.0, 0.0), at(1.0, 0.0));
    sketch.line(at(1.0, -right), middle, Pen::new(sketch.theme.ink, 1.6));
    for end in [at(1.0, right), at(1.0, -right)] {
        sketch.line(eye, end, given);
    }
    sketch.line(eye, middle, sketch.guide());
    sketch.beside(eye, middle, "1", sketch.theme.muted);
    let radius = 0.22 * eye.distance(middle);
    let (up, down) = (at(1.0, right) - eye, at(1.0, -right) - eye);
    sketch.drawing.angle(eye, up, down, radius, Pen { width: 1.4, ..given });
    sketch.keep_off_arc(eye, up, down, radius);
    sketch.name_in(eye + DVec2::new(radius, 0.0), format!("{}°", shown(fov_y_degrees)), given.color);
    sketch.line(middle, at(1.0, right), Pen { width: 4.0, ..green });
    sketch.name_in(at(1.0, right), format!("true {}", shown(right)), green.color);
    if let Some(y) = wrong.filter(|_| is_near) {
        // Beside the true one, or nothing would be seen of it.
        let aside = DVec2::new(9.0, 0.0);
        sketch.line(middle + aside, at(1.0, y) + aside, red);
        sketch.name_in(at(1.0, y) + aside, format!("yours {}", shown(y)), red.color);
    }
    sketch.dot(eye, sketch.theme.ink);
    sketch.name(eye, "eye");
    sketch.finish();
    page.drawing
}

/// The pixels of an image, of `[x, y, width, height]` that of (x, y) marked, and where its middle is.
pub fn pixel_grid([x, y, width, height]: [u32; 4], what: &Shown) -> Drawing {
    let mut page = Page::new(what, "The image with its pixels: x from -1 to 1 to the right, y from -1 to 1 upwards.");
    let of = |answer: &super::Answer| Some(DVec2::new(answer.number("x")?, answer.number("y")?));
    let right = of(&what.expected).unwrap_or_default();
    let got = what.wrong().and_then(of);
    let room = page.room.grown(-44.0);
    // Pixels are square.
    let scale = (room.size() / DVec2::new(width.into(), height.into())).min_element();
    let half = scale * DVec2::new(width.into(), height.into()) / 2.0;
    let is_near = |p: DVec2| p.abs().max_element() < 1.15;
    if what.wrong().is_some() && !got.is_some_and(is_near) {
        page.note("Your place lies outside of the image.");
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| room.center() + p * half * DVec2::new(1.0, -1.0);
    let corner = |column: u32, row: u32| {
        let share = DVec2::new(f64::from(column) / f64::from(width), f64::from(row) / f64::from(height));
        at(DVec2::new(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y))
    };
    let pixel = Rect { min: corner(x, y), max: corner(x + 1, y + 1) };
    sketch.drawing.fill(Path::rect(pixel), given.color.fade(0.18));
    let grid = Pen::new(sketch.theme.axis, 0.9);
    for column in 0..=width {
        sketch.faint(corner(column, 0), corner(column, height), grid);
    }
    for row in 0..=height {
        sketch.faint(corner(0, row), corner(width, row), grid);
    }
    sketch
        .drawing
        .stroke(Path::rect(Rect { min: corner(0, 0), max: corner(width, height) }), Pen::new(sketch.theme.ink, 1.8));
    for (place, words) in [(DVec2::NEG_ONE, "(-1, -1)"), (DVec2::ONE, "(1, 1)")] {
        sketch.name_in(at(place), words, sketch.theme.muted);
    }
    sketch.disk(at(right), 5.0, green.color);
    sketch.name_in(at(right), "true", green.color);
    if let Some(p) = got.filter(|p| is_near(*p)) {
        sketch.disk(at(p), 5.0, red.color);
        sketch.name_in(at(p), "yours", red.color);
    }
    sketch.finish();
    page.drawing
}

/// The image plane as the eye sees it; `halves` are half its width and half its height, `on_image` the place on it.
pub fn image_plane(camera: &Camera, halves: DVec2, on_image: DVec2, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "The image plane as the eye sees it, at distance 1.");
    let of = |answer: &super::Answer| answer.vector("p").map(|p| p - camera.eye);
    let flat = |way: DVec3| DVec2::new(way.dot(camera.right), way.dot(camera.up));
    let right = of(&what.expected).map_or(on_image * halves, flat);
    let got = what.wrong().and_then(of);
    let wished: Vec<DVec2> = got.map(flat).into_iter().collect();
    let (view, is_near) = View::new(&[-halves, halves, right], &wished, page.room);
    if let Some(way) = got {
        let distance = way.dot(camera.forward);
        if (distance - 1.0).abs() > 1e-6 {
            let side = if distance < 0.0 { "behind" } else { "in front of" };
            page.note(&format!("Your point is not on the plane: it is {} {side} the eye.", shown(distance.abs())));
        }
        if !is_near {
            page.note("Your point lies too far away to be drawn.");
        }
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |p: DVec2| view.at(p);
    let frame = Rect { min: at(DVec2::new(-halves.x, halves.y)), max: at(DVec2::new(halves.x, -halves.y)) };
    sketch.drawing.fill(Path::rect(frame), sketch.theme.panel);
    sketch.drawing.stroke(Path::rect(frame), Pen::new(sketch.theme.ink, 1.8));
    let [a, b, c, d] = frame.corners();
    sketch.keep_off(&[a, b, c, d, a]);
    let zero = at(DVec2::ZERO);
    for (end, letter, length) in
        [(DVec2::new(halves.x, 0.0), "w", halves.x), (DVec2::new(0.0, halves.y), "h", halves.y)]
    {
        sketch.line(zero, at(end), given);
        let words = Words::default().tex(&format!("{letter} = {}", shown(length)));
        sketch.beside(zero, at(end), words, given.color);
    }
    sketch.dot(zero, given.color);
    sketch.name_in(zero, "the middle", given.color);
    sketch.disk(at(right), 5.5, green.color);
    sketch.name_in(at(right), "true", green.color);
    if let Some(p) = wished.first().filter(|_| is_near) {
        sketch.disk(at(*p), 4.5, red.color);
        sketch.name_in(at(*p), "yours", red.color);
    }
    sketch.finish();
    page.drawing
}
