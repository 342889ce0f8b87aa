//! The web application: a request in, a call of the engine, a page out. No physics and no marking stands here, nor in the
//! scripts of its pages: a browser draws what the engine computed.

mod again;
mod answer;
mod app;
mod arrival;
mod assets;
mod connections;
mod courses;
mod explained;
mod headers;
mod health;
pub mod invite;
mod library;
mod log;
mod metrics;
mod metrics_page;
mod observed;
mod page_faults;
mod pages;
mod parameters;
pub mod retention;
mod routes;
mod sender;
mod server;
mod settings;
mod view;
mod workers;

pub use app::App;
pub use courses::{Address, Clock, Courses, Who, addresses};
pub use metrics_page::metrics_router;
pub use page_faults::page_faults;
pub use routes::router;
pub use server::{NotServed, serve};
pub use settings::Settings;
