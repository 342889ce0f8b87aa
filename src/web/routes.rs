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
use axum::http::Uri;
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

use momentous_pages::{Again, Nothing, OfProblem, PROBLEM_PAGES, Parameters, SIMULATORS, Shown, Withheld, no_page};

use super::answer;
use super::app::{App, SharedApp};
use super::companion::Unreachable;
use super::explained::explained;
use super::headers::{BY_TLS, FOR_EVER, HEADERS};
use super::health::health;
use super::observed::observed;
use super::workers::{Admitted, Lane, NotDone};

/// The fields of an address or of a form.
type Fields = Vec<(String, String)>;

/// Everything that is served.
pub fn router(app: Arc<App>) -> Router {
    let base = app.settings.base_path.clone();
    let mut router = Router::new()
        .route("/", get(start))
        .route("/figure/{*problem}", get(figure))
        .route("/health", get(health))
        .route("/watch", get(watch))
        .route("/static/{digest}/{name}", get(asset))
        .route("/api/{call}", post(call))
        .fallback(async |State(app): State<SharedApp>| answer::refused(&app, &no_page()));
    for (begin, shown, make) in PROBLEM_PAGES {
        router = router.route(&format!("{begin}{{*problem}}"), of_problem(shown, make));
    }
    if let Some(companion) = &app.companion {
        router = Arc::clone(companion).add_routes(router);
    }
    let router = router.with_state(Arc::clone(&app)).layer(DefaultBodyLimit::max(app.settings.limits.request_bytes));
    let router = router.layer(from_fn_with_state(Arc::clone(&app), explained));
    let mut all = if base.is_empty() {
        router
    } else {
        // Nested routes begin without the slash that the start page's address ends with.
        Router::new().nest(&base, router).route(&format!("{base}/"), get(start).with_state(Arc::clone(&app)))
    };
    let by_tls = app.settings.is_secure.then_some(BY_TLS);
    for (name, value) in HEADERS.into_iter().chain(by_tls) {
        all = all.layer(SetResponseHeaderLayer::if_not_present(name, value));
    }
    let all = all.layer(CompressionLayer::new()).layer(CatchPanicLayer::new());
    all.layer(from_fn_with_state(app, observed))
}

/// Both ways to ask for the page of a problem: by its address, and with what was typed into it.
fn of_problem(shown: Shown, make: OfProblem) -> MethodRouter<SharedApp> {
    let page = move |app: SharedApp, (headers, uri): (HeaderMap, Uri), problem: String, fields: Fields| async move {
        let shown_page = |withheld: Box<dyn Withheld>, parameters: Parameters| {
            move |app: &App| {
                withheld.check(&problem)?;
                make(&app.view(withheld.as_ref()), problem, &parameters)
            }
        };
        let parameters = match Parameters::new(fields, &app.settings.limits) {
            Ok(parameters) => parameters,
            Err(refused) => return answer::refused(&app, &refused),
        };
        match admitted(&app, &headers, shown).await {
            Ok((place, withheld)) => answer::page(&app, place, shown_page(withheld, parameters)).await,
            Err(NotAdmitted::Busy(reason)) => {
                answer::not_done(&app, reason, Again::of(&app.settings.base_path, &uri.to_string(), &parameters))
            }
            Err(NotAdmitted::Unknown(fault)) => unreachable_records(&fault),
        }
    };
    get(
        move |State(app): State<SharedApp>,
              asked: (HeaderMap, Uri),
              Path(problem): Path<String>,
              Query(fields): Query<Fields>| { page(app, asked, problem, fields) },
    )
    .post(
        move |State(app): State<SharedApp>,
              asked: (HeaderMap, Uri),
              Path(problem): Path<String>,
              Form(fields): Form<Fields>| { page(app, asked, problem, fields) },
    )
}

/// Why nothing is done for a visitor.
enum NotAdmitted {
    Busy(NotDone),
    Unknown(Unreachable),
}

/// A place in the queue of whoever asks, and what is withheld from that person. What is read for those who are not known is bounded by
/// their queue as their work is.
async fn admitted<'app>(
    app: &'app App,
    headers: &HeaderMap,
    shown: Shown,
) -> Result<(Admitted<'app>, Box<dyn Withheld>), NotAdmitted> {
    let Some(companion) = &app.companion else {
        let place = app.workers.admit(Lane::Anyone).map_err(NotAdmitted::Busy)?;
        return Ok((place, Box::new(Nothing)));
    };
    let visitor = match (companion.visitor(app, headers).await, shown) {
        (Ok(visitor), _) => visitor,
        // What is never withheld is shown without the records, too.
        (Err(_), Shown::Always) => companion.stranger(app),
        (Err(fault), Shown::UnlessReserved) => return Err(NotAdmitted::Unknown(fault)),
    };
    let place = app.workers.admit(visitor.lane()).map_err(NotAdmitted::Busy)?;
    let withheld = match shown {
        Shown::Always => visitor.withheld_in_simulators().await,
        Shown::UnlessReserved => visitor.withheld().await.map_err(NotAdmitted::Unknown)?,
    };
    Ok((place, withheld))
}

/// Shows nothing where nobody can say what is withheld.
fn unreachable_records(fault: &Unreachable) -> Response {
    eprintln!("momentous serve: {fault}");
    (StatusCode::SERVICE_UNAVAILABLE, "The records cannot be reached at the moment. Try again in a moment.\n")
        .into_response()
}

/// The gallery says what is withheld; where nobody can say, it is shown without that, and the pages behind it refuse.
async fn start(State(app): State<SharedApp>, headers: HeaderMap, Query(fields): Query<Fields>) -> Response {
    let known = match admitted(&app, &headers, Shown::UnlessReserved).await {
        Err(NotAdmitted::Unknown(_)) => admitted(&app, &headers, Shown::Always).await,
        known => known,
    };
    match known {
        Ok((place, withheld)) => {
            let make = move |app: &App| {
                let fields = Parameters::new(fields, &app.settings.limits)?;
                app.view(withheld.as_ref()).start(&fields)
            };
            answer::page(&app, place, make).await
        }
        Err(NotAdmitted::Busy(reason)) => answer::not_done(&app, reason, None),
        Err(NotAdmitted::Unknown(fault)) => unreachable_records(&fault),
    }
}

/// The figure of a problem in the gallery.
async fn figure(State(app): State<SharedApp>, headers: HeaderMap, Path(problem): Path<String>) -> Response {
    match admitted(&app, &headers, Shown::UnlessReserved).await {
        Ok((place, withheld)) => {
            answer::picture(&app, place, move |app| app.view(withheld.as_ref()).figure(&problem)).await
        }
        Err(NotAdmitted::Busy(reason)) => answer::no_call(reason),
        Err(NotAdmitted::Unknown(fault)) => unreachable_records(&fault),
    }
}

async fn call(State(app): State<SharedApp>, headers: HeaderMap, Path(call): Path<String>, body: Bytes) -> Response {
    let is_simulator = SIMULATORS.iter().any(|(name, _)| *name == call);
    let shown = if is_simulator { Shown::Always } else { Shown::UnlessReserved };
    let (place, withheld) = match admitted(&app, &headers, shown).await {
        Ok(admitted) => admitted,
        Err(NotAdmitted::Busy(reason)) => return answer::no_call(reason),
        Err(NotAdmitted::Unknown(fault)) => return unreachable_records(&fault),
    };
    answer::json(&app, place, move |app| app.view(withheld.as_ref()).engine().call(&call, &body)).await
}

/// The state of the watched files, for pages that reload themselves.
async fn watch(State(app): State<SharedApp>) -> Response {
    match app.workers.admit(Lane::Anyone) {
        Ok(place) => {
            answer::json(&app, place, |app| Ok(app.pages.library.stamp().unwrap_or_default().to_string())).await
        }
        Err(reason) => answer::no_call(reason),
    }
}

async fn asset(State(app): State<SharedApp>, Path((_, name)): Path<(String, String)>) -> Response {
    match app.pages.assets.find(&name) {
        Some((kind, bytes)) => {
            ([(header::CONTENT_TYPE, kind)], [(header::CACHE_CONTROL, FOR_EVER)], bytes.to_vec()).into_response()
        }
        None => StatusCode::NOT_FOUND.into_response(),
    }
}
