//! Retention of answers in courses, and its end: for their instructors, and for whoever has the data.

use momentous_course::{Course, Moment};
use momentous_store::{Entry, Records, Store, StoreFault};

use super::clock::Clock;
use super::session;

/// The data that a course keeps of answers, and their end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Retained {
    /// The course.
    pub course: Course,
    /// When its last assignment closes for anybody.
    pub closes: Option<Moment>,
    /// Until when it keeps answers; nothing where it does so without end, or has no assignment.
    pub until: Option<Moment>,
    /// Whether they have been kept long enough.
    pub is_over: bool,
    /// How much there is.
    pub records: Records,
}

impl Retained {
    /// The data that a course keeps at a moment.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn of(store: &Store, course: Course, now: Moment) -> Result<Self, StoreFault> {
        let closes = store.last_close(course.key).await?;
        let until = closes.and_then(|closes| course.keeps_until(closes));
        let records = store.records_of(course.key).await?;
        Ok(Self { closes, until, is_over: until.is_some_and(|until| now > until), records, course })
    }

    /// The data that each course keeps.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn all(store: &Store, clock: &Clock) -> Result<Vec<Self>, StoreFault> {
        let mut all = Vec::new();
        for course in store.courses().await? {
            all.push(Self::of(store, course, clock.now()).await?);
        }
        Ok(all)
    }

    /// Deletes it, where it has been kept long enough, from outside the pages.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn forget(&self, store: &Store, clock: &Clock) -> Result<(), StoreFault> {
        if !self.is_over {
            return Ok(());
        }
        let (key, at, course) = (session::key(), clock.now(), Some(self.course.key));
        let entry = Entry { key, at, by: None, course, what: DELETED.to_owned(), detail: self.detail() };
        store.forget_answers(self.course.key, &entry).await
    }

    /// How much there is, in words.
    #[must_use]
    pub fn detail(&self) -> String {
        let many = |count: i64, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
        format!("{} with {}", many(self.records.sheets, "sheet"), many(self.records.attempts, "attempt"))
    }
}

/// The name of the deletion in the trail.
pub(super) const DELETED: &str = "answers deleted";
