//! From a request to a [`Visit`], and from what comes of it to a response.

use std::collections::BTreeMap;
use std::str::FromStr;
use std::sync::Arc;

use axum::Form;
use axum::Router;
use axum::body::to_bytes;
use axum::extract::multipart::MultipartError;
use axum::extract::{DefaultBodyLimit, FromRequest, Multipart, Query, RawPathParams, Request};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{MethodFilter, on};

use crate::course::{Course, Key, Moment};
use crate::exercise::calls::{Refused, RefusedKind};
use crate::store::{Membership, Store, StoreFault};

use super::super::again::Again;
use super::super::answer;
use super::super::app::{App, SharedApp};
use super::super::arrival::Arrival;
use super::super::parameters::Parameters;
use super::super::sender;
use super::gate::Who;
use super::origin;
use super::outcome::NotShown;
use super::state::Courses;
use super::table::{Does, ROWS, Row};
use super::visit::Visit;
use super::visitor::Visitor;

/// The bytes of a form of somebody who has not signed in: a name, a password and an address.
const LONGEST_AT_THE_DOOR: usize = 8 << 10;
/// The bytes of a form that are kept for whoever was signed out meanwhile.
const LONGEST_KEPT: usize = 1 << 16;
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
        router = router.route(row.address, on(method, handle).layer(DefaultBodyLimit::max(longest(row))));
    }
    router
}

/// The bytes of a form that an address takes.
fn longest(row: &Row) -> usize {
    if row.who == Who::Anyone { LONGEST_AT_THE_DOOR } else { LONGEST_FORM }
}

async fn respond(row: &Row, app: SharedApp, courses: Arc<Courses>, path: &RawPathParams, request: Request) -> Response {
    let to = request.uri().path_and_query().map_or_else(String::new, |own| own.as_str().to_owned());
    let path = path.iter().map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
    let visit = match visit(row, SharedApp::clone(&app), courses, path, request).await {
        Ok(visit) => visit,
        Err((reason, typed)) => return not_shown(&app, reason, row.does, &to, &typed),
    };
    match (row.make)(&visit).await {
        Ok(reply) => reply.response(&visit.app.settings),
        Err(reason) => not_shown(&app, reason, row.does, &to, &visit.fields),
    }
}

/// Why there is no visit, and what was typed.
type NoVisit = (NotShown, Parameters);

/// Who asks for what. Nothing is read of a form that another site has sent.
async fn visit(
    row: &Row,
    app: SharedApp,
    courses: Arc<Courses>,
    path: Vec<(String, String)>,
    request: Request,
) -> Result<Visit, NoVisit> {
    let bare = |reason| (reason, Parameters::default());
    // What is in time is decided by when the headers came, however long the rest takes.
    let now = courses.clock.now();
    let headers = request.headers();
    if row.does == Does::Changes && !origin::is_own(headers, &app.settings) {
        return Err(bare(NotShown::Origin));
    }
    let course = path.iter().find(|(name, _)| name == "course").and_then(|(_, text)| Key::from_str(text).ok());
    let (visitor, place) = match known(&courses.store, headers, now, course).await {
        Ok(known) => known,
        Err(fault) => return Err((fault.into(), typed(row, request, longest(row)).await)),
    };
    let from = sender::of(request.extensions(), headers, &app.settings.trusted_proxies);
    let fields = Parameters::default();
    let mut visit = Visit { app, courses, now, place, visitor, from, path, fields };
    match row.who.admits(&visit) {
        Ok(()) => {}
        Err(NotShown::SignIn) => return Err((NotShown::SignIn, typed(row, request, LONGEST_KEPT).await)),
        // Whoever may not see the page has nothing read.
        Err(reason) => return Err(bare(reason)),
    }
    let fields = fields_of(row.does, request).await.map_err(bare)?;
    let has_nul = |(name, value): &(String, String)| name.contains('\0') || value.contains('\0');
    if visit.path.iter().chain(&fields).any(has_nul) {
        // PostgreSQL keeps no such text.
        return Err(bare(NotShown::field("a text has a character that nobody can type (NUL)")));
    }
    visit.fields = Parameters::new(fields, &visit.app.settings.limits).map_err(|refused| bare(refused.into()))?;
    Ok(visit)
}

/// Who asks, and the place of that person in the course of the address, as far as the session reaches.
async fn known(
    store: &Store,
    headers: &HeaderMap,
    now: Moment,
    course: Option<Key<Course>>,
) -> Result<(Option<Visitor>, Option<Membership>), StoreFault> {
    let visitor = Visitor::at(store, headers, now).await?;
    let place = match (course, &visitor) {
        (Some(course), Some(visitor)) if visitor.reaches(course) => {
            store.membership(course, visitor.person.key).await?
        }
        _ => None,
    };
    Ok((visitor, place))
}

/// What was typed into a form that cannot be taken now, where it can be read.
async fn typed(row: &Row, request: Request, longest: usize) -> Parameters {
    if row.does == Does::Shows || is_multipart(request.headers()) {
        return Parameters::default();
    }
    let body = to_bytes(request.into_body(), longest).await.unwrap_or_default();
    Parameters::all_of(serde_urlencoded::from_bytes(&body).unwrap_or_default())
}

/// The fields of an address or of a form; the contents of a file that is sent along is the value of its field.
async fn fields_of(does: Does, request: Request) -> Result<Vec<(String, String)>, NotShown> {
    let unread = |message: String| NotShown::Refused(Refused::new(RefusedKind::Invalid, message));
    let arrival = request.extensions().get::<Arrival>().copied();
    let failed = |status, message| match arrival {
        Some(arrival) if arrival.is_over() => NotShown::Slow,
        _ => NotShown::Refused(too_large_or(status, message)),
    };
    if does == Does::Shows {
        return match Query::try_from_uri(request.uri()) {
            Ok(Query(fields)) => Ok(fields),
            Err(error) => Err(unread(error.body_text())),
        };
    }
    if !is_multipart(request.headers()) {
        return match Form::from_request(request, &()).await {
            Ok(Form(fields)) => Ok(fields),
            Err(error) => Err(failed(error.status(), error.body_text())),
        };
    }
    let mut parts = Multipart::from_request(request, &()).await.map_err(|error| unread(error.body_text()))?;
    let mut fields: BTreeMap<String, String> = BTreeMap::new();
    let failed = |error: MultipartError| failed(error.status(), error.body_text());
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

/// A page that says why the one that was asked for is not shown. Where the form can be sent again it is there as it was typed.
fn not_shown(app: &App, reason: NotShown, does: Does, to: &str, typed: &Parameters) -> Response {
    let again = (does == Does::Changes).then(|| Again::of(to, typed)).flatten();
    let said = |status, title, message: &str, help: &str, again| {
        let refused = Refused::new(RefusedKind::Invalid, message);
        let refused = if help.is_empty() { refused } else { refused.help(help) };
        answer::refusal(app, (status, title), &refused, again)
    };
    match reason {
        NotShown::Refused(refused) => answer::refused(app, &refused),
        NotShown::SignIn if does == Does::Shows => {
            let base = &app.settings.base_path;
            let to = to.strip_prefix(base.as_str()).unwrap_or(to);
            let to: String = to.bytes().map(escaped).collect();
            (StatusCode::SEE_OTHER, [(header::LOCATION, format!("{base}/sign-in?to={to}"))]).into_response()
        }
        NotShown::SignIn => {
            let help = "sign in in another tab, come back to this page, and send it again; nothing of it is lost";
            said(StatusCode::UNAUTHORIZED, "Signed out", "you are not signed in any more", help, again)
        }
        NotShown::Forbidden(why) => said(StatusCode::FORBIDDEN, "Not for you", why, "", None),
        NotShown::Origin => {
            let help = "load the page anew and send it again; behind a proxy the server has to know its address, by --base-url";
            let message = "this form was not sent by a page of this server";
            said(StatusCode::FORBIDDEN, "Not from here", message, help, None)
        }
        NotShown::Slow => {
            let message = "the form was not here half a minute after its beginning";
            said(StatusCode::REQUEST_TIMEOUT, "Too slow", message, "go back and send it again", None)
        }
        NotShown::TooMany => {
            let message = "this was tried many times in a short while";
            said(StatusCode::TOO_MANY_REQUESTS, "Too many", message, "wait a minute and try again", again)
        }
        NotShown::Conflict(message) => {
            said(StatusCode::CONFLICT, "Changed meanwhile", &message, "load the page anew", again)
        }
        NotShown::NotDone(reason) => answer::not_done(app, reason, again),
        NotShown::Store(fault) => {
            eprintln!("momentous serve: {fault}");
            let help = "try again in a moment; nothing that you typed is at fault";
            let message = "the records cannot be reached at the moment";
            said(StatusCode::SERVICE_UNAVAILABLE, "Not kept", message, help, again)
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
