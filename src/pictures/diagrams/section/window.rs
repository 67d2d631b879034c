//! Which part of the plane is seen, and how large.

use glam::DVec2;

use super::cut::Cut;
use super::plane::{Plane, Ray};
use crate::pictures::drawing::Rect;

/// A part of the plane on a part of the canvas.
#[derive(Clone, Copy)]
pub(super) struct Window {
    /// On the canvas.
    pub(super) frame: Rect,
    /// The point of the plane in the middle.
    middle: DVec2,
    /// Units of the canvas for each unit of length.
    pub(super) scale: f64,
}

/// The share of the frame that is left free around what it was chosen for.
const MARGIN: f64 = 0.13;

/// A ray shorter than this on the canvas is hard to see.
const SHORT: f64 = 40.0;

/// By how much the window may grow to show a shape in full.
const GROWTH: f64 = 1.55;

impl Window {
    /// The window around points.
    fn around(frame: Rect, points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        let bounds = Rect::around(points)?;
        let size = bounds.size();
        let room = frame.size() * (1.0 - 2.0 * MARGIN);
        let scale = (room / size.max(DVec2::splat(f64::MIN_POSITIVE))).min_element();
        let fits = size.max_element() > 0.0 && scale.is_finite() && scale > 0.0;
        fits.then_some(Window { frame, middle: bounds.center(), scale })
    }

    /// The window in which most of the tree is seen: of the windows around the hit and the points nearest to it, however many,
    /// the one in which the most rays are long enough to see. Then it grows, where that costs little, to show shapes in full.
    pub(super) fn choose(frame: Rect, plane: &Plane, rays: &[Ray<'_>], cuts: &[&Cut]) -> Self {
        let mut points = vec![DVec2::ZERO];
        points.extend(rays.iter().flat_map(|ray| [Some(ray.start), ray.end]).flatten().map(|p| plane.at(p)));
        points.retain(|p| p.is_finite());
        points.sort_by(|a, b| a.length().total_cmp(&b.length()));
        points.dedup();
        let mut best: Option<(f64, Window)> = None;
        for count in 2..=points.len() {
            let Some(window) = Window::around(frame, points[..count].iter().copied()) else { continue };
            let score = rays.iter().map(|ray| ray.importance * window.shows(plane, ray)).sum();
            if best.is_none_or(|(most, _)| score >= most) {
                best = Some((score, window));
            }
        }
        let mut window = best.map(|(_, window)| window);
        let near = |cut: &Cut| cut.extent().iter().map(|p| p.length()).fold(f64::INFINITY, f64::min);
        let mut order: Vec<&Cut> = cuts.to_vec();
        order.sort_by(|a, b| near(a).total_cmp(&near(b)));
        for cut in order {
            let extent = cut.extent();
            let seen = window.map_or(vec![DVec2::ZERO], |window| window.corners());
            let Some(larger) = Window::around(frame, seen.into_iter().chain(extent)) else { continue };
            if window.is_none_or(|window| larger.scale * GROWTH >= window.scale) {
                window = Some(larger);
            }
        }
        window.unwrap_or(Window { frame, middle: DVec2::ZERO, scale: 0.3 * frame.size().min_element() })
    }

    /// The corners of what it was chosen for, in the plane.
    fn corners(&self) -> Vec<DVec2> {
        let half = self.frame.size() * (0.5 - MARGIN) / self.scale;
        vec![self.middle - half, self.middle + half]
    }

    /// Where a point of the plane is on the canvas; may be far off.
    pub(super) fn at(&self, point: DVec2) -> DVec2 {
        let moved = self.scale * (point - self.middle);
        self.frame.center() + DVec2::new(moved.x, -moved.y)
    }

    /// A direction of the plane on the canvas.
    pub(super) fn turned(v: DVec2) -> DVec2 {
        DVec2::new(v.x, -v.y)
    }

    /// Where a ray starts and ends on the canvas; one without end goes on far beyond the frame.
    pub(super) fn ends(&self, plane: &Plane, ray: &Ray<'_>) -> [DVec2; 2] {
        let start = self.at(plane.at(ray.start));
        let end = match ray.end {
            Some(end) => self.at(plane.at(end)),
            None => {
                let reach = 4.0 * self.frame.size().length() + start.distance(self.frame.center());
                start + Window::turned(plane.along(ray.direction)).normalize_or_zero() * reach
            }
        };
        [start, end]
    }

    /// How well a ray is seen, from 0 to 1.
    fn shows(&self, plane: &Plane, ray: &Ray<'_>) -> f64 {
        let [start, end] = self.ends(plane, ray);
        let Some((a, b)) = self.frame.clip(start, end) else { return 0.0 };
        let long = (a.distance(b) / SHORT).min(1.0);
        let inside = |p: DVec2| self.frame.contains(Rect { min: p, max: p });
        let whole = inside(start) && (ray.end.is_none() || inside(end));
        long * if whole { 1.0 } else { 0.6 }
    }
}
