//! JSON read into a type, with every error located: line, column, JSON path, and what would be right.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use jsonc_parser::ast;
use jsonc_parser::common::Ranged;
use serde::de::{DeserializeOwned, Deserializer, MapAccess, Visitor};
use serde_json::Value;

use super::problem::Problem;
use super::{nearest, one_of};

/// One step of a [`JsonPath`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Segment {
    /// Into an object.
    Key(String),
    /// Into an array, from 0.
    Index(usize),
}

impl From<&str> for Segment {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for Segment {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

/// The way from a document's root to a value: `objects[2].shape.sphere.radius`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct JsonPath(Vec<Segment>);

impl JsonPath {
    /// The path one step further in.
    pub fn child(&self, segment: impl Into<Segment>) -> Self {
        let mut path = self.clone();
        path.0.push(segment.into());
        path
    }
}

impl fmt::Display for JsonPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return f.write_str("(top level)");
        }
        for (i, segment) in self.0.iter().enumerate() {
            match segment {
                Segment::Index(index) => write!(f, "[{index}]")?,
                Segment::Key(key) if key.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '$') => {
                    write!(f, "{}{key}", if i == 0 { "" } else { "." })?;
                }
                Segment::Key(key) => write!(f, "[{key:?}]")?,
            }
        }
        Ok(())
    }
}

/// A text that was read as JSON, kept so that a problem found later can still point into it.
#[derive(Clone, Copy, Debug)]
pub struct Located<'a> {
    /// The file as the caller named it.
    pub file: &'a str,
    /// Its whole text.
    pub text: &'a str,
}

impl Located<'_> {
    /// A problem of the value at `path`.
    pub fn problem(&self, path: &JsonPath, message: impl Into<String>, help: impl Into<String>) -> Problem {
        let mut problem = Problem::new(self.file, message, help);
        problem.path = Some(path.to_string());
        match self.span(path, None) {
            Some(range) => problem.at(self.text, range),
            None => problem,
        }
    }

    /// The bytes of the value at `path`, or of the key `key` in it; the nearest enclosing value if it is not there.
    fn span(&self, path: &JsonPath, key: Option<&str>) -> Option<Range<usize>> {
        let parsed = jsonc_parser::parse_to_ast(self.text, &Default::default(), &Default::default()).ok()?;
        let mut value = parsed.value?;
        for segment in &path.0 {
            let inner = match (segment, value) {
                // The last of several equal keys is the one that counts, and the one at fault.
                (Segment::Key(key), ast::Value::Object(object)) => {
                    let range = object.range;
                    let found = object.properties.into_iter().rev().find(|p| p.name.as_str() == key);
                    found.map(|p| p.value).ok_or(range)
                }
                (Segment::Index(index), ast::Value::Array(array)) => {
                    let range = array.range;
                    array.elements.into_iter().nth(*index).ok_or(range)
                }
                (_, other) => Err(other.range()),
            };
            match inner {
                Ok(inner) => value = inner,
                Err(enclosing) => return Some(enclosing.start..enclosing.end),
            }
        }
        if let (Some(key), ast::Value::Object(object)) = (key, &value)
            && let Some(property) = object.properties.iter().rev().find(|p| p.name.as_str() == key)
        {
            let range = property.name.range();
            return Some(range.start..range.end);
        }
        let range = value.range();
        Some(range.start..range.end)
    }
}

/// The value that a JSON text holds.
///
/// # Errors
/// One [`Problem`], located, for: bytes that are not UTF-8, text that is not JSON, a key that is unknown (with the
/// nearest known one), missing or given twice, a value of the wrong type, a number beyond the range of `f64`.
pub fn read_json<T: DeserializeOwned>(located: Located<'_>) -> Result<T, Problem> {
    // Some editors put a byte order mark in front; JSON allows a reader to pass over it.
    let text = located.text.strip_prefix('\u{feff}').unwrap_or(located.text);
    let located = Located { text, ..located };
    let mut json = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut json).map_err(|error| explain(located, error))?;
    json.end().map_err(|error| syntax(located, &error))?;
    Ok(value)
}

/// Refuses a text that wrote an object as the array of its values, which serde would take.
///
/// `value` is what was read from it.
///
/// # Errors
/// One [`Problem`] for the first such array.
pub fn refuse_arrays_for_objects(located: Located<'_>, value: &impl serde::Serialize) -> Result<(), Problem> {
    let text = located.text.strip_prefix('\u{feff}').unwrap_or(located.text);
    let (Ok(written), Ok(read)) = (serde_json::from_str(text), serde_json::to_value(value)) else { return Ok(()) };
    match array_for_object(&JsonPath::default(), &written, &read) {
        None => Ok(()),
        Some(path) => Err(located.problem(&path, "an array where an object belongs", "write an object, with its keys")),
    }
}

fn array_for_object(path: &JsonPath, written: &Value, read: &Value) -> Option<JsonPath> {
    match (written, read) {
        (Value::Array(_), Value::Object(_)) => Some(path.clone()),
        (Value::Array(written), Value::Array(read)) => {
            let mut entries = written.iter().zip(read).enumerate();
            entries.find_map(|(i, (written, read))| array_for_object(&path.child(i), written, read))
        }
        (Value::Object(written), Value::Object(read)) => {
            let mut entries = written.iter().filter_map(|(key, value)| Some((key, value, read.get(key)?)));
            entries.find_map(|(key, written, read)| array_for_object(&path.child(key.as_str()), written, read))
        }
        _ => None,
    }
}

fn explain(located: Located<'_>, error: serde_path_to_error::Error<serde_json::Error>) -> Problem {
    // What is no JSON at all says so first, whatever was read until then. (A value has a limit to its depth, unlike
    // this type.)
    if let Err(error) = serde_json::from_str::<serde::de::IgnoredAny>(located.text) {
        return syntax(located, &error);
    }
    let mut path = JsonPath::default();
    for segment in error.path() {
        use serde_path_to_error::Segment as S;
        path = match segment {
            S::Seq { index } => path.child(*index),
            S::Map { key } => path.child(key.as_str()),
            S::Enum { .. } | S::Unknown => path,
        };
    }
    let text = error.inner().to_string();
    let text = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    let quoted: Vec<&str> = text.split('`').skip(1).step_by(2).collect();

    // serde names the offender and the known names between backticks.
    if let Some(kind) = ["unknown field", "unknown variant"].into_iter().find(|k| text.starts_with(k))
        && let [word, known @ ..] = quoted.as_slice()
    {
        if path.0.last() == Some(&Segment::from(*word)) {
            path.0.pop();
        }
        let (what, place) = match kind {
            "unknown field" => ("key", path.child(*word)),
            _ => ("name", path.clone()),
        };
        let help = match nearest(word, known.iter().copied()) {
            Some(near) => format!("did you mean `{near}`? Known here: {}", one_of(known.iter().copied())),
            None => format!("known here: {}", one_of(known.iter().copied())),
        };
        let range = located.span(&path, (kind == "unknown field").then_some(word));
        return at(located, range, &place, &error, format!("unknown {what} `{word}`"), help);
    }
    if let ("missing field", [key]) = (text.get(..13).unwrap_or_default(), quoted.as_slice()) {
        let (message, help) = (format!("the key `{key}` is missing"), format!("add `{key}` to this object"));
        return at(located, located.span(&path, None), &path, &error, message, help);
    }
    if let ("duplicate field", [key]) = (text.get(..15).unwrap_or_default(), quoted.as_slice()) {
        if path.0.last() == Some(&Segment::from(*key)) {
            path.0.pop();
        }
        let range = located.span(&path, Some(key));
        let message = format!("the key `{key}` stands here twice");
        return at(located, range, &path.child(*key), &error, message, "keep one of the two".to_owned());
    }
    let range = located.span(&path, None);
    let (message, help) = match text.split_once(", expected ") {
        Some((got, wanted)) => {
            let (got, wanted) = (plain(got), plain(wanted));
            let off = match got.as_str() {
                "null" | "`true`" | "`false`" => "; what is not wanted is left out, key and all",
                _ => "",
            };
            (format!("{got} where {wanted} belongs"), format!("write {wanted}{off}"))
        }
        // serde_json says this of an array that goes on where a fixed number of entries is wanted.
        None if text.starts_with("trailing characters") => {
            let help = "[x, y, z] and [r, g, b] have three entries, a pixel [x, y] two, a triangle three vertices";
            ("an array with too many entries".to_owned(), help.to_owned())
        }
        None if text.starts_with("expected value") => (
            "not one of the names that belong here".to_owned(),
            "a name in quotes; `raytree schema` lists them".to_owned(),
        ),
        None if text.starts_with("number out of range") => (
            "a number beyond all numbers of 64 bits".to_owned(),
            "a finite number, at most about 1.8e308 in magnitude".to_owned(),
        ),
        None if text.starts_with("recursion limit") => {
            ("nested too deep".to_owned(), "nest no deeper than 127 levels".to_owned())
        }
        None => {
            (plain(text), "`raytree schema scene` and `raytree schema tree` print what the formats allow".to_owned())
        }
    };
    at(located, range, &path, &error, message, help)
}

/// A problem at a range, or where there is none, where the parser stopped.
fn at(
    located: Located<'_>,
    range: Option<Range<usize>>,
    path: &JsonPath,
    error: &serde_path_to_error::Error<serde_json::Error>,
    message: String,
    help: String,
) -> Problem {
    let mut problem = Problem::new(located.file, clipped(&message), clipped(&help));
    problem.path = Some(clipped(&path.to_string()));
    let range = range.unwrap_or_else(|| {
        let offset = offset_of(located.text, error.inner());
        offset..offset
    });
    problem.at(located.text, range)
}

/// A long text, shortened in the middle.
fn clipped(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    match chars.len() {
        0..=400 => text.to_owned(),
        n => format!("{} ... {}", String::from_iter(&chars[..200]), String::from_iter(&chars[n - 100..])),
    }
}

/// serde's words for types in the words of JSON.
fn plain(text: &str) -> String {
    let text = text.strip_prefix("invalid type: ").unwrap_or(text);
    let text = text.strip_prefix("invalid value: ").unwrap_or(text);
    if let Some(length) = text.strip_prefix("invalid length ") {
        return format!("an array of {length}");
    }
    let mut text = text.to_owned();
    for (rust, json) in [
        ("floating point `", "the number `"),
        ("integer `", "the number `"),
        ("boolean `", "`"),
        ("an array of length ", "an array of "),
        ("a sequence", "an array"),
        ("sequence", "an array"),
        ("a map", "an object"),
        ("map", "an object"),
        ("string \"", "the text \""),
        ("unit value", "null"),
    ] {
        text = text.replacen(rust, json, 1);
        if text.starts_with("an array") || text.starts_with("an object") {
            break;
        }
    }
    match text.as_str() {
        "f64" | "f32" => "a number".to_owned(),
        "u32" => format!("a whole number from 0 to {}", u32::MAX),
        "u64" | "usize" => format!("a whole number from 0 to {}", u64::MAX),
        _ => text,
    }
}

/// The byte where the parser stopped.
fn offset_of(text: &str, error: &serde_json::Error) -> usize {
    let start: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    let mut offset = (start + error.column().saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

fn syntax(located: Located<'_>, error: &serde_json::Error) -> Problem {
    if located.text.trim().is_empty() {
        return Problem::new(located.file, "the file is empty", "a JSON object");
    }
    let text = error.to_string();
    let message = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    let offset = offset_of(located.text, error);
    // The whole word that the parser stopped in.
    let word = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'+' | b'-' | b'_');
    let bytes = located.text.as_bytes();
    let from = (0..offset).rev().take_while(|&i| word(bytes[i])).last().unwrap_or(offset);
    let to = (offset..bytes.len()).take_while(|&i| word(bytes[i])).last().map_or(offset, |i| i + 1);
    let inside_word = bytes.get(offset).is_some_and(|&b| word(b));
    let range = if inside_word || from < offset && message.contains("number") { from..to } else { offset..offset };
    let help = if message.contains("out of range") {
        "a number must be finite in 64 bits: at most about 1.8e308 in magnitude"
    } else if message.contains("recursion") {
        "nest no deeper than 127 levels"
    } else if message.contains("EOF") {
        "the text ends too early: a bracket, brace or quote is not closed"
    } else if message.contains("trailing characters") {
        "one value a file: remove what follows it"
    } else {
        "plain JSON: keys in double quotes, commas between entries, none after the last, no comments, no NaN or Infinity"
    };
    Problem::new(located.file, format!("this is not JSON: {message}"), help).at(located.text, range)
}

/// An optional key that is there: `null` is not a way to leave it out.
///
/// # Errors
/// What the value's own type says, of `null` too.
pub fn present<'de, D: Deserializer<'de>, T: serde::Deserialize<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

/// One of the names that `T`, an enum without data, serialises to.
///
/// # Errors
/// A value that is not text, and a name that is none of them.
pub fn name<'de, D: Deserializer<'de>, T: DeserializeOwned>(deserializer: D) -> Result<Option<T>, D::Error> {
    struct Name<T>(PhantomData<T>);
    impl<T: DeserializeOwned> Visitor<'_> for Name<T> {
        type Value = T;
        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a name in quotes")
        }
        fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<T, E> {
            T::deserialize(serde::de::value::StrDeserializer::new(name))
        }
    }
    deserializer.deserialize_str(Name(PhantomData)).map(Some)
}

/// A JSON object whose keys are names that the writer chose: the entries in the order of the file, each name once.
#[derive(Clone, Debug, PartialEq)]
pub struct Named<T>(pub Vec<(String, T)>);

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T: serde::Serialize> serde::Serialize for Named<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<'de, T: serde::Deserialize<'de>> serde::Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries<T>(PhantomData<T>);
        impl<'de, T: serde::Deserialize<'de>> Visitor<'de> for Entries<T> {
            type Value = Named<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object of named entries")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Named<T>, A::Error> {
                let mut entries = Vec::new();
                let mut seen = std::collections::HashSet::new();
                while let Some((name, value)) = map.next_entry::<String, T>()? {
                    if !seen.insert(name.clone()) {
                        return Err(serde::de::Error::custom(format_args!("duplicate field `{name}`")));
                    }
                    entries.push((name, value));
                }
                Ok(Named(entries))
            }
        }
        deserializer.deserialize_map(Entries(PhantomData))
    }
}

#[cfg(feature = "schema")]
impl<T: schemars::JsonSchema> schemars::JsonSchema for Named<T> {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("Named{}", T::schema_name()).into()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        <std::collections::BTreeMap<String, T>>::json_schema(generator)
    }
    fn inline_schema() -> bool {
        true
    }
}
