//! Requests that are refused before anybody has read them get a page, or an object, that says why.

use axum::Json;
use axum::extract::{Request, State};
use axum::http::{StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use momentous_exercise::calls::{Refused, RefusedKind};

use super::answer;
use super::app::SharedApp;

/// Answers a request; where it was refused in a few words, by its form alone, the answer says the way out.
pub(super) async fn explained(State(app): State<SharedApp>, request: Request, next: Next) -> Response {
    let is_call = request.uri().path().starts_with("/api/");
    let response = next.run(request).await;
    let status = response.status();
    let Some(refused) = why(status, app.settings.limits.request_bytes).filter(|_| !is_explained(&response)) else {
        return response;
    };
    let mut answer = if is_call {
        (status, Json(refused)).into_response()
    } else {
        answer::refusal(&app, (status, "Not understood"), &refused, None)
    };
    // Which methods an address takes.
    answer.headers_mut().extend(response.headers().get(header::ALLOW).map(|allowed| (header::ALLOW, allowed.clone())));
    answer
}

fn is_explained(response: &Response) -> bool {
    let kind = response.headers().get(header::CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or_default();
    kind.starts_with("text/html") || kind.starts_with("application/json")
}

fn why(status: StatusCode, most: usize) -> Option<Refused> {
    let (kind, message, help) = match status {
        StatusCode::METHOD_NOT_ALLOWED => (
            RefusedKind::Invalid,
            "this address does not take such a request".to_owned(),
            "go back, load the page anew and try again",
        ),
        StatusCode::PAYLOAD_TOO_LARGE => {
            (RefusedKind::TooLarge, format!("a request has at most {most} bytes"), "leave something out")
        }
        StatusCode::BAD_REQUEST | StatusCode::UNSUPPORTED_MEDIA_TYPE | StatusCode::UNPROCESSABLE_ENTITY => {
            (RefusedKind::Invalid, "the request cannot be read".to_owned(), "go back, load the page anew and try again")
        }
        _ => return None,
    };
    Some(Refused::new(kind, message).help(help))
}
