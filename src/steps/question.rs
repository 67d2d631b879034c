//! Predict, then reveal: what may be asked before a step is shown.

use serde::Serialize;

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
}
