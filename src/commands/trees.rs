//! Files of ray trees: one, or a forest, one JSON tree a line or all in an array; `-` is standard input.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read};

use super::files;
use crate::input::{Located, Problem, read_json};
use crate::scene;
use crate::tree::check::parse_tree;
use crate::tree::{FORMAT, RayTree};

/// What a file holds.
pub(super) enum Trees {
    /// One tree, and its text.
    One(Box<RayTree>, String),
    /// Several.
    Forest(Forest),
}

/// Trees that are read one after the other.
pub(super) struct Forest {
    file: String,
    /// What was read to find out that it is a forest, with the numbers of the lines.
    begun: VecDeque<(usize, String)>,
    /// Trees of an array.
    array: VecDeque<RayTree>,
    rest: Option<Lines>,
}

/// The lines of a file that is being read.
struct Lines {
    name: String,
    reader: Box<dyn BufRead>,
    line: usize,
}

impl Trees {
    /// Opens a file and reads as much of it as it takes to know which of the two it is: a forest has a whole tree on its
    /// first line and another one on a later line, or begins with a bracket.
    pub(super) fn open(file: &str) -> Result<Self, Problem> {
        let shown = files::shown(file);
        let reader: Box<dyn BufRead> = match file {
            "-" => Box::new(BufReader::new(std::io::stdin())),
            _ => Box::new(BufReader::new(scene::open(file).map_err(|why| cannot_read(shown, &why))?)),
        };
        let mut lines = Lines { name: shown.to_owned(), reader, line: 0 };
        let Some((number, first)) = lines.next_full()? else {
            return Err(Problem::new(shown, "it is empty", "a ray tree, or one JSON tree a line"));
        };
        let is_whole = || serde_json::from_str::<serde::de::IgnoredAny>(first.trim_start_matches('\u{feff}')).is_ok();
        if first.trim_start_matches('\u{feff}').trim_start().starts_with('[') {
            let text = lines.all(number, first)?;
            let located = Located { file: shown, text: &text };
            let array: VecDeque<RayTree> = read_json(located)?;
            if let Some(tree) = array.iter().find(|tree| tree.format != FORMAT) {
                let message = format!("the format of a tree is {:?}", tree.format);
                return Err(Problem::new(shown, message, format!("this program reads {FORMAT:?}")));
            }
            return Ok(Self::Forest(Forest { file: shown.to_owned(), begun: VecDeque::new(), array, rest: None }));
        }
        if is_whole() {
            return match lines.next_full()? {
                None => Self::one(shown, first),
                Some(second) => {
                    let begun = [(number, first), second].into();
                    let file = shown.to_owned();
                    Ok(Self::Forest(Forest { file, begun, array: VecDeque::new(), rest: Some(lines) }))
                }
            };
        }
        Self::one(shown, lines.all(number, first)?)
    }

    fn one(file: &str, text: String) -> Result<Self, Problem> {
        Ok(Self::One(Box::new(parse_tree(file, &text)?), text))
    }

    /// The same as a forest, if only of one tree.
    pub(super) fn into_forest(self, file: &str) -> Forest {
        match self {
            Self::Forest(forest) => forest,
            Self::One(tree, _) => Forest {
                file: files::shown(file).to_owned(),
                begun: VecDeque::new(),
                array: [*tree].into(),
                rest: None,
            },
        }
    }
}

impl Forest {
    /// The next tree and its pixel.
    pub(super) fn next(&mut self) -> Result<Option<([u32; 2], RayTree)>, Problem> {
        let tree = match self.array.pop_front() {
            Some(tree) => tree,
            None => {
                let line = match self.begun.pop_front() {
                    Some(line) => Some(line),
                    None => self.rest.as_mut().map_or(Ok(None), Lines::next_full)?,
                };
                let Some((number, text)) = line else { return Ok(None) };
                parse_tree(&self.file, &text).map_err(|mut problem| {
                    if let Some(place) = &mut problem.place {
                        place.line += number - 1;
                    }
                    problem
                })?
            }
        };
        match tree.pixel {
            Some(pixel) => Ok(Some((pixel, tree))),
            None => Err(Problem::new(&self.file, "a tree of a forest without `pixel`", "trees are aligned by it")),
        }
    }
}

impl Lines {
    /// The next line that is not blank, and its number from 1.
    fn next_full(&mut self) -> Result<Option<(usize, String)>, Problem> {
        loop {
            let mut bytes = Vec::new();
            let read = self.reader.by_ref().take(scene::LARGEST_FILE).read_until(b'\n', &mut bytes);
            if read.map_err(|error| cannot_read(&self.name, &error.to_string()))? == 0 {
                return Ok(None);
            }
            self.line += 1;
            let line = self.text(bytes)?;
            if !line.trim().is_empty() {
                return Ok(Some((self.line, line)));
            }
        }
    }

    /// A line that was read with all that comes after it; blank lines before it keep the numbers of lines right.
    fn all(&mut self, number: usize, line: String) -> Result<String, Problem> {
        let mut bytes = Vec::new();
        let read = self.reader.by_ref().take(scene::LARGEST_FILE + 1).read_to_end(&mut bytes);
        read.map_err(|error| cannot_read(&self.name, &error.to_string()))?;
        if bytes.len() as u64 > scene::LARGEST_FILE {
            return Err(cannot_read(&self.name, &format!("it is larger than {} bytes", scene::LARGEST_FILE)));
        }
        Ok("\n".repeat(number - 1) + &line + &self.text(bytes)?)
    }

    fn text(&self, bytes: Vec<u8>) -> Result<String, Problem> {
        String::from_utf8(bytes).map_err(|error| {
            let message = format!("line {} holds bytes that are not UTF-8", self.line + 1);
            Problem::new(&self.name, format!("{message}: {}", error.utf8_error()), "JSON is UTF-8 text")
        })
    }
}

fn cannot_read(file: &str, why: &str) -> Problem {
    Problem::new(file, format!("it cannot be read: {why}"), "the path of a readable file, or - for standard input")
}
