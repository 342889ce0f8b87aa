//! The visitor, known by the session that a browser sends along.

use axum::http::HeaderMap;

use momentous_course::{Course, Key, Moment, Person};
use momentous_store::{Membership, Reach, Store, StoreFault, TicketKind};

use super::cookie::Cookie;
use super::session;

/// Somebody who has signed in.
#[derive(Clone, Debug)]
pub(crate) struct Visitor {
    pub(super) person: Person,
    /// How far the session reaches.
    pub(super) reach: Reach,
    /// The hash of its token.
    pub(super) session: String,
}

impl Visitor {
    /// Whoever sends a request at a moment; nothing where nobody has signed in. A session of one course runs no server.
    pub(super) async fn at(store: &Store, headers: &HeaderMap, now: Moment) -> Result<Option<Self>, StoreFault> {
        let Some(session) = Cookie::Session.sent(headers).map(session::hash) else { return Ok(None) };
        let holder = store.holder(&session, TicketKind::Session, now).await?;
        Ok(holder.map(|(person, reach)| {
            let operator = person.operator && !matches!(reach, Reach::Course(_));
            Self { person: Person { operator, ..person }, reach, session }
        }))
    }

    /// Whether the session reaches into a course.
    pub(super) fn reaches(&self, course: Key<Course>) -> bool {
        match self.reach {
            Reach::All | Reach::Anew => true,
            Reach::Course(only) => only == course,
        }
    }

    /// The visitor's places in courses, as far as the session reaches.
    pub(super) async fn places(&self, store: &Store) -> Result<Vec<Membership>, StoreFault> {
        let all = store.courses_of(self.person.key).await?;
        Ok(all.into_iter().filter(|membership| self.reaches(membership.course.key)).collect())
    }
}
