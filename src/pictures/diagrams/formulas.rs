//! A column of formulas with this ray's numbers.

use glam::DVec2;

use super::numbers::tex;
use crate::pictures::drawing::{Align, Drawing, Face, Level, Path, Pen, Rect, Text, Words};
use crate::pictures::theme::{Hue, Theme};

/// A line of a column.
#[derive(Clone, Debug)]
pub(super) struct Line {
    words: Words,
    look: Look,
    /// Whether it stays where there is little room.
    needed: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Look {
    Heading,
    Formula,
    Sentence,
    /// A sentence after a check mark or a cross.
    Verdict(bool),
}

impl Line {
    /// A few words above formulas.
    pub(super) fn heading(words: &str) -> Self {
        Line { words: words.into(), look: Look::Heading, needed: false }
    }

    /// A formula that may be left out where there is little room.
    pub(super) fn formula(tex: &str) -> Self {
        Line { words: Words::default().display_tex(tex), look: Look::Formula, needed: false }
    }

    /// A formula that stays.
    pub(super) fn result(tex: &str) -> Self {
        Line { needed: true, ..Line::formula(tex) }
    }

    /// What came of it, in words.
    pub(super) fn sentence(words: &str) -> Self {
        Line { words: words.into(), look: Look::Sentence, needed: true }
    }

    /// What came of a test.
    pub(super) fn verdict((yes, words): (bool, Words)) -> Self {
        Line { words, look: Look::Verdict(yes), needed: true }
    }

    /// The size of its letters where formulas have size 1.
    fn share(&self) -> f64 {
        match self.look {
            Look::Heading => 0.84,
            Look::Formula => 1.0,
            Look::Sentence | Look::Verdict(_) => 0.92,
        }
    }

    fn text(&self, size: f64, theme: &Theme) -> Text {
        let text = Text::new(size * self.share(), theme.ink);
        match self.look {
            Look::Heading => text.color(theme.muted),
            Look::Formula => text,
            Look::Sentence | Look::Verdict(_) => text.face(Face::Bold),
        }
    }

    /// The room for the mark, in sizes.
    fn indent(&self) -> f64 {
        if matches!(self.look, Look::Verdict(_)) { 1.5 } else { 0.0 }
    }

    /// The room above, in sizes.
    fn gap(&self) -> f64 {
        if self.look == Look::Formula { 0.5 } else { 0.85 }
    }
}

/// Three numbers in TeX.
pub(super) fn triple(v: [f64; 3]) -> String {
    let [x, y, z] = v.map(tex);
    format!(r"({x},\; {y},\; {z})")
}

/// A number in TeX, in brackets where it would follow an operator with a sign of its own.
pub(super) fn operand(x: f64) -> String {
    if x < 0.0 { format!("({})", tex(x)) } else { tex(x) }
}

/// The largest and the smallest size of a column's formulas.
const LARGEST: f64 = 14.0;
const SMALLEST: f64 = 9.5;

/// Writes lines one below the other into `room`, smaller where they would not fit, without those that may be left out where that
/// does not help.
pub(super) fn column(drawing: &mut Drawing, room: Rect, lines: &[Line], theme: &Theme) {
    let measured = |line: &Line| {
        let ink = line.text(1.0, theme).ink(DVec2::ZERO, line.words.clone());
        ink.map(|ink| (line.clone(), ink))
    };
    let mut rows: Vec<(Line, Rect)> = lines.iter().filter_map(measured).collect();
    let height = |rows: &[(Line, Rect)]| rows.iter().map(|(line, ink)| ink.size().y + line.gap()).sum::<f64>();
    let fits = |rows: &[(Line, Rect)]| height(rows) * SMALLEST <= room.size().y;
    while !fits(&rows) {
        let last = rows.iter().rposition(|(line, _)| !line.needed);
        match last {
            Some(i) => drop(rows.remove(i)),
            None => break,
        }
    }
    let size = LARGEST.min(room.size().y / height(&rows).max(1e-9));
    let mut y = room.min.y;
    for (i, (line, ink)) in rows.iter().enumerate() {
        // Wide lines shrink alone.
        let width = ink.max.x + line.indent();
        let own = size.min(room.size().x / width.max(1e-9));
        y += if i == 0 { 0.0 } else { line.gap() * size };
        let x = room.min.x + line.indent() * own;
        let baseline = y - ink.min.y * own;
        let text = line.text(own, theme).anchor(Align::Start, Level::Baseline);
        drawing.text((x, baseline), line.words.clone(), text);
        if let Look::Verdict(yes) = line.look {
            mark(drawing, DVec2::new(room.min.x + 0.5 * own, baseline - 0.32 * own), 0.42 * own, yes, theme);
        }
        y += ink.size().y * own;
    }
}

/// Draws a check mark or a cross.
pub(super) fn mark(drawing: &mut Drawing, at: DVec2, radius: f64, yes: bool, theme: &Theme) {
    let p = |x: f64, y: f64| at + radius * DVec2::new(x, y);
    let hue = if yes { Hue::Green } else { Hue::Vermilion };
    let pen = Pen::new(theme.hue(hue), (0.35 * radius).max(1.4));
    let strokes = match yes {
        true => Path::open([p(-1.0, 0.1), p(-0.3, 0.8), p(1.0, -0.8)]),
        false => Path::line(p(-0.8, -0.8), p(0.8, 0.8)).and(Path::line(p(-0.8, 0.8), p(0.8, -0.8))),
    };
    drawing.stroke(strokes, pen);
}
