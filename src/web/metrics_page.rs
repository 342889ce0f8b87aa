//! The page of what operators measure, as the program that collects it reads it.

use std::sync::atomic::Ordering;

use axum::Router;
use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use prometheus_client::encoding::text::encode;

use super::app::SharedApp;

/// The format of the text.
const KIND: &str = "application/openmetrics-text; version=1.0.0; charset=utf-8";

/// The one page for operators. It is served on an address of its own, which no proxy leads to: behind a proxy every visitor seems to
/// come from this machine, so the sender of a request says nothing of who may read it.
pub fn metrics_router(app: SharedApp) -> Router {
    Router::new().route("/metrics", get(page)).with_state(app)
}

async fn page(State(app): State<SharedApp>) -> Response {
    let metrics = &app.metrics;
    if let Some(companion) = &app.companion {
        let counts = companion.counts();
        metrics.reads.inner().store(counts.reads, Ordering::Relaxed);
        metrics.attempts.inner().store(counts.attempts, Ordering::Relaxed);
    }
    metrics.queue.set(i64::try_from(app.workers.waiting()).unwrap_or(i64::MAX));
    let mut text = String::new();
    match encode(&mut text, &metrics.registry) {
        Ok(()) => ([(header::CONTENT_TYPE, KIND)], text).into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}
