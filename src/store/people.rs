//! People.

use sqlx::Row;
use sqlx::query;

use momentous_course::{Course, Key, Member, Person};

use super::fault::StoreFault;
use super::mail;
use super::open::Store;
use super::records::to_json;
use super::tickets::Ticket;
use super::trail::Entry;
use super::writer::Statement;

/// Somebody's place in a course.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Membership {
    /// The place.
    pub member: Member,
    /// The person who has it.
    pub person: Person,
    /// The course.
    pub course: Course,
}

impl Store {
    /// Whether nobody is known yet.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn is_empty(&self) -> Result<bool, StoreFault> {
        Ok(self.rows(query("SELECT 1 FROM person LIMIT 1")).await?.is_empty())
    }

    /// Adds people. [`StoreFault::is_taken`] where somebody signs in by that name already; then nobody is added.
    ///
    /// # Errors
    /// Where a name is taken.
    pub async fn add_people(&self, people: &[Person], entry: &Entry) -> Result<(), StoreFault> {
        let mut statements = people.iter().map(add).collect::<Result<Vec<_>, _>>()?;
        statements.push(entry.statement()?);
        self.write(statements).await.map(|_| ())
    }

    /// Keeps what became of a person.
    ///
    /// # Errors
    /// Where the name by which the person signs in is another's.
    pub async fn save_person(&self, person: &Person, entry: &Entry) -> Result<(), StoreFault> {
        self.write(vec![save(person)?, entry.statement()?]).await.map(|_| ())
    }

    /// Forgets who a person is, and lets nobody sign in as it. What it handed in stays, under its key.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn erase_person(&self, erased: &Person, entries: &[Entry]) -> Result<(), StoreFault> {
        let key = erased.key.to_string();
        let mut statements = vec![
            save(erased)?,
            query("DELETE FROM password WHERE person = $1").bind(key.clone()),
            query("DELETE FROM ticket WHERE person = $1").bind(key),
        ];
        statements.extend(mail::forget(erased.key));
        for entry in entries {
            statements.push(entry.statement()?);
        }
        self.write(statements).await.map(|_| ())
    }

    /// A person by its key.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn person(&self, key: Key<Person>) -> Result<Option<Person>, StoreFault> {
        self.one(query("SELECT data FROM person WHERE key = $1").bind(key.to_string())).await
    }

    /// A person by the name by which it signs in.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn person_named(&self, login: &str) -> Result<Option<Person>, StoreFault> {
        self.one(query("SELECT data FROM person WHERE login = $1").bind(login.to_owned())).await
    }

    /// Everybody, by name.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn people(&self) -> Result<Vec<Person>, StoreFault> {
        self.records(query("SELECT data FROM person WHERE login IS NOT NULL ORDER BY login")).await
    }

    /// The hash of a person's password, where it has one.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn password(&self, person: Key<Person>) -> Result<Option<String>, StoreFault> {
        let rows = self.rows(query("SELECT hash FROM password WHERE person = $1").bind(person.to_string())).await?;
        Ok(rows.first().map(|row| row.try_get(0)).transpose()?)
    }

    /// Keeps the hash of a person's password, and ends every session and link of that person but for a new session.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn set_password(
        &self,
        person: Key<Person>,
        hash: String,
        next: Option<Ticket>,
        entries: &[Entry],
    ) -> Result<(), StoreFault> {
        let tickets = query("DELETE FROM ticket WHERE person = $1").bind(person.to_string());
        let mut statements = vec![with_password(person, hash), tickets];
        statements.extend(next.map(Ticket::kept));
        for entry in entries {
            statements.push(entry.statement()?);
        }
        self.write(statements).await.map(|_| ())
    }
}

/// The name that must be unique; an erased person has none.
fn login(person: &Person) -> Option<String> {
    (!person.login.is_empty()).then(|| person.login.clone())
}

/// The hash of a person's password, in place of the one before.
pub(super) fn with_password(person: Key<Person>, hash: String) -> Statement {
    let statement = query(
        "INSERT INTO password (person, hash) VALUES ($1, $2) ON CONFLICT (person) DO UPDATE SET hash = excluded.hash",
    );
    statement.bind(person.to_string()).bind(hash)
}

/// A new person.
pub(super) fn add(person: &Person) -> Result<Statement, StoreFault> {
    let statement = query("INSERT INTO person (key, login, data) VALUES ($1, $2, $3)");
    Ok(statement.bind(person.key.to_string()).bind(login(person)).bind(to_json(person)?))
}

/// A person who may be there already, under its key.
pub(super) fn keep(person: &Person) -> Result<Statement, StoreFault> {
    let statement = query(
        "INSERT INTO person (key, login, data) VALUES ($1, $2, $3) \
         ON CONFLICT (key) DO UPDATE SET login = excluded.login, data = excluded.data",
    );
    Ok(statement.bind(person.key.to_string()).bind(login(person)).bind(to_json(person)?))
}

fn save(person: &Person) -> Result<Statement, StoreFault> {
    let statement = query("UPDATE person SET login = $2, data = $3 WHERE key = $1");
    Ok(statement.bind(person.key.to_string()).bind(login(person)).bind(to_json(person)?))
}
