//! The web application: a request in, a page out, by HTTP. The pages themselves are made without it, in `pages`.

pub mod answer;
mod app;
mod arrival;
mod companion;
mod connections;
mod explained;
mod headers;
mod health;
mod log;
mod metrics;
mod metrics_page;
mod observed;
mod page_faults;
mod routes;
pub mod sender;
mod server;
mod settings;
mod workers;

pub use app::{App, SharedApp};
pub use arrival::Arrival;
pub use companion::{Awaited, Companion, Counts, Unreachable, Visitor};
pub use metrics_page::metrics_router;
pub use page_faults::page_faults;
pub use routes::router;
pub use server::{NotServed, serve};
pub use settings::Settings;
pub use workers::{Lane, NotDone};
