//! Outlines: straight pieces and Bézier curves.

use glam::DVec2;

use super::rect::Rect;

/// A piece of an outline. Each begins where the one before it ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Begins a new contour here.
    Move(DVec2),
    /// A straight line to here.
    Line(DVec2),
    /// A quadratic Bézier curve: control point, end.
    Quad(DVec2, DVec2),
    /// A cubic Bézier curve: two control points, end.
    Cubic(DVec2, DVec2, DVec2),
    /// A straight line back to where the contour began.
    Close,
}

impl Segment {
    /// The points of the piece, control points included.
    pub fn points(&self) -> impl Iterator<Item = DVec2> + use<> {
        let (points, count) = match *self {
            Self::Move(p) | Self::Line(p) => ([p; 3], 1),
            Self::Quad(c, p) => ([c, p, p], 2),
            Self::Cubic(c, d, p) => ([c, d, p], 3),
            Self::Close => ([DVec2::ZERO; 3], 0),
        };
        points.into_iter().take(count)
    }

    /// The piece with every point sent through `f`, which has to be affine.
    pub fn map(self, f: impl Fn(DVec2) -> DVec2) -> Self {
        match self {
            Self::Move(p) => Self::Move(f(p)),
            Self::Line(p) => Self::Line(f(p)),
            Self::Quad(c, p) => Self::Quad(f(c), f(p)),
            Self::Cubic(c, d, p) => Self::Cubic(f(c), f(d), f(p)),
            Self::Close => Self::Close,
        }
    }
}

/// An outline of any number of contours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// Its pieces in order.
    pub segments: Vec<Segment>,
}

impl Path {
    /// The straight line from `a` to `b`.
    pub fn line(a: impl Into<DVec2>, b: impl Into<DVec2>) -> Self {
        Path::open([a.into(), b.into()])
    }

    /// The open chain through `points`.
    pub fn open(points: impl IntoIterator<Item = DVec2>) -> Self {
        let piece = |(i, p)| if i == 0 { Segment::Move(p) } else { Segment::Line(p) };
        Path { segments: points.into_iter().enumerate().map(piece).collect() }
    }

    /// The closed polygon through `points`.
    pub fn polygon(points: impl IntoIterator<Item = DVec2>) -> Self {
        let mut path = Path::open(points);
        path.segments.push(Segment::Close);
        path
    }

    /// The border of a rectangle.
    pub fn rect(rect: Rect) -> Self {
        Path::polygon(rect.corners())
    }

    /// A rectangle whose corners are quarter circles of `radius`, at most half of the shorter side.
    pub fn rounded(rect: Rect, radius: f64) -> Self {
        let r = radius.min(rect.size().min_element() / 2.0);
        let mut segments = Vec::new();
        let corners = rect.corners();
        for i in 0..4 {
            let (before, corner, after) = (corners[(i + 3) % 4], corners[i], corners[(i + 1) % 4]);
            let a = corner + (before - corner).normalize_or_zero() * r;
            let b = corner + (after - corner).normalize_or_zero() * r;
            segments.push(if i == 0 { Segment::Move(a) } else { Segment::Line(a) });
            segments.push(Segment::Cubic(a + (corner - a) * QUARTER, b + (corner - b) * QUARTER, b));
        }
        segments.push(Segment::Close);
        Path { segments }
    }

    /// A circle.
    pub fn circle(center: impl Into<DVec2>, radius: f64) -> Self {
        Path::ellipse(center, DVec2::splat(radius))
    }

    /// An ellipse with axes along x and y.
    pub fn ellipse(center: impl Into<DVec2>, radii: DVec2) -> Self {
        let center = center.into();
        let at = |x: f64, y: f64| center + radii * DVec2::new(x, y);
        let q = QUARTER;
        Path {
            segments: vec![
                Segment::Move(at(1.0, 0.0)),
                Segment::Cubic(at(1.0, q), at(q, 1.0), at(0.0, 1.0)),
                Segment::Cubic(at(-q, 1.0), at(-1.0, q), at(-1.0, 0.0)),
                Segment::Cubic(at(-1.0, -q), at(-q, -1.0), at(0.0, -1.0)),
                Segment::Cubic(at(q, -1.0), at(1.0, -q), at(1.0, 0.0)),
                Segment::Close,
            ],
        }
    }

    /// The arc of a circle from one angle to another, in radians from the x axis; with y down, growing angles go
    /// clockwise. It may go round more than once.
    ///
    /// # Accuracy
    /// Cubics over at most an eighth of a turn, off by less than 5e-6 of the radius.
    pub fn arc(center: impl Into<DVec2>, radius: f64, from: f64, to: f64) -> Self {
        let center = center.into();
        let pieces = ((to - from).abs() / std::f64::consts::FRAC_PI_4).ceil().clamp(1.0, 64.0);
        let step = (to - from) / pieces;
        let k = 4.0 / 3.0 * libm::tan(step / 4.0);
        let unit = |angle: f64| DVec2::new(libm::cos(angle), libm::sin(angle));
        let mut segments = vec![Segment::Move(center + radius * unit(from))];
        for i in 0..pieces as usize {
            let (u, v) = (unit(from + i as f64 * step), unit(from + (i + 1) as f64 * step));
            let (c, d) = (u + k * u.perp(), v - k * v.perp());
            segments.push(Segment::Cubic(center + radius * c, center + radius * d, center + radius * v));
        }
        Path { segments }
    }

    /// The path followed by the contours of `other`.
    pub fn and(mut self, other: Path) -> Self {
        self.segments.extend(other.segments);
        self
    }

    /// The path with every point sent through `f`, which has to be affine.
    pub fn map(&self, f: impl Fn(DVec2) -> DVec2) -> Self {
        Path { segments: self.segments.iter().map(|s| s.map(&f)).collect() }
    }

    /// A rectangle around the path: exact for straight pieces, around the control points of curves.
    pub fn bounds(&self) -> Option<Rect> {
        Rect::around(self.segments.iter().flat_map(Segment::points))
    }
}

/// How far the control points of a quarter circle lie from its ends, in radii: 4/3 (sqrt 2 - 1).
const QUARTER: f64 = 0.552_284_749_830_793_4;
