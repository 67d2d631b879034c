//! What diagrams are made of beyond lines: arrows, angles, lengths, media, listings.

use glam::DVec2;

use super::pen::{Color, Dash, Pen};
use super::{Drawing, Face, Path, Rect, Text};

/// A head is so many widths of the line long, and at least so many units.
const HEAD: (f64, f64) = (4.2, 7.0);

/// The angle of `v`, in radians clockwise from the x axis, in (-pi, pi].
pub fn angle_of(v: DVec2) -> f64 {
    libm::atan2(v.y, v.x)
}

impl Drawing {
    /// Draws an arrow with its tip at `to`. Nothing where the two points are the same.
    pub fn arrow(&mut self, from: impl Into<DVec2>, to: impl Into<DVec2>, pen: Pen) {
        let (from, to) = (from.into(), to.into());
        let Some(along) = (to - from).try_normalize() else { return };
        let length = head_length(pen).min(0.6 * from.distance(to));
        // The line ends within the head, or its round end would show beside the tip.
        self.line(from, to - 0.8 * length * along, pen);
        self.head(to, along, length, pen.color);
    }

    /// Draws a line with a head that shows its direction, the head's tip at the share `at` of the way.
    pub fn directed(&mut self, from: impl Into<DVec2>, to: impl Into<DVec2>, at: f64, pen: Pen) {
        let (from, to) = (from.into(), to.into());
        self.line(from, to, pen);
        let Some(along) = (to - from).try_normalize() else { return };
        let length = head_length(pen);
        if from.distance(to) > 2.5 * length {
            self.head(from.lerp(to, at) + 0.5 * length * along, along, length, pen.color);
        }
    }

    fn head(&mut self, tip: DVec2, along: DVec2, length: f64, color: Color) {
        let (back, across) = (tip - length * along, 0.38 * length * along.perp());
        let notch = back + 0.22 * length * along;
        self.fill(Path::polygon([tip, back + across, notch, back - across]), color);
    }

    /// Draws the arc of the angle at `vertex` from the direction `a` to the direction `b`, the shorter way round, and returns
    /// the middle of the arc's label: a point beyond the arc on its bisector. Equal directions have no arc.
    pub fn angle(&mut self, vertex: impl Into<DVec2>, a: DVec2, b: DVec2, radius: f64, pen: Pen) -> DVec2 {
        let vertex = vertex.into();
        let from = angle_of(a);
        let turn = libm::atan2(a.perp_dot(b), a.dot(b));
        if turn != 0.0 {
            self.stroke(Path::arc(vertex, radius, from, from + turn), pen);
        }
        let middle = from + turn / 2.0;
        vertex + (radius + 11.0) * DVec2::new(libm::cos(middle), libm::sin(middle))
    }

    /// Draws the square corner of a right angle at `vertex` between the directions `a` and `b`.
    pub fn right_angle(&mut self, vertex: impl Into<DVec2>, a: DVec2, b: DVec2, side: f64, pen: Pen) {
        let vertex = vertex.into();
        let (a, b) = (side * a.normalize_or_zero(), side * b.normalize_or_zero());
        self.stroke(Path::open([vertex + a, vertex + a + b, vertex + b]), pen);
    }

    /// Draws a length: a line with end strokes from `a` to `b`, moved by `aside` to the right of the way, with thin lines back to
    /// the points. Returns the ends of the line, for its label to stand beside and to keep away from.
    pub fn dimension(&mut self, a: impl Into<DVec2>, b: impl Into<DVec2>, aside: f64, pen: Pen) -> [DVec2; 2] {
        let (a, b) = (a.into(), b.into());
        let across = (b - a).normalize_or_zero().perp();
        let (p, q) = (a + aside * across, b + aside * across);
        let thin = Pen { width: 0.6 * pen.width, dash: Dash::Short, ..pen };
        if aside.abs() > 8.0 {
            let gap = 3.0 * aside.signum() * across;
            self.line(a + gap, p, thin);
            self.line(b + gap, q, thin);
        }
        self.line(p, q, pen);
        for end in [p, q] {
            self.line(end - 4.0 * across, end + 4.0 * across, pen);
        }
        [p, q]
    }

    /// Hatches the inside of a path with lines in a direction, `spacing` apart. Where several are hatched in the same direction
    /// the lines run on from one to the next.
    ///
    /// More lines than [`MOST_HATCHES`] are too close to be told apart: the spacing grows.
    pub fn hatch(&mut self, inside: Path, direction: DVec2, spacing: f64, pen: Pen) {
        let Some(bounds) = inside.bounds() else { return };
        let Some(along) = direction.try_normalize() else { return };
        let across = along.perp();
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in bounds.corners() {
            (low, high) = (low.min(corner.dot(across)), high.max(corner.dot(across)));
        }
        let spacing = spacing.max((high - low) / MOST_HATCHES as f64).max(1e-3);
        self.clipped(inside, |drawing| {
            let (first, last) = ((low / spacing).ceil() as i64, (high / spacing).floor() as i64);
            let mut lines = Path::default();
            for i in first..=last {
                // Long enough to cross the whole rectangle, whatever the direction.
                let reach = bounds.size().x + bounds.size().y;
                let foot = across * (i as f64 * spacing) + along * bounds.center().dot(along);
                if let Some((a, b)) = bounds.clip(foot - reach * along, foot + reach * along) {
                    lines = lines.and(Path::line(a, b));
                }
            }
            drawing.stroke(lines, pen);
        });
    }

    /// Hatches a strip along the line from `a` to `b`, on the right of the way: the side that is matter.
    pub fn ground(&mut self, a: impl Into<DVec2>, b: impl Into<DVec2>, depth: f64, pen: Pen) {
        let (a, b) = (a.into(), b.into());
        let along = (b - a).normalize_or_zero();
        let across = along.perp();
        let strip = Path::polygon([a, b, b + depth * across, a + depth * across]);
        self.hatch(strip, along + across, 6.0, pen);
    }

    /// Writes lines of monospaced text from an upper left corner down, blanks kept, and returns the rectangle they take. Every
    /// line is a label. Lines that are wider than `width` end in an ellipsis.
    pub fn listing(&mut self, corner: impl Into<DVec2>, lines: &[String], width: f64, size: f64, color: Color) -> Rect {
        let corner = corner.into();
        let text = Text::new(size, color).face(Face::Mono);
        let columns = (width / text.width("0") + 1e-9).floor() as usize;
        let leading = (1.45 * size).round();
        let mut widest = 0.0_f64;
        for (i, line) in lines.iter().enumerate() {
            let mut line = line.clone();
            if line.chars().count() > columns {
                line = line.chars().take(columns.saturating_sub(1)).chain(['…']).collect();
            }
            widest = widest.max(text.width(&line));
            self.text(corner + DVec2::new(0.0, (i as f64 + 1.0) * leading - 0.42 * size), &line, text);
        }
        Rect::new(corner, (widest, lines.len() as f64 * leading))
    }
}

/// The most lines that a hatching has.
pub const MOST_HATCHES: usize = 400;

fn head_length(pen: Pen) -> f64 {
    (HEAD.0 * pen.width).max(HEAD.1)
}
