//! The canvas of a lesson's picture.

use glam::DVec2;

use super::Shown;
use crate::pictures::charts::wrap;
use crate::pictures::diagrams::{begin, elided};
use crate::pictures::drawing::{Align, Color, Dash, Drawing, Face, Level, Pen, Rect, Text};
use crate::pictures::theme::{Hue, Theme};

/// A drawing with its heading and its column, and the room for the diagram.
pub(super) struct Page {
    pub(super) drawing: Drawing,
    pub(super) room: Rect,
    pub(super) theme: &'static Theme,
    /// The lowest line of the column.
    column: Rect,
}

/// The canvas.
const SIZE: DVec2 = DVec2::new(880.0, 560.0);
/// The width of the column.
const COLUMN: f64 = 300.0;

impl Page {
    /// The canvas for what is shown. `about` says how to read the diagram.
    pub(super) fn new(shown: &Shown, about: &str) -> Self {
        let theme = &Theme::LIGHT;
        let title = format!("{}: {}", shown.title, shown.case);
        let (drawing, room) = begin(SIZE, &title, about, theme);
        let split = room.max.x - COLUMN;
        let column = Rect { min: DVec2::new(split, room.min.y + 8.0), max: room.max };
        let room = Rect { max: DVec2::new(split - 20.0, room.max.y), ..room };
        let mut page = Page { drawing, room, theme, column };
        page.write(shown);
        page
    }

    /// The pen of what is given.
    pub(super) fn given(&self) -> Pen {
        Pen::new(self.theme.hue(Hue::Blue), 2.4)
    }

    /// The pen of the right answer.
    pub(super) fn right(&self) -> Pen {
        Pen::new(self.theme.hue(Hue::Green), 2.6)
    }

    /// The pen of the student's answer.
    pub(super) fn wrong(&self) -> Pen {
        Pen::new(self.theme.hue(Hue::Vermilion), 2.6).dashed(Dash::Dashed)
    }

    fn write(&mut self, shown: &Shown) {
        let theme = self.theme;
        let told = shown.wrong().map(|got| shown.expected.told_beside(got));
        self.heading("given", None);
        shown.given.iter().for_each(|line| self.line(line, theme.ink));
        let (right, wrong) = (self.right(), self.wrong());
        self.heading("true", Some(right));
        match &told {
            Some([expected, _]) => self.line(expected, right.color),
            None => self.line(&shown.expected.to_string(), right.color),
        }
        if let Some([_, got]) = &told {
            self.heading(&format!("your {}", shown.function), Some(wrong));
            self.line(got, wrong.color);
        }
        if let Some(mistake) = &shown.mistake {
            self.heading("the mistake", None);
            self.line(mistake, theme.ink);
        }
        let answer = match (&shown.got, &told) {
            (_, Some([_, got])) => format!(", yours: {got}"),
            (Some(_), None) => ", and so is yours".to_owned(),
            (None, None) => String::new(),
        };
        self.drawing.describe(format!("{}: {}{answer}.", shown.given.join(", "), shown.expected));
    }

    fn heading(&mut self, words: &str, pen: Option<Pen>) {
        self.column.min.y += 14.0;
        let mut x = self.column.min.x;
        if let Some(pen) = pen {
            let y = self.column.min.y + 8.0;
            self.drawing.line((x + 1.0, y), (x + 31.0, y), pen);
            x += 40.0;
        }
        let text = Text::new(12.5, self.theme.muted).anchor(Align::Start, Level::Middle);
        self.drawing.text((x, self.column.min.y + 8.0), words, text);
        self.column.min.y += 21.0;
    }

    fn line(&mut self, words: &str, color: Color) {
        let text = Text::new(13.5, color).face(Face::Bold).anchor(Align::Start, Level::Middle);
        for line in wrap(words, &text, self.column.size().x) {
            if self.column.min.y + 20.0 > self.column.max.y {
                return;
            }
            let line = elided(&line, &text, self.column.size().x);
            self.drawing.text((self.column.min.x, self.column.min.y + 9.0), line, text);
            self.column.min.y += 20.0;
        }
    }

    /// Writes what the diagram cannot show, on the lower edge of its room, which gets smaller.
    pub(super) fn note(&mut self, words: &str) {
        let text = Text::new(12.0, self.theme.muted);
        for line in wrap(words, &text, self.room.size().x).iter().rev() {
            self.drawing.text((self.room.min.x, self.room.max.y - 4.0), line, text);
            self.room.max.y -= 16.0;
        }
        self.room.max.y -= 4.0;
    }
}
