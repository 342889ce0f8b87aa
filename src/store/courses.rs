//! Courses and who takes part in them.

use std::collections::BTreeSet;

use sqlx::Row;
use sqlx::any::AnyRow;
use sqlx::query;

use momentous_course::{Course, Key, Member, Person};

use super::fault::StoreFault;
use super::open::Store;
use super::people;
use super::people::Membership;
use super::records::{record, to_json};
use super::trail::Entry;
use super::writer::Statement;

impl Store {
    /// Adds a course with its first instructor.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn add_course(&self, course: &Course, first: &Member, entry: &Entry) -> Result<(), StoreFault> {
        let statement = query("INSERT INTO course (key, secret, data) VALUES ($1, $2, $3)");
        let statement = statement.bind(course.key.to_string()).bind(course.secret.clone()).bind(to_json(course)?);
        self.write(vec![statement, save(first)?, entry.statement()?]).await.map(|_| ())
    }

    /// Keeps what became of a course. Its secret stays.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn save_course(&self, course: &Course, entry: &Entry) -> Result<(), StoreFault> {
        let statement = query("UPDATE course SET data = $2 WHERE key = $1");
        let statement = statement.bind(course.key.to_string()).bind(to_json(course)?);
        self.write(vec![statement, entry.statement()?]).await.map(|_| ())
    }

    /// A course.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn course(&self, key: Key<Course>) -> Result<Option<Course>, StoreFault> {
        let statement = query("SELECT data, secret FROM course WHERE key = $1").bind(key.to_string());
        self.rows(statement).await?.first().map(|row| course(row, 0, 1)).transpose()
    }

    /// Every course.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn courses(&self) -> Result<Vec<Course>, StoreFault> {
        let statement = query("SELECT data, secret FROM course ORDER BY key");
        self.rows(statement).await?.iter().map(|row| course(row, 0, 1)).collect()
    }

    /// The courses in which a person takes part.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn courses_of(&self, person: Key<Person>) -> Result<Vec<Membership>, StoreFault> {
        let statement = query(
            "SELECT m.data, p.data AS person, c.data AS course, c.secret FROM member m JOIN person p ON p.key = m.person \
             JOIN course c ON c.key = m.course WHERE m.person = $1 ORDER BY c.key",
        );
        let all = self.memberships(statement.bind(person.to_string())).await?;
        Ok(all.into_iter().filter(|membership| membership.member.left.is_none()).collect())
    }

    /// A person's place in a course, where it has one.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn membership(&self, course: Key<Course>, person: Key<Person>) -> Result<Option<Membership>, StoreFault> {
        let statement = query(
            "SELECT m.data, p.data AS person, c.data AS course, c.secret FROM member m JOIN person p ON p.key = m.person \
             JOIN course c ON c.key = m.course WHERE m.course = $1 AND m.person = $2",
        );
        let memberships = self.memberships(statement.bind(course.to_string()).bind(person.to_string())).await?;
        Ok(memberships.into_iter().next().filter(|membership| membership.member.left.is_none()))
    }

    /// Everybody who takes part in a course, or did.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn members(&self, course: Key<Course>) -> Result<Vec<Membership>, StoreFault> {
        let statement = query(
            "SELECT m.data, p.data AS person, c.data AS course, c.secret FROM member m JOIN person p ON p.key = m.person \
             JOIN course c ON c.key = m.course WHERE m.course = $1 ORDER BY m.key",
        );
        self.memberships(statement.bind(course.to_string())).await
    }

    /// The places that those who take part in a course have in other courses.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn elsewhere(&self, course: Key<Course>) -> Result<Vec<Membership>, StoreFault> {
        let statement = query(
            "SELECT m.data, p.data AS person, c.data AS course, c.secret FROM member here \
             JOIN member m ON m.person = here.person AND m.course <> here.course JOIN person p ON p.key = m.person \
             JOIN course c ON c.key = m.course WHERE here.course = $1 ORDER BY m.key",
        );
        let all = self.memberships(statement.bind(course.to_string())).await?;
        Ok(all.into_iter().filter(|membership| membership.member.left.is_none()).collect())
    }

    /// Those in a course who have a password.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn with_password(&self, course: Key<Course>) -> Result<BTreeSet<Key<Person>>, StoreFault> {
        let statement = query(
            "SELECT p.data FROM member m JOIN person p ON p.key = m.person JOIN password w ON w.person = m.person WHERE m.course = $1",
        );
        let people: Vec<Person> = self.records(statement.bind(course.to_string())).await?;
        Ok(people.into_iter().map(|person| person.key).collect())
    }

    /// Keeps people, new or changed, and members, all or none.
    ///
    /// # Errors
    /// Where somebody else signs in by a person's name already: [`StoreFault::is_taken`].
    pub async fn save_members(&self, people: &[Person], members: &[Member], entry: &Entry) -> Result<(), StoreFault> {
        let people = people.iter().map(people::keep);
        let mut statements = people.chain(members.iter().map(save)).collect::<Result<Vec<_>, _>>()?;
        statements.push(entry.statement()?);
        self.write(statements).await.map(|_| ())
    }

    async fn memberships(&self, statement: Statement) -> Result<Vec<Membership>, StoreFault> {
        let extension = |row: &AnyRow| {
            let person = serde_json::from_str(row.try_get::<&str, _>(1)?)?;
            Ok(Membership { member: record(row)?, person, course: course(row, 2, 3)? })
        };
        self.rows(statement).await?.iter().map(extension).collect()
    }
}

/// A course, and its secret from a column of its own: what is written from a course never holds it.
fn course(row: &AnyRow, data: usize, secret: usize) -> Result<Course, StoreFault> {
    let course: Course = serde_json::from_str(row.try_get::<&str, _>(data)?)?;
    Ok(Course { secret: row.try_get(secret)?, ..course })
}

/// A member, new or changed.
pub(super) fn save(member: &Member) -> Result<Statement, StoreFault> {
    let statement = query(
        "INSERT INTO member (key, course, person, data) VALUES ($1, $2, $3, $4) ON CONFLICT (key) DO UPDATE SET data = excluded.data",
    );
    let [key, course, person] = [member.key.to_string(), member.course.to_string(), member.person.to_string()];
    Ok(statement.bind(key).bind(course).bind(person).bind(to_json(member)?))
}
