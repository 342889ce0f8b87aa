//! From what a call gave to a response.

use axum::Json;
use axum::http::HeaderName;
use axum::http::HeaderValue;
use axum::http::StatusCode;
use axum::http::header;
use axum::response::Html;
use axum::response::IntoResponse;
use axum::response::Response;
use serde::Serialize;

use crate::exercise::calls::{Refused, RefusedKind};

use super::app::{App, SharedApp};
use super::headers::ANEW;
use super::workers::NotDone;

/// What a page that shows a refusal knows.
#[derive(Serialize)]
struct RefusedPage<'a> {
    title: &'static str,
    status: u16,
    refused: &'a Refused,
    sentences: Vec<String>,
}

/// What each kind of refusal is: its status, and the title of its page.
fn kind(kind: RefusedKind) -> (StatusCode, &'static str) {
    match kind {
        RefusedKind::Unknown => (StatusCode::NOT_FOUND, "Not found"),
        RefusedKind::Reserved => (StatusCode::FORBIDDEN, "Part of an assignment"),
        RefusedKind::Invalid => (StatusCode::BAD_REQUEST, "Not understood"),
        RefusedKind::TooLarge => (StatusCode::PAYLOAD_TOO_LARGE, "Too large"),
        RefusedKind::Values => (StatusCode::UNPROCESSABLE_ENTITY, "These values cannot be used"),
        RefusedKind::NotSimulated => (StatusCode::UNPROCESSABLE_ENTITY, "Nothing to simulate"),
        RefusedKind::Fault => (StatusCode::INTERNAL_SERVER_ERROR, "A fault in a file"),
    }
}

const NO_CACHE: [(HeaderName, HeaderValue); 1] = [(header::CACHE_CONTROL, ANEW)];

/// Makes a page on a worker.
pub(super) async fn page(
    app: SharedApp,
    make: impl FnOnce(&App) -> Result<String, Refused> + Send + 'static,
) -> Response {
    let own = SharedApp::clone(&app);
    let made = app.workers.work(move || make(&own).or_else(|refused| refused_page(&own, &refused))).await;
    match made {
        Ok(Ok(text)) => (NO_CACHE, Html(text)).into_response(),
        Ok(Err((status, text))) => (status, NO_CACHE, Html(text)).into_response(),
        Err(reason) => not_done(reason).into_response(),
    }
}

/// A page that says why there is none of the kind that was asked for.
fn refused_page(app: &App, refused: &Refused) -> Result<String, (StatusCode, String)> {
    let (status, title) = kind(refused.kind);
    Err((status, said(app, status, title, refused)))
}

/// Makes a JSON object on a worker.
pub(super) async fn json(
    app: SharedApp,
    make: impl FnOnce(&App) -> Result<String, Refused> + Send + 'static,
) -> Response {
    let own = SharedApp::clone(&app);
    match app.workers.work(move || make(&own)).await {
        Ok(Ok(text)) => (NO_CACHE, [(header::CONTENT_TYPE, "application/json")], text).into_response(),
        Ok(Err(refused)) => (kind(refused.kind).0, NO_CACHE, Json(refused)).into_response(),
        Err(reason) => not_done(reason).into_response(),
    }
}

/// A page that says why there is none of the kind that was asked for.
pub(super) async fn refused(app: SharedApp, refused: Refused) -> Response {
    let (status, title) = kind(refused.kind);
    refusal(app, status, title, refused).await
}

/// The same with a status and a title of its own.
pub(super) async fn refusal(app: SharedApp, status: StatusCode, title: &'static str, refused: Refused) -> Response {
    let own = SharedApp::clone(&app);
    match app.workers.work(move || said(&own, status, title, &refused)).await {
        Ok(text) => (status, NO_CACHE, Html(text)).into_response(),
        Err(reason) => not_done(reason).into_response(),
    }
}

fn said(app: &App, status: StatusCode, title: &'static str, refused: &Refused) -> String {
    filled(app, status, title, refused).unwrap_or_else(|_| title.to_owned())
}

fn filled(app: &App, status: StatusCode, title: &'static str, refused: &Refused) -> Result<String, Refused> {
    let page = RefusedPage { title, status: status.as_u16(), refused, sentences: refused.sentences() };
    app.page("refused", &page)
}

/// The page of a refusal, to see whether its template can be filled.
pub(super) fn tried(app: &App) -> Result<String, Refused> {
    let refused =
        Refused::new(RefusedKind::Unknown, "there is no such page").help("the start page lists every problem");
    filled(app, StatusCode::NOT_FOUND, "Not found", &refused)
}

pub(super) fn not_done(reason: NotDone) -> (StatusCode, [(HeaderName, HeaderValue); 1], &'static str) {
    match reason {
        NotDone::Busy => (
            StatusCode::TOO_MANY_REQUESTS,
            [(header::RETRY_AFTER, HeaderValue::from_static("2"))],
            "Many people are asking at this moment. Try again in a few seconds.",
        ),
        NotDone::Broken => (
            StatusCode::INTERNAL_SERVER_ERROR,
            NO_CACHE,
            "Something went wrong here; nothing that you typed is at fault.",
        ),
    }
}
