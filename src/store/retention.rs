//! How much is kept of what students handed in, and its end.

use serde::Serialize;
use sqlx::Row;
use sqlx::query;

use momentous_course::{Course, Key, Moment};

use super::fault::StoreFault;
use super::open::Store;
use super::trail::Entry;

/// How much is kept of what students handed in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Records {
    /// Sheets.
    pub sheets: i64,
    /// Attempts at them.
    pub attempts: i64,
    /// Points set by hand.
    pub by_hand: i64,
}

/// The sheets of a course.
const SHEETS: &str = "SELECT s.key FROM sheet s JOIN item i ON i.key = s.item JOIN assignment t ON t.key = i.assignment \
    WHERE t.course = $1";

impl Store {
    /// How much a course keeps.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn records_of(&self, course: Key<Course>) -> Result<Records, StoreFault> {
        let count = async |from: &str| -> Result<i64, StoreFault> {
            // A text of this file, of nothing that anybody typed.
            let text = format!("SELECT COUNT(*) FROM {from} IN ({SHEETS})");
            let rows = self.rows(query(sqlx::AssertSqlSafe(text)).bind(course.to_string())).await?;
            Ok(rows.first().map(|row| row.try_get(0)).transpose()?.unwrap_or(0))
        };
        Ok(Records {
            sheets: count("sheet WHERE key").await?,
            attempts: count("attempt WHERE sheet").await?,
            by_hand: count("decision WHERE sheet").await?,
        })
    }

    /// When the last assignment of a course closes for anybody, where it has one.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn last_close(&self, course: Key<Course>) -> Result<Option<Moment>, StoreFault> {
        let rows =
            self.rows(query("SELECT MAX(closes) FROM assignment WHERE course = $1").bind(course.to_string())).await?;
        let closes: Option<i64> = rows.first().map(|row| row.try_get(0)).transpose()?.flatten();
        Ok(closes.map(Moment::from_millis))
    }

    /// Deletes what the students of a course handed in: sheets, attempts, drafts, hints and points set by hand.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn forget_answers(&self, course: Key<Course>, entry: &Entry) -> Result<(), StoreFault> {
        let of_sheets = ["attempt", "marked_before", "hint", "draft", "decision"].map(|table| (table, "sheet"));
        let statement = |(table, column): (&str, &str)| {
            let text = format!("DELETE FROM {table} WHERE {column} IN ({SHEETS})");
            query(sqlx::AssertSqlSafe(text)).bind(course.to_string())
        };
        let mut statements: Vec<_> = of_sheets.into_iter().chain([("sheet", "key")]).map(statement).collect();
        statements.push(entry.statement()?);
        self.write(statements).await.map(|_| ())
    }
}
