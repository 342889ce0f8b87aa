//! The connections of a server: as many as there is room for. Where there is no room, the one that has waited longest for the rest of a
//! request makes it, so that nobody who sends whole requests is kept out by those who never do.

use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use axum::Router;
use axum::body::Body;
use axum::extract::Request;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Notify, Semaphore};
use tokio::time::{sleep, timeout};

use super::arrival::{Arrival, TimedBody};

/// How long headers may take, and how long a connection may be idle.
const HEADERS: Duration = Duration::from_secs(10);
/// The bytes that headers may have.
const LONGEST: usize = 1 << 16;
/// How long requests under way may take once the server was told to stop.
const ENDING: Duration = Duration::from_secs(15);
/// How long to wait for a place, or for the system to have one more file.
const PAUSE: Duration = Duration::from_millis(50);
/// The most connections, where the system would allow more.
const MOST: usize = 4096;
/// The files that the process may open besides: those of the databases, of checks, of the bank.
const OTHERS: usize = 128;

/// Connections that wait for the rest of a request, or for the next one, in the order in which they began to.
#[derive(Default)]
struct Waiting(Mutex<Line>);

#[derive(Default)]
struct Line {
    /// The place of the last that came.
    last: u64,
    waiting: BTreeMap<u64, Arc<Notify>>,
}

/// One connection.
struct Connection {
    all: Arc<Waiting>,
    /// Its place in the line, if it waits.
    place: AtomicU64,
    close: Arc<Notify>,
}

/// Serves until `stop`, then answers the requests that are under way.
pub(super) async fn serve(listener: TcpListener, router: Router, stop: impl Future<Output = ()>) {
    let places = Arc::new(Semaphore::new(most()));
    let waiting = Arc::new(Waiting::default());
    let graceful = GracefulShutdown::new();
    let router = TowerToHyperService::new(router);
    let accept = async {
        loop {
            let Ok((stream, from)) = listener.accept().await else {
                // Too many files are open; connections that end make room.
                sleep(PAUSE).await;
                continue;
            };
            let place = loop {
                if let Ok(place) = Arc::clone(&places).try_acquire_owned() {
                    break place;
                }
                waiting.close_first();
                if let Ok(Ok(place)) = timeout(PAUSE, Arc::clone(&places).acquire_owned()).await {
                    break place;
                }
            };
            let connection = Arc::new(Connection::new(&waiting));
            let (close, router, watcher) = (Arc::clone(&connection.close), router.clone(), graceful.watcher());
            tokio::spawn(async move {
                tokio::select! {
                    // What is wrong with a connection is the other side's to see.
                    _ = watcher.watch(over(stream, from, router, connection)) => {}
                    () = close.notified() => {}
                }
                drop(place);
            });
        }
    };
    tokio::select! {
        () = accept => {}
        () = stop => {}
    }
    drop(listener);
    // Whoever is not answered by then has been told nothing.
    let _ = timeout(ENDING, graceful.shutdown()).await;
}

/// The requests of a connection, one after the other.
fn over(
    stream: TcpStream,
    from: SocketAddr,
    router: TowerToHyperService<Router>,
    connection: Arc<Connection>,
) -> impl hyper_util::server::graceful::GracefulConnection {
    let _ = stream.set_nodelay(true);
    let service = service_fn(move |request: Request<Incoming>| {
        connection.waits();
        let answered = Arc::clone(&connection);
        // The time of the body begins after that by which it is judged.
        let arrival = Arrival::now(from);
        let mut request = request.map(|body| Body::new(TimedBody::new(body, move || answered.is_answered())));
        request.extensions_mut().insert(arrival);
        let (answer, of_request) = (router.call(request), Arc::clone(&connection));
        async move {
            let answer = answer.await;
            of_request.waits();
            answer
        }
    });
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(HEADERS).max_buf_size(LONGEST);
    builder.serve_connection(TokioIo::new(stream), service)
}

impl Waiting {
    /// Closes the connection that has waited longest.
    fn close_first(&self) {
        let first = self.line().waiting.pop_first();
        if let Some((_, close)) = first {
            close.notify_one();
        }
    }

    fn line(&self) -> MutexGuard<'_, Line> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Connection {
    fn new(all: &Arc<Waiting>) -> Self {
        let connection = Self { all: Arc::clone(all), place: AtomicU64::default(), close: Arc::default() };
        connection.waits();
        connection
    }

    /// From now on it waits for something of the other side: the last of the line.
    fn waits(&self) {
        self.is_answered();
        let mut line = self.all.line();
        line.last += 1;
        let place = line.last;
        line.waiting.insert(place, Arc::clone(&self.close));
        self.place.store(place, Ordering::Relaxed);
    }

    /// From now on a whole request is answered, and nobody closes it.
    fn is_answered(&self) {
        self.all.line().waiting.remove(&self.place.load(Ordering::Relaxed));
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        self.is_answered();
    }
}

/// How many connections there is room for. The process may open as many files as the system lets it.
#[cfg(unix)]
fn most() -> usize {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let Rlimit { current, maximum } = getrlimit(Resource::Nofile);
    // Where the limit cannot be raised it stays.
    let raised = setrlimit(Resource::Nofile, Rlimit { current: maximum, maximum }).is_ok();
    let files = if raised { maximum } else { current };
    let files = files.and_then(|files| usize::try_from(files).ok()).unwrap_or(usize::MAX);
    files.saturating_sub(OTHERS).clamp(1, MOST)
}

#[cfg(not(unix))]
fn most() -> usize {
    MOST.min(512)
}
