//! The listener: how many connections there are, how long they may take, and how they end.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::future::{Future, poll_fn};
use std::io;
use std::net::TcpListener;
use std::pin::pin;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::task::Poll;
use std::time::Duration;

use axum::Router;
use axum::body::Body;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper::{Request, Response};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpStream;
use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore, watch};
use tokio::time::timeout;

use super::guard::{Guard, seal};
use super::patience::Patience;
use super::routes::routes;
use super::scenes::Inspector;

/// How patient the server is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// For the head of a request, and for the next one on the same connection.
    pub head: Duration,
    /// For the body of a request.
    pub body: Duration,
    /// For a client that takes nothing of its answer.
    pub answer: Duration,
    /// Connections at a time.
    pub connections: usize,
}

impl Default for Limits {
    fn default() -> Self {
        let seconds = Duration::from_secs;
        Self { head: seconds(20), body: seconds(10), answer: seconds(20), connections: 256 }
    }
}

/// How often it is looked whether to stop.
const TICK: Duration = Duration::from_millis(50);
/// What answers that are on their way get at the end.
const GRACE: Duration = Duration::from_millis(500);
/// The largest head of a request.
const LARGEST_HEAD: usize = 1 << 14;

/// Answers requests until `stop` is set.
///
/// # Errors
/// Those of the listener, one that is not on the loopback address, and threads that cannot be started.
///
/// # Example
/// ```
/// use std::sync::Arc;
/// use std::sync::atomic::{AtomicBool, Ordering};
/// use raytree::inspector::{Inspector, Limits, Settings, serve};
/// let text = include_str!("../../scenes/first-hit.json");
/// let inspector = Inspector::new("first-hit.json", text, Settings::default(), &mut |_| Err("no meshes".into())).unwrap();
/// let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
/// let stop = AtomicBool::new(false);
/// std::thread::scope(|scope| {
///     scope.spawn(|| serve(listener, Arc::new(inspector), Limits::default(), &stop));
///     stop.store(true, Ordering::SeqCst);
/// });
/// ```
pub fn serve(listener: TcpListener, inspector: Arc<Inspector>, limits: Limits, stop: &AtomicBool) -> io::Result<()> {
    let address = listener.local_addr()?;
    if !address.ip().is_loopback() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "the listener is not on the loopback address"));
    }
    listener.set_nonblocking(true)?;
    let guard = Arc::new(Guard::new(address.port()));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build()?;
    let done = runtime.block_on(async {
        let listener = tokio::net::TcpListener::from_std(listener)?;
        let site = Site { router: routes(inspector, limits.body), guard, limits, newcomers: Arc::default() };
        accept(&listener, site, stop).await;
        Ok(())
    });
    // What is not done by now is told to stop by the end of those who wait for it.
    runtime.shutdown_timeout(GRACE);
    done
}

#[derive(Clone, Debug)]
struct Site {
    router: Router,
    guard: Arc<Guard>,
    limits: Limits,
    newcomers: Arc<Newcomers>,
}

async fn accept(listener: &tokio::net::TcpListener, site: Site, stop: &AtomicBool) {
    let places = Arc::new(Semaphore::new(site.limits.connections));
    let (end, ending) = watch::channel(());
    while !stop.load(Ordering::SeqCst) {
        let stream = match timeout(TICK, listener.accept()).await {
            Ok(Ok((stream, _))) => stream,
            Ok(Err(_)) => {
                // Out of file descriptors, for one: it passes as connections end.
                tokio::time::sleep(TICK).await;
                continue;
            }
            Err(_) => continue,
        };
        let place = loop {
            if let Ok(place) = Arc::clone(&places).try_acquire_owned() {
                break Some(place);
            }
            if stop.load(Ordering::SeqCst) {
                break None;
            }
            // Who has not said anything yet makes room.
            site.newcomers.dismiss_oldest();
            if let Ok(Ok(place)) = timeout(TICK, Arc::clone(&places).acquire_owned()).await {
                break Some(place);
            }
        };
        if let Some(place) = place {
            tokio::spawn(connection(stream, site.clone(), place, ending.clone()));
        }
    }
    drop((ending, site));
    end.send(()).ok();
    timeout(GRACE, end.closed()).await.ok();
}

/// Serves a connection until it ends, is dismissed, or the server ends.
async fn connection(stream: TcpStream, site: Site, _place: OwnedSemaphorePermit, mut ending: watch::Receiver<()>) {
    stream.set_nodelay(true).ok();
    let newcomer = site.newcomers.add();
    let service = service_fn(|request: Request<Incoming>| {
        newcomer.said_something();
        answer(&site, request)
    });
    let io = TokioIo::new(Patience::new(stream, site.limits.answer));
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new()).header_read_timeout(site.limits.head).max_buf_size(LARGEST_HEAD);
    let mut connection = pin!(http.serve_connection(io, service));
    let mut dismissed = pin!(newcomer.dismissed.notified());
    let mut ended = pin!(ending.changed());
    let mut is_ending = false;
    poll_fn(|cx| {
        if dismissed.as_mut().poll(cx).is_ready() {
            return Poll::Ready(());
        }
        if !is_ending && ended.as_mut().poll(cx).is_ready() {
            is_ending = true;
            connection.as_mut().graceful_shutdown();
        }
        // Whatever ends a connection early is the client's doing, and nobody is left to be told.
        connection.as_mut().poll(cx).map(|_| ())
    })
    .await;
}

async fn answer(site: &Site, request: Request<Incoming>) -> Result<Response<Body>, Infallible> {
    let response = match site.guard.check(&request) {
        Ok(()) => TowerToHyperService::new(site.router.clone()).call(request.map(Body::new)).await?,
        Err(refusal) => refusal.into_response(),
    };
    Ok(seal(response))
}

/// Connections that have not brought a request yet, the oldest first: when there is no place left, they go.
#[derive(Debug, Default)]
struct Newcomers {
    waiting: Mutex<(u64, BTreeMap<u64, Arc<Notify>>)>,
}

/// A connection; as long as it has said nothing, a newcomer.
struct Newcomer {
    among: Arc<Newcomers>,
    number: u64,
    dismissed: Arc<Notify>,
}

impl Newcomers {
    fn add(self: &Arc<Self>) -> Newcomer {
        let dismissed = Arc::new(Notify::new());
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.0 += 1;
        let number = waiting.0;
        waiting.1.insert(number, Arc::clone(&dismissed));
        Newcomer { among: Arc::clone(self), number, dismissed }
    }

    fn dismiss_oldest(&self) {
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, oldest)) = waiting.1.pop_first() {
            oldest.notify_one();
        }
    }
}

impl Newcomer {
    fn said_something(&self) {
        let mut waiting = self.among.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.1.remove(&self.number);
    }
}

impl Drop for Newcomer {
    fn drop(&mut self) {
        self.said_something();
    }
}
