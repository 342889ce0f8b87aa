//! Codes with which people ask for a place in a course, and who has asked.

use sqlx::{Row, query};

use momentous_course::{Code, Course, CourseCode, Key, Member, Moment, Person, PlaceRequest};

use super::courses;
use super::fault::StoreFault;
use super::open::Store;
use super::people;
use super::records::to_json;
use super::trail::Entry;

/// The milliseconds for which a request waits: a month.
const WAITS: i64 = 30 * 86_400_000;

impl Store {
    /// Keeps the code of a course, in place of the one before.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn save_code(&self, code: &CourseCode, entry: &Entry) -> Result<(), StoreFault> {
        let statement = query(
            "INSERT INTO course_code (course, code, expires, data) VALUES ($1, $2, $3, $4) \
             ON CONFLICT (course) DO UPDATE SET code = excluded.code, expires = excluded.expires, data = excluded.data",
        );
        let statement = statement.bind(code.course.to_string()).bind(code.code.plain().to_owned());
        let statement = statement.bind(code.expires.millis()).bind(to_json(code)?);
        self.write(vec![statement, entry.statement()?]).await.map(|_| ())
    }

    /// Ends the code of a course. Whoever has asked already still waits.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn end_code(&self, course: Key<Course>, entry: &Entry) -> Result<(), StoreFault> {
        let statement = query("DELETE FROM course_code WHERE course = $1").bind(course.to_string());
        self.write(vec![statement, entry.statement()?]).await.map(|_| ())
    }

    /// The code of a course, where it has one that has not ended.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn code_of(&self, course: Key<Course>, now: Moment) -> Result<Option<CourseCode>, StoreFault> {
        let statement = query("SELECT data FROM course_code WHERE course = $1 AND expires > $2");
        self.one(statement.bind(course.to_string()).bind(now.millis())).await
    }

    /// The course of a code that has not ended.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn course_of_code(&self, code: &Code, now: Moment) -> Result<Option<Key<Course>>, StoreFault> {
        let statement = query("SELECT data FROM course_code WHERE code = $1 AND expires > $2");
        let code: Option<CourseCode> = self.one(statement.bind(code.plain().to_owned()).bind(now.millis())).await?;
        Ok(code.map(|code| code.course))
    }

    /// Keeps a request for a place, and forgets those that have waited for a month.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn ask_for_place(&self, request: &PlaceRequest) -> Result<(), StoreFault> {
        let forgotten = query("DELETE FROM place_request WHERE at <= $1").bind(request.at.after(-WAITS).millis());
        let statement = query("INSERT INTO place_request (key, course, at, data) VALUES ($1, $2, $3, $4)");
        let statement = statement.bind(request.key.to_string()).bind(request.course.to_string());
        self.write(vec![forgotten, statement.bind(request.at.millis()).bind(to_json(request)?)]).await.map(|_| ())
    }

    /// Those who wait for a place in a course, the first first.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn place_requests(&self, course: Key<Course>) -> Result<Vec<PlaceRequest>, StoreFault> {
        let statement = query("SELECT data FROM place_request WHERE course = $1 ORDER BY at, key");
        self.records(statement.bind(course.to_string())).await
    }

    /// How many wait for a place in a course.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn waiting(&self, course: Key<Course>) -> Result<i64, StoreFault> {
        let statement = query("SELECT COUNT(*) FROM place_request WHERE course = $1").bind(course.to_string());
        let rows = self.rows(statement).await?;
        Ok(rows.first().map(|row| row.try_get(0)).transpose()?.unwrap_or_default())
    }

    /// Takes requests away, and keeps the people who come into the course by them, each new one with the hash of a password. Nothing is
    /// done, and the result says so, where one of the requests is no longer there.
    ///
    /// # Errors
    /// Where somebody signs in by a person's name already: [`StoreFault::is_taken`].
    pub async fn settle_requests(
        &self,
        requests: &[Key<PlaceRequest>],
        people: &[(Person, String)],
        members: &[Member],
        entry: &Entry,
    ) -> Result<bool, StoreFault> {
        let settled = |key: &Key<_>| query("DELETE FROM place_request WHERE key = $1").bind(key.to_string());
        let mut statements: Vec<_> = requests.iter().map(settled).collect();
        for (person, password) in people {
            statements.push(people::add(person)?);
            statements.push(people::with_password(person.key, password.clone()));
        }
        for member in members {
            statements.push(courses::save(member)?);
        }
        statements.push(entry.statement()?);
        self.write_if(requests.len(), statements).await
    }
}
