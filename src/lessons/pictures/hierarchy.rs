//! Lesson 12: boxes around triangles, the two halves of a cut, the boxes of a hierarchy that a ray visits, a small picture.
//!
//! Single boxes are drawn in space. Whole hierarchies are seen from above, along z: there the triangles are walls, and a ray
//! runs between them.

use glam::{DVec2, DVec3};

use super::view::{View, oblique};
use super::{Answer, Page, Shown};
use crate::lessons::{Aabb, Hierarchy, Item, MeshView, Ray, Rendered, shown};
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Color, Dash, Drawing, Face, Path, Pen, Raster, Rect, Sampling, Text, Words};
use crate::pictures::theme::{Hue, Theme};

/// Triangles in space, and the box around them.
pub fn box_around(items: &[Item], what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "In space, z towards you. The box has to hold every corner, and to be no larger than that.");
    let corners: Vec<DVec3> = items.iter().flat_map(|item| item.triangle.vertices).collect();
    let right = answered_box(&what.expected);
    let wrong = what.wrong().and_then(answered_box);
    let needed: Vec<DVec2> =
        corners.iter().copied().chain(right.into_iter().flat_map(box_corners)).map(oblique).collect();
    let wished: Vec<DVec2> = wrong.into_iter().flat_map(box_corners).map(oblique).collect();
    if what.wrong().is_some() && wrong.is_none() {
        page.note("Your box has no corners that can be drawn.");
    }
    let (view, _) = View::new(&needed, &wished, page.room);
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    for item in items {
        let points = item.triangle.vertices.map(|v| view.at(oblique(v)));
        sketch.drawing.fill(Path::polygon(points), given.color.fade(0.22));
        let [a, b, c] = points;
        for (p, q) in [(a, b), (b, c), (c, a)] {
            sketch.line(p, q, Pen { width: 1.6, ..given });
        }
    }
    for (aabb, pen, whose) in [(right, green, "true"), (wrong, red, "your")] {
        let Some(aabb) = aabb else { continue };
        draw_box(&mut sketch, &view, aabb, pen);
        for (corner, name) in [(aabb.min, "min"), (aabb.max, "max")] {
            let at = view.at(oblique(corner));
            sketch.disk(at, 4.5, pen.color);
            sketch.name_in(at, format!("{whose} {name}"), pen.color);
        }
    }
    sketch.finish();
    page.drawing
}

/// A box and the areas of its faces.
pub fn box_area(aabb: &Aabb, what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "In space, z towards you. Each of the three faces that are seen has one across from it.");
    let size = aabb.max - aabb.min;
    let needed: Vec<DVec2> = box_corners(*aabb).into_iter().map(oblique).collect();
    let (view, _) = View::new(&needed, &[], page.room);
    let given = page.given();
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let (min, max) = (aabb.min, aabb.max);
    let faces = [
        (Hue::Sky, [size.x, size.y], [min.with_z(max.z), max.with_y(min.y), max, max.with_x(min.x)]),
        (Hue::Amber, [size.x, size.z], [min.with_y(max.y), max.with_z(min.z), max, max.with_x(min.x)]),
        (Hue::Purple, [size.y, size.z], [min.with_x(max.x), max.with_z(min.z), max, max.with_y(min.y)]),
    ];
    for (hue, [a, b], [p, q, r, s]) in faces {
        let points = [p, q, r, s].map(|corner| view.at(oblique(corner)));
        let color = sketch.theme.hue(hue);
        sketch.drawing.fill(Path::polygon(points), color.fade(0.28));
        let middle = points.iter().sum::<DVec2>() / 4.0;
        sketch.in_area(middle, format!("{} · {} = {}", shown(a), shown(b), shown(a * b)), sketch.theme.ink);
    }
    draw_box(&mut sketch, &view, *aabb, given);
    sketch.finish();
    page.drawing
}

/// Two groups of walls from above, each with its box.
pub fn two_groups(left: &[Item], right: &[Item], what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "Seen from above. What a ray costs: it meets a box the more often the larger its surface is.");
    let all: Vec<Item> = left.iter().chain(right).copied().collect();
    let view = above(&all, &[], page.room);
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    for (items, hue) in [(left, Hue::Blue), (right, Hue::Purple)] {
        let color = sketch.theme.hue(hue);
        walls(&mut sketch, &view, items, |_| color);
        let Some(aabb) = around(items) else { continue };
        let rect = rectangle(&view, &aabb).grown(5.0);
        outline(&mut sketch, rect, Pen::new(color, 1.8));
        let area = crate::hits::Bounds { min: aabb.min.to_array(), max: aabb.max.to_array() }.half_area() * 2.0;
        let words = format!("triangles: {}, area {}", items.len(), shown(area));
        sketch.name_in(DVec2::new(rect.center().x, rect.min.y), words, color);
    }
    sketch.finish();
    page.drawing
}

/// The two halves of a cut from above: the cheapest above, the student's below.
pub fn two_halves(items: &[Item], what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "Seen from above. Both halves with their boxes; what is in both, or in neither, is grey.");
    let answers: Vec<(&Answer, Pen, &str)> = match what.wrong() {
        Some(wrong) => vec![(&what.expected, page.right(), "true"), (wrong, page.wrong(), "yours")],
        None => vec![(&what.expected, page.right(), "true")],
    };
    let height = page.room.size().y / answers.len() as f64;
    for (i, (answer, pen, whose)) in answers.into_iter().enumerate() {
        let top = page.room.min.y + height * i as f64;
        let room = Rect { min: DVec2::new(page.room.min.x, top), max: DVec2::new(page.room.max.x, top + height - 6.0) };
        let heading = Text::new(13.0, pen.color).face(Face::Bold);
        page.drawing.text((room.min.x, room.min.y + 13.0), whose, heading);
        let room = Rect { min: room.min + DVec2::new(0.0, 18.0), ..room };
        let halves = ["left", "right"].map(|name| answer.set(name).unwrap_or_default());
        let view = above(items, &[], room);
        let mut sketch = Sketch::new(&mut page.drawing, room, page.theme);
        let hues = [sketch.theme.hue(Hue::Blue), sketch.theme.hue(Hue::Purple)];
        let neither = sketch.theme.axis;
        let color = |item: &Item| match [0, 1].map(|half: usize| halves[half].contains(&item.number)) {
            [true, false] => hues[0],
            [false, true] => hues[1],
            _ => neither,
        };
        walls(&mut sketch, &view, items, color);
        for half in &halves {
            let inside: Vec<Item> = items.iter().filter(|item| half.contains(&item.number)).copied().collect();
            if let Some(aabb) = around(&inside) {
                outline(&mut sketch, rectangle(&view, &aabb).grown(5.0), pen);
            }
        }
        sketch.finish();
    }
    page.drawing
}

/// All boxes of a hierarchy from above: a right one, and the student's.
pub fn nested_boxes(items: &[Item], right: &Hierarchy, wrong: Option<&Hierarchy>, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "Seen from above. All boxes of the hierarchy, the inner ones thinner.");
    let boxes: Vec<DVec2> = wrong
        .iter()
        .flat_map(|hierarchy| hierarchy.root().walk())
        .filter(|(node, _)| is_drawn(&node.bounds))
        .flat_map(|(node, _)| [node.bounds.min.truncate(), node.bounds.max.truncate()])
        .collect();
    let view = above(items, &boxes, page.room);
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    walls(&mut sketch, &view, items, |_| given.color);
    // The student's first, then the right ones a little larger, so that both are seen where they are the same.
    for (hierarchy, pen, margin) in [(wrong, red, 3.0), (Some(right), green, 6.0)] {
        for (node, depth) in hierarchy.iter().flat_map(|hierarchy| hierarchy.root().walk()) {
            if is_drawn(&node.bounds) {
                let inward = 1.2 * depth.min(4) as f64;
                let width = (2.4 - 0.4 * depth as f64).max(0.9);
                outline(&mut sketch, rectangle(&view, &node.bounds).grown(margin - inward), Pen { width, ..pen });
            }
        }
    }
    sketch.finish();
    page.drawing
}

/// A ray between walls, and the boxes of a hierarchy: those that are opened, and the triangles that are tested.
pub fn visited_boxes(hierarchy: &Hierarchy, ray: &Ray, what: &Shown) -> Drawing {
    let mut page = Page::new(
        what,
        "Seen from above. Boxes that have to be opened are green, those that you open red, and so are the walls that are tested.",
    );
    let items: Vec<Item> = hierarchy.root().items().copied().collect();
    let flat = |v: DVec3| v.truncate();
    let view = above(&items, &[flat(ray.origin), flat(ray.origin + ray.direction)], page.room);
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let sets =
        |name: &str| [Some(&what.expected), what.wrong()].map(|a| a.and_then(|a| a.set(name)).unwrap_or_default());
    let ([opened, also_opened], [tested, also_tested]) = (sets("opened"), sets("tested"));
    let is_wrong = what.wrong().is_some();
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let (ink, quiet) = (sketch.theme.ink, sketch.theme.axis.fade(0.6));
    for (node, depth) in hierarchy.root().walk() {
        let rect = rectangle(&view, &node.bounds).grown(6.0 - 1.2 * depth.min(4) as f64);
        outline(&mut sketch, rect, Pen::new(quiet, 0.9));
        if opened.contains(&node.number()) {
            outline(&mut sketch, rect, Pen { width: 1.9, ..green });
        }
        if is_wrong && also_opened.contains(&node.number()) {
            outline(&mut sketch, rect.grown(2.4), Pen { width: 1.6, ..red });
        }
    }
    walls(&mut sketch, &view, &items, |item| match tested.contains(&item.number) {
        true => green.color,
        false if is_wrong && also_tested.contains(&item.number) => red.color,
        false => ink.fade(0.55),
    });
    let (eye, way) = (view.at(flat(ray.origin)), view.at(flat(ray.origin + ray.direction)) - view.at(flat(ray.origin)));
    sketch.line(eye, eye + 3e3 * way.normalize_or_zero(), Pen { width: 1.2, ..given });
    sketch.arrow(eye, eye + way, given);
    sketch.dot(eye, given.color);
    sketch.name_in(eye, Words::default().tex(r"\mathbf{o}"), given.color);
    for (t, pen, whose) in [
        (what.expected.number("t"), green, "true hit"),
        (what.wrong().and_then(|answer| answer.number("t")), red, "your hit"),
    ] {
        if let Some(t) = t.filter(|_| whose != "your hit" || what.wrong().is_some()) {
            let at = view.at(flat(ray.at(t)));
            sketch.disk(at, 5.0, pen.color);
            sketch.name_in(at, whose, pen.color);
        }
    }
    sketch.finish();
    page.drawing
}

/// The tracer's picture of a mesh and what came of the student's hierarchy; below them how many tests each pixel took.
pub fn counted(view: &MeshView, right: &Rendered, yours: Option<&Rendered>, what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "Above: the picture, wrong pixels red. Below: how many tests each pixel took; darker is more.");
    let most = right.tests.iter().chain(yours.iter().flat_map(|y| &y.tests)).copied().max().unwrap_or(1).max(1);
    // From ten tests to twenty is as large a step as from a hundred to two hundred.
    let level = |tests: usize| libm::log1p(tests as f64);
    let heat = |rendered: &Rendered, theme: &Theme| {
        Raster::from_fn(view.size[0], view.size[1], |x, y| {
            theme.heat(level(rendered.tests[(y * view.size[0] + x) as usize]) / level(most))
        })
    };
    let a_ray = |rendered: &Rendered| shown((rendered.total() as f64 / view.rays() as f64 * 10.0).round() / 10.0);
    let red = page.theme.hue(Hue::Vermilion);
    let mut panels = vec![
        (0, 0, "true".to_owned(), view.picture.clone()),
        (0, 1, format!("the solution: {} tests a ray", a_ray(right)), heat(right, page.theme)),
    ];
    if let Some(yours) = yours {
        let marked = Raster::from_fn(view.size[0], view.size[1], |x, y| {
            let i = (y * view.size[0] + x) as usize;
            let [r, g, b] = [0, 1, 2].map(|k| view.picture.rgba[4 * i + k]);
            if yours.right[i] { Color { r, g, b, a: 255 } } else { red }
        });
        panels.push((1, 0, format!("yours: {} wrong pixels", yours.wrong()), marked));
        panels.push((1, 1, format!("yours: {} tests a ray", a_ray(yours)), heat(yours, page.theme)));
    }
    let gap = DVec2::new(14.0, 26.0);
    let cell = (page.room.size() - gap * DVec2::new(1.0, 2.0)) / 2.0;
    let [columns, rows] = view.size.map(f64::from);
    let scale = (cell.x / columns).min(cell.y / rows);
    let size = DVec2::new(columns, rows) * scale;
    let caption = Text::new(12.5, page.theme.ink).face(Face::Bold);
    for (column, row, words, raster) in panels {
        let corner = page.room.min + DVec2::new(f64::from(column), f64::from(row)) * (size + gap);
        page.drawing.text(corner + DVec2::new(0.0, 15.0), words, caption);
        let rect = Rect::new(corner + DVec2::new(0.0, 22.0), size);
        page.drawing.image(raster, rect, Sampling::Nearest);
        page.drawing.stroke(Path::rect(rect.grown(0.5)), Pen::new(page.theme.axis, 1.0));
    }
    page.drawing
}

/// The box that an answer gives, if it can be drawn.
fn answered_box(answer: &Answer) -> Option<Aabb> {
    Some(Aabb { min: answer.vector("min")?, max: answer.vector("max")? })
}

fn is_drawn(aabb: &Aabb) -> bool {
    [aabb.min, aabb.max].iter().all(|v| v.is_finite() && v.abs().max_element() < 1e4)
}

fn box_corners(aabb: Aabb) -> [DVec3; 8] {
    std::array::from_fn(|i| {
        let of = |axis: usize| if i >> axis & 1 == 0 { aabb.min[axis] } else { aabb.max[axis] };
        DVec3::new(of(0), of(1), of(2))
    })
}

fn draw_box(sketch: &mut Sketch<'_>, view: &View, aabb: Aabb, pen: Pen) {
    let corners = box_corners(aabb);
    for i in 0..8 {
        for j in [i | 1, i | 2, i | 4].into_iter().filter(|j| *j != i) {
            // The corner at the back, below, left is hidden.
            let hidden = Pen { width: 1.0, ..pen }.dashed(Dash::Short);
            let (p, q) = (view.at(oblique(corners[i])), view.at(oblique(corners[j])));
            sketch.line(p, q, if i == 0 { hidden } else { pen });
        }
    }
}

/// The smallest box around triangles; nothing around none.
fn around(items: &[Item]) -> Option<Aabb> {
    let corners: Vec<DVec3> = items.iter().flat_map(|item| item.triangle.vertices).collect();
    (!corners.is_empty()).then(|| Aabb::of_points(&corners))
}

/// The view from above of walls, and of what else is not too far off.
fn above(items: &[Item], wished: &[DVec2], room: Rect) -> View {
    let corners: Vec<DVec2> = items.iter().flat_map(|item| item.triangle.vertices).map(DVec3::truncate).collect();
    View::new(&corners, wished, room).0
}

fn rectangle(view: &View, aabb: &Aabb) -> Rect {
    let (a, b) = (view.at(aabb.min.truncate()), view.at(aabb.max.truncate()));
    Rect { min: a.min(b), max: a.max(b) }
}

/// Draws a rectangle, cut to the room; labels keep away from it.
fn outline(sketch: &mut Sketch<'_>, rect: Rect, pen: Pen) {
    let [a, b, c, d] = rect.corners();
    for (p, q) in [(a, b), (b, c), (c, d), (d, a)] {
        sketch.line(p, q, pen);
    }
}

/// Draws walls from above with their numbers.
fn walls(sketch: &mut Sketch<'_>, view: &View, items: &[Item], color: impl Fn(&Item) -> Color) {
    for item in items {
        let [a, b, _] = item.triangle.vertices.map(|v| view.at(v.truncate()));
        let color = color(item);
        sketch.line(a, b, Pen::new(color, 3.2));
        sketch.name_without_line(a.midpoint(b), item.number.to_string(), color);
    }
}
