//! The addresses of people, and links to sign in that were sent there.

use std::collections::HashMap;

use sqlx::query;
use sqlx::{Row, any::AnyRow};

use momentous_course::{Key, MailAddress, Moment, Person};

use super::fault::StoreFault;
use super::open::Store;
use super::records::record;
use super::tickets::Ticket;
use super::trail::Entry;
use super::writer::Statement;

/// A link that was sent to an address. Whoever opens it in the browser that asked for it is the person, and reads letters to the address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MailedLink {
    /// The hash of the link's token and of the browser's.
    pub hash: String,
    /// The person who signs in by it.
    pub person: Key<Person>,
    /// The address to which it was sent.
    pub address: MailAddress,
    /// When it ends.
    pub expires: Moment,
}

impl Store {
    /// The address of a person, where one is known.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn mail_address(&self, person: Key<Person>) -> Result<Option<MailAddress>, StoreFault> {
        let statement = query("SELECT address FROM mail_address WHERE person = $1").bind(person.to_string());
        Ok(self.rows(statement).await?.first().and_then(|row| address(row, 0)))
    }

    /// The addresses of all people who have one.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn mail_addresses(&self) -> Result<HashMap<Key<Person>, MailAddress>, StoreFault> {
        let rows = self.rows(query("SELECT person, address FROM mail_address")).await?;
        let read = |row: &AnyRow| {
            let person: String = row.try_get(0).ok()?;
            Some((person.parse().ok()?, address(row, 1)?))
        };
        Ok(rows.iter().filter_map(read).collect())
    }

    /// Those who have an address. More than one person may: nobody but them reads what is sent there.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn people_at(&self, address: &MailAddress) -> Result<Vec<Person>, StoreFault> {
        let statement = query(
            "SELECT p.data FROM mail_address m JOIN person p ON p.key = m.person WHERE m.address = $1 ORDER BY p.key",
        );
        self.records(statement.bind(address.to_string())).await
    }

    /// Gives a person an address in place of the one before, or none. Links that were sent before end.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn set_mail_address(
        &self,
        person: Key<Person>,
        address: Option<&MailAddress>,
        entries: &[Entry],
    ) -> Result<(), StoreFault> {
        let mut statements = Vec::from(forget(person));
        statements.extend(address.map(|address| keep(person, address)));
        for entry in entries {
            statements.push(entry.statement()?);
        }
        self.write(statements).await.map(|_| ())
    }

    /// Keeps links that are about to be sent, and forgets those that have ended.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn add_mailed_links(&self, links: Vec<MailedLink>, now: Moment) -> Result<(), StoreFault> {
        let mut statements = vec![query("DELETE FROM mailed_link WHERE expires <= $1").bind(now.millis())];
        statements.extend(links.into_iter().map(|link| {
            let statement = query("INSERT INTO mailed_link (hash, person, address, expires) VALUES ($1, $2, $3, $4)");
            let statement = statement.bind(link.hash).bind(link.person.to_string());
            statement.bind(link.address.to_string()).bind(link.expires.millis())
        }));
        self.write(statements).await.map(|_| ())
    }

    /// Whose link it is and where it was sent, where it has not ended.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn mailed_link(&self, hash: &str, now: Moment) -> Result<Option<(Person, MailAddress)>, StoreFault> {
        let statement = query(
            "SELECT p.data, m.address FROM mailed_link m JOIN person p ON p.key = m.person \
             WHERE m.hash = $1 AND m.expires > $2",
        );
        let rows = self.rows(statement.bind(hash.to_owned()).bind(now.millis())).await?;
        let Some(row) = rows.first() else { return Ok(None) };
        let person = record(row)?;
        Ok(address(row, 1).map(|address| (person, address)))
    }

    /// Takes a link away, and gives a session for it: its address is the person's from now on, and other links that were sent to the
    /// person end. Of several who try at once one is told that it was there.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn take_mailed_link(
        &self,
        hash: &str,
        address: &MailAddress,
        session: Ticket,
        entries: &[Entry],
    ) -> Result<bool, StoreFault> {
        let person = session.person;
        let mut statements = vec![query("DELETE FROM mailed_link WHERE hash = $1").bind(hash.to_owned())];
        statements.extend(forget(person));
        statements.extend([keep(person, address), session.kept()]);
        for entry in entries {
            statements.push(entry.statement()?);
        }
        self.write_if(1, statements).await
    }
}

/// The address in a column of a row.
fn address(row: &AnyRow, column: usize) -> Option<MailAddress> {
    let text: String = row.try_get(column).ok()?;
    MailAddress::read(&text).ok()
}

/// The address of a person who has none.
fn keep(person: Key<Person>, address: &MailAddress) -> Statement {
    query("INSERT INTO mail_address (person, address) VALUES ($1, $2)")
        .bind(person.to_string())
        .bind(address.to_string())
}

/// The statements that end with a person's address.
pub(super) fn forget(person: Key<Person>) -> [Statement; 2] {
    let person = person.to_string();
    [
        query("DELETE FROM mail_address WHERE person = $1").bind(person.clone()),
        query("DELETE FROM mailed_link WHERE person = $1").bind(person),
    ]
}
