//! Measures for operators: counts and times of requests, without anything of what was asked or who asked.

use std::time::Duration;

use axum::http::StatusCode;
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::histogram::Histogram;
use prometheus_client::registry::Registry;

/// The seconds up to which requests are counted together.
const SECONDS: [f64; 10] = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.5, 1.0, 5.0];

/// A label and its value.
type Label = [(&'static str, &'static str); 1];

/// The measures from the start of the server on.
pub(super) struct Metrics {
    pub(super) registry: Registry,
    requests: Family<Label, Counter>,
    seconds: Histogram,
    /// These three are read where they are kept, whenever somebody asks.
    pub(super) attempts: Counter,
    pub(super) reads: Counter,
    pub(super) queue: Gauge,
}

impl Metrics {
    pub(super) fn new() -> Self {
        let (requests, seconds) = (Family::default(), Histogram::new(SECONDS));
        let (attempts, reads, queue) = (Counter::default(), Counter::default(), Gauge::default());
        let mut registry = Registry::with_prefix("momentous");
        registry.register("requests", "Requests answered, by the class of their status", Clone::clone(&requests));
        registry.register("request_seconds", "Seconds until the answer to a request began", Clone::clone(&seconds));
        registry.register("attempts", "Attempts handed in and kept", Clone::clone(&attempts));
        registry.register("database_reads", "Statements that read the database", Clone::clone(&reads));
        registry.register("queue_length", "Requests that wait for a worker", Clone::clone(&queue));
        Self { registry, requests, seconds, attempts, reads, queue }
    }

    /// Counts a request.
    pub(super) fn count(&self, status: StatusCode, took: Duration) {
        self.requests.get_or_create(&[("status", class(status))]).inc();
        self.seconds.observe(took.as_secs_f64());
    }
}

/// The class of a status.
fn class(status: StatusCode) -> &'static str {
    match status.as_u16() / 100 {
        1 => "1xx",
        2 => "2xx",
        3 => "3xx",
        4 => "4xx",
        _ => "5xx",
    }
}
