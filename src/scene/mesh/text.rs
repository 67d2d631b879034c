//! Words in text that remember where they stand.

use crate::numbers::is_in_range;
use crate::scene::mesh::MeshError;
use crate::scene::mesh::range::RANGE_HELP;

/// A word and its offset in the file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    pub(super) at: usize,
}

/// The bytes as text.
///
/// # Errors
/// They are not UTF-8; the error names line, column and offset of the first byte that is not.
pub(super) fn utf8(bytes: &[u8]) -> Result<&str, MeshError> {
    std::str::from_utf8(bytes).map_err(|error| {
        let at = error.valid_up_to();
        let valid = std::str::from_utf8(&bytes[..at]).unwrap_or_default();
        let message = format!("the byte 0x{:02x} is not UTF-8", bytes[at]);
        let help = "the file is text in UTF-8, or a PLY file whose header says that it is binary";
        MeshError { byte_offset: Some(at), ..MeshError::in_text(valid, at, message, help) }
    })
}

/// Line and column of an offset, both from 1, the column in characters. A byte order mark takes up no column.
pub(super) fn place(text: &str, at: usize) -> (u32, u32) {
    let before = text.get(..at).unwrap_or(text).trim_start_matches('\u{feff}');
    let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    (u32::try_from(line).unwrap_or(u32::MAX), u32::try_from(column).unwrap_or(u32::MAX))
}

/// The word in quotes, escaped, cut after 40 characters.
pub(super) fn quoted(word: &str) -> String {
    let mut shown: String = word.chars().take(40).flat_map(char::escape_debug).collect();
    if word.chars().nth(40).is_some() {
        shown.push_str("...");
    }
    format!("\"{shown}\"")
}

/// Reads a text line by line, and each line word by word.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Lines<'a> {
    /// Reads from an offset on; a byte order mark at the start of the text is passed over.
    pub(super) fn new(text: &'a str, at: usize) -> Self {
        let mark = if at == 0 && text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Self { text, at: at + mark }
    }

    /// The offset of what is not yet read.
    pub(super) fn offset(&self) -> usize {
        self.at
    }

    /// Puts the words of the next line that has any into `words`; false at the end of the text.
    ///
    /// Words are parted by spaces and tabs; lines end in LF or CRLF. A word that starts with `comment` ends the line's
    /// words. With `continued`, a backslash at the end of a line joins the next line to it.
    pub(super) fn next_line(&mut self, words: &mut Vec<Word<'a>>, comment: Option<u8>, continued: bool) -> bool {
        words.clear();
        let bytes = self.text.as_bytes();
        let joint = |at: usize| match bytes.get(at..) {
            Some([b'\\', b'\n', ..]) if continued => 2,
            Some([b'\\', b'\r', b'\n', ..]) if continued => 3,
            _ => 0,
        };
        while let Some(&byte) = bytes.get(self.at) {
            if byte == b'\n' {
                self.at += 1;
                if !words.is_empty() {
                    return true;
                }
            } else if Some(byte) == comment {
                while bytes.get(self.at).is_some_and(|&byte| byte != b'\n') {
                    self.at += 1;
                }
            } else if is_blank(byte) {
                self.at += 1;
            } else if joint(self.at) > 0 {
                self.at += joint(self.at);
            } else {
                let start = self.at;
                while bytes.get(self.at).is_some_and(|&byte| !is_blank(byte) && byte != b'\n') && joint(self.at) == 0 {
                    self.at += 1;
                }
                words.push(Word { text: &self.text[start..self.at], at: start });
            }
        }
        !words.is_empty()
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\x0b' | b'\x0c')
}

/// The finite number that a word writes, rounded to the nearest double.
///
/// # Errors
/// The word is no decimal number, or one that is infinite or NaN; `what` names it.
pub(super) fn finite(text: &str, word: Word<'_>, what: &str) -> Result<f64, MeshError> {
    let message = match word.text.parse::<f64>() {
        Ok(x) if x.is_finite() => return Ok(x),
        Ok(_) => format!("{what} is {}, not a finite number", quoted(word.text)),
        Err(_) => format!("{what} is {}, not a number", quoted(word.text)),
    };
    Err(MeshError::in_text(text, word.at, message, "a decimal number such as 0.25 or -1e-3"))
}

/// The coordinate that a word writes.
///
/// # Errors
/// Those of [`finite`], and a number out of range.
pub(super) fn coordinate(text: &str, word: Word<'_>, what: &str) -> Result<f64, MeshError> {
    let x = finite(text, word, what)?;
    if !is_in_range(x) {
        let message = format!("{what} is {}, which is out of range", quoted(word.text));
        return Err(MeshError::in_text(text, word.at, message, RANGE_HELP));
    }
    Ok(x)
}
