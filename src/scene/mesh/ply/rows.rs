//! The rows of a PLY file: numbers and lists, in text or in binary of either byte order.

use super::header::{Element, Kind, Scalar};
use crate::scene::mesh::MeshError;
use crate::scene::mesh::text::{Lines, Word, quoted};

/// A number from a row, and where it stands.
pub(super) struct Value {
    pub(super) number: f64,
    pub(super) at: usize,
}

/// The rows below the header.
pub(super) enum Rows<'a> {
    Text { text: &'a str, lines: Lines<'a>, words: Vec<Word<'a>>, next: usize },
    Binary { bytes: &'a [u8], at: usize, big_endian: bool },
}

impl Rows<'_> {
    pub(super) fn error(&self, at: usize, message: impl Into<String>, help: impl Into<String>) -> MeshError {
        match self {
            Self::Text { text, .. } => MeshError::in_text(text, at, message, help),
            Self::Binary { .. } => MeshError::in_binary(at, message, help),
        }
    }

    /// Refuses a count of rows that the rest of the file cannot hold, so that memory may follow it.
    pub(super) fn check_promise(&self, element: &Element<'_>, end: usize) -> Result<(), MeshError> {
        let (at, least) = match self {
            // A digit and a blank or line end for every number; the last line may lack its end.
            Self::Text { lines, .. } => (lines.offset(), 2 * element.properties.len()),
            Self::Binary { at, .. } => {
                let sizes = element.properties.iter().map(|property| match property.kind {
                    Kind::Scalar(scalar) => scalar.size(),
                    Kind::List { count, .. } => count.size(),
                });
                (*at, sizes.sum())
            }
        };
        let wanted = u128::from(element.count) * least as u128;
        let had = end - at;
        let spare = usize::from(matches!(self, Self::Text { .. }));
        if wanted > (had + spare) as u128 {
            let message = format!(
                "the header promises {} rows of {}, at least {wanted} bytes, but {had} bytes are left",
                element.count,
                quoted(element.name),
            );
            return Err(self.error(at, message, "a complete file, or a smaller count"));
        }
        Ok(())
    }

    pub(super) fn begin_row(&mut self, element: &Element<'_>, row: u64) -> Result<(), MeshError> {
        if let Self::Text { text, lines, words, next } = self {
            *next = 0;
            if !lines.next_line(words, None, false) {
                let message = format!(
                    "the file ends before row {row} of {} rows of {}, counted from 0",
                    element.count,
                    quoted(element.name)
                );
                return Err(MeshError::in_text(text, text.len(), message, "a complete file, or a smaller count"));
            }
        }
        Ok(())
    }

    pub(super) fn end_row(&self) -> Result<(), MeshError> {
        if let Self::Text { text, words, next, .. } = self
            && let Some(word) = words.get(*next)
        {
            let message = format!("{} is more than this row holds by the header", quoted(word.text));
            return Err(MeshError::in_text(
                text,
                word.at,
                message,
                "one row a line, with the properties of the header",
            ));
        }
        Ok(())
    }

    pub(super) fn expect_end(&mut self) -> Result<(), MeshError> {
        let at = match self {
            Self::Text { lines, words, .. } => {
                if !lines.next_line(words, None, false) {
                    return Ok(());
                }
                words[0].at
            }
            Self::Binary { bytes, at, .. } if *at < bytes.len() => *at,
            Self::Binary { .. } => return Ok(()),
        };
        Err(self.error(at, "there is more after the last row", "counts in the header that cover the whole file"))
    }

    pub(super) fn scalar(&mut self, scalar: Scalar) -> Result<Value, MeshError> {
        match self {
            Self::Text { text, words, next, .. } => {
                let Some(&word) = words.get(*next) else {
                    let at = words.last().map_or(text.len(), |word| word.at + word.text.len());
                    let help = "one row a line, with the properties of the header";
                    return Err(MeshError::in_text(text, at, "the row ends too early", help));
                };
                *next += 1;
                // Integers go through f64 too: all of the types have at most 32 bits, and larger ones are out of range.
                match word.text.parse::<f64>() {
                    Ok(number) if !scalar.is_integer() || number.fract() == 0.0 => Ok(Value { number, at: word.at }),
                    _ => {
                        let what = if scalar.is_integer() { "a whole number" } else { "a number" };
                        let message = format!("{} is not {what}", quoted(word.text));
                        Err(MeshError::in_text(text, word.at, message, format!("{what}, as the header says")))
                    }
                }
            }
            Self::Binary { bytes, at, big_endian } => {
                let start = *at;
                let size = scalar.size();
                let mut raw = [0; 8];
                raw[..size].copy_from_slice(take(bytes, at, size as u64)?);
                if *big_endian {
                    raw[..size].reverse();
                }
                let [b0, b1, b2, b3, ..] = raw;
                let number = match scalar {
                    Scalar::I8 => f64::from(i8::from_le_bytes([b0])),
                    Scalar::U8 => f64::from(b0),
                    Scalar::I16 => f64::from(i16::from_le_bytes([b0, b1])),
                    Scalar::U16 => f64::from(u16::from_le_bytes([b0, b1])),
                    Scalar::I32 => f64::from(i32::from_le_bytes([b0, b1, b2, b3])),
                    Scalar::U32 => f64::from(u32::from_le_bytes([b0, b1, b2, b3])),
                    Scalar::F32 => f64::from(f32::from_le_bytes([b0, b1, b2, b3])),
                    Scalar::F64 => f64::from_le_bytes(raw),
                };
                Ok(Value { number, at: start })
            }
        }
    }

    /// The length of a list, and where it stands; the list itself may still be cut short.
    pub(super) fn list_length(&mut self, count: Scalar) -> Result<(u64, usize), MeshError> {
        let Value { number, at } = self.scalar(count)?;
        if !(0.0..=f64::from(u32::MAX)).contains(&number) {
            return Err(self.error(at, format!("a list of {number} numbers"), "a count from 0 to 2^32 - 1"));
        }
        Ok((number as u64, at))
    }

    pub(super) fn skip(&mut self, kind: Kind) -> Result<(), MeshError> {
        let (length, item) = match kind {
            Kind::Scalar(scalar) => (1, scalar),
            Kind::List { count, item } => (self.list_length(count)?.0, item),
        };
        match self {
            Self::Binary { bytes, at, .. } => take(bytes, at, length * item.size() as u64).map(|_| ()),
            // Ends at the end of the line, however long the list pretends to be.
            Self::Text { .. } => (0..length).try_for_each(|_| self.scalar(Scalar::F64).map(|_| ())),
        }
    }
}

/// The next `wanted` bytes.
pub(super) fn take<'a>(bytes: &'a [u8], at: &mut usize, wanted: u64) -> Result<&'a [u8], MeshError> {
    let rest = &bytes[*at..];
    match usize::try_from(wanted).ok().and_then(|wanted| rest.get(..wanted)) {
        Some(taken) => {
            *at += taken.len();
            Ok(taken)
        }
        None => {
            let message = format!("the file is cut short: {wanted} bytes wanted here, {} had", rest.len());
            Err(MeshError::in_binary(*at, message, "a complete file"))
        }
    }
}
