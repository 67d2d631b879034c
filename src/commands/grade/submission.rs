//! A submission: a folder with files `NN-name/exercise.rs` somewhere in it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::course::{Course, Lesson};
use crate::commands::failure::Failure;
use crate::input::Problem;

/// How deep below a submission's folder a lesson may lie.
const DEPTH: usize = 5;
/// How many entries of a submission are looked at.
const ENTRIES: usize = 20_000;
/// The largest file that is taken, in bytes.
pub(super) const LARGEST: u64 = 1 << 20;

/// What was handed in.
#[derive(Debug)]
pub(super) struct Submission {
    pub(super) name: String,
    /// The file of each lesson of the course, in that order; nothing where there is none.
    pub(super) files: Vec<Option<Handed>>,
    /// What a tutor should know of the whole.
    pub(super) notes: Vec<String>,
}

/// A file that was handed in.
#[derive(Debug)]
pub(super) struct Handed {
    /// What is in it, if it is not too large.
    pub(super) source: Option<Vec<u8>>,
    /// What a tutor should look at.
    pub(super) notes: Vec<String>,
}

impl Submission {
    /// The submission in a folder.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub(super) fn open(folder: &Path, course: &Course) -> Result<Self, Failure> {
        let mut walk = Walk { course, found: BTreeMap::new(), left: ENTRIES };
        let cannot = |error: std::io::Error| {
            let help = "a folder with the files NN-name/exercise.rs of a submission";
            Problem::new(folder.display().to_string(), format!("it cannot be read: {error}"), help)
        };
        walk.folder(folder, DEPTH).map_err(cannot)?;
        let mut notes = Vec::new();
        if walk.left == 0 {
            notes.push(format!("it has more than {ENTRIES} files: not all were looked at"));
        }
        let mut files = Vec::new();
        for lesson in &course.lessons {
            let mut paths = walk.found.remove(&lesson.folder).unwrap_or_default();
            // The one nearest to the top.
            paths.sort_by_key(|path| (path.components().count(), path.clone()));
            let handed = paths.first().map(|path| Handed::read(path, lesson)).transpose().map_err(cannot)?;
            if let [first, _, ..] = paths.as_slice() {
                let taken = first.strip_prefix(folder).unwrap_or(first).display();
                notes.push(format!("{} is there {} times: {taken} was taken", lesson.folder, paths.len()));
            }
            files.push(handed);
        }
        if files.iter().all(Option::is_none) {
            notes.push("it holds no NN-name/exercise.rs of these lessons".to_owned());
        }
        // "." and ".." have no name of their own.
        let whole = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
        let name = whole.file_name().map_or_else(|| "submission".into(), |name| name.to_string_lossy().into_owned());
        Ok(Submission { name, files, notes })
    }

    /// Whether there is nothing to grade.
    pub(super) fn is_empty(&self) -> bool {
        self.files.iter().all(Option::is_none)
    }
}

struct Walk<'a> {
    course: &'a Course,
    /// The paths that were found of each lesson's exercise.
    found: BTreeMap<String, Vec<PathBuf>>,
    left: usize,
}

impl Walk<'_> {
    /// Looks into a folder. Links are not followed: they may lead out of the submission.
    fn folder(&mut self, folder: &Path, depth: usize) -> std::io::Result<()> {
        let name = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let lesson = self.course.lessons.iter().find(|lesson| lesson.folder == name);
        for entry in fs::read_dir(folder)? {
            if self.left == 0 {
                break;
            }
            self.left -= 1;
            let entry = entry?;
            let (kind, path) = (entry.file_type()?, entry.path());
            let name = entry.file_name();
            if kind.is_file() && name == "exercise.rs" {
                if let Some(lesson) = lesson {
                    self.found.entry(lesson.folder.clone()).or_default().push(path);
                }
            } else if kind.is_dir() && depth > 0 && !name.to_string_lossy().starts_with('.') && name != "target" {
                // One that cannot be read holds nothing for us.
                self.folder(&path, depth - 1).ok();
            }
        }
        Ok(())
    }
}

impl Handed {
    fn read(path: &Path, lesson: &Lesson) -> std::io::Result<Self> {
        if fs::metadata(path)?.len() > LARGEST {
            return Ok(Handed { source: None, notes: Vec::new() });
        }
        let source = fs::read(path)?;
        let notes = looks(&String::from_utf8_lossy(&source), lesson);
        Ok(Handed { source: Some(source), notes })
    }
}

/// Words that no lesson needs: what lies behind them may be harmless, or not.
const SUSPICIOUS: [&str; 12] = [
    "std::process",
    "std::fs",
    "std::env",
    "std::net",
    "std::io",
    "std::panic",
    "std::thread",
    "unsafe",
    "asm!",
    "extern",
    "include",
    "commands::",
];

/// What a tutor should look at in a file.
fn looks(source: &str, lesson: &Lesson) -> Vec<String> {
    let mut notes = Vec::new();
    let (own, handed_out) = (split(source), split(&lesson.exercise));
    if squeezed(own.1) != squeezed(handed_out.1) {
        notes.push("fn main is not the one that was handed out".to_owned());
    }
    let code: String = own.0.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let words: Vec<&str> = SUSPICIOUS.into_iter().filter(|word| code.contains(word)).collect();
    if !words.is_empty() {
        notes.push(format!("it names {}", words.join(", ")));
    }
    if squeezed(own.0) == squeezed(split(&lesson.solution).0) {
        notes.push("it is the course's own solution".to_owned());
    }
    notes
}

/// A file before its main function, and from there on.
fn split(source: &str) -> (&str, &str) {
    source.split_at(source.find("fn main()").unwrap_or(source.len()))
}

/// Code without blanks and without comments on lines of their own.
fn squeezed(code: &str) -> String {
    let lines = code.lines().map(str::trim).filter(|line| !line.starts_with("//") && !line.starts_with("#!["));
    lines.flat_map(str::chars).filter(|c| !c.is_whitespace()).collect()
}
