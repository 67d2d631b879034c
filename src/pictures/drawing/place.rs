//! Labels that find their place: the best of several.

use glam::DVec2;

use super::text::{Align, Frame, Level, Text, Words};
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

/// A label that has yet to find its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// What it says.
    pub words: Words,
    /// How it looks; the anchoring is that of the place.
    pub text: Text,
    /// Where it may stand, the best first.
    pub places: Vec<Placement>,
}

/// A place that was chosen: which one, its ink, and the line from what is named to the ink.
#[derive(Clone, Copy, Debug)]
struct Choice {
    place: Placement,
    ink: Rect,
    line: Option<[DVec2; 2]>,
    cost: f64,
}

impl Drawing {
    /// Writes a label at the best of `places`: that of [`Drawing::label_all`] for one label.
    pub fn label(
        &mut self,
        words: impl Into<Words>,
        text: Text,
        places: &[Placement],
        within: Rect,
        obstacles: &[Rect],
    ) -> Option<Rect> {
        let wanted = Wanted { words: words.into(), text, places: places.to_vec() };
        self.label_all(&[wanted], within, obstacles)[0]
    }

    /// Writes each label at the best of its places: within `within`, clear of all labels and of `obstacles`, close to what it
    /// names, and so that a line between the two crosses nothing; of places about as good the earlier. Returns the
    /// rectangles around their ink; a label for which there is no room at all is not written.
    ///
    /// One label after the other chooses, then all choose again, knowing the others, until nobody moves or `ROUNDS` are over.
    pub fn label_all(&mut self, wanted: &[Wanted], within: Rect, obstacles: &[Rect]) -> Vec<Option<Rect>> {
        let fixed: Vec<Rect> = self.labels.iter().map(|label| label.rect).collect();
        let mut choices: Vec<Option<Choice>> = vec![None; wanted.len()];
        let frame = |wanted: &Wanted| wanted.text.frame(&wanted.text.set(&wanted.words));
        let frames: Vec<Option<Frame>> = wanted.iter().map(frame).collect();
        for _ in 0..ROUNDS {
            let before: Vec<_> = choices.iter().map(|c| c.map(|c| c.place)).collect();
            for i in 0..wanted.len() {
                let others = || choices.iter().enumerate().filter(|(k, _)| *k != i).filter_map(|(_, c)| *c);
                let labels: Vec<Rect> = fixed.iter().copied().chain(others().map(|c| c.ink)).collect();
                let lines = others().filter_map(|c| c.line).flat_map(|[a, b]| cover(&[a, b]));
                let blocked: Vec<Rect> = obstacles.iter().copied().chain(lines.map(|r| r.grown(2.0))).collect();
                choices[i] = frames[i].and_then(|frame| choose(&wanted[i], frame, within, &labels, &blocked));
            }
            if before == choices.iter().map(|c| c.map(|c| c.place)).collect::<Vec<_>>() {
                break;
            }
        }
        let chosen = wanted.iter().zip(choices);
        let write = |(wanted, choice): (&Wanted, Option<Choice>)| {
            let Choice { place: Placement { at, align, level, .. }, ink, .. } = choice?;
            if !self.canvas().contains(ink) || self.labels.iter().any(|label| label.rect.overlaps(ink)) {
                return None;
            }
            self.text(at, wanted.words.clone(), wanted.text.anchor(align, level))
        };
        chosen.map(write).collect()
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

/// The place of least cost. Outside is worse than on a label, on a label worse than on an obstacle, and all of it worse than
/// far.
fn choose(wanted: &Wanted, frame: Frame, within: Rect, labels: &[Rect], obstacles: &[Rect]) -> Option<Choice> {
    let mut best: Option<Choice> = None;
    for (i, place) in wanted.places.iter().enumerate() {
        let text = wanted.text.anchor(place.align, place.level);
        let ink = frame.at(&text, place.at);
        let room = ink.grown(CLEARANCE);
        let outside = room.size().x * room.size().y - room.overlap_area(within.grown(CLEARANCE));
        let covered: f64 = labels.iter().map(|rect| room.overlap_area(*rect)).sum();
        let line = place.of.map(|of| [of, of.clamp(ink.min, ink.max)]);
        let far = line.map_or(0.0, |[of, near]| 0.6 * near.distance(of));
        let mut cost = 100.0 * outside.max(0.0) + 10.0 * covered + far + 0.4 * i as f64;
        // What is left only adds to the cost, and takes the longest to find out.
        if best.is_some_and(|best| best.cost <= cost) {
            continue;
        }
        cost += 2.0 * obstacles.iter().map(|rect| room.overlap_area(*rect)).sum::<f64>();
        if best.is_some_and(|best| best.cost <= cost) {
            continue;
        }
        cost += line.map_or(0.0, |[of, near]| 0.25 * crossings(of, near, labels, obstacles));
        if best.is_none_or(|best| cost < best.cost) {
            best = Some(Choice { place: *place, ink, line, cost });
        }
    }
    best
}

/// What a straight line from `of` to a label would meet of other labels and obstacles away from its beginning: the length met,
/// times how thick the thing is that it meets.
fn crossings(of: DVec2, near: DVec2, labels: &[Rect], obstacles: &[Rect]) -> f64 {
    const SAMPLES: u32 = 16;
    let met = |i: u32| {
        let at = of.lerp(near, f64::from(i) / f64::from(SAMPLES));
        let dot = Rect { min: at, max: at }.grown(0.5);
        let met = labels.iter().chain(obstacles).filter(|rect| at.distance(of) > 9.0 && rect.overlaps(dot));
        met.map(|rect| rect.size().min_element()).fold(0.0, f64::max)
    };
    (0..SAMPLES).map(met).sum::<f64>() * of.distance(near) / f64::from(SAMPLES)
}

/// Small squares that cover a chain of lines, as obstacles for labels.
pub fn cover(points: &[DVec2]) -> Vec<Rect> {
    let mut rects = Vec::new();
    for ends in points.windows(2) {
        let steps = (ends[0].distance(ends[1]) / 5.0).ceil().clamp(1.0, 400.0) as usize;
        rects.extend((0..=steps).map(|i| {
            let at = ends[0].lerp(ends[1], i as f64 / steps as f64);
            Rect { min: at, max: at }.grown(2.0)
        }));
    }
    rects
}

/// The room that is left free around a label.
const CLEARANCE: f64 = 2.0;

/// How often labels choose again.
const ROUNDS: usize = 6;
