//! Labels that are written only where they hide nothing.

use glam::DVec2;

use crate::pictures::drawing::{Align, Drawing, Level, Pen, Rect, Text, Words};

/// What is taken of a canvas.
#[derive(Clone, Debug)]
pub(super) struct Taken {
    within: Rect,
    /// What no label may touch: labels.
    rects: Vec<Rect>,
    /// What a label had better not touch: lines and marks.
    soft: Vec<Rect>,
}

/// A place for a label: the anchor, and how the label stands there.
pub(super) type Place = (DVec2, Align, Level);

impl Taken {
    /// Nothing but what the drawing has in labels; labels stay within `within`.
    pub(super) fn new(drawing: &Drawing, within: Rect) -> Self {
        let rects = drawing.labels().iter().map(|label| label.rect.grown(CLEARANCE)).collect();
        Taken { within, rects, soft: Vec::new() }
    }

    /// Takes a rectangle that labels had better leave free.
    pub(super) fn take(&mut self, rect: Rect) {
        self.soft.push(rect);
    }

    /// Takes what a line covers.
    pub(super) fn take_line(&mut self, a: DVec2, b: DVec2) {
        let Some((a, b)) = self.within.grown(20.0).clip(a, b) else { return };
        let steps = (a.distance(b) / 4.0).ceil().clamp(1.0, 600.0) as usize;
        for i in 0..=steps {
            let at = a.lerp(b, i as f64 / steps as f64);
            self.soft.push(Rect { min: at, max: at }.grown(1.5));
        }
    }

    /// Writes a label at the first of `places` that is clear of everything; where there is none, and `needed` says that the
    /// label matters more than a line below it, at the place that touches least but no other label. Returns its rectangle.
    pub(super) fn write(
        &mut self,
        drawing: &mut Drawing,
        words: impl Into<Words>,
        text: Text,
        places: &[Place],
        needed: bool,
    ) -> Option<Rect> {
        let words = words.into();
        // The ink is set once; anchors only move it.
        let origin = text.anchor(Align::Start, Level::Baseline).ink(DVec2::ZERO, words.clone())?;
        let width = text.width(words.clone());
        let mut best: Option<(f64, Place)> = None;
        for &(at, align, level) in places {
            let x = match align {
                Align::Start => 0.0,
                Align::Middle => -width / 2.0,
                Align::End => -width,
            };
            let y = match level {
                Level::Baseline => 0.0,
                Level::Middle => text.cap_height() / 2.0,
                Level::Top => text.cap_height(),
            };
            let ink = origin.moved(at + DVec2::new(x, y));
            if !self.within.contains(ink) || self.rects.iter().any(|taken| taken.overlaps(ink)) {
                continue;
            }
            let hidden: f64 = self.soft.iter().map(|taken| taken.overlap_area(ink)).sum();
            if best.is_none_or(|(least, _)| hidden < least) {
                best = Some((hidden, (at, align, level)));
            }
            if hidden == 0.0 {
                break;
            }
        }
        let (hidden, (at, align, level)) = best?;
        if hidden > 0.0 && !needed {
            return None;
        }
        let rect = drawing.text(at, words, text.anchor(align, level))?;
        self.rects.push(rect.grown(CLEARANCE));
        Some(rect)
    }

    /// A thin line from `point` to a label that stands farther away than `reach`.
    pub(super) fn lead(&mut self, drawing: &mut Drawing, point: DVec2, label: Rect, reach: f64, pen: Pen) {
        let near = point.clamp(label.min - 2.0, label.max + 2.0);
        if near.distance(point) > reach {
            let start = point + (near - point).normalize_or_zero() * 4.0;
            drawing.line(start, near, pen);
            self.take_line(start, near);
        }
    }
}

/// Places around a point, near ones first.
pub(super) fn around(point: DVec2, gap: f64, rings: u32) -> Vec<Place> {
    let directions = [(1, -1), (-1, -1), (1, 1), (-1, 1), (1, 0), (-1, 0), (0, -1), (0, 1)];
    let mut places = Vec::new();
    for ring in 0..rings {
        let gap = gap + 11.0 * f64::from(ring);
        for (x, y) in directions {
            let share = if x != 0 && y != 0 { 0.75 } else { 1.0 };
            let align = [Align::End, Align::Middle, Align::Start][(x + 1) as usize];
            let level = [Level::Baseline, Level::Middle, Level::Top][(y + 1) as usize];
            places.push((point + gap * share * DVec2::new(x.into(), y.into()), align, level));
        }
    }
    places
}

/// Places beside a line, from its middle outwards, on both sides.
pub(super) fn beside(a: DVec2, b: DVec2, gap: f64) -> Vec<Place> {
    let across = (b - a).normalize_or_zero().perp();
    let mut places = Vec::new();
    for share in [0.5, 0.38, 0.62, 0.26, 0.74, 0.15, 0.85] {
        for side in [1.0, -1.0] {
            let off = side * across;
            let align = match off.x {
                x if x > 0.35 => Align::Start,
                x if x < -0.35 => Align::End,
                _ => Align::Middle,
            };
            let level = match off.y {
                y if y > 0.35 => Level::Top,
                y if y < -0.35 => Level::Baseline,
                _ => Level::Middle,
            };
            places.push((a.lerp(b, share) + gap * off, align, level));
        }
    }
    places
}

/// The room that is left free around a label.
const CLEARANCE: f64 = 2.0;
