//! From a request to a [`Visit`], and from what comes of it to a response.

use std::collections::BTreeMap;
use std::str::FromStr;
use std::sync::Arc;

use axum::Form;
use axum::Router;
use axum::extract::{DefaultBodyLimit, FromRequest, Multipart, Query, RawPathParams, Request};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{MethodFilter, on};

use crate::course::Key;
use crate::exercise::calls::{Refused, RefusedKind};
use crate::store::TicketKind;

use super::super::answer;
use super::super::app::SharedApp;
use super::super::parameters::Parameters;
use super::origin;
use super::outcome::NotShown;
use super::session;
use super::state::Courses;
use super::table::{Does, ROWS, Row};
use super::visit::Visit;

/// The bytes of a form: a roster of some thousand students, or a problem file with a lot of text.
const LONGEST_FORM: usize = 1 << 20;

/// The pages of courses, beside the others.
pub(in crate::web) fn with_courses(mut router: Router<SharedApp>, app: &SharedApp) -> Router<SharedApp> {
    let Some(courses) = &app.courses else { return router };
    for row in ROWS {
        let courses = Arc::clone(courses);
        let method = match row.does {
            Does::Shows => MethodFilter::GET,
            Does::Changes => MethodFilter::POST,
        };
        let handle =
            move |axum::extract::State(app): axum::extract::State<SharedApp>, path: RawPathParams, request: Request| {
                let courses = Arc::clone(&courses);
                async move { respond(row, app, courses, &path, request).await }
            };
        router = router.route(row.address, on(method, handle).layer(DefaultBodyLimit::max(LONGEST_FORM)));
    }
    router
}

async fn respond(row: &Row, app: SharedApp, courses: Arc<Courses>, path: &RawPathParams, request: Request) -> Response {
    let to = request.uri().path_and_query().map_or_else(String::new, |own| own.as_str().to_owned());
    let path = path.iter().map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
    let shown = async {
        let visit = visit(row, SharedApp::clone(&app), courses, path, request).await?;
        row.who.admits(&visit)?;
        let reply = (row.make)(&visit).await?;
        Ok(reply.response(&visit.app.settings))
    };
    match shown.await {
        Ok(response) => response,
        Err(reason) => not_shown(app, reason, row.does, &to).await,
    }
}

/// Who asks for what. Nothing is read of a form that another site has sent.
async fn visit(
    row: &Row,
    app: SharedApp,
    courses: Arc<Courses>,
    path: Vec<(String, String)>,
    request: Request,
) -> Result<Visit, NotShown> {
    let now = courses.clock.now();
    let headers = request.headers();
    if row.does == Does::Changes && !origin::is_own(headers, app.settings.host.as_deref()) {
        return Err(NotShown::Origin);
    }
    let session = session::of(headers).map(session::hash);
    let person = match &session {
        Some(hash) => courses.store.holder(hash, TicketKind::Session, now).await?,
        None => None,
    };
    let course = path.iter().find(|(name, _)| name == "course").and_then(|(_, text)| Key::from_str(text).ok());
    let place = match (course, &person) {
        (Some(course), Some(person)) => courses.store.membership(course, person.key).await?,
        _ => None,
    };
    let host = headers.get(header::HOST).and_then(|value| value.to_str().ok()).unwrap_or_default();
    let host = app.settings.host.clone().unwrap_or_else(|| host.to_owned());
    let mut visit = Visit { app, courses, host, now, person, place, session, path, fields: Parameters::default() };
    // Whoever may not see the page has nothing read.
    row.who.admits(&visit)?;
    let fields = fields(row.does, request).await?;
    let has_nul = |(name, value): &(String, String)| name.contains('\0') || value.contains('\0');
    if visit.path.iter().chain(&fields).any(has_nul) {
        // PostgreSQL keeps no such text.
        return Err(NotShown::field("a text has a character that nobody can type (NUL)"));
    }
    visit.fields = Parameters::new(fields, &visit.app.settings.limits)?;
    Ok(visit)
}

/// The fields of an address or of a form; the contents of a file that is sent along is the value of its field.
async fn fields(does: Does, request: Request) -> Result<Vec<(String, String)>, NotShown> {
    let unread = |message: String| NotShown::Refused(Refused::new(RefusedKind::Invalid, message));
    if does == Does::Shows {
        return match Query::try_from_uri(request.uri()) {
            Ok(Query(fields)) => Ok(fields),
            Err(error) => Err(unread(error.body_text())),
        };
    }
    if !is_multipart(request.headers()) {
        return match Form::from_request(request, &()).await {
            Ok(Form(fields)) => Ok(fields),
            Err(error) => Err(NotShown::Refused(too_large_or(error.status(), error.body_text()))),
        };
    }
    let mut parts = Multipart::from_request(request, &()).await.map_err(|error| unread(error.body_text()))?;
    let mut fields: BTreeMap<String, String> = BTreeMap::new();
    let failed = |error: axum::extract::multipart::MultipartError| {
        NotShown::Refused(too_large_or(error.status(), error.body_text()))
    };
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

fn too_large_or(status: StatusCode, message: String) -> Refused {
    if status == StatusCode::PAYLOAD_TOO_LARGE {
        Refused::new(RefusedKind::TooLarge, format!("a form has at most {LONGEST_FORM} bytes"))
    } else {
        Refused::new(RefusedKind::Invalid, message)
    }
}

fn is_multipart(headers: &HeaderMap) -> bool {
    let kind = headers.get(header::CONTENT_TYPE).and_then(|value| value.to_str().ok());
    kind.is_some_and(|kind| kind.starts_with("multipart/form-data"))
}

async fn not_shown(app: SharedApp, reason: NotShown, does: Does, to: &str) -> Response {
    let said = |status, title, message: &str, help: &str| {
        let refused = Refused::new(RefusedKind::Invalid, message);
        answer::refusal(
            SharedApp::clone(&app),
            status,
            title,
            if help.is_empty() { refused } else { refused.help(help) },
        )
    };
    match reason {
        NotShown::Refused(refused) => answer::refused(app, refused).await,
        NotShown::SignIn if does == Does::Shows => {
            let base = &app.settings.base_path;
            let to = to.strip_prefix(base.as_str()).unwrap_or(to);
            let to: String = to.bytes().map(escaped).collect();
            (StatusCode::SEE_OTHER, [(header::LOCATION, format!("{base}/sign-in?to={to}"))]).into_response()
        }
        NotShown::SignIn => {
            let help = "sign in in another tab, come back to this page, and send it again; nothing of it is lost";
            said(StatusCode::UNAUTHORIZED, "Signed out", "you are not signed in any more", help).await
        }
        NotShown::Forbidden(why) => said(StatusCode::FORBIDDEN, "Not for you", why, "").await,
        NotShown::Origin => {
            let help = "load the page anew and send it again; behind a proxy the server has to know its address, by --base-url";
            said(StatusCode::FORBIDDEN, "Not from here", "this form was not sent by a page of this server", help).await
        }
        NotShown::TooMany => {
            let message = "this was tried many times in a short while";
            said(StatusCode::TOO_MANY_REQUESTS, "Too many", message, "wait a minute and try again").await
        }
        NotShown::Conflict(message) => {
            said(StatusCode::CONFLICT, "Changed meanwhile", &message, "load the page anew").await
        }
        NotShown::NotDone(reason) => answer::not_done(reason).into_response(),
        NotShown::Store(fault) => {
            eprintln!("momentous serve: {fault}");
            let help = "try again in a moment; nothing that you typed is at fault";
            said(StatusCode::SERVICE_UNAVAILABLE, "Not kept", "the records cannot be reached at the moment", help).await
        }
    }
}

/// A byte of an address within an address.
fn escaped(byte: u8) -> String {
    if byte.is_ascii_alphanumeric() || b"/-_.~".contains(&byte) {
        char::from(byte).to_string()
    } else {
        format!("%{byte:02X}")
    }
}
