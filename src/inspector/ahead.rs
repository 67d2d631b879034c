//! The picture of the scene that was given, begun before a page asks for it: while a browser starts there is time.

use std::pin::pin;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use tokio::sync::Notify;

use super::bands::{fitting, rows};
use super::scenes::Held;
use super::tracing::Show;

/// The rows that are there.
#[derive(Debug, Default)]
pub(super) struct Ahead {
    picture: Mutex<Picture>,
    grown: Notify,
}

#[derive(Debug, Default)]
struct Picture {
    /// Whole rows from the top, sRGB and alpha.
    bytes: Vec<u8>,
    is_growing: bool,
}

impl Ahead {
    fn picture(&self) -> MutexGuard<'_, Picture> {
        self.picture.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Traces the picture until it is done or `stop` is set.
    pub(super) fn paint(&self, held: &Held, stop: &AtomicBool) {
        let height = held.loaded.scene.image.height;
        let (mut next, mut count) = (0, 4);
        self.picture().is_growing = true;
        while next < height && !stop.load(Ordering::Relaxed) {
            count = count.min(height - next);
            let start = Instant::now();
            let band = rows(held, Show::Picture, next, count, stop);
            next += count;
            count = fitting(count, start.elapsed());
            // Rows that were stopped are zeros.
            if !stop.load(Ordering::Relaxed) {
                self.picture().bytes.extend(band);
                self.grown.notify_waiters();
            }
        }
        self.picture().is_growing = false;
        self.grown.notify_waiters();
    }

    /// The rows from `first` on that are there, at least one; waits for it as long as the picture grows. Nothing where no more
    /// come.
    pub(super) async fn rows_from(&self, first: u32, held: &Held) -> Option<Vec<u8>> {
        let from = first as usize * held.loaded.scene.image.width as usize * 4;
        loop {
            // Listened for before it is looked, so that no row is missed in between.
            let mut grown = pin!(self.grown.notified());
            grown.as_mut().enable();
            {
                let picture = self.picture();
                if let Some(rows) = picture.bytes.get(from..).filter(|rows| !rows.is_empty()) {
                    return Some(rows.to_vec());
                }
                if !picture.is_growing {
                    return None;
                }
            }
            grown.await;
        }
    }
}
