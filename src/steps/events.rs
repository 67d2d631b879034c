//! What a player can run to.

use std::fmt;
use std::str::FromStr;

use super::{Mark, Procedure, Recording};
use crate::input::{nearest, printable};
use crate::tree::{TestRecord, Verdict};

/// What a player can run to.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// A ray has hit something.
    Hit,
    /// A shadow ray has been blocked.
    Blocked,
    /// A surface reflects totally.
    TotalReflection,
    /// A ray of this level is traced.
    Depth(u32),
    /// A child has a weight whose largest component is below this.
    Weight(f64),
    /// A shape is the nearest hit so far, at a `t` below this.
    T(f64),
    /// A verdict was left open by the filter and decided exactly.
    Exact,
    /// A value is not a number.
    NotANumber,
    /// The object with this name, or a box around it or a part of it, is tested.
    Object(String),
}

/// Why a text is no event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSuchEvent {
    /// What is wrong.
    pub message: String,
    /// What there is instead.
    pub help: String,
}

impl fmt::Display for NoSuchEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.message, self.help)
    }
}

impl std::error::Error for NoSuchEvent {}

impl Event {
    /// How each is written, and what it waits for.
    pub const LIST: [(&'static str, &'static str); 9] = [
        ("hit", "a ray has hit something"),
        ("blocked", "a shadow ray has been blocked"),
        ("tir", "a surface reflects totally"),
        ("depth N", "a ray of level N is traced"),
        ("weight W", "a child's weight is below W"),
        ("t X", "a hit nearer than t = X is the best so far"),
        ("exact", "a verdict is left open by the filter and decided exactly"),
        ("nan", "a value is not a number"),
        ("object NAME", "that object, or a box around it, is tested"),
    ];

    /// Whether it holds at a step.
    pub fn holds(&self, recording: &Recording<'_>, step: usize) -> bool {
        let Some(step) = recording.steps.get(step) else { return false };
        let marked = |mark| step.marks.contains(&mark);
        let ray = recording.nodes[step.node].ray;
        match self {
            Self::Hit => marked(Mark::Hit),
            Self::Blocked => marked(Mark::Blocked),
            Self::TotalReflection => marked(Mark::TotalReflection),
            Self::Exact => marked(Mark::Exact),
            Self::NotANumber => marked(Mark::NotANumber),
            Self::Depth(depth) => step.call == Some(Procedure::Trace) && ray.depth == *depth,
            Self::Weight(below) => {
                matches!(step.call, Some(Procedure::Reflected | Procedure::Refracted))
                    && ray.weight.is_some_and(|weight| weight.iter().fold(0.0_f64, |m, w| m.max(*w)) < *below)
            }
            Self::T(below) => match recording.test_of(step) {
                Some(TestRecord::Shape(test)) => test.verdict == Verdict::Best && test.t.is_some_and(|t| t < *below),
                _ => false,
            },
            Self::Object(name) => match recording.test_of(step) {
                Some(TestRecord::Shape(test)) => test.object.as_ref() == Some(name),
                Some(TestRecord::Bounds(test)) => test.object.as_ref() == Some(name),
                None => false,
            },
        }
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hit => f.write_str("hit"),
            Self::Blocked => f.write_str("blocked"),
            Self::TotalReflection => f.write_str("tir"),
            Self::Depth(depth) => write!(f, "depth {depth}"),
            Self::Weight(weight) => write!(f, "weight {weight}"),
            Self::T(t) => write!(f, "t {t}"),
            Self::Exact => f.write_str("exact"),
            Self::NotANumber => f.write_str("nan"),
            Self::Object(name) => write!(f, "object {}", printable(name)),
        }
    }
}

impl FromStr for Event {
    type Err = NoSuchEvent;
    /// # Errors
    /// [`NoSuchEvent`] with the list of those that there are.
    ///
    /// # Example
    /// ```
    /// use raytree::steps::Event;
    /// assert_eq!("depth 2".parse(), Ok(Event::Depth(2)));
    /// assert_eq!("object glass ball".parse(), Ok(Event::Object("glass ball".into())));
    /// assert!("dept 2".parse::<Event>().unwrap_err().help.starts_with("did you mean `depth N`?"));
    /// ```
    fn from_str(text: &str) -> Result<Self, NoSuchEvent> {
        let text = text.trim();
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let rest = rest.trim();
        let plain = match word {
            "hit" => Some(Self::Hit),
            "blocked" => Some(Self::Blocked),
            "tir" => Some(Self::TotalReflection),
            "exact" => Some(Self::Exact),
            "nan" => Some(Self::NotANumber),
            _ => None,
        };
        let number = || rest.parse::<f64>().ok().filter(|x| x.is_finite());
        let event = match (word, plain) {
            (_, Some(plain)) => rest.is_empty().then_some(plain),
            ("depth", _) => rest.parse().ok().map(Self::Depth),
            ("weight", _) => number().map(Self::Weight),
            ("t", _) => number().map(Self::T),
            ("object", _) => {
                let name = rest.strip_prefix('"').and_then(|name| name.strip_suffix('"')).unwrap_or(rest);
                (!name.is_empty()).then(|| Self::Object(name.to_owned()))
            }
            _ => None,
        };
        event.ok_or_else(|| {
            let first = |form: &'static str| form.split(' ').next().unwrap_or(form);
            let known = Self::LIST.iter().find(|(form, _)| first(form) == word);
            let near = nearest(word, Self::LIST.iter().map(|(form, _)| first(form)));
            let near = near.and_then(|near| Self::LIST.iter().find(|(form, _)| first(form) == near));
            let list = Self::LIST.map(|(form, _)| format!("`{form}`")).join(", ");
            let help = match (known, near) {
                (Some((form, about)), _) => format!("`{form}`: {about}"),
                (None, Some((form, _))) => format!("did you mean `{form}`? {list}"),
                (None, None) => list.clone(),
            };
            match text {
                "" => NoSuchEvent { message: "no event is named".to_owned(), help: list },
                _ => NoSuchEvent { message: format!("`{}` is no event", printable(text)), help },
            }
        })
    }
}
