//! A corrected problem taken into an item, and attempts as they are marked now. What marking made of them before stays.

use sqlx::Row;
use sqlx::query;

use momentous_course::{Assignment, Attempt, Correction, HintShown, Item, Key, Override};

use super::assignments::{changed, save_item};
use super::fault::StoreFault;
use super::open::Store;
use super::records::to_json;
use super::sheets::set_points;
use super::trail::Entry;

/// A corrected problem taken into an item, in one step.
#[derive(Clone, Copy, Debug)]
pub struct Regrade<'a> {
    /// The item as it becomes.
    pub item: &'a Item,
    /// The correction.
    pub correction: &'a Correction,
    /// The attempts with what marking makes of them now.
    pub attempts: &'a [Attempt],
    /// The points that students keep because nobody was to have fewer.
    pub kept: &'a [(Key<Override>, Override)],
    /// The revision of the assignment by which this was worked out.
    pub revision: i64,
    /// How many attempts there were then at all sheets of the item.
    pub handed_in: i64,
}

impl Store {
    /// Takes a correction into an item, where nothing was changed or handed in since it was worked out. Says whether it did.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn regrade(&self, key: Key<Correction>, step: &Regrade<'_>, entry: &Entry) -> Result<bool, StoreFault> {
        let Regrade { item, correction, attempts, kept, revision, handed_in } = *step;
        // The first holds the assignment, so that nobody hands in any more; the second counts what was handed in until then.
        let held = query("UPDATE assignment SET revision = revision + 1 WHERE key = $1 AND revision = $2");
        let held = held.bind(item.assignment.to_string()).bind(revision);
        let counted = query(
            "UPDATE assignment SET revision = revision + 1 WHERE key = $1 AND $3 = \
             (SELECT COUNT(*) FROM attempt a JOIN sheet s ON s.key = a.sheet WHERE s.item = $2)",
        );
        let counted = counted.bind(item.assignment.to_string()).bind(item.key.to_string()).bind(handed_in);
        let decision = query("INSERT INTO decision (key, sheet, item, at, data) VALUES ($1, NULL, $2, $3, $4)");
        let decision = decision.bind(key.to_string()).bind(correction.item.to_string());
        let decision = decision.bind(correction.at.millis()).bind(to_json(correction)?);
        let mut statements = vec![held, counted, save_item(item)?, decision];
        for attempt in attempts {
            let (sheet, number) = (attempt.sheet.to_string(), i64::from(attempt.number));
            let before = query(
                "INSERT INTO marked_before (sheet, number, correction, data) \
                 SELECT sheet, number, CAST($3 AS TEXT), data FROM attempt WHERE sheet = $1 AND number = $2",
            );
            statements.push(before.bind(sheet.clone()).bind(number).bind(key.to_string()));
            let now = query("UPDATE attempt SET data = $3 WHERE sheet = $1 AND number = $2");
            statements.push(now.bind(sheet).bind(number).bind(to_json(attempt)?));
        }
        for (key, points) in kept {
            statements.push(set_points(*key, points)?);
        }
        statements.push(changed(item.assignment));
        statements.push(entry.statement()?);
        self.write_if(2, statements).await
    }

    /// The number of attempts at all sheets of an item.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn attempts_at(&self, item: Key<Item>) -> Result<i64, StoreFault> {
        let statement = query("SELECT COUNT(*) FROM attempt a JOIN sheet s ON s.key = a.sheet WHERE s.item = $1");
        let rows = self.rows(statement.bind(item.to_string())).await?;
        Ok(rows.first().map(|row| row.try_get(0)).transpose()?.unwrap_or(0))
    }

    /// Every attempt of an assignment, by sheet and in its order.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn all_attempts(&self, assignment: Key<Assignment>) -> Result<Vec<Attempt>, StoreFault> {
        let statement = query(
            "SELECT a.data FROM attempt a JOIN sheet s ON s.key = a.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 ORDER BY a.sheet, a.number",
        );
        self.records(statement.bind(assignment.to_string())).await
    }

    /// Every hint that was shown in an assignment.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn all_hints(&self, assignment: Key<Assignment>) -> Result<Vec<HintShown>, StoreFault> {
        let statement = query(
            "SELECT h.data FROM hint h JOIN sheet s ON s.key = h.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 ORDER BY h.sheet, h.part, h.number",
        );
        self.records(statement.bind(assignment.to_string())).await
    }
}
