//! What can be asked for.
//!
//! | request | answer |
//! |---|---|
//! | `GET /`, `/page/NAME` | the page and its files |
//! | `GET /api/scene` | SCENE: the scene that was given |
//! | `POST /api/scenes` | SCENE of `{"text", "settings": {"precision"?, "numerics"?, "max_depth"?}}`, or 422 with its problem |
//! | `GET /api/scenes/ID/geometry` | the shapes for the view in three dimensions |
//! | `GET /api/scenes/ID/render` | bands: u32 first row, u32 rows (little-endian), then sRGB and alpha, four bytes a pixel |
//! | `GET /api/scenes/ID/overlay?kind=` | bands of one f32 a pixel: `rays`, `depth`, `tests`, `stage`, `time` |
//! | `GET /api/scenes/ID/recording?x=&y=` | the recording of a pixel |
//! | `GET /api/scenes/ID/diagram?x=&y=&kind=&node=` | SVG, or 422 with `why`; also `shape`, `primitive`, `theme` |
//! | the same with `kind=verdict` | that of the test that decides; the header `x-raytree-diagram` says which |
//! | `GET /api/scenes/ID/difference?x=&y=&from=ID` | where the pixel's tree parts from that in another scene |
//! | `GET /api/scenes/ID/export`, `?pixel=x,y` | the page as one file with some pixels, else with those that have names |

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::{Path, RawQuery, State};
use axum::routing::{get, post};
use hyper::header::{CONTENT_DISPOSITION, CONTENT_LENGTH, HeaderName, HeaderValue};
use hyper::{HeaderMap, Request, Response, StatusCode};
use serde::Deserialize;
use tokio::sync::Semaphore;

use super::answer::{Answer, Refusal, bytes, json};
use super::assets;
use super::bands::Bands;
use super::bundle;
use super::description::Description;
use super::diagram::{Wanted, of_the_verdict, svg};
use super::export::{self, Kept};
use super::geometry::Geometry;
use super::query::Query;
use super::recording;
use super::scenes::{Held, Inspector, Settings};
use super::tracing::Show;
use crate::input::{Located, name, present, read_json};
use crate::numbers::Precision;
use crate::pictures::diagrams::Chosen;
use crate::pictures::theme::Theme;
use crate::scene::Numerics;
use crate::steps::Recording;
use crate::tree::diff::{Tolerances, diff};

/// A scene text and what surrounds it, at most: 1 MiB.
pub(super) const LARGEST_BODY: usize = 1 << 20;
/// Bytes of bodies that are on their way at a time.
const BODIES: usize = 64 * LARGEST_BODY;

/// What handlers have.
#[derive(Clone, Debug)]
pub(super) struct Site {
    inspector: Arc<Inspector>,
    bodies: Arc<Semaphore>,
    body_timeout: Duration,
}

/// All addresses.
pub(super) fn routes(inspector: Arc<Inspector>, body_timeout: Duration) -> Router {
    Router::new()
        .route("/", get(async || bytes(bundle::served(), "text/html; charset=utf-8")))
        .route("/page/{name}", get(async |Path(name): Path<String>| file(&name)))
        .route("/api/scene", get(first))
        .route("/api/scenes", post(add))
        .route("/api/scenes/{id}/geometry", get(geometry))
        .route("/api/scenes/{id}/render", get(render))
        .route("/api/scenes/{id}/overlay", get(overlay))
        .route("/api/scenes/{id}/recording", get(recording))
        .route("/api/scenes/{id}/diagram", get(diagram))
        .route("/api/scenes/{id}/difference", get(difference))
        .route("/api/scenes/{id}/export", get(export_page))
        .fallback(async || nothing().into_response())
        .with_state(Site { inspector, bodies: Arc::new(Semaphore::new(BODIES)), body_timeout })
}

fn nothing() -> Refusal {
    Refusal::Request(StatusCode::NOT_FOUND, "there is nothing here".to_owned(), "the page is at /")
}

fn file(name: &str) -> Response<Body> {
    assets::find(name).map_or_else(|| nothing().into_response(), |asset| bytes(asset.bytes, asset.mime))
}

impl axum::response::IntoResponse for Refusal {
    fn into_response(self) -> Response<Body> {
        self.into_response()
    }
}

impl Site {
    fn scene(&self, id: &str) -> Result<Arc<Held>, Refusal> {
        self.inspector.find(id).ok_or_else(Refusal::no_scene)
    }
}

async fn first(State(site): State<Site>) -> Answer {
    describe(&site, Arc::clone(site.inspector.first())).await
}

async fn describe(site: &Site, held: Arc<Held>) -> Answer {
    site.inspector.work().quick(move |_| json(StatusCode::OK, &Description::of(&held))).await
}

/// The body of a post.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with `text` and `settings`")]
struct Post {
    text: String,
    #[serde(default)]
    settings: Overrides,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object")]
struct Overrides {
    #[serde(default, deserialize_with = "name")]
    precision: Option<Precision>,
    #[serde(default, deserialize_with = "name")]
    numerics: Option<Numerics>,
    #[serde(default, deserialize_with = "present")]
    max_depth: Option<u32>,
}

async fn add(State(site): State<Site>, request: Request<Body>) -> Answer {
    let body = take(&site, request).await?;
    let inspector = Arc::clone(&site.inspector);
    let added = site.inspector.work().quick(move |_| {
        let not_ours = |message: String| Refusal::bad(message, "{\"text\": \"the scene\", \"settings\": {}}");
        let text = std::str::from_utf8(&body).map_err(|_| not_ours("the body is not UTF-8".to_owned()))?;
        let post: Post = read_json(Located { file: "body", text }).map_err(|problem| not_ours(problem.to_string()))?;
        let given = inspector.settings();
        let settings = Settings {
            precision: post.settings.precision.or(given.precision),
            numerics: post.settings.numerics.or(given.numerics),
            max_depth: post.settings.max_depth.or(given.max_depth),
            ..given
        };
        Ok::<_, Refusal>(inspector.add(post.text, settings)?)
    });
    describe(&site, added.await??).await
}

/// The body of a request, if it is small enough and comes in time.
async fn take(site: &Site, request: Request<Body>) -> Result<Bytes, Refusal> {
    let refuse = |status, message: &str, help| Refusal::Request(status, message.to_owned(), help);
    let too_large = || refuse(StatusCode::PAYLOAD_TOO_LARGE, "the body is too large", "at most 1 MiB");
    let announced = length(request.headers()).unwrap_or(LARGEST_BODY);
    if announced > LARGEST_BODY {
        return Err(too_large());
    }
    let busy = || refuse(StatusCode::SERVICE_UNAVAILABLE, "too many bodies at a time", "try again");
    let _held = site.bodies.try_acquire_many(announced as u32).map_err(|_| busy())?;
    match tokio::time::timeout(site.body_timeout, axum::body::to_bytes(request.into_body(), LARGEST_BODY)).await {
        Ok(Ok(body)) => Ok(body),
        Ok(Err(_)) => Err(too_large()),
        Err(_) => Err(refuse(StatusCode::REQUEST_TIMEOUT, "the body takes too long", "send it at once")),
    }
}

fn length(headers: &HeaderMap) -> Option<usize> {
    headers.get(CONTENT_LENGTH)?.to_str().ok()?.parse().ok()
}

async fn geometry(State(site): State<Site>, Path(id): Path<String>) -> Answer {
    let held = site.scene(&id)?;
    site.inspector.work().quick(move |_| json(StatusCode::OK, &Geometry::of(&held.loaded.scene))).await
}

async fn render(State(site): State<Site>, Path(id): Path<String>) -> Answer {
    let held = site.scene(&id)?;
    Ok(bytes(Bands::body(site.inspector, held, Show::Picture), "application/octet-stream"))
}

async fn overlay(State(site): State<Site>, Path(id): Path<String>, RawQuery(query): RawQuery) -> Answer {
    let held = site.scene(&id)?;
    let query = Query::parse(query.as_deref(), &["kind"])?;
    let show = match query.one("kind")? {
        Some("rays") => Show::Rays,
        Some("depth") => Show::Depth,
        Some("tests") => Show::Tests,
        Some("time") => Show::Time,
        Some("stage") if held.options.numerics == Numerics::Certified => Show::Stage,
        Some("stage") => return Err(Refusal::Why("only certified numerics decide in stages".to_owned())),
        _ => return Err(Refusal::bad("there is no such overlay", "rays, depth, tests, stage or time")),
    };
    Ok(bytes(Bands::body(site.inspector, held, show), "application/octet-stream"))
}

async fn recording(State(site): State<Site>, Path(id): Path<String>, RawQuery(query): RawQuery) -> Answer {
    let held = site.scene(&id)?;
    let pixel = Query::parse(query.as_deref(), &["x", "y"])?.pixel(held.loaded.scene.image)?;
    let inspector = Arc::clone(&site.inspector);
    let work = move |stop: &_| {
        let tree = recording::tree(&inspector, &held, pixel, stop)?;
        Ok(json(StatusCode::OK, &Recording::of(&held.loaded.scene, &tree.tree)))
    };
    site.inspector.work().quick(work).await?
}

async fn diagram(State(site): State<Site>, Path(id): Path<String>, RawQuery(query): RawQuery) -> Answer {
    let held = site.scene(&id)?;
    let query = Query::parse(query.as_deref(), &["x", "y", "kind", "node", "shape", "primitive", "theme"])?;
    let pixel = query.pixel(held.loaded.scene.image)?;
    let kind = match query.one("kind")?.unwrap_or_default() {
        "verdict" => None,
        kind => Some(kind.parse().map_err(|_| {
            Refusal::bad("there is no such kind of diagram", "`raytree diagram --help` lists them; also `verdict`")
        })?),
    };
    let node = query.one("node")?.unwrap_or("root").parse();
    let node = node.map_err(|_| Refusal::bad("there is no such node", "root.reflected.shadows[0]"))?;
    let chosen = match (query.number("shape")?, query.number("primitive")?) {
        (Some(shape), primitive) => Some(Chosen { shape, primitive }),
        (None, None) => None,
        (None, Some(_)) => return Err(Refusal::bad("a primitive of no shape", "add the shape")),
    };
    let theme = match query.one("theme")? {
        None | Some("light") => &Theme::LIGHT,
        Some("dark") => &Theme::DARK,
        Some(_) => return Err(Refusal::bad("there is no such theme", "light or dark")),
    };
    let inspector = Arc::clone(&site.inspector);
    let work = move |stop: &_| {
        let tree = recording::tree(&inspector, &held, pixel, stop)?;
        let scene = &held.loaded.scene;
        let Some(kind) = kind else {
            let wanted = of_the_verdict(scene, &tree.tree, node, theme)?;
            let about = wanted.about();
            let mut response = bytes(svg(scene, &tree.tree, wanted)?, "image/svg+xml");
            response.headers_mut().extend(HeaderValue::try_from(about).ok().map(|about| (ABOUT, about)));
            return Ok(response);
        };
        Ok(bytes(svg(scene, &tree.tree, Wanted { kind, node, chosen, theme })?, "image/svg+xml"))
    };
    site.inspector.work().quick(work).await?
}

/// What a diagram of the kind `verdict` is of.
const ABOUT: HeaderName = HeaderName::from_static("x-raytree-diagram");

async fn difference(State(site): State<Site>, Path(id): Path<String>, RawQuery(query): RawQuery) -> Answer {
    let held = site.scene(&id)?;
    let query = Query::parse(query.as_deref(), &["x", "y", "from"])?;
    let from = query.one("from")?.ok_or_else(|| Refusal::bad("no scene to compare with", "from=ID"))?;
    let from = site.scene(from)?;
    let pixel = query.pixel(held.loaded.scene.image)?;
    query.pixel(from.loaded.scene.image)?;
    let inspector = Arc::clone(&site.inspector);
    let work = move |stop: &_| {
        let before = recording::tree(&inspector, &from, pixel, stop)?;
        let after = recording::tree(&inspector, &held, pixel, stop)?;
        let (before, after) = (&before.tree, &after.tree);
        Ok(json(StatusCode::OK, &diff(before, after, &Tolerances::of(before, after))))
    };
    site.inspector.work().quick(work).await?
}

/// Pixels that one request may have kept.
const MOST_KEPT: usize = 64;

async fn export_page(State(site): State<Site>, Path(id): Path<String>, RawQuery(query): RawQuery) -> Answer {
    let held = site.scene(&id)?;
    let place = |word: &str| {
        let (x, y) = word.split_once(',')?;
        Some([x.parse().ok()?, y.parse().ok()?])
    };
    let query = Query::parse(query.as_deref(), &["pixel"])?;
    let drawn: Option<Vec<[u32; 2]>> = query.all("pixel").map(place).collect();
    let mut drawn = drawn.ok_or_else(|| Refusal::bad("not a pixel where one belongs", "pixel=x,y"))?;
    if drawn.is_empty() {
        drawn.extend(held.loaded.scene.pixels.iter().map(|(_, pixel)| *pixel));
    }
    if drawn.len() > MOST_KEPT {
        return Err(Refusal::bad("too many pixels for one page", "at most 64; `raytree inspect --export` takes more"));
    }
    let name = HeaderValue::try_from(format!("attachment; filename=\"{}.html\"", file_name(&held.loaded.file)));
    let work = move |stop: &_| export::page(&held, &Kept { drawn, all: false }, &|| {}, stop);
    // Nothing comes back only where nobody waits.
    let page = site.inspector.work().quick(work).await??.unwrap_or_default();
    let mut response = bytes(page, "text/html; charset=utf-8");
    response.headers_mut().extend(name.ok().map(|name| (CONTENT_DISPOSITION, name)));
    Ok(response)
}

/// The scene's name for a file: letters, digits and hyphens.
fn file_name(scene: &str) -> String {
    let name = scene.rsplit(['/', '\\']).next().unwrap_or(scene);
    let name = name.strip_suffix(".json").unwrap_or(name);
    let plain: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    if plain.trim_matches('-').is_empty() { "scene".to_owned() } else { plain }
}
