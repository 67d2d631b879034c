//! Whom the server talks to: a page that it served itself, on this machine.
//!
//! A page from elsewhere can make a browser send requests here, under a name of its own that leads to this address (DNS
//! rebinding) or straight. The first carries that name in `Host`; the second says where it comes from in `Origin` or
//! `Sec-Fetch-Site`, and cannot have the header that a post needs without asking first, which nobody answers.

use axum::body::Body;
use hyper::header::{CONTENT_TYPE, HOST, HeaderName, HeaderValue, ORIGIN};
use hyper::{Method, Request, Response, StatusCode};

use super::answer::Refusal;

/// What a page may load: what comes from here. Nothing else, in no frame.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; \
                      connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Sent with every answer.
const HEADERS: [(&str, &str); 6] = [
    ("content-security-policy", POLICY),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cache-control", "no-store"),
];

/// The names under which the server is asked for.
#[derive(Debug)]
pub(super) struct Guard([String; 3]);

impl Guard {
    /// For a server on a port of the loopback address.
    pub(super) fn new(port: u16) -> Self {
        Self(["127.0.0.1", "localhost", "[::1]"].map(|name| format!("{name}:{port}")))
    }

    /// Nothing if the request may go on.
    ///
    /// # Errors
    /// [`Refusal`] for a request that is not for this server, or comes from a page of another.
    pub(super) fn check<B>(&self, request: &Request<B>) -> Result<(), Refusal> {
        let deny = |message: &str| {
            let help = "open the address that `raytree inspect` printed";
            Err(Refusal::Request(StatusCode::FORBIDDEN, message.to_owned(), help))
        };
        let headers = request.headers();
        let only = |name: &HeaderName| {
            let mut values = headers.get_all(name).iter();
            let first = values.next().and_then(|value| value.to_str().ok());
            first.filter(|_| values.next().is_none())
        };
        if !only(&HOST).is_some_and(|host| self.is_own(host)) {
            return deny("this server does not go by that name");
        }
        // An address written out in the request line has to say the same.
        let authority = request.uri().authority();
        if authority.is_some_and(|name| !self.is_own(name.as_str()))
            || request.uri().scheme_str().is_some_and(|scheme| scheme != "http")
        {
            return deny("this server does not go by that name");
        }
        let own_origin = |origin: &str| origin.strip_prefix("http://").is_some_and(|host| self.is_own(host));
        if headers.contains_key(ORIGIN) && !only(&ORIGIN).is_some_and(own_origin) {
            return deny("the request comes from another page");
        }
        let from = HeaderName::from_static("sec-fetch-site");
        let own_site = |site: &str| matches!(site, "same-origin" | "none");
        if request.uri().path().starts_with("/api/")
            && headers.contains_key(&from)
            && !only(&from).is_some_and(own_site)
        {
            return deny("the request comes from another page");
        }
        if request.method() == Method::POST {
            let mark = HeaderName::from_static("x-raytree");
            if only(&mark) != Some("1") {
                return deny("a post needs the header X-Raytree: 1");
            }
            let kind = only(&CONTENT_TYPE).and_then(|kind| kind.split(';').next());
            if !kind.is_some_and(|kind| kind.trim().eq_ignore_ascii_case("application/json")) {
                let message = "a post of something else than JSON".to_owned();
                return Err(Refusal::Request(
                    StatusCode::UNSUPPORTED_MEDIA_TYPE,
                    message,
                    "Content-Type: application/json",
                ));
            }
        }
        Ok(())
    }

    fn is_own(&self, host: &str) -> bool {
        self.0.iter().any(|own| own.eq_ignore_ascii_case(host))
    }
}

/// Adds the headers that every answer has.
pub(super) fn seal(mut response: Response<Body>) -> Response<Body> {
    for (name, value) in HEADERS {
        response.headers_mut().insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    response
}
