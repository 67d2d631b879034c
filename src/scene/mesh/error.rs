//! What is wrong with a mesh, where, and what would be right.

use std::fmt;

use crate::scene::mesh::text::place;

/// Why a mesh was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshError {
    /// The line in the file, from 1; absent in binary data and where the whole file is at fault.
    pub line: Option<u32>,
    /// The column in that line, from 1, counted in characters.
    pub column: Option<u32>,
    /// The offset from the start of the file, in bytes; only where the data there is not text.
    pub byte_offset: Option<usize>,
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub help: String,
}

impl MeshError {
    /// An error about the file as a whole.
    pub(super) fn whole(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { line: None, column: None, byte_offset: None, message: message.into(), help: help.into() }
    }

    /// An error at an offset in text.
    pub(super) fn in_text(text: &str, at: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        let (line, column) = place(text, at);
        Self { line: Some(line), column: Some(column), ..Self::whole(message, help) }
    }

    /// An error at an offset in binary data.
    pub(super) fn in_binary(at: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { byte_offset: Some(at), ..Self::whole(message, help) }
    }
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.line, self.column, self.byte_offset) {
            (Some(line), Some(column), _) => write!(f, "line {line}, column {column}: ")?,
            (Some(line), None, _) => write!(f, "line {line}: ")?,
            (None, _, Some(offset)) => write!(f, "byte {offset}: ")?,
            (None, _, None) => {}
        }
        write!(f, "{}\nhelp: {}", self.message, self.help)
    }
}

impl std::error::Error for MeshError {}
