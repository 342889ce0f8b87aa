//! Several servers over one database: each sees what the others have done, and finds the database again where it was away.

use std::collections::BTreeMap;

use momentous::course::{Correction, CorrectionChoice, Draft, Key, Moment};
use momentous::store::sqlx;
use momentous::store::sqlx::{AnyConnection, Executor, Row};
use momentous::store::{AssignmentWithItems, HandIn, HandedIn, Inspection, Regrade};
use tokio::task::JoinHandle;

use super::NOW;
use super::database::{Database, on_both, postgres_with};
use super::sample::Sample;

/// Another server's transaction, which has not ended yet.
async fn other(database: &Database, statements: &[String]) -> AnyConnection {
    let mut connection = database.connection().await;
    connection.execute("BEGIN").await.unwrap();
    for statement in statements {
        connection.execute(sqlx::raw_sql(sqlx::AssertSqlSafe(statement.clone()))).await.unwrap();
    }
    connection
}

async fn number(connection: &mut AnyConnection, statement: &'static str) -> i64 {
    connection.fetch_one(statement).await.unwrap().try_get(0).unwrap()
}

/// Returns once a work waits for the other transaction, or has not waited for it.
async fn until_it_waits<T>(database: &Database, work: &JoinHandle<T>) {
    let mut connection = database.connection().await;
    let waiting =
        "SELECT COUNT(*) FROM pg_stat_activity WHERE datname = current_database() AND wait_event_type = 'Lock'";
    while !work.is_finished() && number(&mut connection, waiting).await == 0 {}
}

#[test]
fn nothing_is_handed_in_while_another_server_changes_the_rules() {
    on_both(async |database| {
        let Database::Postgres(_) = database else { return };
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let (revision, assignment) = (sample.revision(&store).await, sample.whole.assignment.key);
        let change = format!("UPDATE assignment SET revision = revision + 1 WHERE key = '{assignment}'");
        let mut changing = other(database, &[change]).await;
        let (attempt, held) = (sample.attempt(1, "a"), store.clone());
        let handed_in =
            tokio::spawn(
                async move { held.hand_in(HandIn { attempt: &attempt, assignment, revision }).await.unwrap() },
            );
        until_it_waits(database, &handed_in).await;
        changing.execute("COMMIT").await.unwrap();
        assert!(matches!(handed_in.await.unwrap(), HandedIn::Stale));
        assert!(store.attempts(sample.sheet.key).await.unwrap().is_empty());
    });
}

#[test]
fn a_correction_waits_for_what_is_handed_in_through_another_server() {
    on_both(async |database| {
        let Database::Postgres(_) = database else { return };
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let revision = sample.revision(&store).await;
        let hold = format!("SELECT 1 FROM assignment WHERE key = '{}' FOR SHARE", sample.whole.assignment.key);
        let add = format!(
            "INSERT INTO attempt (sheet, number, request, data) VALUES ('{}', 1, 'a', '{}')",
            sample.sheet.key,
            serde_json::to_string(&sample.attempt(1, "a")).unwrap()
        );
        let mut handing_in = other(database, &[hold, add]).await;
        let (held, item, entry) = (store.clone(), sample.whole.items[0].clone(), sample.entry(80));
        let (from, to, choice) = ("a".to_owned(), "b".to_owned(), CorrectionChoice::Remark);
        let (reason, comment, never_lower) = (String::new(), String::new(), false);
        let correction = Correction { item: item.key, from, to, choice, never_lower, reason, comment, at: NOW };
        let regraded = tokio::spawn(async move {
            let step =
                Regrade { item: &item, correction: &correction, attempts: &[], kept: &[], revision, handed_in: 0 };
            held.regrade(Key::new([80; 16]), &step, &entry).await.unwrap()
        });
        until_it_waits(database, &regraded).await;
        handing_in.execute("COMMIT").await.unwrap();
        assert!(!regraded.await.unwrap(), "an attempt was overlooked");
        assert_eq!(sample.revision(&store).await, revision, "nothing was done");
    });
}

#[test]
fn an_assignment_is_saved_as_it_was_read_or_not_at_all() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let key = sample.whole.assignment.key;
        let read = store.assignment(key).await.unwrap().unwrap();
        let mut pinned = read.clone();
        pinned.assignment.pinned = Some(NOW);
        pinned.items[0].digest = Some("d".into());
        assert!(store.save_assignment(&pinned, &sample.entry(80)).await.unwrap());
        let mut late = read.clone();
        late.assignment.title = "Sheet 2".into();
        late.items.clear();
        for late in [late.clone(), AssignmentWithItems { revision: 0, ..late }] {
            assert!(!store.save_assignment(&late, &sample.entry(81)).await.unwrap(), "it was pinned meanwhile");
        }
        let kept = store.assignment(key).await.unwrap().unwrap();
        assert_eq!((kept.assignment, kept.items), (pinned.assignment, pinned.items));
        assert_eq!(store.trail(sample.course.key, 10).await.unwrap().len(), 3, "what was refused left nothing");
    });
}

#[test]
fn where_no_tables_can_be_made_is_found_out_before_the_first_start() {
    on_both(async |database| {
        let Database::Postgres(url) = database else { return };
        let nowhere = Inspection::of(&postgres_with(url, "search_path=nowhere")).await.unwrap();
        assert!(nowhere.lacks_rights && nowhere.unsafe_settings.is_empty());
    });
}

#[test]
fn a_database_that_was_away_is_found_again() {
    on_both(async |database| {
        let Database::Postgres(_) = database else { return };
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let mut connection = database.connection().await;
        let others = "FROM pg_stat_activity WHERE datname = current_database() AND pid <> pg_backend_pid()";
        let end = format!("SELECT pg_terminate_backend(pid) {others}");
        connection.execute(sqlx::raw_sql(sqlx::AssertSqlSafe(end))).await.unwrap();
        let left =
            "SELECT COUNT(*) FROM pg_stat_activity WHERE datname = current_database() AND pid <> pg_backend_pid()";
        while number(&mut connection, left).await > 0 {}
        for millis in 1..=2 {
            let saved = Moment::from_millis(millis);
            let draft = Draft { sheet: sample.sheet.key, answers: BTreeMap::new(), saved, settled: None };
            store.save_draft(&draft).await.unwrap();
            assert_eq!(store.draft(sample.sheet.key).await.unwrap(), Some(draft));
        }
    });
}
