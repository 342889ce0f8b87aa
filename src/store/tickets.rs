//! Tickets that let somebody in: sessions, and links that sign in once. Only a hash of each is kept.

use sqlx::Row;
use sqlx::query;

use momentous_course::{Course, Key, Moment, Person};

use super::fault::StoreFault;
use super::open::Store;
use super::records::record;
use super::trail::Entry;
use super::writer::Statement;

/// The kind of a ticket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TicketKind {
    /// Its holder is somebody, request after request.
    Session,
    /// Its holder signs in once.
    Link,
}

/// How far a ticket reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// To everything that the person may do.
    All,
    /// To the same, and to a new password without the old one.
    Anew,
    /// To one course, and to nothing that belongs to the person elsewhere, too.
    Course(Key<Course>),
}

impl TicketKind {
    const fn name(self) -> &'static str {
        match self {
            Self::Session => "session",
            Self::Link => "link",
        }
    }

    /// How the database names tickets of this kind that reach so far.
    fn reaching(self, reach: Reach) -> String {
        let name = self.name();
        match reach {
            Reach::All => name.to_owned(),
            Reach::Anew => format!("{name} anew"),
            Reach::Course(course) => format!("{name} {course}"),
        }
    }

    /// How far a ticket reaches that the database names so; nothing where it is none of this kind.
    fn reach(self, kept: &str) -> Option<Reach> {
        match kept.strip_prefix(self.name())? {
            "" => Some(Reach::All),
            " anew" => Some(Reach::Anew),
            course => Some(Reach::Course(course.strip_prefix(' ')?.parse().ok()?)),
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
    /// Its kind.
    pub kind: TicketKind,
    /// How far it reaches.
    pub reach: Reach,
    /// When it ends.
    pub expires: Moment,
}

impl Ticket {
    pub(super) fn kept(self) -> Statement {
        query("INSERT INTO ticket (hash, person, kind, expires) VALUES ($1, $2, $3, $4)")
            .bind(self.hash)
            .bind(self.person.to_string())
            .bind(self.kind.reaching(self.reach))
            .bind(self.expires.millis())
    }

    /// The statement that ends the tickets which a new link ends: earlier ones of the same course, or all where it is the
    /// operator's.
    fn ended(&self) -> Option<Statement> {
        let person = self.person.to_string();
        match (self.kind, self.reach) {
            (TicketKind::Session, _) => None,
            (TicketKind::Link, Reach::Course(_)) => {
                let query = query("DELETE FROM ticket WHERE person = $1 AND kind = $2");
                Some(query.bind(person).bind(self.kind.reaching(self.reach)))
            }
            (TicketKind::Link, Reach::All | Reach::Anew) => {
                Some(query("DELETE FROM ticket WHERE person = $1 AND kind LIKE 'link%'").bind(person))
            }
        }
    }
}

impl Store {
    /// Keeps tickets, and forgets those that have ended. A new link ends earlier ones.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn add_tickets(&self, tickets: Vec<Ticket>, now: Moment, entries: &[Entry]) -> Result<(), StoreFault> {
        let mut statements = vec![query("DELETE FROM ticket WHERE expires <= $1").bind(now.millis())];
        statements.extend(tickets.iter().filter_map(Ticket::ended));
        statements.extend(tickets.into_iter().map(Ticket::kept));
        for entry in entries {
            statements.push(entry.statement()?);
        }
        self.write(statements).await.map(|_| ())
    }

    /// Whose ticket it is and how far it reaches, where it is of this kind and has not ended.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn holder(
        &self,
        hash: &str,
        kind: TicketKind,
        now: Moment,
    ) -> Result<Option<(Person, Reach)>, StoreFault> {
        let statement = query(
            "SELECT p.data, t.kind FROM ticket t JOIN person p ON p.key = t.person WHERE t.hash = $1 AND t.expires > $2",
        );
        let rows = self.rows(statement.bind(hash.to_owned()).bind(now.millis())).await?;
        let Some(row) = rows.first() else { return Ok(None) };
        let kept: String = row.try_get(1)?;
        kind.reach(&kept).map(|reach| Ok((record(row)?, reach))).transpose()
    }

    /// Takes a ticket away, and gives another for it where there is one. Of several who try at once one is told that it was there.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn take_ticket(&self, hash: &str, next: Option<Ticket>, entries: &[Entry]) -> Result<bool, StoreFault> {
        let mut statements = vec![query("DELETE FROM ticket WHERE hash = $1").bind(hash.to_owned())];
        statements.extend(next.map(Ticket::kept));
        for entry in entries {
            statements.push(entry.statement()?);
        }
        self.write_if(1, statements).await
    }
}
