//! The fields of an address, and those of a form within its time and its length.

use std::collections::BTreeMap;

use axum::body::Body;
use axum::extract::multipart::MultipartError;
use axum::extract::{FromRequest, Multipart, Query, Request};
use axum::http::{HeaderMap, Method, StatusCode, Uri, header};
use futures_util::StreamExt;

use momentous_exercise::calls::{Refused, RefusedKind};

use super::outcome::NotShown;
use momentous_pages::Parameters;
use momentous_web::Arrival;

/// The bytes of a form that are read in all. Of one that is too long nothing is kept; were its rest not read, its sender would see a
/// broken connection in place of the reason.
const MOST: usize = 4 << 20;

/// Names and values.
type Pairs = Vec<(String, String)>;

/// The fields of an address.
pub(super) fn of_address(address: &Uri) -> Result<Pairs, NotShown> {
    match Query::try_from_uri(address) {
        Ok(Query(fields)) => Ok(fields),
        Err(error) => Err(unread(error.body_text())),
    }
}

/// The fields of a form; the contents of a file that is sent along is the value of its field.
pub(super) async fn of_form(request: Request, longest: usize) -> Result<Pairs, NotShown> {
    let arrival = request.extensions().get::<Arrival>().copied();
    let fields = if is_a(request.headers(), "multipart/form-data") {
        of_parts(request, longest).await
    } else if is_a(request.headers(), "application/x-www-form-urlencoded") {
        let bytes = read(request.into_body(), longest).await?;
        serde_urlencoded::from_bytes(&bytes).map_err(|error| unread(format!("the form cannot be read: {error}")))
    } else {
        Err(unread("this is no form".to_owned()))
    };
    if fields.is_err() && arrival.is_some_and(|arrival| arrival.is_over()) { Err(NotShown::Slow) } else { fields }
}

/// The fields of a form that cannot be taken now, where they can be read.
pub(super) async fn typed(request: Request, longest: usize) -> Parameters {
    if request.method() != Method::POST || is_a(request.headers(), "multipart/form-data") {
        return Parameters::default();
    }
    let body = read(request.into_body(), longest).await.unwrap_or_default();
    Parameters::all_of(serde_urlencoded::from_bytes(&body).unwrap_or_default())
}

async fn read(body: Body, longest: usize) -> Result<Vec<u8>, NotShown> {
    let (mut kept, mut length) = (Vec::new(), 0_usize);
    let mut frames = body.into_data_stream();
    while let Some(frame) = frames.next().await {
        let frame = frame.map_err(|_| unread("the form broke off".to_owned()))?;
        length = length.saturating_add(frame.len());
        if length <= longest {
            kept.extend_from_slice(&frame);
        } else {
            kept = Vec::new();
        }
        if length > MOST {
            break;
        }
    }
    if length <= longest { Ok(kept) } else { Err(too_long(longest)) }
}

async fn of_parts(request: Request, longest: usize) -> Result<Pairs, NotShown> {
    let failed = |error: MultipartError| match error.status() {
        StatusCode::PAYLOAD_TOO_LARGE => too_long(longest),
        _ => unread(error.body_text()),
    };
    let mut parts = Multipart::from_request(request, &()).await.map_err(|error| unread(error.body_text()))?;
    let mut fields: BTreeMap<String, String> = BTreeMap::new();
    while let Some(part) = parts.next_field().await.map_err(failed)? {
        let name = part.name().unwrap_or_default().to_owned();
        let bytes = part.bytes().await.map_err(failed)?;
        let text = String::from_utf8(bytes.to_vec())
            .map_err(|_| unread(format!("the file in `{name}` is no text in UTF-8; save it so and send it again")))?;
        // A file may be sent in place of what is pasted: whichever is not empty counts.
        if !text.trim().is_empty() || !fields.contains_key(&name) {
            fields.insert(name, text);
        }
    }
    Ok(fields.into_iter().collect())
}

fn unread(message: String) -> NotShown {
    NotShown::Refused(Refused::new(RefusedKind::Invalid, message))
}

fn too_long(longest: usize) -> NotShown {
    NotShown::Refused(Refused::new(RefusedKind::TooLarge, format!("a form has at most {longest} bytes here")))
}

fn is_a(headers: &HeaderMap, kind: &str) -> bool {
    let content_type = headers.get(header::CONTENT_TYPE).and_then(|value| value.to_str().ok());
    content_type.is_some_and(|content_type| content_type.starts_with(kind))
}
