//! Replies to somebody who asked for a page.

use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{Html, IntoResponse, Response};
use serde_json::Value;

use super::cookie::Cookie;
use momentous_web::Settings;

/// A reply.
pub(super) enum Reply {
    /// A page.
    Page(String),
    /// A page with a status other than 200: what was typed is still there, and something is wrong with it.
    Wrong(String),
    /// Another address; a reload there sends nothing twice.
    To(String),
    /// Another address, with a cookie.
    ToWith {
        /// The address.
        to: String,
        /// Which cookie.
        cookie: Cookie,
        /// Its token; nothing where the browser forgets it.
        token: Option<String>,
    },
    /// A file to be saved.
    Download {
        /// Its name.
        name: String,
        /// Its media type.
        kind: &'static str,
        /// Its content.
        bytes: Vec<u8>,
    },
    /// An object for a script.
    Json(Value),
}

impl Reply {
    /// The same page, as one that says what is wrong.
    pub(super) fn wrong(self) -> Self {
        match self {
            Self::Page(text) => Self::Wrong(text),
            other => other,
        }
    }

    /// Another address, signed in.
    pub(super) fn signed_in(to: String, token: String) -> Self {
        Self::ToWith { to, cookie: Cookie::Session, token: Some(token) }
    }

    /// Turns it into a response. No cache keeps what only one person may see.
    pub(super) fn response(self, settings: &Settings) -> Response {
        let mut headers = HeaderMap::new();
        headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
        match self {
            Self::Page(text) => (headers, Html(text)).into_response(),
            Self::Wrong(text) => (StatusCode::UNPROCESSABLE_ENTITY, headers, Html(text)).into_response(),
            Self::To(address) => to(headers, &address),
            Self::ToWith { to: address, cookie, token } => {
                let cookie = cookie.header(token.as_deref(), settings);
                headers.extend(cookie.map(|cookie| (header::SET_COOKIE, cookie)));
                to(headers, &address)
            }
            Self::Download { name, kind, bytes } => {
                headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
                let disposition = HeaderValue::from_str(&format!("attachment; filename=\"{}\"", plain(&name)));
                headers.extend(disposition.ok().map(|value| (header::CONTENT_DISPOSITION, value)));
                (headers, bytes).into_response()
            }
            Self::Json(value) => {
                headers.insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
                (headers, value.to_string()).into_response()
            }
        }
    }
}

fn to(mut headers: HeaderMap, address: &str) -> Response {
    headers.extend(HeaderValue::from_str(address).ok().map(|address| (header::LOCATION, address)));
    (StatusCode::SEE_OTHER, headers).into_response()
}

/// The name of a file with letters that every system takes.
fn plain(name: &str) -> String {
    name.chars()
        .map(|letter| if letter.is_ascii_alphanumeric() || "-_.".contains(letter) { letter } else { '-' })
        .collect()
}
