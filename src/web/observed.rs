//! Every request is counted and told.

use std::time::Instant;

use axum::extract::{MatchedPath, Request, State};
use axum::middleware::Next;
use axum::response::Response;

use super::app::SharedApp;

/// The route of an address that is none of the server's.
const NONE: &str = "none";

/// Answers a request, counts it, and tells the log of it.
pub(super) async fn observed(State(app): State<SharedApp>, request: Request, next: Next) -> Response {
    let start = Instant::now();
    let method = request.method().clone();
    let route = request.extensions().get::<MatchedPath>().cloned();
    let response = next.run(request).await;
    let took = start.elapsed();
    app.metrics.count(response.status(), took);
    let route = route.as_ref().map_or(NONE, MatchedPath::as_str);
    app.log.tell(&method, route, response.status(), took);
    response
}
