//! What lets somebody in: sessions, and links that sign in once. Only a hash of each is kept.

use sqlx::query;

use crate::course::{Key, Moment, Person};

use super::fault::StoreFault;
use super::open::Store;
use super::trail::Entry;

/// What a ticket lets somebody do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TicketKind {
    /// Be somebody, request after request.
    Session,
    /// Sign in once.
    Link,
}

impl TicketKind {
    const fn name(self) -> &'static str {
        match self {
            Self::Session => "session",
            Self::Link => "link",
        }
    }
}

/// A ticket as it is kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ticket {
    /// The hash of what the person holds.
    pub hash: String,
    /// Whose it is.
    pub person: Key<Person>,
    /// What it lets that person do.
    pub kind: TicketKind,
    /// When it ends.
    pub expires: Moment,
}

impl Store {
    /// Keeps tickets, and forgets those that have ended.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn add_tickets(
        &self,
        tickets: Vec<Ticket>,
        now: Moment,
        entry: Option<&Entry>,
    ) -> Result<(), StoreFault> {
        let mut statements = vec![query("DELETE FROM ticket WHERE expires <= $1").bind(now.millis())];
        statements.extend(tickets.into_iter().map(|ticket| {
            query("INSERT INTO ticket (hash, person, kind, expires) VALUES ($1, $2, $3, $4)")
                .bind(ticket.hash)
                .bind(ticket.person.to_string())
                .bind(ticket.kind.name())
                .bind(ticket.expires.millis())
        }));
        statements.extend(entry.map(Entry::statement).transpose()?);
        self.write(statements).await.map(|_| ())
    }

    /// Whose ticket it is, where it has not ended.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn holder(&self, hash: &str, kind: TicketKind, now: Moment) -> Result<Option<Person>, StoreFault> {
        let statement = query(
            "SELECT p.data FROM ticket t JOIN person p ON p.key = t.person WHERE t.hash = $1 AND t.kind = $2 AND t.expires > $3",
        );
        self.one(statement.bind(hash.to_owned()).bind(kind.name()).bind(now.millis())).await
    }

    /// Takes a ticket away. Of several who try at once one is told that it was there.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn take_ticket(&self, hash: &str) -> Result<bool, StoreFault> {
        let statement = query("DELETE FROM ticket WHERE hash = $1").bind(hash.to_owned());
        Ok(self.write(vec![statement]).await?.iter().sum::<u64>() > 0)
    }
}
