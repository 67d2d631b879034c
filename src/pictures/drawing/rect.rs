//! Axis-parallel rectangles.

use glam::DVec2;

/// A rectangle, x to the right and y down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Its upper left corner.
    pub min: DVec2,
    /// Its lower right corner.
    pub max: DVec2,
}

impl Rect {
    /// The rectangle with a corner and a size.
    pub fn new(min: impl Into<DVec2>, size: impl Into<DVec2>) -> Self {
        let min = min.into();
        Rect { min, max: min + size.into() }
    }

    /// The smallest rectangle around points, or nothing if there are none.
    pub fn around(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        let grow = |r: Rect, p: DVec2| Rect { min: r.min.min(p), max: r.max.max(p) };
        points.into_iter().fold(None, |rect, p| Some(rect.map_or(Rect { min: p, max: p }, |r| grow(r, p))))
    }

    /// Width and height.
    pub fn size(self) -> DVec2 {
        self.max - self.min
    }

    /// The point in the middle.
    pub fn center(self) -> DVec2 {
        (self.min + self.max) / 2.0
    }

    /// The corners, clockwise from the upper left.
    pub fn corners(self) -> [DVec2; 4] {
        let Rect { min, max } = self;
        [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)]
    }

    /// The smallest rectangle around both.
    pub fn union(self, other: Self) -> Self {
        Rect { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The rectangle with `margin` added on all four sides, taken away if negative.
    pub fn grown(self, margin: f64) -> Self {
        Rect { min: self.min - margin, max: self.max + margin }
    }

    /// The rectangle moved by `offset`.
    pub fn moved(self, offset: DVec2) -> Self {
        Rect { min: self.min + offset, max: self.max + offset }
    }

    /// Whether the two share more than a border.
    pub fn overlaps(self, other: Self) -> bool {
        self.min.cmplt(other.max).all() && other.min.cmplt(self.max).all()
    }

    /// Whether `other` lies within, borders included.
    pub fn contains(self, other: Self) -> bool {
        self.min.cmple(other.min).all() && other.max.cmple(self.max).all()
    }

    /// The area that both cover.
    pub fn overlap_area(self, other: Self) -> f64 {
        let size = (self.max.min(other.max) - self.min.max(other.min)).max(DVec2::ZERO);
        size.x * size.y
    }

    /// The part of the segment from `a` to `b` that lies within, borders included (Liang and Barsky 1984), or nothing
    /// where it misses. It is how a ray of any length is cut to a panel.
    pub fn clip(self, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
        let d = b - a;
        let (mut t_in, mut t_out) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            if d[axis] == 0.0 {
                if !(self.min[axis] <= a[axis] && a[axis] <= self.max[axis]) {
                    return None;
                }
                continue;
            }
            let t = [(self.min[axis] - a[axis]) / d[axis], (self.max[axis] - a[axis]) / d[axis]];
            t_in = t_in.max(t[0].min(t[1]));
            t_out = t_out.min(t[0].max(t[1]));
        }
        (t_in <= t_out).then(|| (a + d * t_in, a + d * t_out))
    }
}
