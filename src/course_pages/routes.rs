//! From a request to a [`Visit`], and from what comes of it to a response.

use std::str::FromStr;
use std::sync::Arc;

use axum::Router;
use axum::extract::{DefaultBodyLimit, RawPathParams, Request};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{MethodFilter, on};

use momentous_course::{Course, Key, Moment};
use momentous_exercise::calls::{Refused, RefusedKind};
use momentous_store::{Membership, Store, StoreFault};

use super::cookie::Cookie;
use super::fields;
use super::gate::Who;
use super::origin;
use super::outcome::NotShown;
use super::state::Courses;
use super::table::{Does, ROWS, Row};
use super::visit::Visit;
use super::visitor::Visitor;
use momentous_pages::Again;
use momentous_pages::Parameters;
use momentous_web::answer;
use momentous_web::sender;
use momentous_web::{App, SharedApp};

/// The bytes of a form of somebody who has not signed in: a name, a password and an address.
const LONGEST_AT_THE_DOOR: usize = 8 << 10;
/// The bytes of a form that are kept for whoever was signed out meanwhile.
const LONGEST_KEPT: usize = 1 << 16;
/// The bytes of a form: a roster of some thousand students, or a problem file with a lot of text.
const LONGEST_FORM: usize = 1 << 20;

/// The pages of courses, beside the others.
pub(super) fn with_courses(mut router: Router<SharedApp>, courses: &Arc<Courses>) -> Router<SharedApp> {
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
    let to = request.uri().path_and_query().map_or_else(String::new, |path| path.as_str().to_owned());
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

/// Reads who asks for what. Nothing is read of a form that another site has sent.
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
        Err(fault) => return Err((fault.into(), fields::typed(request, longest(row)).await)),
    };
    let browser = Cookie::Browser.sent(headers).map(str::to_owned);
    let from = sender::sender(request.extensions(), headers, &app.settings.trusted_proxies);
    let fields = Parameters::default();
    let mut visit = Visit { app, courses, now, place, visitor, browser, from, path, fields };
    match row.who.admits(&visit) {
        Ok(()) => {}
        Err(NotShown::SignIn) => return Err((NotShown::SignIn, fields::typed(request, LONGEST_KEPT).await)),
        // Whoever may not see the page has nothing read.
        Err(reason) => return Err(bare(reason)),
    }
    let fields = match row.does {
        Does::Shows => fields::of_address(request.uri()),
        Does::Changes => fields::of_form(request, longest(row)).await,
    };
    let fields = fields.map_err(bare)?;
    let has_nul = |(name, value): &(String, String)| name.contains('\0') || value.contains('\0');
    if visit.path.iter().chain(&fields).any(has_nul) {
        // PostgreSQL keeps no such text.
        return Err(bare(NotShown::field("a text has a character that nobody can type (NUL)")));
    }
    visit.fields = Parameters::new(fields, &visit.app.settings.limits).map_err(|refused| bare(refused.into()))?;
    Ok(visit)
}

/// Finds who asks, and the place of that person in the course of the address, as far as the session reaches.
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

/// A page that says why the one that was asked for is not shown. Where the form can be sent again it is there as it was typed.
fn not_shown(app: &App, reason: NotShown, does: Does, to: &str, typed: &Parameters) -> Response {
    let again = (does == Does::Changes).then(|| Again::of(&app.settings.base_path, to, typed)).flatten();
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
        NotShown::NotPossible(message) => said(StatusCode::CONFLICT, "Not possible", &message, "", None),
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
