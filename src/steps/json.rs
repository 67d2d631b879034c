//! A recording as JSON, compact: what the browser plays, and what is exported.
//!
//! ```text
//! { "format": "raytree-recording/1",
//!   "tree": { raytree/1, with tests },
//!   "nodes": [ { "path", "parent", "name", "contribution": [r,g,b], "values": { "o": [..], "d": [..], "inv_x", .. } } ],
//!   "pseudocode": [ { "procedure", "indent", "text" } ],
//!   "forms": { NAME: { "title", "source", "precision": "f32" or "f64",
//!                      "lines": [ { "name", "symbols", "expression" } ] } },
//!   "steps": [ { "line", "node", "call": PROCEDURE, "return": true, "set": { NAME: VARIABLE }, "test",
//!                "arithmetic": { "form", "values": { NAME: number or vector }, "note" },
//!                "verdict": { "ok", "words" }, "diagram": { "kind", "node", "shape", "primitive" },
//!                "events": [ "hit", "blocked", "tir", "exact", "nan" ],
//!                "question": { "ask", "choices", "answer" } } ] }
//! ```
//!
//! A name in a formula is one of the step's `arithmetic.values`, else of its node's `values`; a line whose name is in neither
//! was not reached. A `diagram` is of the step's node unless it names another. A variable is a number, a vector, a text
//! (`none`), a ray (`origin`, `direction`, `t_max`) or a hit (`t`, `object`, `shape`, `primitive`).
//!
//! A key that is absent means "not there". Numbers that JSON has no way to write are the strings `Infinity`, `-Infinity` and
//! `NaN`.

use std::io;

use serde::ser::{Serialize, SerializeMap, SerializeSeq, Serializer};

use super::arithmetic::{Arithmetic, Form};
use super::{FORMAT, Node, PSEUDOCODE, Picture, Recording, Step};
use crate::tree::Value;

impl Recording<'_> {
    /// The recording as JSON, on one line.
    pub fn to_json(&self) -> String {
        // Writing text under text keys into memory cannot fail.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Writes what [`Recording::to_json`] gives, piece by piece, and a line feed.
    ///
    /// # Errors
    /// What `out` says.
    pub fn write_json(&self, out: &mut dyn io::Write) -> io::Result<()> {
        serde_json::to_writer(&mut *out, self)?;
        out.write_all(b"\n")
    }
}

impl Serialize for Recording<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("format", FORMAT)?;
        map.serialize_entry("tree", self.tree)?;
        map.serialize_entry("nodes", &self.nodes)?;
        map.serialize_entry("pseudocode", PSEUDOCODE)?;
        map.serialize_entry("forms", &Forms(&self.forms))?;
        map.serialize_entry("steps", &Steps(self))?;
        map.end()
    }
}

impl Serialize for Node<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("path", &self.path.to_string())?;
        entry(&mut map, "parent", self.parent)?;
        map.serialize_entry("name", &self.name)?;
        map.serialize_entry("contribution", &self.contribution)?;
        map.serialize_entry("values", &Named(&self.values))?;
        map.end()
    }
}

struct Forms<'a>(&'a [Form]);

impl Serialize for Forms<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|form| (&form.name, form)))
    }
}

impl Serialize for Form {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("title", self.title)?;
        map.serialize_entry("source", self.source)?;
        map.serialize_entry("precision", &self.precision)?;
        map.serialize_entry("lines", &Lines(self))?;
        map.end()
    }
}

struct Lines<'a>(&'a Form);

impl Serialize for Lines<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Line<'a> {
            name: &'a str,
            symbols: String,
            expression: &'a super::arithmetic::Expression,
        }
        let lines = self.0.lines.iter();
        serializer.collect_seq(lines.map(|line| Line {
            name: line.name,
            symbols: line.symbols(),
            expression: &line.expression,
        }))
    }
}

struct Steps<'a>(&'a Recording<'a>);

impl Serialize for Steps<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.steps.iter().map(|step| One(step, self.0)))
    }
}

struct One<'a>(&'a Step, &'a Recording<'a>);

impl Serialize for One<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(step, recording) = self;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("line", &step.line)?;
        map.serialize_entry("node", &step.node)?;
        entry(&mut map, "call", step.call)?;
        if step.returns {
            map.serialize_entry("return", &true)?;
        }
        if !step.set.is_empty() {
            map.serialize_entry("set", &Pairs(&step.set))?;
        }
        entry(&mut map, "test", step.test)?;
        if let Some(Arithmetic { form, values, note }) = &step.arithmetic {
            #[derive(serde::Serialize)]
            struct Shown<'a> {
                form: &'a str,
                values: Named<'a>,
                #[serde(skip_serializing_if = "Option::is_none")]
                note: &'a Option<String>,
            }
            let form = &recording.forms[*form].name;
            map.serialize_entry("arithmetic", &Shown { form, values: Named(values), note })?;
        }
        if let Some(finding) = &step.finding {
            #[derive(serde::Serialize)]
            struct Verdict<'a> {
                ok: bool,
                words: &'a str,
            }
            map.serialize_entry("verdict", &Verdict { ok: finding.is_ok, words: &finding.words })?;
        }
        entry(&mut map, "diagram", step.diagram)?;
        if !step.marks.is_empty() {
            let names: Vec<&str> = step.marks.iter().map(|mark| mark.name()).collect();
            map.serialize_entry("events", &names)?;
        }
        entry(&mut map, "question", step.question.as_ref())?;
        map.end()
    }
}

impl Serialize for Picture {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("kind", self.kind)?;
        entry(&mut map, "node", self.node)?;
        entry(&mut map, "shape", self.shape)?;
        entry(&mut map, "primitive", self.primitive)?;
        map.end()
    }
}

/// An entry, where there is a value.
fn entry<M: SerializeMap>(map: &mut M, key: &str, value: Option<impl Serialize>) -> Result<(), M::Error> {
    match value {
        Some(value) => map.serialize_entry(key, &value),
        None => Ok(()),
    }
}

struct Pairs<'a, T>(&'a [(&'static str, T)]);

impl<T: Serialize> Serialize for Pairs<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// Values by their names; of one that stands twice the later.
struct Named<'a>(&'a [(&'static str, Value)]);

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, Finite(*value))))
    }
}

struct Finite(Value);

impl Serialize for Finite {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Number(x) => Component(x).serialize(serializer),
            Value::Vector(v) => {
                let mut array = serializer.serialize_seq(Some(3))?;
                v.iter().try_for_each(|x| array.serialize_element(&Component(*x)))?;
                array.end()
            }
        }
    }
}

struct Component(f64);

impl Serialize for Component {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            x if x.is_nan() => serializer.serialize_str("NaN"),
            x if x.is_infinite() => serializer.serialize_str(if x > 0.0 { "Infinity" } else { "-Infinity" }),
            x => serializer.serialize_f64(x),
        }
    }
}
