//! What is measured and told of requests.

use std::fs;
use std::sync::Arc;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::Request;
use momentous::course::Moment;
use momentous::course_pages::{Clock, Courses};
use momentous::store::sqlx::{AnyConnection, Connection, Executor};
use momentous::store::{Address, Store};
use momentous::web::{App, Settings, metrics_router, router};
use serde_json::Value;
use tower::ServiceExt;

use super::server::{Server, folder};

async fn get(router: &Router, path: &str) -> (u16, String) {
    let request = Request::get(path).body(Body::empty()).unwrap();
    let response = router.clone().oneshot(request).await.unwrap();
    let status = response.status().as_u16();
    let bytes = to_bytes(response.into_body(), 1 << 22).await.unwrap();
    (status, String::from_utf8_lossy(&bytes).into_owned())
}

/// The number that stands behind a name.
fn value(text: &str, name: &str) -> Option<f64> {
    text.lines().find_map(|line| line.strip_prefix(name)?.trim().parse().ok())
}

fn block_on<T>(future: impl Future<Output = T>) -> T {
    tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap().block_on(future)
}

#[test]
fn requests_are_counted_by_the_class_of_their_status() {
    let room = folder();
    block_on(async {
        let store = Store::serve(&Address::Folder(room.path().join("data"))).await.unwrap();
        let courses = Courses::new(store.clone(), Clock::default());
        let app = Arc::new(App::new(Settings::default()).unwrap().with_companion(Arc::new(courses)));
        let (pages, metrics) = (router(Arc::clone(&app)), metrics_router(app));
        for (path, status) in
            [("/simulators/collision", 200), ("/no/such/page", 404), ("/courses", 303), ("/health", 200)]
        {
            assert_eq!(get(&pages, path).await.0, status, "{path}");
        }
        let (status, text) = get(&metrics, "/metrics").await;
        assert_eq!(status, 200);
        for (name, expected) in [
            ("momentous_requests_total{status=\"2xx\"}", 2.0),
            ("momentous_requests_total{status=\"3xx\"}", 1.0),
            ("momentous_requests_total{status=\"4xx\"}", 1.0),
            ("momentous_request_seconds_count", 4.0),
            ("momentous_request_seconds_bucket{le=\"+Inf\"}", 4.0),
            ("momentous_attempts_total", 0.0),
            ("momentous_queue_length", 0.0),
        ] {
            assert_eq!(value(&text, name), Some(expected), "{name}\n{text}");
        }
        let reads = value(&text, "momentous_database_reads_total").unwrap();
        assert!(reads >= 1.0, "the health of the database was read");
        store.ping().await.unwrap();
        let (_, text) = get(&metrics, "/metrics").await;
        assert_eq!(value(&text, "momentous_database_reads_total"), Some(reads + 1.0));
        assert_eq!(get(&pages, "/metrics").await.0, 404, "readers of the pages see nothing of it");
    });
}

#[test]
fn the_health_of_the_database_is_told() {
    let room = folder();
    let data = room.path().join("data");
    block_on(async {
        let store = Store::serve(&Address::Folder(data.clone())).await.unwrap();
        let app = App::new(Settings::default())
            .unwrap()
            .with_companion(Arc::new(Courses::new(store.clone(), Clock::default())));
        let pages = router(Arc::new(app));
        // Nothing new is taken, and that is said before anybody hands in.
        let url = format!("sqlite://{}", data.join("momentous.sqlite").display());
        let mut connection = AnyConnection::connect(&url).await.unwrap();
        let refuse = "CREATE TRIGGER refuse BEFORE INSERT ON draft BEGIN SELECT RAISE(ROLLBACK, 'full'); END";
        connection.execute(refuse).await.unwrap();
        assert_eq!(get(&pages, "/health").await, (503, "the database takes nothing new\n".to_owned()));
        connection.execute("DROP TRIGGER refuse").await.unwrap();
        store.add_tickets(Vec::new(), Moment::from_millis(0), &[]).await.unwrap();
        assert_eq!(get(&pages, "/health").await, (200, "fine\n".to_owned()));
        store.close().await;
        assert_eq!(get(&pages, "/health").await, (503, "the database does not answer\n".to_owned()));
    });
}

#[test]
fn a_line_names_the_pattern_of_an_address_and_nothing_else_of_it() {
    let room = folder();
    let server = Server::start(room.path());
    let asked = [
        ("/practice/impact/two-carts?seed=7&answer.v=Ada", "/practice/{*problem}", 200),
        ("/sign-in/0123456789abcdef-token", "/sign-in/{token}", 200),
        ("/Ada/is/not/here", "none", 404),
        ("/health", "/health", 200),
    ];
    for (path, _, status) in asked {
        assert!(server.get(path).starts_with(&format!("HTTP/1.1 {status}")), "{path}");
    }
    server.stop();
    let log = fs::read_to_string(room.path().join("log")).unwrap();
    let lines: Vec<Value> = log.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
    assert_eq!(lines.len(), asked.len(), "{log}");
    for (line, (path, route, status)) in lines.iter().zip(asked) {
        assert_eq!(
            (&line["method"], &line["route"], &line["status"]),
            (&"GET".into(), &route.into(), &status.into()),
            "{path}"
        );
        let milliseconds = line["milliseconds"].as_f64().unwrap();
        assert!((0.0..600_000.0).contains(&milliseconds));
        let keys: Vec<&str> = line.as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(keys, ["at", "method", "route", "status", "milliseconds"]);
    }
    for secret in ["Ada", "token", "two-carts", "seed"] {
        assert!(!log.replace("{token}", "").contains(secret), "{secret} stands in the log");
    }
}
