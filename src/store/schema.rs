//! The tables, and how those of an earlier version become those of this one.

use sqlx::AnyConnection;
use sqlx::Row;

use super::fault::StoreFault;

/// The statements that lead from each version to the next, the first from nothing. A row is never changed once a version with it was released.
const STEPS: [(i64, &str); 4] = [
    (1, include_str!("schema/1.sql")),
    (2, include_str!("schema/2.sql")),
    (3, include_str!("schema/3.sql")),
    (4, include_str!("schema/4.sql")),
];

/// Every table, each after those that it speaks of: the order of a backup.
pub(super) const TABLES: [(&str, &str); 21] = [
    ("person", "key, login, data"),
    ("password", "person, hash"),
    ("ticket", "hash, person, kind, expires"),
    ("mail_address", "person, address"),
    ("mailed_link", "hash, person, address, expires"),
    ("course", "key, secret, data"),
    ("member", "key, course, person, data"),
    ("course_code", "course, code, expires, data"),
    ("place_request", "key, course, at, data"),
    ("problem_file", "course, digest, problem, data"),
    ("assignment", "key, course, opens, closes, revision, data"),
    ("item", "key, assignment, problem, data"),
    ("extension", "assignment, member, closes, data"),
    ("sheet", "key, item, member, issue, data"),
    ("attempt", "sheet, number, request, data"),
    ("marked_before", "sheet, number, correction, data"),
    ("hint", "sheet, part, number, data"),
    ("draft", "sheet, data"),
    ("decision", "key, sheet, item, at, data"),
    ("trail", "key, course, at, data"),
    ("allowance", "key, free_at"),
];

/// The version of the tables of this program.
pub(super) const VERSION: i64 = STEPS[STEPS.len() - 1].0;

/// Brings the tables to this version, in one transaction.
pub(super) async fn migrate(connection: &mut AnyConnection) -> Result<(), StoreFault> {
    let create = "CREATE TABLE IF NOT EXISTS version (number BIGINT NOT NULL)";
    sqlx::raw_sql(create).execute(&mut *connection).await?;
    let row = sqlx::query("SELECT MAX(number) FROM version").fetch_one(&mut *connection).await?;
    let version_found: i64 = row.try_get::<Option<i64>, _>(0)?.unwrap_or(0);
    if version_found > VERSION {
        return Err(StoreFault::Newer { found: version_found, known: VERSION });
    }
    for (number, step) in STEPS.into_iter().filter(|(number, _)| *number > version_found) {
        sqlx::raw_sql(step).execute(&mut *connection).await?;
        sqlx::query("INSERT INTO version (number) VALUES ($1)").bind(number).execute(&mut *connection).await?;
    }
    Ok(())
}
