//! Courses as the pages of problems know them.

use std::sync::Arc;

use axum::Router;
use axum::http::HeaderMap;

use momentous_store::{Ill, StoreFault};
use momentous_web::{App, Awaited, Companion, Counts, Lane, SharedApp, Unreachable};

use super::routes::with_courses;
use super::state::Courses;
use super::visitor::Visitor;
use super::withheld::Withheld;

impl Companion for Courses {
    fn add_routes(self: Arc<Self>, router: Router<SharedApp>) -> Router<SharedApp> {
        with_courses(router, &self)
    }

    fn visitor<'a>(
        &'a self,
        app: &'a App,
        headers: &'a HeaderMap,
    ) -> Awaited<'a, Result<Box<dyn momentous_web::Visitor + 'a>, Unreachable>> {
        Box::pin(async move {
            let visitor =
                Visitor::at(&self.store, headers, self.clock.now()).await.map_err(|fault| unreachable(&fault))?;
            let reader: Box<dyn momentous_web::Visitor + 'a> = Box::new(Reader { courses: self, app, visitor });
            Ok(reader)
        })
    }

    fn stranger<'a>(&'a self, app: &'a App) -> Box<dyn momentous_web::Visitor + 'a> {
        Box::new(Reader { courses: self, app, visitor: None })
    }

    fn hidden_simulators(&self) -> Vec<&'static str> {
        self.hidden.simulators()
    }

    fn health(&self) -> Awaited<'_, Result<(), &'static str>> {
        Box::pin(async {
            self.store.health().await.map_err(|ill| match ill {
                Ill::Silent => "the database does not answer\n",
                Ill::TakesNothing => "the database takes nothing new\n",
            })
        })
    }

    fn counts(&self) -> Counts {
        Counts { reads: self.store.reads().0, attempts: self.store.handed_in() }
    }
}

/// Somebody who reads the pages of problems, known by a session or not.
struct Reader<'a> {
    courses: &'a Courses,
    app: &'a App,
    visitor: Option<Visitor>,
}

impl momentous_web::Visitor for Reader<'_> {
    fn lane(&self) -> Lane {
        if self.visitor.is_some() { Lane::SignedIn } else { Lane::Anyone }
    }

    fn withheld(&self) -> Awaited<'_, Result<Box<dyn momentous_pages::Withheld>, Unreachable>> {
        Box::pin(async {
            let withheld = Withheld::from(self.courses, self.app, self.visitor.as_ref())
                .await
                .map_err(|fault| unreachable(&fault))?;
            let withheld: Box<dyn momentous_pages::Withheld> = Box::new(withheld);
            Ok(withheld)
        })
    }

    fn withheld_in_simulators(&self) -> Awaited<'_, Box<dyn momentous_pages::Withheld>> {
        Box::pin(async {
            let withheld = Withheld::of_simulators(self.courses, self.app, self.visitor.as_ref()).await;
            let withheld: Box<dyn momentous_pages::Withheld> = Box::new(withheld);
            withheld
        })
    }
}

fn unreachable(fault: &StoreFault) -> Unreachable {
    Unreachable(fault.to_string())
}
