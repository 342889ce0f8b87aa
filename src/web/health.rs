//! Whether the server can serve, for whoever watches it.

use std::time::Duration;

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};

use super::app::SharedApp;
use super::headers::ANEW;

/// How long the database may take to answer.
const PATIENCE: Duration = Duration::from_secs(5);

/// `fine`, or that the database does not answer.
pub(super) async fn health(State(app): State<SharedApp>) -> Response {
    let answers = match &app.courses {
        None => true,
        Some(courses) => matches!(tokio::time::timeout(PATIENCE, courses.store().ping()).await, Ok(Ok(()))),
    };
    let no_cache = [(header::CACHE_CONTROL, ANEW)];
    if answers {
        (no_cache, "fine\n").into_response()
    } else {
        (StatusCode::SERVICE_UNAVAILABLE, no_cache, "the database does not answer\n").into_response()
    }
}
