//! A client that asks the router itself.

use std::sync::Arc;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::{HeaderMap, Method, Request};
use momentous::web::{App, Settings, router};
use serde_json::Value;
use tokio::runtime::{Builder, Runtime};
use tower::ServiceExt;

/// More than any response has.
const LONGEST: usize = 16 << 20;

/// The application and something to run it on.
pub struct Client {
    runtime: Runtime,
    router: Router,
    /// The application itself.
    pub app: Arc<App>,
}

/// A response, read to its end.
pub struct Answer {
    pub status: u16,
    headers: HeaderMap,
    body: Vec<u8>,
}

impl Client {
    pub fn new() -> Self {
        Self::under("")
    }

    /// The application behind a proxy that puts this path before its pages.
    pub fn under(base: &str) -> Self {
        Self::with(Settings { base_path: base.to_owned(), ..Settings::default() })
    }

    pub fn with(settings: Settings) -> Self {
        let app = Arc::new(App::new(settings).unwrap());
        Self {
            runtime: Builder::new_multi_thread().enable_all().build().unwrap(),
            router: router(Arc::clone(&app)),
            app,
        }
    }

    pub fn get(&self, address: &str) -> Answer {
        self.ask(Request::get(address).body(Body::empty()).unwrap())
    }

    /// A form, as a browser sends it.
    pub fn post(&self, address: &str, fields: &str) -> Answer {
        let request = Request::post(address).header("content-type", "application/x-www-form-urlencoded");
        self.ask(request.body(Body::from(fields.to_owned())).unwrap())
    }

    /// A call of the engine.
    pub fn call(&self, name: &str, request: &Value) -> Answer {
        self.bytes(Method::POST, &format!("/api/{name}"), "application/json", request.to_string().into_bytes())
    }

    pub fn bytes(&self, method: Method, address: &str, kind: &str, body: Vec<u8>) -> Answer {
        let request = Request::builder().method(method).uri(address).header("content-type", kind);
        self.ask(request.body(Body::from(body)).unwrap())
    }

    fn ask(&self, request: Request<Body>) -> Answer {
        self.runtime.block_on(async {
            let response = self.router.clone().oneshot(request).await.unwrap();
            let (parts, body) = response.into_parts();
            let body = to_bytes(body, LONGEST).await.unwrap().to_vec();
            Answer { status: parts.status.as_u16(), headers: parts.headers, body }
        })
    }
}

impl Answer {
    /// The text of a response that has this status.
    pub fn text(&self, status: u16) -> String {
        let text = String::from_utf8(self.body.clone()).unwrap();
        assert_eq!(self.status, status, "{text}");
        text
    }

    /// The object of a response that has this status.
    pub fn json(&self, status: u16) -> Value {
        serde_json::from_str(&self.text(status)).unwrap()
    }

    pub fn header(&self, name: &str) -> String {
        self.headers.get(name).map(|value| value.to_str().unwrap().to_owned()).unwrap_or_default()
    }
}

/// Fields as a browser writes them.
pub fn encoded(fields: &[(String, String)]) -> String {
    let pairs: Vec<String> =
        fields.iter().map(|(name, value)| format!("{}={}", percent(name), percent(value))).collect();
    pairs.join("&")
}

/// A text with everything but letters and digits as `%2F`.
pub fn percent(text: &str) -> String {
    text.bytes()
        .map(|byte| if byte.is_ascii_alphanumeric() { char::from(byte).to_string() } else { format!("%{byte:02X}") })
        .collect()
}
