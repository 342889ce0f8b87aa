//! Every address that is served.

use std::sync::Arc;

use axum::Form;
use axum::Router;
use axum::body::Bytes;
use axum::extract::DefaultBodyLimit;
use axum::extract::Path;
use axum::extract::Query;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::http::StatusCode;
use axum::http::header;
use axum::middleware::from_fn_with_state;
use axum::response::IntoResponse;
use axum::response::Response;
use axum::routing::MethodRouter;
use axum::routing::get;
use axum::routing::post;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::compression::CompressionLayer;
use tower_http::set_header::SetResponseHeaderLayer;

use crate::exercise::calls::{Engine, Refused, RefusedKind};
use crate::store::StoreFault;

use super::answer;
use super::app::{App, SharedApp};
use super::courses::{Rest, Withheld, with_courses};
use super::explained::explained;
use super::headers::{FOR_EVER, HEADERS};
use super::health::health;
use super::observed::observed;
use super::pages;
use super::parameters::Parameters;

/// The fields of an address or of a form.
type Fields = Vec<(String, String)>;

/// What makes the page of a problem, or of a simulator by its name.
type OfProblem = fn(&App, String, &Parameters) -> Result<String, Refused>;

/// Whether pages are refused while an assignment with their problem is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum While {
    Refused,
    Shown,
}

/// The pages of problems, `/practice/impact/two-carts`, and of simulators, which are always shown.
const OF_PROBLEMS: [(&str, While, OfProblem); 5] = [
    ("/play/{*problem}", While::Refused, pages::play),
    ("/practice/{*problem}", While::Refused, pages::practice),
    ("/simulators/{*problem}", While::Shown, pages::simulator),
    ("/solution/{*problem}", While::Refused, pages::solution),
    ("/solve/{*problem}", While::Refused, pages::solve),
];

/// The calls of simulators, which are never refused.
const OF_SIMULATORS: [&str; 2] = ["collision", "restitution"];

/// Everything that is served.
pub fn router(app: Arc<App>) -> Router {
    let base = app.settings.base_path.clone();
    let mut own = Router::new()
        .route("/", get(start))
        .route("/health", get(health))
        .route("/watch", get(watch))
        .route("/static/{digest}/{name}", get(asset))
        .route("/api/{call}", post(call))
        .fallback(|State(app): State<SharedApp>| answer::page(app, |_| Err(no_page())));
    for (path, reserved, make) in OF_PROBLEMS {
        own = own.route(path, of_problem(reserved, make));
    }
    let own = with_courses(own, &app);
    let own = own.with_state(Arc::clone(&app)).layer(DefaultBodyLimit::max(app.settings.limits.request_bytes));
    let own = own.layer(from_fn_with_state(Arc::clone(&app), explained));
    let mut all = if base.is_empty() {
        own
    } else {
        // Nested routes begin without the slash that the start page's address ends with.
        Router::new().nest(&base, own).route(&format!("{base}/"), get(start).with_state(Arc::clone(&app)))
    };
    for (name, value) in HEADERS {
        all = all.layer(SetResponseHeaderLayer::overriding(name, value));
    }
    let all = all.layer(CompressionLayer::new()).layer(CatchPanicLayer::new());
    all.layer(from_fn_with_state(app, observed))
}

/// Both ways to ask for the page of a problem: by its address, and with what was typed into it.
fn of_problem(reserved: While, make: OfProblem) -> MethodRouter<SharedApp> {
    let page = move |app: SharedApp, headers: HeaderMap, problem: String, fields: Fields| async move {
        let withheld = match reserved {
            While::Shown => Withheld::default(),
            While::Refused => match Withheld::from(&app, &headers).await {
                Ok(withheld) => withheld,
                Err(fault) => return unreachable_records(&fault),
            },
        };
        answer::page(app, move |app| {
            withheld.check(&problem)?;
            make(app, problem, &Parameters::new(fields, &app.settings.limits)?)
        })
        .await
    };
    get(
        move |State(app): State<SharedApp>,
              headers: HeaderMap,
              Path(problem): Path<String>,
              Query(fields): Query<Fields>| { page(app, headers, problem, fields) },
    )
    .post(
        move |State(app): State<SharedApp>,
              headers: HeaderMap,
              Path(problem): Path<String>,
              Form(fields): Form<Fields>| { page(app, headers, problem, fields) },
    )
}

/// Where nobody can say what is withheld, nothing is shown.
fn unreachable_records(fault: &StoreFault) -> Response {
    eprintln!("momentous serve: {fault}");
    (StatusCode::SERVICE_UNAVAILABLE, "The records cannot be reached at the moment. Try again in a moment.\n")
        .into_response()
}

async fn start(State(app): State<SharedApp>, Query(fields): Query<Fields>) -> Response {
    answer::page(app, move |app| pages::start(app, &Parameters::new(fields, &app.settings.limits)?)).await
}

async fn call(State(app): State<SharedApp>, headers: HeaderMap, Path(call): Path<String>, body: Bytes) -> Response {
    let withheld = if OF_SIMULATORS.contains(&call.as_str()) {
        Withheld::default()
    } else {
        match Withheld::from(&app, &headers).await {
            Ok(withheld) => withheld,
            Err(fault) => return unreachable_records(&fault),
        }
    };
    answer::json(app, move |app| {
        let engine = app.engine();
        let problems = Rest { problems: engine.problems, withheld: &withheld };
        Engine { problems: &problems, ..engine }.call(&call, &body)
    })
    .await
}

/// The state of the watched files, for pages that reload themselves.
async fn watch(State(app): State<SharedApp>) -> Response {
    answer::json(app, |app| Ok(app.library.stamp().to_string())).await
}

async fn asset(State(app): State<SharedApp>, Path((_, name)): Path<(String, String)>) -> Response {
    match app.assets.find(&name) {
        Some((kind, bytes)) => {
            ([(header::CONTENT_TYPE, kind)], [(header::CACHE_CONTROL, FOR_EVER)], bytes.to_vec()).into_response()
        }
        None => StatusCode::NOT_FOUND.into_response(),
    }
}

fn no_page() -> Refused {
    Refused::new(RefusedKind::Unknown, "there is no such page").help("the start page lists every problem")
}
