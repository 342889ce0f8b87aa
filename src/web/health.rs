//! Whether the server can serve, for whoever watches it.

use std::time::Duration;

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};

use super::app::SharedApp;
use super::headers::ANEW;

/// The longest time that the database may take to answer.
const PATIENCE: Duration = Duration::from_secs(5);

/// `fine`, or what is wrong with the database.
pub(super) async fn health(State(app): State<SharedApp>) -> Response {
    let health = match &app.companion {
        None => Ok(()),
        Some(companion) => {
            let asked = tokio::time::timeout(PATIENCE, companion.health()).await;
            asked.unwrap_or(Err("the database does not answer\n"))
        }
    };
    let (status, said) = match health {
        Ok(()) => (StatusCode::OK, "fine\n"),
        Err(said) => (StatusCode::SERVICE_UNAVAILABLE, said),
    };
    (status, [(header::CACHE_CONTROL, ANEW)], said).into_response()
}
