//! A companion is served beside the pages of problems and may withhold some of them: the courses, which know these pages while
//! these pages know nothing of courses.

use std::fmt;
use std::pin::Pin;
use std::sync::Arc;

use axum::Router;
use axum::http::HeaderMap;

use momentous_pages::Withheld;

use super::app::{App, SharedApp};
use super::workers::Lane;

/// A result that is waited for.
pub type Awaited<'a, T> = Pin<Box<dyn Future<Output = T> + Send + 'a>>;

/// A companion of the pages of problems.
pub trait Companion: Send + Sync {
    /// Adds its addresses to those of the pages.
    fn add_routes(self: Arc<Self>, router: Router<SharedApp>) -> Router<SharedApp>;

    /// The person who asks, by what a browser sends along.
    fn visitor<'a>(
        &'a self,
        app: &'a App,
        headers: &'a HeaderMap,
    ) -> Awaited<'a, Result<Box<dyn Visitor + 'a>, Unreachable>>;

    /// Somebody who is not known.
    fn stranger<'a>(&'a self, app: &'a App) -> Box<dyn Visitor + 'a>;

    /// The simulators that no page leads to at the moment, by their names in addresses.
    fn hidden_simulators(&self) -> Vec<&'static str>;

    /// Whether it keeps what it is given; a line for whoever watches the server where it does not.
    fn health(&self) -> Awaited<'_, Result<(), &'static str>>;

    /// The numbers read and kept since the start.
    fn counts(&self) -> Counts;
}

/// How often something was read from the records, and how many attempts were kept.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Reads of the records.
    pub reads: u64,
    /// Attempts that were kept.
    pub attempts: u64,
}

/// A person who asks for a page.
pub trait Visitor: Send + Sync {
    /// The queue in which the person waits.
    fn lane(&self) -> Lane;

    /// The problems withheld from the person on the pages of problems.
    fn withheld(&self) -> Awaited<'_, Result<Box<dyn Withheld>, Unreachable>>;

    /// The problems withheld on the pages of simulators, which are shown whether or not the records can be reached.
    fn withheld_in_simulators(&self) -> Awaited<'_, Box<dyn Withheld>>;
}

/// The records that say what is withheld cannot be reached: the reason for the log.
#[derive(Debug)]
pub struct Unreachable(pub String);

impl fmt::Display for Unreachable {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}
