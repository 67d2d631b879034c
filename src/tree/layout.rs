//! How a tree's JSON is laid out: indented, but an array of numbers on one line.

use std::io::{self, Write};

use serde_json::ser::{CompactFormatter, Formatter};

/// A `serde_json` formatter.
#[derive(Debug, Default)]
pub(super) struct Layout {
    depth: usize,
    /// For each open array: whether it has been broken into lines, as one of objects or arrays is.
    broken: Vec<bool>,
    /// Whether the value to come is the first of its array; nothing unless it is in an array at all.
    in_array: Option<bool>,
}

impl Layout {
    fn line<W: ?Sized + Write>(&self, out: &mut W) -> io::Result<()> {
        out.write_all(b"\n")?;
        (0..self.depth).try_for_each(|_| out.write_all(b"  "))
    }

    /// Separates an entry of an array from the one before it.
    fn separate<W: ?Sized + Write>(&mut self, out: &mut W, on_a_line: bool) -> io::Result<()> {
        let Some(first) = self.in_array.take() else { return Ok(()) };
        if !first {
            out.write_all(b",")?;
        }
        if on_a_line {
            if let Some(broken) = self.broken.last_mut() {
                *broken = true;
            }
            return self.line(out);
        }
        if first { Ok(()) } else { out.write_all(b" ") }
    }
}

impl Formatter for Layout {
    // Of the scalars only those that a tree holds may follow each other on one line.
    fn write_f64<W: ?Sized + Write>(&mut self, out: &mut W, value: f64) -> io::Result<()> {
        self.separate(out, false)?;
        CompactFormatter.write_f64(out, value)
    }

    fn write_u32<W: ?Sized + Write>(&mut self, out: &mut W, value: u32) -> io::Result<()> {
        self.separate(out, false)?;
        CompactFormatter.write_u32(out, value)
    }

    fn write_u64<W: ?Sized + Write>(&mut self, out: &mut W, value: u64) -> io::Result<()> {
        self.separate(out, false)?;
        CompactFormatter.write_u64(out, value)
    }

    fn begin_string<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.separate(out, false)?;
        out.write_all(b"\"")
    }

    fn begin_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.separate(out, true)?;
        self.depth += 1;
        self.broken.push(false);
        out.write_all(b"[")
    }

    fn end_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.depth -= 1;
        if self.broken.pop() == Some(true) {
            self.line(out)?;
        }
        out.write_all(b"]")
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, _: &mut W, first: bool) -> io::Result<()> {
        self.in_array = Some(first);
        Ok(())
    }

    fn begin_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.separate(out, true)?;
        self.depth += 1;
        out.write_all(b"{")
    }

    fn end_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.depth -= 1;
        self.line(out)?;
        out.write_all(b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        if !first {
            out.write_all(b",")?;
        }
        self.line(out)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }
}

/// Writes `value` as JSON, a line feed at its end.
pub(super) fn write(out: &mut dyn Write, value: &impl serde::Serialize) -> io::Result<()> {
    let mut serializer = serde_json::Serializer::with_formatter(&mut *out, Layout::default());
    value.serialize(&mut serializer)?;
    out.write_all(b"\n")
}

/// `value` as a JSON text.
pub(super) fn to_string(value: &impl serde::Serialize) -> String {
    let mut bytes = Vec::new();
    // Writing finite numbers and text under text keys into memory cannot fail, and gives UTF-8.
    write(&mut bytes, value).ok();
    String::from_utf8(bytes).unwrap_or_default()
}
