//! From what a call gave to a response.

use axum::Json;
use axum::http::HeaderName;
use axum::http::HeaderValue;
use axum::http::StatusCode;
use axum::http::header;
use axum::response::Html;
use axum::response::IntoResponse;
use axum::response::Response;

use momentous_exercise::calls::{Refused, RefusedKind};
use momentous_pages::{Again, Refusal, heading, no_page};

use super::app::{App, SharedApp};
use super::headers::{A_WHILE, ANEW, OF_PICTURES};
use super::workers::{Admitted, NotDone};

/// The status and the title of the page for a kind of refusal.
fn kind(kind: RefusedKind) -> (StatusCode, &'static str) {
    let (status, title) = heading(kind);
    (StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR), title)
}

const NO_CACHE: [(HeaderName, HeaderValue); 1] = [(header::CACHE_CONTROL, ANEW)];

/// Makes a page on a worker.
pub(super) async fn page(
    app: &SharedApp,
    admitted: Admitted<'_>,
    make: impl FnOnce(&App) -> Result<String, Refused> + Send + 'static,
) -> Response {
    let shared = SharedApp::clone(app);
    match admitted.work(move || make(&shared)).await {
        Ok(Ok(text)) => (NO_CACHE, Html(text)).into_response(),
        Ok(Err(refused)) => self::refused(app, &refused),
        Err(reason) => not_done(app, reason, None),
    }
}

/// Makes a picture on a worker, which a browser keeps for a while unless files are watched.
pub(super) async fn picture(
    app: &SharedApp,
    admitted: Admitted<'_>,
    make: impl FnOnce(&App) -> Result<String, Refused> + Send + 'static,
) -> Response {
    let shared = SharedApp::clone(app);
    let kept = if app.settings.watch.is_some() { ANEW } else { A_WHILE };
    match admitted.work(move || make(&shared)).await {
        Ok(Ok(text)) => {
            let kind = HeaderValue::from_static("image/svg+xml");
            let headers = [
                (header::CONTENT_TYPE, kind),
                (header::CACHE_CONTROL, kept),
                (header::CONTENT_SECURITY_POLICY, OF_PICTURES),
            ];
            (headers, text).into_response()
        }
        Ok(Err(refused)) => (kind(refused.kind).0, NO_CACHE).into_response(),
        Err(reason) => no_call(reason),
    }
}

/// Makes a JSON object on a worker.
pub(super) async fn json(
    app: &SharedApp,
    admitted: Admitted<'_>,
    make: impl FnOnce(&App) -> Result<String, Refused> + Send + 'static,
) -> Response {
    let shared = SharedApp::clone(app);
    match admitted.work(move || make(&shared)).await {
        Ok(Ok(text)) => (NO_CACHE, [(header::CONTENT_TYPE, "application/json")], text).into_response(),
        Ok(Err(refused)) => (kind(refused.kind).0, NO_CACHE, Json(refused)).into_response(),
        Err(reason) => no_call(reason),
    }
}

/// A page that says why there is none of the kind that was asked for.
pub fn refused(app: &App, refused: &Refused) -> Response {
    refusal(app, kind(refused.kind), refused, None)
}

/// The same with a status and a title of its own, and perhaps with the form that was refused. It takes no worker: it is small, and often
/// there is none.
pub fn refusal(
    app: &App,
    (status, title): (StatusCode, &'static str),
    refused: &Refused,
    again: Option<Again>,
) -> Response {
    let text = filled(app, (status, title), refused, again).unwrap_or_else(|_| title.to_owned());
    (status, NO_CACHE, Html(text)).into_response()
}

fn filled(
    app: &App,
    (status, title): (StatusCode, &'static str),
    refused: &Refused,
    again: Option<Again>,
) -> Result<String, Refused> {
    app.page("refused", &Refusal::new((status.as_u16(), title), refused, again))
}

/// The page of a refusal, to see whether its template can be filled.
pub(super) fn tried(app: &App) -> Result<String, Refused> {
    let refused = no_page();
    filled(app, kind(refused.kind), &refused, None)
}

/// When to come again.
const SOON: [(HeaderName, HeaderValue); 1] = [(header::RETRY_AFTER, HeaderValue::from_static("2"))];

const fn status(reason: NotDone) -> StatusCode {
    match reason {
        NotDone::Busy => StatusCode::TOO_MANY_REQUESTS,
        NotDone::Broken => StatusCode::INTERNAL_SERVER_ERROR,
    }
}

/// The same of a call.
#[must_use]
pub(super) fn no_call(reason: NotDone) -> Response {
    (status(reason), SOON, format!("{reason}\n")).into_response()
}

/// A page that says why work was not done.
pub fn not_done(app: &App, reason: NotDone, again: Option<Again>) -> Response {
    let (title, help) = match reason {
        NotDone::Busy => ("Busy", "try again in a few seconds"),
        NotDone::Broken => ("Something went wrong", "nothing that you typed is at fault"),
    };
    let refused = Refused::new(RefusedKind::Invalid, reason.to_string()).help(help);
    let page = refusal(app, (status(reason), title), &refused, again);
    if reason == NotDone::Busy { (SOON, page).into_response() } else { page }
}
