//! What a function gave back, in a form that can be compared and told.

use glam::DVec3;

use super::words::{full, shown};
use crate::tree::diff::{self, Tolerances, diff};
use crate::tree::{Branch, Kind, Outcome, RayTree};

/// Numbers count as equal up to this, or up to this share of the expected one where that is larger than 1.
pub const TOLERANCE: f64 = 1e-9;

/// What a function gave back: one or more named values, or nothing.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Nothing, and what that means: `no hit`.
    Nothing(&'static str),
    /// Values with their names.
    Values(Vec<(&'static str, Value)>),
    /// A ray tree; trees are compared as `raytree diff` does it.
    Tree(Box<RayTree>),
}

/// A value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A vector or a point.
    Vector(DVec3),
    /// A yes or a no.
    Truth(bool),
    /// Some of the numbers 0 to 63: bit `i` says whether `i` is among them.
    Set(u64),
    /// Any number up to this one. Only expected values are such.
    AtMost(f64),
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Value::Number(x)
    }
}

impl From<DVec3> for Value {
    fn from(v: DVec3) -> Self {
        Value::Vector(v)
    }
}

impl From<bool> for Value {
    fn from(yes: bool) -> Self {
        Value::Truth(yes)
    }
}

impl Value {
    /// The set of some numbers; those above 63 are left out.
    pub fn set(numbers: impl IntoIterator<Item = usize>) -> Self {
        Value::Set(numbers.into_iter().filter(|i| *i < 64).fold(0, |set, i| set | 1 << i))
    }

    /// Whether this is `expected` within [`TOLERANCE`]. NaN agrees with NaN, an infinity with itself.
    fn agrees(self, expected: Value) -> bool {
        let near = |x: f64, y: f64, size: f64| {
            x == y || (x.is_nan() && y.is_nan()) || (size.is_finite() && (x - y).abs() <= TOLERANCE * size)
        };
        match (self, expected) {
            (Value::Number(x), Value::Number(y)) => near(x, y, y.abs().max(1.0)),
            (Value::Vector(v), Value::Vector(w)) => {
                let size = w.abs().max_element().max(1.0);
                (0..3).all(|k| near(v[k], w[k], size))
            }
            (Value::Truth(x), Value::Truth(y)) => x == y,
            (Value::Set(x), Value::Set(y)) => x == y,
            (Value::Number(x), Value::AtMost(most)) => x <= most,
            _ => false,
        }
    }

    fn told(self, number: fn(f64) -> String) -> String {
        match self {
            Value::Number(x) => number(x),
            Value::Vector(v) => format!("({})", v.to_array().map(number).join(", ")),
            Value::Truth(yes) => yes.to_string(),
            Value::Set(set) => {
                let told: Vec<String> = members(set).map(|i| i.to_string()).collect();
                format!("{{{}}}", told.join(", "))
            }
            Value::AtMost(most) => format!("at most {}", number(most)),
        }
    }
}

/// The numbers in a set.
fn members(set: u64) -> impl Iterator<Item = usize> {
    (0..64).filter(move |i| set >> i & 1 == 1)
}

impl Answer {
    /// One value with its name.
    pub fn of(name: &'static str, value: impl Into<Value>) -> Self {
        Answer::Values(vec![(name, value.into())])
    }

    /// The answer and one value more.
    pub fn and(self, name: &'static str, value: impl Into<Value>) -> Self {
        match self {
            Answer::Nothing(_) | Answer::Tree(_) => Answer::of(name, value),
            Answer::Values(mut values) => {
                values.push((name, value.into()));
                Answer::Values(values)
            }
        }
    }

    /// What `answer` makes of what is there, or nothing in these words.
    pub fn maybe<T>(given: Option<T>, nothing: &'static str, answer: impl FnOnce(T) -> Answer) -> Self {
        given.map_or(Answer::Nothing(nothing), answer)
    }

    /// Whether this is the expected answer within [`TOLERANCE`].
    pub fn agrees(&self, expected: &Answer) -> bool {
        match (self, expected) {
            (Answer::Nothing(_), Answer::Nothing(_)) => true,
            (Answer::Values(own), Answer::Values(other)) => {
                own.len() == other.len() && own.iter().zip(other).all(|((a, x), (b, y))| a == b && x.agrees(*y))
            }
            (Answer::Tree(own), Answer::Tree(other)) => diff(other, own, &Tolerances::default()).is_same(),
            _ => false,
        }
    }

    /// The value with a name.
    fn value(&self, name: &str) -> Option<Value> {
        match self {
            Answer::Nothing(_) | Answer::Tree(_) => None,
            Answer::Values(values) => values.iter().find(|(own, _)| *own == name).map(|(_, value)| *value),
        }
    }

    /// The number with a name, if it is one that can be drawn.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.value(name)? {
            Value::Number(x) if x.abs() < 1e6 => Some(x),
            _ => None,
        }
    }

    /// The vector with a name, if it is one that can be drawn.
    pub fn vector(&self, name: &str) -> Option<DVec3> {
        match self.value(name)? {
            Value::Vector(v) if v.abs().max_element() < 1e6 && !v.is_nan() => Some(v),
            _ => None,
        }
    }

    /// The yes or no with a name.
    pub fn truth(&self, name: &str) -> Option<bool> {
        match self.value(name)? {
            Value::Truth(yes) => Some(yes),
            _ => None,
        }
    }

    /// The numbers in the set with a name, in order.
    pub fn set(&self, name: &str) -> Option<Vec<usize>> {
        match self.value(name)? {
            Value::Set(set) => Some(members(set).collect()),
            _ => None,
        }
    }

    fn told(&self, number: fn(f64) -> String) -> String {
        match self {
            Answer::Nothing(words) => format!("None ({words})"),
            Answer::Values(values) => {
                let told = values.iter().map(|(name, value)| format!("{name} = {}", value.told(number)));
                told.collect::<Vec<_>>().join(", ")
            }
            Answer::Tree(tree) => color(tree, number),
        }
    }

    /// Both answers in words: with six digits, or with all where six would read the same.
    pub fn told_beside(&self, other: &Answer) -> [String; 2] {
        if let (Answer::Tree(right), Answer::Tree(own)) = (self, other) {
            return parting(right, own);
        }
        let short = [self.told(shown), other.told(shown)];
        if short[0] == short[1] && self != other { [self.told(full), other.told(full)] } else { short }
    }
}

/// The colour of a tree.
fn color(tree: &RayTree, number: fn(f64) -> String) -> String {
    format!("colour ({})", tree.color.map(number).join(", "))
}

/// The first value in which two trees part, of the shallowest ray that does, as each of them has it, and both colours.
fn parting(right: &RayTree, own: &RayTree) -> [String; 2] {
    let difference = diff(right, own, &Tolerances::default());
    // The shallowest ray; of those of one level the first. A shadow ray belongs to the ray that it starts from.
    let level = |other: &&diff::Divergence| other.path.len() - usize::from(other.kind == Kind::Shadow);
    let grown = difference.divergences.iter().filter(|other| !other.consequence);
    let Some(first) = grown.min_by_key(level).or(difference.first()) else {
        return [right, own].map(|tree| color(tree, shown));
    };
    // An object is told by its name, where it has one.
    let is_named = |other: &&diff::Divergence| other.path == first.path && other.field == diff::Field::Object;
    let named = difference.divergences.iter().find(is_named).filter(|_| first.field == diff::Field::Shape);
    let first = named.unwrap_or(first);
    let word = |value: &diff::Value| match value {
        diff::Value::Number(x) => shown(*x),
        diff::Value::Numbers(v) => format!("({})", v.iter().map(|x| shown(*x)).collect::<Vec<_>>().join(", ")),
        diff::Value::Place(place) => place.to_string(),
        diff::Value::Word(word) => word.clone(),
        diff::Value::Flag(yes) => yes.to_string(),
    };
    // Whether there is a ray at all is told of that ray.
    let (path, field) = match first.field {
        diff::Field::Reflected => (first.path.child(Branch::Reflected), diff::Field::Outcome),
        diff::Field::Refracted => (first.path.child(Branch::Refracted), diff::Field::Outcome),
        field => (first.path.clone(), field),
    };
    let is_ray = field != first.field || field == diff::Field::Shadows;
    let absent = if is_ray { "not traced" } else { "not there" };
    let is_unshaded = |tree: &RayTree| {
        let node = path.find(tree);
        field == diff::Field::Outcome
            && node.is_ok_and(|node| node.outcome == Outcome::Background && node.hit.is_some())
    };
    let short = shortened(&path.to_string());
    let of = first.light.as_ref().map_or(String::new(), |light| format!(" of {light}"));
    let told = |tree: &RayTree, value: &Option<diff::Value>| {
        let value = value.as_ref().map_or(absent.to_owned(), word);
        let value = if is_unshaded(tree) { "hit, but not shaded".to_owned() } else { value };
        format!("{short} {field}{of}: {value}; {}", color(tree, shown))
    };
    [told(right, &first.a), told(own, &first.b)]
}

/// A path with what is repeated in it counted: `root.reflected x10`.
fn shortened(path: &str) -> String {
    let parts: Vec<&str> = path.split('.').collect();
    let told = parts.chunk_by(|a, b| a == b).map(|same| match same.len() {
        count if count > 2 => format!("{} x{count}", same[0]),
        _ => same.join("."),
    });
    told.collect::<Vec<_>>().join(".")
}

impl std::fmt::Display for Answer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.told(shown))
    }
}
