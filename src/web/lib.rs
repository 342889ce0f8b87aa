//! The web application: a request in, a call of the engine, a page out. No physics and no marking stands here, nor in the
//! scripts of its pages: a browser draws what the engine computed.

mod again;
pub mod answer;
mod app;
mod arrival;
mod assets;
mod companion;
mod connections;
mod explained;
mod headers;
mod health;
mod library;
mod log;
mod metrics;
mod metrics_page;
mod observed;
mod page_faults;
mod pages;
mod parameters;
mod routes;
pub mod sender;
mod server;
mod settings;
mod view;
pub mod words;
mod workers;

pub use again::Again;
pub use app::{App, SharedApp};
pub use arrival::Arrival;
pub use companion::{Awaited, Companion, Counts, Unreachable, Visitor, Withheld};
pub use library::Library;
pub use metrics_page::metrics_router;
pub use page_faults::page_faults;
pub use parameters::Parameters;
pub use routes::router;
pub use server::{NotServed, serve};
pub use settings::Settings;
pub use workers::{Lane, NotDone};
