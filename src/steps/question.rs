//! Predict, then reveal: what may be asked before a step is shown.

use serde::Serialize;

use crate::tree::{Kind, TestRecord, Verdict};

/// A question with its answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Question {
    /// The question.
    pub ask: String,
    /// The answers to choose from.
    pub choices: Vec<String>,
    /// The right one, by its place.
    pub answer: usize,
}

impl Question {
    /// A question that is answered with yes or no.
    pub(super) fn yes_or_no(ask: impl Into<String>, is_so: bool) -> Self {
        Self::between(ask, ["yes", "no"], usize::from(!is_so))
    }

    /// A question with these answers.
    pub(super) fn between(
        ask: impl Into<String>,
        choices: impl IntoIterator<Item = impl Into<String>>,
        answer: usize,
    ) -> Self {
        Self { ask: ask.into(), choices: choices.into_iter().map(Into::into).collect(), answer }
    }

    /// Which ray comes next?
    pub(super) fn next_ray(kind: Option<Kind>) -> Self {
        let answer = match kind {
            Some(Kind::Reflected) => 0,
            Some(_) => 1,
            None => 2,
        };
        Self::between("Which ray comes next?", ["the reflected one", "the refracted one", "none"], answer)
    }

    /// What may be asked before a test is shown.
    pub(super) fn of_test(test: &TestRecord) -> Option<Self> {
        match test {
            // One question a box of the scene; those inside a mesh are too many.
            TestRecord::Bounds(test) => {
                let object = test.object.as_ref().filter(|_| !test.in_mesh)?;
                let is_entered = test.verdict != Verdict::Rejected;
                Some(Self::yes_or_no(format!("Does the ray enter the box around {object}?"), is_entered))
            }
            TestRecord::Shape(test) if test.values.0.is_empty() => None,
            TestRecord::Shape(test) => {
                let has = |name: &str| test.values.0.iter().any(|(key, _)| key == name);
                if has("disc") {
                    let is_negative = test.reason.as_deref() == Some("discriminant negative");
                    return Some(Self::yes_or_no("Is the discriminant negative?", is_negative));
                }
                let is_best = test.verdict == Verdict::Best;
                let object = test.object.as_deref().unwrap_or("it");
                Some(match test.primitive {
                    Some(primitive) => {
                        Self::yes_or_no(format!("Is triangle {primitive} the nearest hit so far?"), is_best)
                    }
                    None => Self::yes_or_no(format!("Is {object} the nearest hit so far?"), is_best),
                })
            }
        }
    }
}
