//! Work for requests: on threads of its own, so much at a time, and no longer than somebody waits for it.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::task::JoinHandle;
use tokio::time::timeout;

use super::answer::Refusal;

/// Pieces of work of each sort that go on at a time.
const MOST: usize = 16;
/// How long work on all cores has them for itself.
const TURN: Duration = Duration::from_millis(250);

/// The turns that work takes.
#[derive(Debug)]
pub(super) struct Work {
    /// For one pixel or one text, on one thread.
    quick: Arc<Semaphore>,
    /// For rows of a picture, on all cores.
    bands: Arc<Semaphore>,
    /// Pictures that are asked for together grow together, a band of each in turn.
    turn: Arc<Semaphore>,
    running: Arc<AtomicUsize>,
}

impl Default for Work {
    fn default() -> Self {
        let places = |count| Arc::new(Semaphore::new(count));
        Self { quick: places(MOST), bands: places(MOST), turn: places(1), running: Arc::default() }
    }
}

impl Work {
    /// How many pieces of work go on.
    pub(super) fn running(&self) -> usize {
        self.running.load(Ordering::SeqCst)
    }

    /// Runs work on one thread. The flag it is given is set when nobody waits for it any more.
    pub(super) async fn quick<T, F>(&self, work: F) -> Result<T, Refusal>
    where
        T: Send + 'static,
        F: FnOnce(&AtomicBool) -> T + Send + 'static,
    {
        let (_waiting, done) = self.start(place(&self.quick).await?, work);
        done.await.map_err(|_| Refusal::broken())
    }

    /// Runs work that uses all cores, and is meant to take them for a short while. If it takes longer, others get their turn.
    pub(super) async fn band<T, F>(&self, work: F) -> Result<T, Refusal>
    where
        T: Send + 'static,
        F: FnOnce(&AtomicBool) -> T + Send + 'static,
    {
        let place_of_band = place(&self.bands).await?;
        let turn = place(&self.turn).await?;
        let (_waiting, mut done) = self.start(place_of_band, work);
        let in_turn = timeout(TURN, &mut done).await;
        drop(turn);
        match in_turn {
            Ok(done) => done,
            Err(_) => done.await,
        }
        .map_err(|_| Refusal::broken())
    }

    fn start<T, F>(&self, place: OwnedSemaphorePermit, work: F) -> (Waiting, JoinHandle<T>)
    where
        T: Send + 'static,
        F: FnOnce(&AtomicBool) -> T + Send + 'static,
    {
        let waiting = Waiting(Arc::default());
        let stop = Arc::clone(&waiting.0);
        let counted = Counted::new(&self.running);
        let done = tokio::task::spawn_blocking(move || {
            let _held = (place, counted);
            work(&stop)
        });
        (waiting, done)
    }
}

async fn place(places: &Arc<Semaphore>) -> Result<OwnedSemaphorePermit, Refusal> {
    Arc::clone(places).acquire_owned().await.map_err(|_| Refusal::broken())
}

/// Somebody waits for a piece of work; once dropped, nobody does.
struct Waiting(Arc<AtomicBool>);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// A piece of work that goes on.
struct Counted(Arc<AtomicUsize>);

impl Counted {
    fn new(running: &Arc<AtomicUsize>) -> Self {
        running.fetch_add(1, Ordering::SeqCst);
        Self(Arc::clone(running))
    }
}

impl Drop for Counted {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}
