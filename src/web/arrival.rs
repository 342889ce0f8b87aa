//! When and from where a request came, and its body within its time.

use std::io::ErrorKind;
use std::net::SocketAddr;
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use std::time::{Duration, Instant};

use axum::BoxError;
use axum::body::Bytes;
use hyper::body::{Body, Frame, Incoming, SizeHint};
use tokio::time::{Sleep, sleep};

/// The longest time that a body may take after its headers.
const BODY: Duration = Duration::from_secs(30);

/// When the headers of a request were there, and who sent them: the reader's browser, or the proxy before the server.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// The address at the other end of the connection.
    pub from: SocketAddr,
    at: Instant,
}

impl Arrival {
    /// The headers of a request from there have just come.
    #[must_use]
    pub fn now(from: SocketAddr) -> Self {
        Self { from, at: Instant::now() }
    }

    /// Whether a body that came with these headers has taken too long.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.at.elapsed() >= BODY
    }
}

/// A body that ends with an error once it has taken too long, and says when it is whole.
pub(super) struct TimedBody<Whole> {
    body: Incoming,
    over: Pin<Box<Sleep>>,
    whole: Option<Whole>,
}

impl<Whole: FnOnce()> TimedBody<Whole> {
    /// A body whose headers have just come. `whole` is called when its end is read, at once where there is nothing to read.
    pub fn new(body: Incoming, whole: Whole) -> Self {
        let mut timed = Self { body, over: Box::pin(sleep(BODY)), whole: Some(whole) };
        timed.tell();
        timed
    }

    fn tell(&mut self) {
        if self.body.is_end_stream()
            && let Some(whole) = self.whole.take()
        {
            whole();
        }
    }
}

impl<Whole: FnOnce() + Unpin> Body for TimedBody<Whole> {
    type Data = Bytes;
    type Error = BoxError;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, Self::Error>>> {
        if self.over.as_mut().poll(context).is_ready() {
            return Poll::Ready(Some(Err(std::io::Error::from(ErrorKind::TimedOut).into())));
        }
        let frame = ready!(Pin::new(&mut self.body).poll_frame(context));
        self.tell();
        Poll::Ready(frame.map(|frame| frame.map_err(BoxError::from)))
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}
