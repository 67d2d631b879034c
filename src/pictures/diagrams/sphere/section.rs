//! The whole sphere with the ray.

use glam::DVec2;

use super::Cut;
use crate::pictures::diagrams::numbers::tex;
use crate::pictures::diagrams::sketch::Sketch;
use crate::pictures::diagrams::subject::Subject;
use crate::pictures::drawing::{Dash, Drawing, Path, Pen, Rect, Words};
use crate::pictures::theme::{Hue, Theme};

/// Where things stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// Units a world unit.
    pub(super) scale: f64,
    /// Where the foot of the perpendicular is.
    pub(super) foot: DVec2,
    /// Where the origin of the ray is.
    pub(super) eye: DVec2,
    /// Whether the way from there to the sphere is shortened.
    pub(super) is_broken: bool,
}

impl Frame {
    pub(super) fn new(cut: &Cut, room: Rect) -> Self {
        let size = room.size();
        let r = match cut.radius {
            r if r > 0.0 => r,
            // A sphere that is a point.
            _ => (0.2 * cut.away).max(0.1 * cut.foot.abs()).max(1e-30),
        };
        // Along the ray, from the foot.
        let eye = -cut.foot;
        let (near, far) = (-1.25 * r, 1.25 * r);
        let reach = 2.3 * r + 0.3 * cut.away;
        let (eye, is_broken) = match eye {
            e if e < near - reach => (near - 0.9 * r, true),
            e if e > far + reach => (far + 0.9 * r, true),
            e => (e, false),
        };
        let (left, right) = (near.min(eye - 0.2 * r), far.max(eye + 0.75 * r));
        let (top, bottom) = (0.0_f64.min(cut.away - r), 0.0_f64.max(cut.away + r));
        let height = (bottom - top).max(0.5 * r);
        let scale = ((size.x - 24.0) / (right - left)).min((size.y - 44.0) / height);
        let x = room.center().x - scale * (left + right) / 2.0;
        let y = room.center().y - scale * (top + bottom) / 2.0;
        let foot = DVec2::new(x, y);
        Frame { scale, foot, eye: foot + DVec2::new(scale * eye, 0.0), is_broken }
    }

    /// A place on the ray, by its world distance from the origin of the ray.
    pub(super) fn on_ray(&self, cut: &Cut, x: f64) -> DVec2 {
        match self.is_broken {
            true => self.foot + DVec2::new((x - cut.foot) * self.scale, 0.0),
            false => self.eye + DVec2::new(x * self.scale, 0.0),
        }
    }

    /// The centre of the sphere.
    fn center(&self, cut: &Cut) -> DVec2 {
        self.foot + DVec2::new(0.0, cut.away * self.scale)
    }
}

pub(super) fn draw(drawing: &mut Drawing, room: Rect, cut: &Cut, frame: &Frame, subject: &Subject<'_>, theme: &Theme) {
    let mut sketch = Sketch::new(drawing, room, theme);
    let center = frame.center(cut);
    let radius = (cut.radius * frame.scale).max(2.0);
    let circle = Path::circle(center, radius);
    sketch.drawing.fill(circle.clone(), theme.panel);
    sketch.drawing.stroke(circle, Pen::new(theme.ink, 1.8));
    let rim: Vec<DVec2> = (0..=48).map(|i| center + radius * on_circle(f64::from(i) / 48.0)).collect();
    sketch.keep_off(&rim);

    let pen = theme.ray(subject.node.kind, 2.4);
    let faint = Pen { color: pen.color.mix(theme.background, 0.4), width: 1.3, ..pen };
    let roots = cut.roots.map(|roots| roots.map(|x| frame.on_ray(cut, x)));
    let taken = cut.taken.and_then(|i| roots.map(|roots| roots[i]));
    let (west, east) = (DVec2::new(room.min.x, frame.eye.y), DVec2::new(room.max.x, frame.eye.y));
    if center.x - radius < frame.eye.x {
        sketch.line(west, frame.eye, sketch.guide());
    }
    match taken.filter(|_| subject.t().is_some_and(|t| t >= 0.0)) {
        Some(hit) => {
            sketch.ray(frame.eye, hit, pen);
            sketch.line(hit, east, faint);
        }
        None => sketch.ray(frame.eye, east, pen),
    }
    if frame.is_broken {
        let right = frame.eye.x > frame.foot.x;
        let edge = center.x + if right { radius } else { -radius };
        let at = DVec2::new(frame.eye.x + 0.3 * (edge - frame.eye.x), frame.eye.y);
        sketch.broken(at - DVec2::X, at + DVec2::X, theme.axis);
    }
    lines(&mut sketch, cut, frame, subject, roots);
    sketch.dot(center, theme.ink);
    sketch.name(center, Words::default().tex(r"\mathbf{c}"));
    sketch.dot(frame.eye, theme.ink);
    sketch.name(frame.eye, Words::default().tex(r"\mathbf{o}"));
    points(&mut sketch, cut, frame, subject, roots);
    sketch.finish();
}

/// The perpendicular, the half chord, the radius.
fn lines(sketch: &mut Sketch<'_>, cut: &Cut, frame: &Frame, subject: &Subject<'_>, roots: Option<[DVec2; 2]>) {
    let theme = sketch.theme;
    let (foot, center) = (frame.foot, frame.center(cut));
    let purple = theme.hue(Hue::Purple);
    if foot.distance(center) > 6.0 {
        sketch.line(foot, center, Pen::new(purple, 1.6));
        let words = match subject.number("l_dot_l") {
            Some(_) => Words::default().tex(r"\sqrt{\mathbf{l}\cdot\mathbf{l}\,/\,a}"),
            None => Words::default().tex(r"\sqrt{r^2 - \Delta\,/\,4a}"),
        };
        // On the right first: the radius is on the left.
        sketch.beside(center, foot, words, purple);
    }
    if foot.distance(center) > 24.0 {
        sketch.drawing.right_angle(foot, DVec2::X, DVec2::Y, 8.0, Pen::new(theme.axis, 1.1));
    }
    let Some([near, far]) = roots else {
        // What is missing.
        let top = center - DVec2::new(0.0, cut.radius * frame.scale);
        radius_to(sketch, center, center + cut.radius * frame.scale * DVec2::splat(std::f64::consts::FRAC_1_SQRT_2));
        if foot.distance(top) > 10.0 {
            let red = theme.hue(Hue::Vermilion);
            let [p, q] = sketch.drawing.dimension(foot, top, 14.0, Pen::new(red, 1.6));
            sketch.keep_off(&[p, q]);
            sketch.beside(p, q, Words::from("missed by this"), red);
        }
        return;
    };
    if near.distance(far) > 30.0 {
        let green = theme.hue(Hue::Green);
        let half = match subject.number("l_dot_l") {
            Some(_) => r"\sqrt{\Delta\,/\,a}",
            None => r"\sqrt{\Delta\,/\,4a}",
        };
        sketch.length(foot, far, 12.0, Words::default().tex(half), green);
    }
    // Where it would lie on the perpendicular or on the ray it is drawn elsewhere.
    let is_clear = near.distance(foot) > 34.0 && foot.distance(center) > 60.0;
    let elsewhere = center + cut.radius * frame.scale * DVec2::splat(std::f64::consts::FRAC_1_SQRT_2);
    radius_to(sketch, center, if is_clear { near } else { elsewhere });
}

/// Draws the radius to a point of the circle, where it is long enough.
fn radius_to(sketch: &mut Sketch<'_>, center: DVec2, rim: DVec2) {
    if center.distance(rim) > 12.0 {
        let muted = sketch.theme.muted;
        sketch.line(center, rim, Pen::new(muted, 1.3).dashed(Dash::Short));
        sketch.beside(center, rim, Words::default().tex("r"), muted);
    }
}

/// The roots with their numbers.
fn points(sketch: &mut Sketch<'_>, cut: &Cut, frame: &Frame, subject: &Subject<'_>, roots: Option<[DVec2; 2]>) {
    let theme = sketch.theme;
    let named = [("t_in", r"t_{\mathrm{in}}"), ("t_out", r"t_{\mathrm{out}}")];
    let Some(roots) = roots else {
        sketch.disk(frame.foot, 3.0, theme.muted);
        return;
    };
    let values = named.map(|(key, _)| subject.number(key));
    if let [Some(t_in), Some(t_out)] = values
        && t_in == t_out
    {
        let color = theme.ray(subject.node.kind, 1.0).color;
        sketch.dot(roots[0], color);
        let words = format!("{} = {} = {}", named[0].1, named[1].1, tex(t_in));
        sketch.name_in(roots[0], Words::default().tex(&words), color);
        return;
    }
    for (i, (key, letter)) in named.into_iter().enumerate() {
        let color = if cut.taken == Some(i) { theme.ray(subject.node.kind, 1.0).color } else { theme.muted };
        let Some(t) = subject.number(key).or(subject.t().filter(|_| cut.taken == Some(i))) else { continue };
        sketch.dot(roots[i], color);
        sketch.name_aside(roots[i], Words::default().tex(&format!("{letter} = {}", tex(t))), color, i == 0);
    }
}

/// The point of the unit circle at a share of a full turn.
fn on_circle(share: f64) -> DVec2 {
    let angle = std::f64::consts::TAU * share;
    DVec2::new(libm::cos(angle), libm::sin(angle))
}
