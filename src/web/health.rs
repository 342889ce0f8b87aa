//! Whether the server can serve, for whoever watches it.

use std::time::Duration;

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};

use momentous_store::Ill;

use super::app::SharedApp;
use super::headers::ANEW;

/// How long the database may take to answer.
const PATIENCE: Duration = Duration::from_secs(5);

/// `fine`, or what is wrong with the database.
pub(super) async fn health(State(app): State<SharedApp>) -> Response {
    let health = match &app.courses {
        None => Ok(()),
        Some(courses) => {
            let asked = tokio::time::timeout(PATIENCE, courses.store().health()).await;
            asked.unwrap_or(Err(Ill::Silent))
        }
    };
    let (status, said) = match health {
        Ok(()) => (StatusCode::OK, "fine\n"),
        Err(Ill::Silent) => (StatusCode::SERVICE_UNAVAILABLE, "the database does not answer\n"),
        Err(Ill::TakesNothing) => (StatusCode::SERVICE_UNAVAILABLE, "the database takes nothing new\n"),
    };
    (status, [(header::CACHE_CONTROL, ANEW)], said).into_response()
}
