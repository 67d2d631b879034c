//! Answers: what is sent back, and how a request is turned down.

use axum::body::Body;
use hyper::header::{CONTENT_TYPE, HeaderValue};
use hyper::{Response, StatusCode};
use serde::Serialize;

use crate::input::Problem;

/// What a handler gives.
pub(super) type Answer = Result<Response<Body>, Refusal>;

/// Why a request gets no answer.
#[derive(Debug)]
pub(super) enum Refusal {
    /// The request is at fault, or what it names is not there.
    Request(StatusCode, String, &'static str),
    /// A scene text is at fault.
    Scene(Box<Problem>),
    /// There is no such picture of this ray, or no such tree of this pixel.
    Why(String),
}

impl Refusal {
    /// A malformed request.
    pub(super) fn bad(message: impl Into<String>, help: &'static str) -> Self {
        Self::Request(StatusCode::BAD_REQUEST, message.into(), help)
    }

    /// An unknown scene.
    pub(super) fn no_scene() -> Self {
        let message = "this scene is not held, or no more".to_owned();
        Self::Request(StatusCode::NOT_FOUND, message, "post its text to /api/scenes again")
    }

    /// Work that ended badly.
    pub(super) fn broken() -> Self {
        let message = "the work for this request failed".to_owned();
        Self::Request(StatusCode::INTERNAL_SERVER_ERROR, message, "a mistake in the program: please report it")
    }

    /// The answer that says so.
    pub(super) fn into_response(self) -> Response<Body> {
        #[derive(Serialize)]
        struct Problems {
            problem: Shown,
        }
        #[derive(Serialize)]
        struct Why {
            why: String,
        }
        match self {
            Self::Request(status, message, help) => {
                let problem = Shown {
                    file: None,
                    message,
                    help: help.to_owned(),
                    path: None,
                    line: None,
                    column: None,
                    length: None,
                };
                json(status, &Problems { problem })
            }
            Self::Scene(problem) => json(StatusCode::UNPROCESSABLE_ENTITY, &Problems { problem: Shown::of(*problem) }),
            Self::Why(why) => json(StatusCode::UNPROCESSABLE_ENTITY, &Why { why }),
        }
    }
}

impl From<Problem> for Refusal {
    fn from(problem: Problem) -> Self {
        Self::Scene(Box::new(problem))
    }
}

/// A problem as the page gets it.
#[derive(Debug, Serialize)]
struct Shown {
    /// The scene, or the mesh that is at fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    message: String,
    help: String,
    /// The JSON path of what is wrong.
    #[serde(skip_serializing_if = "Option::is_none")]
    path: Option<String>,
    /// From 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    /// From 1, in characters.
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    /// In characters, within the line.
    #[serde(skip_serializing_if = "Option::is_none")]
    length: Option<usize>,
}

impl Shown {
    fn of(problem: Problem) -> Self {
        let place = problem.place.as_deref();
        Self {
            line: place.map(|place| place.line),
            column: place.map(|place| place.column),
            length: place.map(|place| place.text.get(place.span.clone()).map_or(0, |span| span.chars().count())),
            file: Some(problem.file),
            message: problem.message,
            help: problem.help,
            path: problem.path,
        }
    }
}

/// `value` as JSON.
pub(super) fn json(status: StatusCode, value: &impl Serialize) -> Response<Body> {
    // Plain data under text keys: writing it cannot fail.
    let mut response = bytes(serde_json::to_vec(value).unwrap_or_default(), "application/json");
    *response.status_mut() = status;
    response
}

/// Bytes of a media type.
pub(super) fn bytes(bytes: impl Into<Body>, mime: &'static str) -> Response<Body> {
    let mut response = Response::new(bytes.into());
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(mime));
    response
}
