//! A ray and a plane from the side: in the plane that the normal and the ray span, the normal up.

use glam::{DVec2, DVec3};

use super::sketch::Sketch;
use crate::pictures::drawing::{Dash, Pen, Rect, Words};
use crate::pictures::theme::Hue;
use crate::tree::RayNode;

/// A ray beside a plane, as numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// How high the origin of the ray lies above the plane.
    height: f64,
    /// What a unit of t adds to the height, and across.
    climb: f64,
    across: f64,
    /// Where the ray meets the plane; behind the origin where it is negative.
    t: Option<f64>,
    /// The direction that is drawn to the right: a unit vector in the plane.
    pub(super) right: DVec3,
}

impl Side {
    /// A ray whose origin is `height` above a plane with the unit normal `normal`.
    pub(super) fn new(node: &RayNode, normal: DVec3, height: f64, t: Option<f64>) -> Self {
        let d = DVec3::from(node.direction);
        let along = d - normal * d.dot(normal);
        let right = along.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
        let (climb, across) = (d.dot(normal), d.dot(right));
        // Far along a ray that is as good as parallel nothing is left to be drawn.
        let t = t.filter(|t| (t * d.length()).abs() < 1e100);
        Side { height, climb, across, t, right }
    }
}

/// Where things stand in a side view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    /// Units a world unit, across and up.
    scale: DVec2,
    /// Where the origin of the ray and its foot on the plane are.
    pub(super) eye: DVec2,
    /// Where the ray meets the plane.
    pub(super) hit: Option<DVec2>,
    /// The height of the plane on the canvas.
    pub(super) ground: f64,
    /// The direction of the ray on the canvas, of unit length.
    pub(super) along: DVec2,
    /// Whether heights are drawn larger than widths.
    pub(super) is_stretched: bool,
}

/// The least height of a ray's origin on the canvas, if it has one.
const LEAST: f64 = 58.0;

impl Placed {
    /// The layout of a side view in `room`.
    pub(super) fn new(side: &Side, room: Rect) -> Self {
        let size = room.size();
        let width = side.t.map_or(0.0, |t| (t * side.across).abs());
        let height = side.height.abs();
        // Below the plane there is room for its name, above the origin of the ray for that of the ray.
        let below = (0.27 * size.y).min(76.0);
        let above = (0.45 * size.y).min(90.0);
        let free = if side.height >= 0.0 { below + (0.2 * size.y).min(44.0) } else { above + (0.2 * size.y).min(44.0) };
        let most = DVec2::new(0.7 * size.x, size.y - free);
        // Where there is neither width nor height any scale is right.
        let ratio = |room: f64, span: f64| if span > 0.0 { room / span } else { f64::INFINITY };
        let even = ratio(most.x, width).min(ratio(most.y, height));
        let even = if even.is_finite() { even } else { 1.0 };
        let is_stretched = height > 0.0 && height * even < LEAST.min(most.y);
        let up = if is_stretched { LEAST.min(most.y) / height } else { even };
        let scale = DVec2::new(even, up);
        // What is not needed is left free above and below alike.
        let spare = 0.45 * (most.y - height * up).max(0.0);
        let ground = if side.height >= 0.0 { room.max.y - below - spare } else { room.min.y + above + spare };
        let backward = side.t.is_some_and(|t| t < 0.0);
        let wide = width * even;
        // Behind the origin of the ray there is something, and before it the ray.
        let share = if backward { 0.12 } else { 0.45 };
        let left = room.min.x + (share * (size.x - wide)).max(0.0);
        let right = left + wide;
        let (eye_x, hit_x) = if backward { (right, left) } else { (left, right) };
        let eye = DVec2::new(eye_x, ground - side.height * up);
        let along = DVec2::new(side.across * scale.x, -side.climb * scale.y);
        let along = along.try_normalize().unwrap_or(DVec2::X);
        let hit = side.t.map(|_| DVec2::new(hit_x, ground));
        Placed { scale, eye, hit, ground, along, is_stretched }
    }

    /// Where a point of the plane is that lies `right` to the right of where the ray meets it.
    pub(super) fn on_ground(&self, right: f64) -> DVec2 {
        let x = self.hit.map_or(self.eye.x, |hit| hit.x) + right * self.scale.x;
        DVec2::new(x.clamp(-1e4, 1e4), self.ground)
    }

    /// How far down a height of the world is, from the plane.
    pub(super) fn down(&self, height: f64) -> f64 {
        (-height * self.scale.y).clamp(-1e4, 1e4)
    }
}

/// Draws the plane, its normal where the ray meets it, and the ray.
pub(super) fn draw(sketch: &mut Sketch<'_>, side: &Side, placed: &Placed, node: &RayNode, solid: bool) {
    let theme = sketch.theme;
    let room = sketch.room;
    let &Placed { eye, hit, ground, along, .. } = placed;
    let (a, b) = (DVec2::new(room.min.x, ground), DVec2::new(room.max.x, ground));
    if solid {
        sketch.drawing.ground(a, b, 12.0, Pen::new(theme.axis, 0.8));
    }
    sketch.line(a, b, Pen::new(theme.ink, 1.8));
    let (pen, rest) = (theme.ray(node.kind, 2.4), theme.ray(node.kind, 1.3));
    let faint = Pen { color: rest.color.mix(theme.background, 0.4), ..rest };
    let reach = room.size().x + room.size().y;
    match hit {
        Some(hit) if side.t.is_some_and(|t| t >= 0.0) => {
            sketch.faint(hit, hit + 60.0 * along, faint);
            sketch.ray(eye, hit, pen);
        }
        Some(hit) => {
            sketch.faint(eye, hit - 40.0 * along, sketch.guide());
            sketch.ray(eye, eye + 0.3 * reach * along, pen);
        }
        None => sketch.ray(eye, eye + 0.5 * reach * along, pen),
    }
    let foot = hit.unwrap_or(DVec2::new(eye.x + 0.25 * room.size().x, ground));
    let normal = theme.hue(Hue::Purple);
    let length = 58.0_f64.min(ground - room.min.y - 6.0);
    sketch.arrow(foot, foot - DVec2::new(0.0, length), Pen::new(normal, 2.2));
    sketch.drawing.right_angle(foot, DVec2::X, DVec2::NEG_Y, 9.0, Pen::new(theme.axis, 1.1));
    sketch.name_in(foot - DVec2::new(0.0, length), Words::default().tex(r"\mathbf{n}"), normal);
    direction(sketch, placed, pen);
    sketch.dot(eye, theme.ink);
    sketch.name(eye, Words::default().tex(r"\mathbf{o}"));
    if let Some(hit) = hit {
        sketch.dot(hit, pen.color);
        sketch.name(hit, Words::default().tex(r"\mathbf{p}"));
    }
}

/// Draws the direction of the ray at its origin, and its projection on the normal.
fn direction(sketch: &mut Sketch<'_>, placed: &Placed, pen: Pen) {
    let theme = sketch.theme;
    let far = placed.hit.map_or(f64::INFINITY, |hit| hit.distance(placed.eye));
    let length = if far > 24.0 { (0.42 * far).min(92.0) } else { 92.0 };
    let tip = placed.eye + length * placed.along;
    sketch.arrow(placed.eye, tip, Pen { width: 4.0, dash: Dash::Solid, ..pen });
    sketch.name_in(tip, Words::default().tex(r"\mathbf{d}"), pen.color);
    let foot = DVec2::new(placed.eye.x, tip.y);
    // Straight up or down it would lie on the direction itself.
    if (foot.y - placed.eye.y).abs() > 18.0 && (tip.x - placed.eye.x).abs() > 8.0 {
        let normal = Pen::new(theme.hue(Hue::Purple), 1.6);
        sketch.faint(tip, foot, sketch.guide());
        sketch.arrow(placed.eye, foot, normal);
        sketch.beside(placed.eye, foot, Words::default().tex(r"\mathbf{n}\cdot\mathbf{d}"), normal.color);
    }
}
