//! Pages and calls of the web application, without a network: `cargo bench --bench pages`.

use std::hint::black_box;
use std::sync::Arc;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::Request;
use criterion::Criterion;
use criterion::criterion_group;
use criterion::criterion_main;
use momentous::web::{App, Settings, router};
use tokio::runtime::{Builder, Runtime};
use tower::ServiceExt;

/// As in the program, of which this is a part.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Pages by their addresses.
const PAGES: [&str; 6] = [
    "/",
    "/practice/impact/two-carts?seed=7",
    "/solution/impact/two-carts?seed=7",
    "/solve/impact/two-carts?set.m_A=3+kg&find=v_A2",
    "/play/impact/two-carts?seed=7",
    "/simulators/collision",
];

/// Calls with their requests.
const CALLS: [(&str, &str); 4] = [
    ("read", r#"{"problem":"impact/two-carts","part":"v_A2","text":"0.4 m/s to the left"}"#),
    ("mark", r#"{"problem":"impact/two-carts","answers":{"v_A2":"3 m/s","v_B2":"4 m/s","T_lost":"30 J"}}"#),
    ("collision", r#"{"values":{"m_A":3,"m_B":2,"v_A":3,"v_B":-2,"e":0.7}}"#),
    ("restitution", r#"{"values":{"h":4,"e":0.75}}"#),
];

fn ask(runtime: &Runtime, router: &Router, request: Request<Body>) -> usize {
    runtime.block_on(async {
        let Ok(response) = router.clone().oneshot(request).await;
        assert!(response.status().is_success(), "{}", response.status());
        to_bytes(response.into_body(), usize::MAX).await.map_or(0, |bytes| bytes.len())
    })
}

fn pages(criterion: &mut Criterion) {
    let (Ok(app), Ok(runtime)) = (App::new(Settings::default()), Builder::new_current_thread().enable_all().build())
    else {
        panic!("the built-in bank is served")
    };
    let router = router(Arc::new(app));
    let mut group = criterion.benchmark_group("page");
    for address in PAGES {
        group.bench_function(address, |bencher| {
            bencher.iter(|| {
                let request = Request::get(black_box(address)).body(Body::empty());
                request.map(|request| ask(&runtime, &router, request))
            });
        });
    }
    group.finish();
    let mut group = criterion.benchmark_group("call");
    for (call, body) in CALLS {
        group.bench_function(call, |bencher| {
            bencher.iter(|| {
                let request = Request::post(format!("/api/{call}")).body(Body::from(black_box(body)));
                request.map(|request| ask(&runtime, &router, request))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, pages);
criterion_main!(benches);
