//! One thing that is wrong with one input.

use std::fmt;
use std::ops::Range;

/// What is wrong with an input file or argument, where, and what would be right.
///
/// `Display` gives one line; a command that has the colour and the room draws the offending line as well.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file as the caller named it, or what else was read (`PIXEL`, `<stdin>`).
    pub file: String,
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub help: String,
    /// The JSON path of the offending value, where the input is JSON.
    pub path: Option<String>,
    /// Where in the text it stands.
    pub place: Option<Box<Place>>,
}

/// A stretch of one line of a text, kept with the line itself so that it can be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1, in characters.
    pub column: usize,
    /// The line's text, without its end.
    pub text: String,
    /// The offending bytes of `text`; never empty unless the line is.
    pub span: Range<usize>,
}

impl Place {
    /// The place of a byte range of `text`, cut at the end of its first line.
    pub fn new(text: &str, range: Range<usize>) -> Self {
        let mut start = range.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let line_text = text[line_start..line_end].trim_end_matches('\r');
        let from = (start - line_start).min(line_text.len());
        let mut to = range.end.saturating_sub(line_start).clamp(from, line_text.len());
        if to == from {
            to = line_text[from..].chars().next().map_or(from, |c| from + c.len_utf8());
        }
        while !line_text.is_char_boundary(to) {
            to += 1;
        }
        Self {
            line: text[..line_start].matches('\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            text: line_text.to_owned(),
            span: from..to,
        }
    }
}

impl Problem {
    /// A problem of a whole file or argument.
    pub fn new(file: impl Into<String>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { file: file.into(), message: message.into(), help: help.into(), path: None, place: None }
    }

    /// The same problem at a byte range of the file's text.
    pub fn at(mut self, text: &str, range: Range<usize>) -> Self {
        self.place = Some(Box::new(Place::new(text, range)));
        self
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file)?;
        if let Some(place) = &self.place {
            write!(f, ":{}:{}", place.line, place.column)?;
        }
        if let Some(path) = &self.path {
            write!(f, ": {path}")?;
        }
        write!(f, ": {}; {}", self.message, self.help)
    }
}

impl std::error::Error for Problem {}
