//! From points of the world to the canvas.

use glam::{DVec2, DVec3};

use crate::pictures::drawing::Rect;

/// An even scale, y up.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    scale: DVec2,
    center: DVec2,
    middle: DVec2,
}

impl View {
    /// The view of `needed` points, and of those `wished` for that are not so far off that little else would be seen. Returns
    /// it with whether all those are seen.
    pub(super) fn new(needed: &[DVec2], wished: &[DVec2], room: Rect) -> (Self, bool) {
        let core = Rect::around(needed.iter().copied()).unwrap_or(Rect { min: DVec2::ZERO, max: DVec2::ONE });
        let reach = core.grown(2.5 * core.size().max_element().max(0.5));
        let is_near = |p: &DVec2| reach.contains(Rect { min: *p, max: *p });
        let near = wished.iter().copied().filter(is_near);
        let all = Rect::around(near).map_or(core, |rect| rect.union(core));
        let inner = room.grown(-36.0);
        let scale = (inner.size() / all.size().max(DVec2::splat(1e-6))).min_element();
        let view = View { scale: DVec2::splat(scale), center: all.center(), middle: inner.center() };
        (view, wished.iter().all(is_near))
    }

    /// The same with a scale of its own for each axis, for charts.
    pub(super) fn stretched(low: DVec2, high: DVec2, room: Rect) -> Self {
        let scale = room.size() / (high - low).max(DVec2::splat(1e-6));
        View { scale, center: (low + high) / 2.0, middle: room.center() }
    }

    /// Where a point stands on the canvas.
    pub(super) fn at(&self, p: DVec2) -> DVec2 {
        let off = ((p - self.center) * self.scale).clamp(DVec2::splat(-9e3), DVec2::splat(9e3));
        self.middle + DVec2::new(off.x, -off.y)
    }

    /// A point far beyond the canvas, from a point in a direction.
    pub(super) fn beyond(&self, from: DVec2, way: DVec2) -> DVec2 {
        let way = (way * self.scale).normalize_or_zero();
        self.at(from) + 3e3 * DVec2::new(way.x, -way.y)
    }

    /// A length on the canvas, along x.
    pub(super) fn length(&self, x: f64) -> f64 {
        (x * self.scale.x).min(9e3)
    }
}

/// A point in space as seen from the front, right and above: x to the right, y up, z towards the viewer and down to the left.
pub(super) fn oblique(p: DVec3) -> DVec2 {
    DVec2::new(p.x - 0.42 * p.z, p.y - 0.34 * p.z)
}

/// A plane in space with two unit axes, to be looked at from the front.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    origin: DVec3,
    right: DVec3,
    up: DVec3,
}

impl Cut {
    /// The plane through `origin` that holds `right`, and `other` as well as can be, which points up in it.
    pub(super) fn through(origin: DVec3, right: DVec3, other: DVec3) -> Self {
        let right = right.try_normalize().or_else(|| other.try_normalize()).unwrap_or(DVec3::X);
        let up = other - other.dot(right) * right;
        // Parallel but for rounding.
        let is_clear = up.length() > 1e-9 * other.length();
        let up = up.try_normalize().filter(|_| is_clear).unwrap_or_else(|| right.any_orthonormal_vector());
        Cut { origin, right, up }
    }

    /// A point, seen straight on.
    pub(super) fn at(&self, p: DVec3) -> DVec2 {
        self.way(p - self.origin)
    }

    /// A direction, seen straight on.
    pub(super) fn way(&self, v: DVec3) -> DVec2 {
        DVec2::new(v.dot(self.right), v.dot(self.up))
    }

    /// Whether a direction lies in the plane, near enough for a drawing.
    pub(super) fn holds(&self, v: DVec3) -> bool {
        let off = v - v.dot(self.right) * self.right - v.dot(self.up) * self.up;
        off.length() <= 1e-3 * v.length().max(1e-9)
    }
}
