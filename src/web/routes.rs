//! Every address that is served.

use std::sync::Arc;

use axum::Form;
use axum::Router;
use axum::body::Bytes;
use axum::extract::DefaultBodyLimit;
use axum::extract::Path;
use axum::extract::Query;
use axum::extract::State;
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

use crate::exercise::calls::{Refused, RefusedKind};

use super::answer;
use super::app::{App, Shared};
use super::courses::with_courses;
use super::headers::{FOR_EVER, HEADERS};
use super::health::health;
use super::observed::observed;
use super::pages;
use super::parameters::Parameters;

/// The fields of an address or of a form.
type Fields = Vec<(String, String)>;

/// What makes the page of a problem, or of a simulator by its name.
type OfProblem = fn(&App, String, &Parameters) -> Result<String, Refused>;

/// The pages of problems, `/practice/impact/two-carts`, and of simulators.
const OF_PROBLEMS: [(&str, OfProblem); 5] = [
    ("/play/{*problem}", pages::play),
    ("/practice/{*problem}", pages::practice),
    ("/simulators/{*problem}", pages::simulator),
    ("/solution/{*problem}", pages::solution),
    ("/solve/{*problem}", pages::solve),
];

/// Everything that is served.
pub fn router(app: Arc<App>) -> Router {
    let base = app.settings.base_path.clone();
    let mut own = Router::new()
        .route("/", get(start))
        .route("/health", get(health))
        .route("/watch", get(watch))
        .route("/static/{digest}/{name}", get(asset))
        .route("/api/{call}", post(call))
        .fallback(|State(app): State<Shared>| answer::page(app, |_| Err(no_page())));
    for (path, make) in OF_PROBLEMS {
        own = own.route(path, of_problem(make));
    }
    let own = with_courses(own, &app);
    let own = own.with_state(Arc::clone(&app)).layer(DefaultBodyLimit::max(app.settings.limits.request_bytes));
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
fn of_problem(make: OfProblem) -> MethodRouter<Shared> {
    let page = move |app: Shared, problem: String, fields: Fields| {
        answer::page(app, move |app| make(app, problem, &Parameters::new(fields, &app.settings.limits)?))
    };
    get(move |State(app): State<Shared>, Path(problem): Path<String>, Query(fields): Query<Fields>| {
        page(app, problem, fields)
    })
    .post(move |State(app): State<Shared>, Path(problem): Path<String>, Form(fields): Form<Fields>| {
        page(app, problem, fields)
    })
}

async fn start(State(app): State<Shared>, Query(fields): Query<Fields>) -> Response {
    answer::page(app, move |app| pages::start(app, &Parameters::new(fields, &app.settings.limits)?)).await
}

async fn call(State(app): State<Shared>, Path(call): Path<String>, body: Bytes) -> Response {
    answer::json(app, move |app| app.engine().call(&call, &body)).await
}

/// The state of the watched files, for pages that reload themselves.
async fn watch(State(app): State<Shared>) -> Response {
    answer::json(app, |app| Ok(app.library.stamp().to_string())).await
}

async fn asset(State(app): State<Shared>, Path((_, name)): Path<(String, String)>) -> Response {
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
