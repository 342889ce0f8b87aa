//! Assignments, their items, and more time for some.

use sqlx::Row;
use sqlx::any::AnyRow;
use sqlx::query;

use momentous_course::{Assignment, Correction, Course, Extension, Item, Key, Member, Moment, Reserved};

use super::fault::StoreFault;
use super::open::Store;
use super::records::{record, to_json};
use super::trail::Entry;
use super::writer::Statement;

/// An assignment and what it consists of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AssignmentWithItems {
    /// The assignment.
    pub assignment: Assignment,
    /// Its items, in their order.
    pub items: Vec<Item>,
    /// Grows with every change of it, of its items and of its extensions.
    pub revision: i64,
}

impl Store {
    /// Keeps an assignment with all its items, where it is new or is kept in the same revision; items that it had and has no more are
    /// taken away. Says whether it did: not where somebody has changed the assignment meanwhile, or it was pinned.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn save_assignment(&self, whole: &AssignmentWithItems, entry: &Entry) -> Result<bool, StoreFault> {
        let AssignmentWithItems { assignment, items, revision } = whole;
        let key = assignment.key.to_string();
        let mut statements =
            vec![save(assignment, *revision)?, query("DELETE FROM item WHERE assignment = $1").bind(key)];
        for item in items {
            statements.push(save_item(item)?);
        }
        statements.push(changed(assignment.key));
        statements.push(entry.statement()?);
        self.write_if(1, statements).await
    }

    /// Keeps items of an assignment as they became.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn save_items(&self, items: &[Item], entry: &Entry) -> Result<(), StoreFault> {
        let mut statements = items.iter().map(save_item).collect::<Result<Vec<_>, _>>()?;
        statements.extend(items.first().map(|item| changed(item.assignment)));
        statements.push(entry.statement()?);
        self.write(statements).await.map(|_| ())
    }

    /// The corrections of an assignment's items, in their order.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn corrections(&self, assignment: Key<Assignment>) -> Result<Vec<Correction>, StoreFault> {
        let statement = query(
            "SELECT d.data FROM decision d JOIN item i ON i.key = d.item WHERE i.assignment = $1 AND d.sheet IS NULL ORDER BY d.at, d.key",
        );
        self.records(statement.bind(assignment.to_string())).await
    }

    /// An assignment with its items.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn assignment(&self, key: Key<Assignment>) -> Result<Option<AssignmentWithItems>, StoreFault> {
        let statement = query("SELECT data, revision FROM assignment WHERE key = $1").bind(key.to_string());
        let rows = self.rows(statement).await?;
        let Some(row) = rows.first() else { return Ok(None) };
        let (assignment, revision) = (record(row)?, row.try_get(1)?);
        let statement = query("SELECT data FROM item WHERE assignment = $1").bind(key.to_string());
        let mut items: Vec<Item> = self.records(statement).await?;
        items.sort_by_key(|item| item.position);
        Ok(Some(AssignmentWithItems { assignment, items, revision }))
    }

    /// An item by its key.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn item(&self, key: Key<Item>) -> Result<Option<Item>, StoreFault> {
        self.one(query("SELECT data FROM item WHERE key = $1").bind(key.to_string())).await
    }

    /// The assignments of a course, by when they open.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn assignments(&self, course: Key<Course>) -> Result<Vec<Assignment>, StoreFault> {
        let statement = query("SELECT data FROM assignment WHERE course = $1 ORDER BY opens, key");
        self.records(statement.bind(course.to_string())).await
    }

    /// Every assignment whose problems are reserved at a moment, with its items and extensions.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn open_assignments(
        &self,
        now: Moment,
    ) -> Result<Vec<(AssignmentWithItems, Vec<Extension>)>, StoreFault> {
        let closed = Reserved::closed_since(now).millis();
        let open = "SELECT data, revision FROM assignment WHERE opens <= $1 AND closes >= $2 ORDER BY key";
        let rows = self.rows(query(open).bind(now.millis()).bind(closed)).await?;
        if rows.is_empty() {
            return Ok(Vec::new());
        }
        let items = "SELECT i.data FROM item i JOIN assignment a ON a.key = i.assignment WHERE a.opens <= $1 AND a.closes >= $2";
        let mut items: Vec<Item> = self.records(query(items).bind(now.millis()).bind(closed)).await?;
        items.sort_by_key(|item| item.position);
        let more = "SELECT e.data FROM extension e JOIN assignment a ON a.key = e.assignment WHERE a.opens <= $1 AND a.closes >= $2";
        let more: Vec<Extension> = self.records(query(more).bind(now.millis()).bind(closed)).await?;
        let whole = |row: &AnyRow| {
            let (assignment, revision): (Assignment, i64) = (record(row)?, row.try_get(1)?);
            let items = items.iter().filter(|item| item.assignment == assignment.key).cloned().collect();
            let extensions = more.iter().filter(|extension| extension.assignment == assignment.key).cloned().collect();
            Ok((AssignmentWithItems { assignment, items, revision }, extensions))
        };
        rows.iter().map(whole).collect()
    }

    /// Gives students more time, each with its entry in the trail: all of them, or none where the database refuses.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn extend(&self, extensions: &[(Extension, Entry)]) -> Result<(), StoreFault> {
        let mut statements = Vec::new();
        for (extension, entry) in extensions {
            let statement = query(
                "INSERT INTO extension (assignment, member, closes, data) VALUES ($1, $2, $3, $4) \
                 ON CONFLICT (assignment, member) DO UPDATE SET closes = excluded.closes, data = excluded.data",
            );
            let [assignment, member] = [extension.assignment.to_string(), extension.member.to_string()];
            let statement = statement.bind(assignment).bind(member);
            statements.push(statement.bind(extension.closes.millis()).bind(to_json(extension)?));
            statements.extend([changed(extension.assignment), entry.statement()?]);
        }
        self.write(statements).await.map(|_| ())
    }

    /// The extensions of an assignment.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn extensions(&self, assignment: Key<Assignment>) -> Result<Vec<Extension>, StoreFault> {
        let statement = query("SELECT data FROM extension WHERE assignment = $1 ORDER BY member");
        self.records(statement.bind(assignment.to_string())).await
    }

    /// The extensions of one student, in every assignment of the course.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn extensions_of(&self, member: Key<Member>) -> Result<Vec<Extension>, StoreFault> {
        let statement = query("SELECT data FROM extension WHERE member = $1 ORDER BY assignment");
        self.records(statement.bind(member.to_string())).await
    }

    /// The extension of one student.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn extension(
        &self,
        assignment: Key<Assignment>,
        member: Key<Member>,
    ) -> Result<Option<Extension>, StoreFault> {
        let statement = query("SELECT data FROM extension WHERE assignment = $1 AND member = $2");
        self.one(statement.bind(assignment.to_string()).bind(member.to_string())).await
    }
}

fn save(assignment: &Assignment, revision: i64) -> Result<Statement, StoreFault> {
    let statement = query(
        "INSERT INTO assignment (key, course, opens, closes, revision, data) VALUES ($1, $2, $3, $4, 0, $5) \
         ON CONFLICT (key) DO UPDATE SET opens = excluded.opens, closes = excluded.closes, data = excluded.data \
         WHERE assignment.revision = $6",
    );
    let [opens, closes] = [assignment.policy.opens, assignment.policy.closes].map(Moment::millis);
    let statement = statement.bind(assignment.key.to_string()).bind(assignment.course.to_string());
    Ok(statement.bind(opens).bind(closes).bind(to_json(assignment)?).bind(revision))
}

/// After a change: what was marked by the rules before is not handed in any more, and the latest close counts extensions in.
pub(super) fn changed(assignment: Key<Assignment>) -> Statement {
    let statement = query(
        "UPDATE assignment SET revision = revision + 1, \
         closes = (SELECT MAX(closing) FROM (SELECT assignment.closes AS closing \
         UNION ALL SELECT e.closes FROM extension e WHERE e.assignment = $1) AS every_close) WHERE key = $1",
    );
    statement.bind(assignment.to_string())
}

pub(super) fn save_item(item: &Item) -> Result<Statement, StoreFault> {
    let statement = query(
        "INSERT INTO item (key, assignment, problem, data) VALUES ($1, $2, $3, $4) \
         ON CONFLICT (key) DO UPDATE SET problem = excluded.problem, data = excluded.data",
    );
    let statement = statement.bind(item.key.to_string()).bind(item.assignment.to_string());
    Ok(statement.bind(item.problem.clone()).bind(to_json(item)?))
}
