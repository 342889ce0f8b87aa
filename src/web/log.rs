//! A line on standard error for each request, for whoever runs the server. It names the pattern of an address and never the address:
//! this may hold a name, an answer or a link with which somebody signs in.

use std::io::Write;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;
use std::time::Duration;

use axum::http::{Method, StatusCode};
use serde::Serialize;

use jiff::{Timestamp, Unit};

/// Lines that may wait to be written; others are left out, so that a reader that does not read holds no request up.
const WAITING: usize = 4096;

/// The destination of lines, where any are written.
#[derive(Default)]
pub(super) struct Log(Option<SyncSender<String>>);

/// A request, as the log tells it.
#[derive(Serialize)]
struct Line<'a> {
    at: String,
    method: &'static str,
    route: &'a str,
    status: u16,
    milliseconds: f64,
}

impl Log {
    /// A log on standard error.
    pub(super) fn started() -> Self {
        let (lines, waiting) = sync_channel(WAITING);
        let started = thread::Builder::new().name("log".to_owned()).spawn(move || write(&waiting));
        Self(started.is_ok().then_some(lines))
    }

    /// Tells of a request.
    pub(super) fn tell(&self, method: &Method, route: &str, status: StatusCode, took: Duration) {
        let Some(lines) = &self.0 else { return };
        let milliseconds = (took.as_secs_f64() * 10_000.0).round() / 10.0;
        let at = Timestamp::now().round(Unit::Millisecond).map_or_else(|_| String::new(), |at| at.to_string());
        let line = Line { at, method: name(method), route, status: status.as_u16(), milliseconds };
        if let Ok(line) = serde_json::to_string(&line) {
            // Where too many wait this one is left out.
            let _ = lines.try_send(line);
        }
    }
}

fn write(waiting: &Receiver<String>) {
    for line in waiting {
        // Where standard error is closed there is nobody to tell.
        let _ = writeln!(std::io::stderr(), "{line}");
    }
}

/// The method's name. A visitor can make names up; those are not repeated.
fn name(method: &Method) -> &'static str {
    match *method {
        Method::GET => "GET",
        Method::HEAD => "HEAD",
        Method::POST => "POST",
        Method::OPTIONS => "OPTIONS",
        _ => "other",
    }
}
