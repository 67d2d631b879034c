//! Labels that find their place: the best of several.

use glam::DVec2;

use super::text::{Align, Level, Text, Words};
use super::{Drawing, Pen, Rect};

/// An anchor that a label may have, and how it stands there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The point that is named, if it is one: a line from it to the label should be clear, too.
    pub of: Option<DVec2>,
    /// The anchor.
    pub at: DVec2,
    /// Where the label stands along the line.
    pub align: Align,
    /// Where the label stands across the line.
    pub level: Level,
}

/// Places around a point, the best first: eight directions at distance `gap`, then again farther and farther out.
pub fn around(point: impl Into<DVec2>, gap: f64) -> Vec<Placement> {
    let point = point.into();
    let directions = [(1, -1), (1, 1), (1, 0), (-1, -1), (-1, 1), (-1, 0), (0, -1), (0, 1)];
    let mut places = Vec::new();
    for ring in 0..6 {
        let gap = gap * (1.0 + 1.6 * f64::from(ring));
        for (x, y) in directions {
            let share = if x != 0 && y != 0 { 0.7 } else { 1.0 };
            let align = [Align::End, Align::Middle, Align::Start][(x + 1) as usize];
            let level = [Level::Baseline, Level::Middle, Level::Top][(y + 1) as usize];
            places.push(Placement {
                of: Some(point),
                at: point + gap * share * DVec2::new(x.into(), y.into()),
                align,
                level,
            });
        }
    }
    places
}

impl Drawing {
    /// Writes a label at the best of `places`: within `within`, clear of all labels so far and of `obstacles`, close to what it
    /// names, and so that a line between the two crosses nothing; of places about as good the earlier. Returns the rectangle
    /// around its ink.
    pub fn label(
        &mut self,
        words: impl Into<Words>,
        text: Text,
        places: &[Placement],
        within: Rect,
        obstacles: &[Rect],
    ) -> Option<Rect> {
        let words = words.into();
        let cost = |place: &Placement| {
            let ink = text.anchor(place.align, place.level).ink(place.at, words.clone())?.grown(CLEARANCE);
            let area = ink.size().x * ink.size().y;
            let outside = area - ink.overlap_area(within.grown(CLEARANCE));
            let labels = self.labels.iter().map(|label| label.rect);
            let covered: f64 = labels.map(|rect| ink.overlap_area(rect)).sum();
            let hidden: f64 = obstacles.iter().map(|rect| ink.overlap_area(*rect)).sum();
            // Outside is worse than on a label, on a label worse than on an obstacle, and all of it worse than far.
            let far = place.of.map_or(0.0, |of| {
                let near = of.clamp(ink.min, ink.max);
                0.6 * near.distance(of) + 0.25 * self.crossings(of, near, obstacles)
            });
            Some(100.0 * outside.max(0.0) + 10.0 * covered + hidden + far)
        };
        let mut best: Option<(f64, Placement)> = None;
        for (i, place) in places.iter().enumerate() {
            let cost = cost(place)? + 0.4 * i as f64;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, *place));
            }
        }
        let (_, place) = best?;
        self.text(place.at, words, text.anchor(place.align, place.level))
    }

    /// What a straight line from `of` to a label would meet of other labels and obstacles away from its beginning: the length
    /// met, times how thick the thing is that it meets.
    fn crossings(&self, of: DVec2, near: DVec2, obstacles: &[Rect]) -> f64 {
        const SAMPLES: u32 = 16;
        let others = || self.labels.iter().map(|l| l.rect).chain(obstacles.iter().copied());
        let met = |i: u32| {
            let at = of.lerp(near, f64::from(i) / f64::from(SAMPLES));
            let dot = Rect { min: at, max: at }.grown(0.5);
            let met = others().filter(|rect| at.distance(of) > 9.0 && rect.overlaps(dot));
            met.map(|rect| rect.size().min_element()).fold(0.0, f64::max)
        };
        (0..SAMPLES).map(met).sum::<f64>() * of.distance(near) / f64::from(SAMPLES)
    }

    /// A thin line from `point` to the nearest point of a label's rectangle, where that is farther than `reach`. Returns its
    /// ends.
    pub fn leader(&mut self, point: impl Into<DVec2>, label: Rect, reach: f64, pen: Pen) -> Option<[DVec2; 2]> {
        let point = point.into();
        let near = point.clamp(label.min - 2.0, label.max + 2.0);
        if near.distance(point) <= reach {
            return None;
        }
        let start = point + (near - point).normalize_or_zero() * (reach * 0.6);
        self.line(start, near, pen);
        Some([start, near])
    }
}

/// The room that is left free around a label.
const CLEARANCE: f64 = 2.0;
