//! The trail of who did what: added to, never changed.

use serde::{Deserialize, Serialize};
use sqlx::query;

use momentous_course::{Course, Key, Moment, Person};

use super::fault::StoreFault;
use super::open::Store;
use super::records::to_json;
use super::writer::Statement;

/// Something that somebody did.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Entry {
    /// The key by which the record is known.
    pub key: Key<Entry>,
    /// When.
    pub at: Moment,
    /// The person; `None` where it was the program itself.
    pub by: Option<Key<Person>>,
    /// The course, where it concerns one.
    pub course: Option<Key<Course>>,
    /// The deed, in a few words: `points set by hand`.
    pub what: String,
    /// To what, and why. It holds no name and no answer.
    pub detail: String,
}

impl Entry {
    pub(super) fn statement(&self) -> Result<Statement, StoreFault> {
        let statement = query("INSERT INTO trail (key, course, at, data) VALUES ($1, $2, $3, $4)");
        let course = self.course.map(|course| course.to_string());
        Ok(statement.bind(self.key.to_string()).bind(course).bind(self.at.millis()).bind(to_json(self)?))
    }
}

impl Store {
    /// The trail of a course, the latest first.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn trail(&self, course: Key<Course>, most: u32) -> Result<Vec<Entry>, StoreFault> {
        let statement = query("SELECT data FROM trail WHERE course = $1 ORDER BY at DESC, key LIMIT $2");
        self.records(statement.bind(course.to_string()).bind(i64::from(most))).await
    }
}
