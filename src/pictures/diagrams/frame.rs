//! What all diagrams share: the heading, the key to the lines, swatches of light.

use glam::DVec2;

use crate::pictures::charts::wrap;
use crate::pictures::drawing::{Align, Color, Drawing, Face, Level, Path, Pen, Rect, Text};
use crate::pictures::srgb::srgb8;
use crate::pictures::theme::Theme;
use crate::tree::Kind;

/// The text sizes of diagrams.
pub(super) const TITLE: f64 = 15.0;
pub(super) const SMALL: f64 = 12.0;

/// The room around a diagram.
pub(super) const MARGIN: f64 = 14.0;

/// A drawing with a heading, and the room that is left for what follows.
pub(crate) fn begin(size: DVec2, title: &str, note: &str, theme: &Theme) -> (Drawing, Rect) {
    let mut drawing = Drawing::new(size.x, size.y, theme.background, title);
    let width = size.x - 2.0 * MARGIN;
    let mut y = MARGIN;
    let heading = Text::new(TITLE, theme.ink).face(Face::Bold);
    let small = Text::new(SMALL, theme.muted);
    for line in wrap(title, &heading, width) {
        drawing.text((MARGIN, y + 12.0), elided(&line, &heading, width), heading);
        y += 20.0;
    }
    for line in wrap(note, &small, width).into_iter().take(3) {
        drawing.text((MARGIN, y + 11.0), elided(&line, &small, width), small);
        y += 16.0;
    }
    let min = DVec2::new(MARGIN, y + 6.0);
    (drawing, Rect { min, max: size - MARGIN })
}

/// The word for a ray.
pub(super) fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Camera => "camera",
        Kind::Shadow => "shadow",
        Kind::Reflected => "reflected",
        Kind::Refracted => "refracted",
    }
}

/// Draws the key to the lines of rays, and to further marks, in one line that stands on the lower edge of `room`; returns the
/// room above it. What no longer fits is left out.
pub(super) fn key(drawing: &mut Drawing, room: Rect, kinds: &[Kind], more: &[Key<'_>], theme: &Theme) -> Rect {
    let text = Text::new(SMALL, theme.muted).anchor(Align::Start, Level::Middle);
    let y = room.max.y - 7.0;
    let mut x = room.min.x;
    let rays = kinds.iter().map(|kind| Key { words: kind_name(*kind), sign: Sign::Ray(*kind) });
    for entry in rays.chain(more.iter().copied()) {
        let sign = match entry.sign {
            Sign::Ray(_) => 32.0,
            Sign::Hollow => 12.0,
            Sign::Swatch => 14.0,
            Sign::None => 0.0,
        };
        let width = sign + 6.0 + text.width(entry.words);
        if x + width > room.max.x {
            break;
        }
        match entry.sign {
            Sign::Ray(kind) => drawing.line((x + 1.0, y), (x + sign - 1.0, y), theme.ray(kind, 2.0)),
            Sign::Hollow => ring(drawing, DVec2::new(x + 6.0, y), 4.0, theme.muted, theme),
            Sign::Swatch => {
                let stripe = |i: u32| Rect::new((x + 1.0, y - 6.0 + 4.0 * f64::from(i)), (12.0, 4.0));
                for (i, grey) in [0.9, 0.35, 0.06].into_iter().enumerate() {
                    drawing.fill(Path::rect(stripe(i as u32)), light([grey; 3]));
                }
                drawing.stroke(Path::rect(Rect::new((x + 1.0, y - 6.0), (12.0, 12.0))), Pen::new(theme.axis, 1.0));
            }
            Sign::None => {}
        }
        drawing.text((x + sign + if sign > 0.0 { 6.0 } else { 0.0 }, y), entry.words, text);
        x += width + 18.0;
    }
    Rect { max: DVec2::new(room.max.x, y - 16.0), ..room }
}

/// An entry of a [`key`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Key<'a> {
    pub(super) words: &'a str,
    pub(super) sign: Sign,
}

/// What an entry of a key explains.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sign {
    Ray(Kind),
    Hollow,
    Swatch,
    None,
}

/// Draws a small circle with the ground inside.
pub(super) fn ring(drawing: &mut Drawing, at: DVec2, radius: f64, color: Color, theme: &Theme) {
    drawing.disk(at, radius, theme.background);
    drawing.stroke(Path::circle(at, radius), Pen::new(color, 1.6));
}

/// Linear light as it is seen, clamped to [0, 1].
pub(in crate::pictures) fn light(rgb: [f64; 3]) -> Color {
    let [r, g, b] = rgb.map(srgb8);
    Color { r, g, b, a: 255 }
}

/// Draws a patch of light with a border, so that it is seen on any ground.
pub(super) fn swatch(drawing: &mut Drawing, rect: Rect, rgb: [f64; 3], theme: &Theme) {
    drawing.fill(Path::rect(rect), light(rgb));
    drawing.stroke(Path::rect(rect), Pen::new(theme.axis, 1.0));
}

/// `words`, with an ellipsis for its middle where they are wider than `width`: names differ at both ends.
pub(crate) fn elided(words: &str, text: &Text, width: f64) -> String {
    if text.width(words) <= width {
        return words.to_owned();
    }
    let letters: Vec<char> = words.chars().collect();
    let shortened = |kept: usize| -> String {
        let (head, tail) = (kept.div_ceil(2), kept / 2);
        letters[..head].iter().chain(&['…']).chain(&letters[letters.len() - tail..]).collect()
    };
    let (mut fits, mut too_long) = (0, letters.len());
    while too_long - fits > 1 {
        let middle = (fits + too_long) / 2;
        if text.width(shortened(middle)) <= width { fits = middle } else { too_long = middle }
    }
    shortened(fits)
}
