//! Sheets that students were given, and their hand-ins.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use sqlx::AssertSqlSafe;
use sqlx::Row;
use sqlx::any::AnyRow;
use sqlx::query;

use momentous_course::{Assignment, Attempt, Draft, HintShown, Item, Key, Member, Override, Sheet};

use super::address::Address;
use super::fault::StoreFault;
use super::open::Store;
use super::records::{record, to_json};
use super::trail::Entry;
use super::writer::Statement;

/// An attempt to be handed in, with what it was marked by.
#[derive(Clone, Copy, Debug)]
pub struct HandIn<'a> {
    /// The attempt; its number is one more than there were attempts before it.
    pub attempt: &'a Attempt,
    /// The assignment.
    pub assignment: Key<Assignment>,
    /// Its revision when the attempt was marked.
    pub revision: i64,
}

/// The fate of an attempt.
#[derive(Clone, Debug)]
pub enum HandedIn {
    /// It is kept.
    Kept,
    /// It was kept before: the request was repeated, and this is the attempt.
    Before(Box<Attempt>),
    /// Something was handed in or changed while it was marked; it has to be marked again.
    Stale,
}

impl Store {
    /// A student's sheet of an item, in one of its issues, where it was seen.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn sheet(&self, item: Key<Item>, member: Key<Member>, issue: u32) -> Result<Option<Sheet>, StoreFault> {
        let statement = query("SELECT data FROM sheet WHERE item = $1 AND member = $2 AND issue = $3");
        self.one(statement.bind(item.to_string()).bind(member.to_string()).bind(i64::from(issue))).await
    }

    /// Keeps a sheet as it is first seen. Where another request was faster its sheet stays: read it again.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn add_sheet(&self, sheet: &Sheet) -> Result<(), StoreFault> {
        self.add_sheets(std::slice::from_ref(sheet)).await
    }

    /// Keeps sheets, all or none; where a student has one of the item already, that one stays.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn add_sheets(&self, sheets: &[Sheet]) -> Result<(), StoreFault> {
        let add = |sheet: &Sheet| {
            let statement = query(
                "INSERT INTO sheet (key, item, member, issue, data) VALUES ($1, $2, $3, $4, $5) ON CONFLICT DO NOTHING",
            );
            let statement = statement.bind(sheet.key.to_string()).bind(sheet.item.to_string());
            Ok(statement.bind(sheet.member.to_string()).bind(i64::from(sheet.issue)).bind(to_json(sheet)?))
        };
        let statements: Result<Vec<_>, StoreFault> = sheets.iter().map(add).collect();
        self.write(statements?).await.map(|_| ())
    }

    /// A sheet by its key.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn sheet_by_key(&self, key: Key<Sheet>) -> Result<Option<Sheet>, StoreFault> {
        self.one(query("SELECT data FROM sheet WHERE key = $1").bind(key.to_string())).await
    }

    /// Every sheet of an assignment.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn sheets(&self, assignment: Key<Assignment>) -> Result<Vec<Sheet>, StoreFault> {
        let statement =
            query("SELECT s.data FROM sheet s JOIN item i ON i.key = s.item WHERE i.assignment = $1 ORDER BY s.key");
        self.records(statement.bind(assignment.to_string())).await
    }

    /// Every sheet of a student.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn sheets_of(&self, member: Key<Member>) -> Result<Vec<Sheet>, StoreFault> {
        self.records(query("SELECT data FROM sheet WHERE member = $1 ORDER BY key").bind(member.to_string())).await
    }

    /// The attempts handed in on a sheet, in their order.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn attempts(&self, sheet: Key<Sheet>) -> Result<Vec<Attempt>, StoreFault> {
        self.records(query("SELECT data FROM attempt WHERE sheet = $1 ORDER BY number").bind(sheet.to_string())).await
    }

    /// The attempts that a student handed in in an assignment, by sheet and in their order.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn attempts_of(
        &self,
        assignment: Key<Assignment>,
        member: Key<Member>,
    ) -> Result<BTreeMap<Key<Sheet>, Vec<Attempt>>, StoreFault> {
        let statement = query(
            "SELECT a.data FROM attempt a JOIN sheet s ON s.key = a.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 AND s.member = $2 ORDER BY a.sheet, a.number",
        );
        let all: Vec<Attempt> = self.records(statement.bind(assignment.to_string()).bind(member.to_string())).await?;
        let mut by_sheet: BTreeMap<Key<Sheet>, Vec<Attempt>> = BTreeMap::new();
        for attempt in all {
            by_sheet.entry(attempt.sheet).or_default().push(attempt);
        }
        Ok(by_sheet)
    }

    /// The last attempt of every sheet of an assignment: its report knows of those before.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn last_attempts(&self, assignment: Key<Assignment>) -> Result<Vec<Attempt>, StoreFault> {
        let statement = query(
            "SELECT a.data FROM attempt a JOIN sheet s ON s.key = a.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 AND a.number = (SELECT MAX(b.number) FROM attempt b WHERE b.sheet = a.sheet)",
        );
        self.records(statement.bind(assignment.to_string())).await
    }

    /// Hands an attempt in. In one step it takes its number, where nothing was handed in or changed since it was marked. When
    /// this returns [`HandedIn::Kept`], the attempt is on the disk.
    ///
    /// # Errors
    /// Where the database refuses; then nothing is kept.
    pub async fn hand_in(&self, hand_in: HandIn<'_>) -> Result<HandedIn, StoreFault> {
        let HandIn { attempt, assignment, revision } = hand_in;
        let [sheet, request] = [attempt.sheet.to_string(), attempt.request.clone()];
        let held = match self.address {
            // There is one writer.
            Address::Folder(_) => "",
            // Whoever changes the assignment through another server waits, or is waited for.
            Address::Postgres(_) => "FOR SHARE",
        };
        // A text of this file, of nothing that anybody typed.
        let statement = query(AssertSqlSafe(format!(
            "INSERT INTO attempt (sheet, number, request, data) \
             SELECT CAST($1 AS TEXT), CAST($2 AS BIGINT), CAST($3 AS TEXT), CAST($4 AS TEXT) \
             WHERE EXISTS (SELECT 1 FROM assignment WHERE key = $5 AND revision = $6 {held}) \
             AND (SELECT COUNT(*) FROM attempt WHERE sheet = $1) = CAST($2 AS BIGINT) - 1 \
             ON CONFLICT DO NOTHING",
        )));
        let statement = statement.bind(sheet.clone()).bind(i64::from(attempt.number)).bind(request.clone());
        let statement = statement.bind(to_json(attempt)?).bind(assignment.to_string()).bind(revision);
        if self.write(vec![statement]).await?.iter().sum::<u64>() > 0 {
            self.handed_in.fetch_add(1, Ordering::Relaxed);
            return Ok(HandedIn::Kept);
        }
        let before = query("SELECT data FROM attempt WHERE sheet = $1 AND request = $2").bind(sheet).bind(request);
        Ok(self.one(before).await?.map_or(HandedIn::Stale, |attempt| HandedIn::Before(Box::new(attempt))))
    }

    /// Takes the words out of attempts of one sheet, whose reports stay.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn redact(&self, redacted: &[Attempt], entry: &Entry) -> Result<(), StoreFault> {
        let mut statements = Vec::new();
        for attempt in redacted {
            let (sheet, number) = (attempt.sheet.to_string(), i64::from(attempt.number));
            let statement = query("UPDATE attempt SET data = $3 WHERE sheet = $1 AND number = $2");
            statements.push(statement.bind(sheet.clone()).bind(number).bind(to_json(attempt)?));
            // Earlier marks and a draft of the sheet may hold the same words.
            let before = query("DELETE FROM marked_before WHERE sheet = $1 AND number = $2");
            statements.push(before.bind(sheet).bind(number));
        }
        let drafts =
            redacted.first().map(|attempt| query("DELETE FROM draft WHERE sheet = $1").bind(attempt.sheet.to_string()));
        statements.extend(drafts);
        statements.push(entry.statement()?);
        self.write(statements).await.map(|_| ())
    }

    /// Keeps that a hint was shown; it costs once.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn show_hint(&self, hint: &HintShown) -> Result<(), StoreFault> {
        let statement =
            query("INSERT INTO hint (sheet, part, number, data) VALUES ($1, $2, $3, $4) ON CONFLICT DO NOTHING");
        let statement = statement.bind(hint.sheet.to_string()).bind(hint.part.clone().unwrap_or_default());
        self.write(vec![statement.bind(i64::from(hint.number)).bind(to_json(hint)?)]).await.map(|_| ())
    }

    /// The hints that were shown on a sheet.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn hints(&self, sheet: Key<Sheet>) -> Result<Vec<HintShown>, StoreFault> {
        let statement = query("SELECT data FROM hint WHERE sheet = $1 ORDER BY part, number");
        self.records(statement.bind(sheet.to_string())).await
    }

    /// Keeps what was typed and not handed in.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn save_draft(&self, draft: &Draft) -> Result<(), StoreFault> {
        let statement = query(
            "INSERT INTO draft (sheet, data) VALUES ($1, $2) ON CONFLICT (sheet) DO UPDATE SET data = excluded.data",
        );
        self.write(vec![statement.bind(draft.sheet.to_string()).bind(to_json(draft)?)]).await.map(|_| ())
    }

    /// The answers typed and not handed in.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn draft(&self, sheet: Key<Sheet>) -> Result<Option<Draft>, StoreFault> {
        self.one(query("SELECT data FROM draft WHERE sheet = $1").bind(sheet.to_string())).await
    }

    /// The answers typed and not handed in at an assignment, of everybody or of one student, each with its sheet.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn drafts(
        &self,
        assignment: Key<Assignment>,
        student: Option<Key<Member>>,
    ) -> Result<Vec<(Draft, Sheet)>, StoreFault> {
        let statement = query(
            "SELECT d.data, s.data FROM draft d JOIN sheet s ON s.key = d.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 AND (s.member = $2 OR $2 = '') ORDER BY d.sheet",
        );
        let student = student.map(|member| member.to_string()).unwrap_or_default();
        let both = |row: &AnyRow| Ok((record(row)?, serde_json::from_str(row.try_get::<&str, _>(1)?)?));
        self.rows(statement.bind(assignment.to_string()).bind(student)).await?.iter().map(both).collect()
    }

    /// Sets points by hand.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn set_points(&self, key: Key<Override>, points: &Override, entry: &Entry) -> Result<(), StoreFault> {
        self.write(vec![set_points(key, points)?, entry.statement()?]).await.map(|_| ())
    }

    /// The points that were set by hand in an assignment, in their order.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn set_by_hand(&self, assignment: Key<Assignment>) -> Result<Vec<Override>, StoreFault> {
        let statement = query(
            "SELECT d.data FROM decision d JOIN sheet s ON s.key = d.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 ORDER BY d.at, d.key",
        );
        self.records(statement.bind(assignment.to_string())).await
    }

    /// The points that were set by hand for one student in an assignment, in their order.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn set_by_hand_of(
        &self,
        assignment: Key<Assignment>,
        member: Key<Member>,
    ) -> Result<Vec<Override>, StoreFault> {
        let statement = query(
            "SELECT d.data FROM decision d JOIN sheet s ON s.key = d.sheet JOIN item i ON i.key = s.item \
             WHERE i.assignment = $1 AND s.member = $2 ORDER BY d.at, d.key",
        );
        self.records(statement.bind(assignment.to_string()).bind(member.to_string())).await
    }
}

pub(super) fn set_points(key: Key<Override>, points: &Override) -> Result<Statement, StoreFault> {
    let statement = query("INSERT INTO decision (key, sheet, item, at, data) VALUES ($1, $2, NULL, $3, $4)");
    let statement = statement.bind(key.to_string()).bind(points.sheet.to_string()).bind(points.at.millis());
    Ok(statement.bind(to_json(points)?))
}
