//! Lesson 05: the quadratic of a ray and a sphere, its roots, the one that counts, the normal there.

use glam::{DVec2, DVec3};

use super::view::{Cut, View};
use super::{Answer, Page, Shown};
use crate::lessons::{Ray, Sphere, shown};
use crate::pictures::diagrams::Sketch;
use crate::pictures::drawing::{Drawing, Path, Pen, Rect, Words};

/// `a t^2 + b t + c` over t: the given parabola, that of the student's coefficients if the answer has some, and the roots.
pub fn parabola([a, b, c]: [f64; 3], what: &Shown) -> Drawing {
    let mut page =
        Page::new(what, "Upwards the value of the quadratic, to the right t. Where it is 0 the ray meets the sphere.");
    let roots =
        |answer: &Answer| ["t_in", "t_out"].map(|name| answer.number(name)).map(|t| t.filter(|t| t.abs() < 60.0));
    let own = what.wrong().and_then(|got| Some([got.number("a")?, got.number("b")?, got.number("c")?]));
    let vertex = -b / (2.0 * a);
    let lowest = c - b * b / (4.0 * a);
    let right = match what.expected.number("a") {
        // The roots of what was to be found.
        Some(_) if lowest <= 0.0 => [-1.0, 1.0].map(|side| Some(vertex + side * (-lowest / a).sqrt())),
        Some(_) => [None; 2],
        None => roots(&what.expected),
    };
    let wrong = what.wrong().map_or([None; 2], roots);
    let times = [vertex - 1.0, vertex + 1.0, 0.0].into_iter().chain(right.into_iter().chain(wrong).flatten());
    let (low, high) = times.fold((f64::MAX, f64::MIN), |(low, high), t| (low.min(t), high.max(t)));
    let margin = 0.15 * (high - low);
    let (low, high) = (low - margin, high + margin);
    let reach = right[0].map_or(1.0, |t| 0.5 * (high - low).min(2.5 * (vertex - t).abs().max(0.6)));
    let top = (lowest + a * reach * reach).max(0.35 * lowest.abs()).max(1.0);
    let bottom = lowest.min(0.0) - 0.18 * (top - lowest.min(0.0));
    let room = Rect { min: page.room.min + DVec2::new(16.0, 16.0), max: page.room.max - DVec2::new(16.0, 30.0) };
    let view = View::stretched(DVec2::new(low, bottom), DVec2::new(high, top), room);
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    let at = |t: f64, y: f64| view.at(DVec2::new(t, y));
    let axis = Pen::new(sketch.theme.axis, 1.2);
    sketch.arrow(at(low, 0.0), at(high, 0.0), axis);
    sketch.name_in(at(high, 0.0), Words::default().tex("t"), sketch.theme.muted);
    sketch.line(at(0.0, bottom), at(0.0, top), sketch.guide());
    sketch.name_in(at(0.0, bottom), Words::default().tex("t = 0"), sketch.theme.muted);
    let mut curve = |[a, b, c]: [f64; 3], pen: Pen, words: &str| {
        let (from, to) = seen_of([a, b, c], [bottom, top]);
        let (from, to) = (from.max(low), to.min(high));
        let point = |i: i32| {
            let t = from + (to - from) * f64::from(i) / 160.0;
            at(t, (a * t + b) * t + c)
        };
        let points: Vec<DVec2> = (0..=160).map(point).collect();
        let room = sketch.room;
        let path = Path::open(points.iter().copied());
        sketch.drawing.clipped(Path::rect(room), |drawing| drawing.stroke(path, pen));
        let inside: Vec<DVec2> = points.into_iter().filter(|p| room.contains(Rect { min: *p, max: *p })).collect();
        sketch.keep_off(&inside);
        // At the end that is further from the line t = 0.
        let off = |p: &&DVec2| (p.x - at(0.0, 0.0).x).abs();
        let ends = inside.first().into_iter().chain(inside.last());
        if let Some(p) = ends.max_by(|p, q| off(p).total_cmp(&off(q))) {
            sketch.name_in(*p, Words::from(words), pen.color);
        }
    };
    let is_asked_for = what.expected.number("a").is_some();
    curve([a, b, c], if is_asked_for { green } else { given }, if is_asked_for { "true" } else { "the quadratic" });
    if let Some(own) = own {
        curve(own, red, "yours");
    }
    for (times, pen, whose) in [(right, green, "true"), (wrong, red, "your")] {
        if is_asked_for && whose == "your" {
            continue;
        }
        let is_double = times[0] == times[1];
        for (t, name) in
            times.into_iter().zip([r"t_{\mathrm{in}}", r"t_{\mathrm{out}}"]).take(if is_double { 1 } else { 2 })
        {
            let Some(t) = t else { continue };
            sketch.disk(at(t, 0.0), 5.0, pen.color);
            let words = Words::from(whose).then(" ").tex(&format!("{name} = {}", shown(t)));
            sketch.name_in(
                at(t, 0.0),
                if is_asked_for { Words::default().tex(&format!("{name} = {}", shown(t))) } else { words },
                pen.color,
            );
        }
    }
    sketch.finish();
    page.drawing
}

/// From which t to which a quadratic is between two values, or somewhat beyond them; for ever where that cannot be told.
fn seen_of([a, b, c]: [f64; 3], [bottom, top]: [f64; 2]) -> (f64, f64) {
    let (middle, extreme) = (-b / (2.0 * a), c - b * b / (4.0 * a));
    let margin = 0.3 * (top - bottom);
    let half = ((top + margin - extreme) / a).max((bottom - margin - extreme) / a).sqrt();
    match half.is_finite() && middle.is_finite() {
        true => (middle - half, middle + half),
        false => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

/// A ray and a sphere, cut through the centre along the ray.
pub fn sphere_hit(ray: &Ray, sphere: &Sphere, what: &Shown) -> Drawing {
    let mut page = Page::new(what, "Cut through the centre, along the ray.");
    let cut = cut_of(ray, sphere);
    let t_of = |answer: &Answer| answer.number("t");
    let right = t_of(&what.expected).map(|t| cut.at(ray.at(t)));
    let got = what.wrong().and_then(t_of);
    let yours = got.map(|t| cut.at(ray.at(t)));
    let mut needed = rim(sphere);
    needed.extend([cut.at(ray.origin), cut.at(ray.origin + ray.direction)].into_iter().chain(right));
    let (view, is_near) = View::new(&needed, &yours.into_iter().collect::<Vec<_>>(), page.room);
    match what.wrong() {
        Some(Answer::Nothing(_)) => page.note("Your function finds no hit."),
        Some(_) if !is_near || got.is_none() => page.note("Your hit lies too far away to be drawn."),
        _ => {}
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    the_sphere(&mut sketch, &view, sphere);
    the_ray(&mut sketch, &view, &cut, ray, given);
    for (p, t, pen, whose) in
        [(right, t_of(&what.expected), green, "true"), (yours.filter(|_| is_near), got, red, "yours")]
    {
        if let (Some(p), Some(t)) = (p, t) {
            sketch.disk(view.at(p), 5.5, pen.color);
            let words = Words::from(whose).then(" ").tex(&format!("t = {}", shown(t)));
            sketch.name_in(view.at(p), words, pen.color);
        }
    }
    sketch.finish();
    page.drawing
}

/// The normal of a sphere where a ray meets it.
pub fn sphere_normal(ray: &Ray, sphere: &Sphere, t: f64, what: &Shown) -> Drawing {
    let mut page = Page::new(
        what,
        "Cut through the centre, along the ray. A unit normal that faces the ray points back to its side.",
    );
    let cut = cut_of(ray, sphere);
    let p = ray.at(t);
    let right = what.expected.vector("n").unwrap_or_default();
    let got = what.wrong().and_then(|got| got.vector("n"));
    if got.is_some_and(|n| !cut.holds(n)) {
        page.note("Your vector does not lie in this cut: you see it from the front.");
    }
    let mut needed = rim(sphere);
    needed.extend([cut.at(ray.origin), cut.at(p + right)]);
    let wished: Vec<DVec2> = got.map(|n| cut.at(p + n)).into_iter().collect();
    let (view, is_near) = View::new(&needed, &wished, page.room);
    if !is_near {
        page.note("Your normal is too long to be drawn whole.");
    }
    let [given, green, red] = [page.given(), page.right(), page.wrong()];
    let mut sketch = Sketch::new(&mut page.drawing, page.room, page.theme);
    the_sphere(&mut sketch, &view, sphere);
    the_ray(&mut sketch, &view, &cut, ray, given);
    let at = |p: DVec3| view.at(cut.at(p));
    sketch.arrow(at(p), at(p + right), green);
    sketch.name_in(at(p + right), Words::from("true ").tex(r"\mathbf{n}"), green.color);
    if let Some(n) = got {
        sketch.arrow(at(p), at(p + n), red);
        sketch.name_in(at(p + n), Words::from("your ").tex(r"\mathbf{n}"), red.color);
    }
    sketch.dot(at(p), given.color);
    sketch.name_in(at(p), Words::default().tex(r"\mathbf{p}"), given.color);
    sketch.finish();
    page.drawing
}

/// The cut through the centre along the ray, seen from the centre.
fn cut_of(ray: &Ray, sphere: &Sphere) -> Cut {
    Cut::through(sphere.center, ray.direction, ray.origin - sphere.center)
}

fn rim(sphere: &Sphere) -> Vec<DVec2> {
    vec![DVec2::splat(-sphere.radius), DVec2::splat(sphere.radius)]
}

fn the_sphere(sketch: &mut Sketch<'_>, view: &View, sphere: &Sphere) {
    let (center, radius) = (view.at(DVec2::ZERO), view.length(sphere.radius));
    sketch.drawing.fill(Path::circle(center, radius), sketch.theme.panel);
    sketch.drawing.stroke(Path::circle(center, radius), Pen::new(sketch.theme.ink, 2.0));
    let on_rim = |i: i32| {
        let angle = std::f64::consts::TAU * f64::from(i) / 48.0;
        center + radius * DVec2::new(libm::cos(angle), libm::sin(angle))
    };
    let points: Vec<DVec2> = (0..=48).map(on_rim).collect();
    sketch.keep_off(&points);
    sketch.dot(center, sketch.theme.ink);
    sketch.name(center, Words::default().tex(r"\mathbf{c}"));
}

fn the_ray(sketch: &mut Sketch<'_>, view: &View, cut: &Cut, ray: &Ray, pen: Pen) {
    let (eye, tip) = (view.at(cut.at(ray.origin)), view.at(cut.at(ray.origin + ray.direction)));
    let way = (tip - eye).normalize_or_zero();
    sketch.line(eye, eye - 3e3 * way, sketch.guide());
    sketch.line(eye, eye + 3e3 * way, Pen { width: 1.2, ..pen });
    sketch.arrow(eye, tip, pen);
    sketch.name_in(tip, Words::default().tex(r"\mathbf{d}"), pen.color);
    sketch.dot(eye, pen.color);
    sketch.name_in(eye, Words::default().tex(r"\mathbf{o}"), pen.color);
}
