//! Pictures as they grow: bands of rows, sent as they are finished.
//!
//! A band is traced only when the client has taken the one before, so that a client that is slow, or gone, costs nothing; and
//! only one band of all clients at a time, so that none waits for another's whole picture.

use std::future::Future;
use std::num::NonZero;
use std::pin::Pin;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll};
use std::time::{Duration, Instant};

use axum::body::{Body, Bytes};
use hyper::body::{Body as HttpBody, Frame};

use super::answer::Refusal;
use super::scenes::{Held, Inspector};
use super::tracing::Show;

/// How long a band is meant to take: short enough to look steady, long enough to be worth it.
const BAND: Duration = Duration::from_millis(40);

/// The rows that are still to come.
struct Rest {
    inspector: Arc<Inspector>,
    scene: Arc<Held>,
    show: Show,
    next: u32,
    rows: u32,
}

type Step = Pin<Box<dyn Future<Output = Result<(Bytes, Rest), Refusal>> + Send>>;

/// What is shown of every pixel as a body: for each band its first row and the number of its rows, little-endian u32, then
/// four bytes a pixel.
pub(super) struct Bands(Option<Step>);

impl Bands {
    /// The picture of a scene.
    pub(super) fn body(inspector: Arc<Inspector>, scene: Arc<Held>, show: Show) -> Body {
        let rest = Rest { inspector, scene, show, next: 0, rows: 4 };
        Body::new(Self(Some(Box::pin(rest.step()))))
    }
}

impl Rest {
    /// Traces a band.
    async fn step(mut self) -> Result<(Bytes, Self), Refusal> {
        let scene = Arc::clone(&self.scene);
        let (show, first) = (self.show, self.next);
        if let (Show::Picture, Some(ahead)) = (show, self.inspector.ahead_of(&scene))
            && let Some(rows) = ahead.rows_from(first, &scene).await
        {
            return Ok(self.sent(&rows));
        }
        let count = self.rows.min(scene.loaded.scene.image.height - first);
        let work = move |stop: &AtomicBool| {
            // The time it takes, not the time it waits for its turn.
            let start = Instant::now();
            (rows(&scene, show, first, count, stop), start.elapsed())
        };
        let (bytes, took) = self.inspector.work().band(work).await?;
        self.rows = fitting(count, took);
        Ok(self.sent(&bytes))
    }

    /// Some rows as they are sent, and what is left after them.
    fn sent(mut self, rows: &[u8]) -> (Bytes, Self) {
        let count = (rows.len() / (self.scene.loaded.scene.image.width as usize * 4)) as u32;
        let band = [&self.next.to_le_bytes(), &count.to_le_bytes(), rows].concat();
        self.next += count;
        (band.into(), self)
    }
}

/// How many rows to trace next, after so many took so long.
pub(super) fn fitting(rows: u32, took: Duration) -> u32 {
    let fitting = f64::from(rows) * BAND.as_secs_f64() / took.as_secs_f64().max(1e-6);
    (fitting as u32).clamp(1, rows * 4).max(cores() as u32)
}

/// Four bytes for every pixel of some rows, traced on all cores; zeros for what was not done when `stop` was set.
pub(super) fn rows(held: &Held, show: Show, first: u32, count: u32, stop: &AtomicBool) -> Vec<u8> {
    let scene = &held.loaded.scene;
    let tracer = held.world.tracer(scene, held.options, stop);
    let row_bytes = scene.image.width as usize * 4;
    let mut bytes = vec![0; count as usize * row_bytes];
    let left = Mutex::new(bytes.chunks_mut(row_bytes).enumerate());
    let next = || left.lock().unwrap_or_else(PoisonError::into_inner).next();
    // Threads of its own: the system shares the cores between these and those of other clients.
    std::thread::scope(|scope| {
        for _ in 0..cores().min(count as usize) {
            scope.spawn(|| {
                while let Some((y, row)) = next() {
                    for (x, pixel) in row.chunks_exact_mut(4).enumerate() {
                        if stop.load(Ordering::Relaxed) {
                            return;
                        }
                        pixel.copy_from_slice(&tracer.show(show, x as u32, first + y as u32));
                    }
                }
            });
        }
    });
    bytes
}

fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, NonZero::get)
}

impl HttpBody for Bands {
    type Data = Bytes;
    type Error = std::io::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, std::io::Error>>> {
        let Some(step) = &mut self.0 else { return Poll::Ready(None) };
        let Poll::Ready(done) = step.as_mut().poll(cx) else { return Poll::Pending };
        Poll::Ready(Some(match done {
            Ok((bytes, rest)) => {
                let is_last = rest.next == rest.scene.loaded.scene.image.height;
                self.0 = (!is_last).then(|| Box::pin(rest.step()) as Step);
                Ok(Frame::data(bytes))
            }
            Err(_) => {
                self.0 = None;
                Err(std::io::Error::other("the work for this picture failed"))
            }
        }))
    }

    fn is_end_stream(&self) -> bool {
        self.0.is_none()
    }
}
