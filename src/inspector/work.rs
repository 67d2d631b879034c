//! Work for requests: on threads of its own, so much at a time, and no longer than somebody waits for it.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use tokio::sync::Semaphore;

use super::answer::Refusal;

/// Pieces of work for one pixel or one text that go on at a time.
const QUICK: usize = 16;

/// The turns that work takes.
#[derive(Debug)]
pub(super) struct Work {
    quick: Arc<Semaphore>,
    /// One band of rows at a time, on all cores: pictures that are asked for together grow together.
    band: Arc<Semaphore>,
    running: Arc<AtomicUsize>,
}

impl Default for Work {
    fn default() -> Self {
        Self { quick: Arc::new(Semaphore::new(QUICK)), band: Arc::new(Semaphore::new(1)), running: Arc::default() }
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
        self.run(&self.quick, work).await
    }

    /// Runs work that uses all cores for a short while.
    pub(super) async fn band<T, F>(&self, work: F) -> Result<T, Refusal>
    where
        T: Send + 'static,
        F: FnOnce(&AtomicBool) -> T + Send + 'static,
    {
        self.run(&self.band, work).await
    }

    async fn run<T, F>(&self, turns: &Arc<Semaphore>, work: F) -> Result<T, Refusal>
    where
        T: Send + 'static,
        F: FnOnce(&AtomicBool) -> T + Send + 'static,
    {
        let turn = Arc::clone(turns).acquire_owned().await.map_err(|_| Refusal::broken())?;
        let waiting = Waiting(Arc::default());
        let stop = Arc::clone(&waiting.0);
        let counted = Counted::new(&self.running);
        let done = tokio::task::spawn_blocking(move || {
            let _held = (turn, counted);
            work(&stop)
        });
        done.await.map_err(|_| Refusal::broken())
    }
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
