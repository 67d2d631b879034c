//! A picture within a diagram: lines that are cut to its room, and labels that wait until all lines are there.

use glam::DVec2;

use crate::pictures::drawing::{
    Align, Color, Dash, Drawing, Level, Path, Pen, Placement, Rect, Text, Wanted, Words, around, cover,
};
use crate::pictures::theme::Theme;

/// The size of labels.
const LABEL: f64 = 13.0;

/// A picture in the making. Labels are written by [`Sketch::finish`].
pub(crate) struct Sketch<'a> {
    pub(crate) drawing: &'a mut Drawing,
    pub(crate) theme: &'a Theme,
    pub(crate) room: Rect,
    /// The labels, and the points that lines lead to from labels that stand far off.
    wanted: Vec<(Wanted, Option<DVec2>)>,
    obstacles: Vec<Rect>,
}

impl<'a> Sketch<'a> {
    /// An empty picture in `room`.
    pub(crate) fn new(drawing: &'a mut Drawing, room: Rect, theme: &'a Theme) -> Self {
        Sketch { drawing, theme, room, wanted: Vec::new(), obstacles: Vec::new() }
    }

    /// The part of a line that is seen.
    pub(crate) fn cut(&self, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
        self.room.clip(a, b)
    }

    /// Draws a line; labels keep away from it.
    pub(crate) fn line(&mut self, a: DVec2, b: DVec2, pen: Pen) {
        if let Some((a, b)) = self.cut(a, b) {
            self.drawing.line(a, b, pen);
            self.obstacles.extend(cover(&[a, b]));
        }
    }

    /// Draws a thin line that labels may touch.
    pub(crate) fn faint(&mut self, a: DVec2, b: DVec2, pen: Pen) {
        if let Some((a, b)) = self.cut(a, b) {
            self.drawing.line(a, b, pen);
        }
    }

    /// Draws an arrow, without its head where that is outside.
    pub(crate) fn arrow(&mut self, a: DVec2, b: DVec2, pen: Pen) {
        let Some((p, q)) = self.cut(a, b) else { return };
        if q.distance(b) < 0.01 {
            self.drawing.arrow(p, q, pen)
        } else {
            self.drawing.line(p, q, pen)
        }
        self.obstacles.extend(cover(&[p, q]));
    }

    /// Draws a ray from `a` to `b` with a head on the way.
    pub(crate) fn ray(&mut self, a: DVec2, b: DVec2, pen: Pen) {
        if let Some((a, b)) = self.cut(a, b) {
            self.drawing.directed(a, b, 0.5, pen);
            self.obstacles.extend(cover(&[a, b]));
        }
    }

    /// Marks a point.
    pub(crate) fn dot(&mut self, at: DVec2, color: Color) {
        self.disk(at, 4.0, color);
    }

    /// Marks a point with a small dot that stands off its ground.
    pub(crate) fn disk(&mut self, at: DVec2, radius: f64, color: Color) {
        if self.sees(at) {
            self.drawing.disk(at, radius + 1.2, self.theme.background);
            self.drawing.disk(at, radius, color);
            self.obstacles.push(Rect { min: at, max: at }.grown(radius + 1.0));
        }
    }

    /// Whether a point lies within.
    pub(crate) fn sees(&self, at: DVec2) -> bool {
        self.room.grown(0.5).contains(Rect { min: at, max: at })
    }

    /// Keeps labels off what else was drawn.
    pub(crate) fn keep_off(&mut self, points: &[DVec2]) {
        self.obstacles.extend(cover(points));
    }

    /// Keeps labels off an arc from one direction to another.
    pub(crate) fn keep_off_arc(&mut self, at: DVec2, from: DVec2, to: DVec2, radius: f64) {
        let on_arc = |i: u32| at + radius * from.lerp(to, f64::from(i) / 12.0).normalize_or_zero();
        let points: Vec<DVec2> = (0..=12).map(on_arc).collect();
        self.keep_off(&points);
    }

    /// Draws the mark of a break in the line from `a` to `b`: two short slanted strokes with the ground between.
    pub(crate) fn broken(&mut self, a: DVec2, b: DVec2, color: Color) {
        let Some(along) = (b - a).try_normalize() else { return };
        let (middle, across) = (a.midpoint(b), along.perp());
        let stroke = |at: DVec2| [at - 7.0 * across - 2.5 * along, at + 7.0 * across + 2.5 * along];
        let ([p, q], [r, s]) = (stroke(middle - 3.5 * along), stroke(middle + 3.5 * along));
        self.drawing.fill(Path::polygon([p, q, s, r]), self.theme.background);
        for [a, b] in [[p, q], [r, s]] {
            self.drawing.line(a, b, Pen::new(color, 1.4));
        }
        self.obstacles.push(Rect { min: middle, max: middle }.grown(8.0));
    }

    /// Names a point.
    pub(crate) fn name(&mut self, at: DVec2, words: impl Into<Words>) {
        self.name_in(at, words, self.theme.ink);
    }

    /// Names a point in a colour.
    pub(crate) fn name_in(&mut self, at: DVec2, words: impl Into<Words>, color: Color) {
        if self.sees(at) {
            self.want(words.into(), color, around(at, 9.5), Some(at));
        }
    }

    /// Names a point, rather on its left or rather on its right.
    pub(crate) fn name_aside(&mut self, at: DVec2, words: impl Into<Words>, color: Color, on_the_left: bool) {
        if self.sees(at) {
            let wrong = if on_the_left { Align::Start } else { Align::End };
            let mut places = around(at, 9.5);
            places.sort_by_key(|place| place.align == wrong);
            self.want(words.into(), color, places, Some(at));
        }
    }

    /// Names a place that is no point, so that no line leads to it.
    pub(crate) fn name_without_line(&mut self, at: DVec2, words: impl Into<Words>, color: Color) {
        self.want(words.into(), color, around(at, 6.0), None);
    }

    /// Names what lies along the line from `a` to `b`, of what is seen of it.
    pub(crate) fn beside(&mut self, a: DVec2, b: DVec2, words: impl Into<Words>, color: Color) {
        let Some((a, b)) = self.cut(a, b) else { return };
        let across = (b - a).try_normalize().unwrap_or(DVec2::X).perp();
        let words = words.into();
        // Of a label over the middle of a line that rises gently, one end comes nearer to it.
        let half = Text::new(LABEL, color).ink(DVec2::ZERO, words.clone()).map_or(0.0, |ink| 0.5 * ink.size().x);
        let mut places = Vec::new();
        for gap in [7.0, 16.0, 30.0, 48.0] {
            for share in [0.5, 0.36, 0.64, 0.22, 0.78] {
                for off in [across, -across] {
                    let align = side(off.x, [Align::End, Align::Middle, Align::Start]);
                    let level = side(off.y, [Level::Baseline, Level::Middle, Level::Top]);
                    let gap = gap + if align == Align::Middle { half * off.x.abs() } else { 0.0 };
                    let of = a.lerp(b, share);
                    places.push(Placement { of: Some(of), at: of + gap * off, align, level });
                }
            }
        }
        self.want(words, color, places, None);
    }

    /// Names an area around `middle`: the label stands on it, or near it with a line to it.
    pub(crate) fn in_area(&mut self, middle: DVec2, words: impl Into<Words>, color: Color) {
        if self.sees(middle) {
            let on_it = Placement { of: Some(middle), at: middle, align: Align::Middle, level: Level::Middle };
            let places = [on_it].into_iter().chain(around(middle, 14.0)).collect();
            self.want(words.into(), color, places, Some(middle));
        }
    }

    /// Wants a label at the best of some places, with a line from `of` where it is far.
    pub(crate) fn want(&mut self, words: Words, color: Color, places: Vec<Placement>, of: Option<DVec2>) {
        self.wanted.push((Wanted { words, text: Text::new(LABEL, color), places }, of));
    }

    /// Draws a length from `a` to `b`, moved aside, and names it.
    pub(crate) fn length(&mut self, a: DVec2, b: DVec2, aside: f64, words: Words, color: Color) {
        let [p, q] = self.drawing.dimension(a, b, aside, Pen::new(color, 1.3));
        self.obstacles.extend(cover(&[a, p, q, b]));
        self.beside(p, q, words, color);
    }

    /// A dashed thin pen for what only helps.
    pub(crate) fn guide(&self) -> Pen {
        Pen::new(self.theme.axis, 1.1).dashed(Dash::Short)
    }

    /// Writes all labels.
    pub(crate) fn finish(self) {
        let (wanted, points): (Vec<Wanted>, Vec<Option<DVec2>>) = self.wanted.into_iter().unzip();
        let rects = self.drawing.label_all(&wanted, self.room, &self.obstacles);
        let pen = Pen::new(self.theme.axis, 0.8);
        for (rect, of) in rects.into_iter().zip(points) {
            if let (Some(rect), Some(of)) = (rect, of) {
                self.drawing.leader(of, rect, 22.0, pen);
            }
        }
    }
}

/// One of three, for a component that is clearly negative, small, or clearly positive.
fn side<T: Copy>(x: f64, of: [T; 3]) -> T {
    match x {
        x if x < -0.35 => of[0],
        x if x > 0.35 => of[2],
        _ => of[1],
    }
}

/// A note at the lower edge of a picture; returns the room above it.
pub(super) fn note(drawing: &mut Drawing, room: Rect, words: &str, theme: &Theme) -> Rect {
    if words.is_empty() {
        return room;
    }
    let text = Text::new(11.5, theme.muted);
    let mut bottom = room.max.y;
    for line in crate::pictures::charts::wrap(words, &text, room.size().x).iter().rev() {
        drawing.text((room.min.x, bottom - 3.0), super::frame::elided(line, &text, room.size().x), text);
        bottom -= 15.0;
    }
    Rect { max: DVec2::new(room.max.x, bottom - 4.0), ..room }
}

/// Splits a room into a picture and a column beside it.
pub(super) fn beside(room: Rect, share: f64) -> [Rect; 2] {
    let width = (share * room.size().x).min(330.0);
    let middle = room.max.x - width;
    [Rect { max: DVec2::new(middle - 18.0, room.max.y), ..room }, Rect { min: DVec2::new(middle, room.min.y), ..room }]
}
