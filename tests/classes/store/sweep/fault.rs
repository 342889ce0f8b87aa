//! What goes wrong with a database while it is written to.

use std::fmt::Write as _;

use momentous::store::sqlx;
use momentous::store::sqlx::{AnyConnection, AssertSqlSafe, Connection, Executor, Row};
use momentous::store::{Address, Store};

use super::super::database::Database;
use super::base::tables;
use super::of_nobody;
use super::proxy::{Moment, Proxy};

/// What goes wrong; the number says how far a write comes before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The file of SQLite may grow by so many pages and no further.
    Full(usize),
    /// The file of SQLite is locked by another program.
    Locked,
    /// The database refuses when so many rows have changed; SQLite takes the whole transaction back by itself then, as it does where
    /// the disk is full.
    Refused(usize),
    /// The database refuses to commit.
    AtCommit,
    /// SQLite takes the transaction of the first beside it back by itself and refuses to commit those after it, as it does where the disk
    /// is full.
    Exhausted,
    /// Whoever asked has gone after looking so many times whether it is done.
    Left(usize),
    /// The connection to PostgreSQL is cut after so many calls.
    Cut(usize, Moment),
}

impl Fault {
    /// The same, later.
    pub fn later(self) -> Option<Self> {
        match self {
            Self::Full(number) => Some(Self::Full(number + 1)),
            Self::Refused(number) => Some(Self::Refused(number + 1)),
            Self::Left(number) => Some(Self::Left(number + 1)),
            Self::Cut(number, moment) => Some(Self::Cut(number + 1, moment)),
            Self::Locked | Self::AtCommit | Self::Exhausted => None,
        }
    }
}

/// A fault that lasts.
pub struct Lasting<'a> {
    fault: Fault,
    database: &'a Database,
    proxy: Option<&'a Proxy>,
    /// Who holds the file locked.
    other: Option<AnyConnection>,
}

impl<'a> Lasting<'a> {
    /// Brings it about.
    pub async fn of(fault: Fault, database: &'a Database, store: &Store, proxy: Option<&'a Proxy>) -> Self {
        let mut other = None;
        match fault {
            Fault::Full(pages) => {
                let mut connection = database.connection().await;
                let used: i64 = connection.fetch_one("PRAGMA page_count").await.unwrap().try_get(0).unwrap();
                let setting = format!("PRAGMA max_page_count = {}", used + i64::try_from(pages).unwrap());
                // Each is one of a few dozen short texts.
                store.set(setting.leak()).await.unwrap();
                connection.close().await.unwrap();
            }
            Fault::Locked => {
                store.set("PRAGMA busy_timeout = 0").await.unwrap();
                let mut connection = database.connection().await;
                connection.execute("BEGIN IMMEDIATE").await.unwrap();
                other = Some(connection);
            }
            Fault::Refused(rows) => carry_out(database, &refusing(database, rows).await).await,
            Fault::AtCommit => carry_out(database, &at_commit(database).await).await,
            Fault::Exhausted => {
                let first = format!(
                    "CREATE TRIGGER fault_first BEFORE INSERT ON draft WHEN NEW.sheet = '{}' \
                     BEGIN SELECT RAISE(ROLLBACK, 'the disk is full'); END;",
                    of_nobody()[0]
                );
                carry_out(database, &format!("{}{first}", at_commit(database).await)).await;
            }
            Fault::Left(_) => {}
            Fault::Cut(calls, moment) => proxy.unwrap().cut(calls, moment),
        }
        Self { fault, database, proxy, other }
    }

    /// Ends it. Says whether it may have been met.
    pub async fn ended(self, store: &Store) -> bool {
        match self.fault {
            Fault::Left(_) => {}
            // It still holds where nothing has failed.
            Fault::Full(_) => store.set("PRAGMA max_page_count = 1000000000").await.unwrap(),
            Fault::Locked => self.other.unwrap().close().await.unwrap(),
            Fault::Refused(_) | Fault::AtCommit | Fault::Exhausted => {
                carry_out(self.database, &healed(self.database).await).await;
            }
            Fault::Cut(..) => return self.proxy.unwrap().has_cut(),
        }
        true
    }
}

async fn carry_out(database: &Database, statements: &str) {
    let mut connection = database.connection().await;
    connection.execute(sqlx::raw_sql(AssertSqlSafe(statements.to_owned()))).await.unwrap();
    connection.close().await.unwrap();
}

/// For each kind of change of each table, a trigger.
async fn triggers(database: &Database, of: impl Fn(&str, &str) -> String) -> String {
    let mut connection = database.connection().await;
    let tables = tables(&mut connection, database).await;
    connection.close().await.unwrap();
    let kept = tables.iter().filter(|table| !table.starts_with("fault_"));
    kept.flat_map(|table| ["INSERT", "UPDATE", "DELETE"].map(|change| of(table, change))).collect()
}

/// From now on each transaction is refused when so many rows have changed.
async fn refusing(database: &Database, rows: usize) -> String {
    let count = format!("CREATE TABLE fault_rows (left_over BIGINT NOT NULL); INSERT INTO fault_rows VALUES ({rows});");
    let refuse = match database.address() {
        Address::Folder(_) => {
            triggers(database, |table, change| {
                format!(
                    "CREATE TRIGGER fault_{table}_{change} BEFORE {change} ON {table} BEGIN \
                     UPDATE fault_rows SET left_over = left_over - 1; \
                     SELECT RAISE(ROLLBACK, 'the disk is full') FROM fault_rows WHERE left_over < 0; END;"
                )
            })
            .await
        }
        Address::Postgres(_) => {
            let function = "CREATE FUNCTION fault() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN \
                UPDATE fault_rows SET left_over = left_over - 1; \
                IF (SELECT left_over FROM fault_rows) < 0 THEN RAISE EXCEPTION 'the disk is full'; END IF; \
                RETURN COALESCE(NEW, OLD); END $$;";
            let each = triggers(database, |table, change| {
                format!(
                    "CREATE TRIGGER fault_{change} BEFORE {change} ON {table} FOR EACH ROW EXECUTE FUNCTION fault();"
                )
            });
            format!("{function}{}", each.await)
        }
    };
    format!("{count}{refuse}")
}

/// From now on no transaction that has changed something can be committed.
async fn at_commit(database: &Database) -> String {
    match database.address() {
        Address::Folder(_) => {
            let promise = "CREATE TABLE fault_kept (id INTEGER PRIMARY KEY); \
                CREATE TABLE fault_promised (id INTEGER REFERENCES fault_kept (id) DEFERRABLE INITIALLY DEFERRED);";
            let each = triggers(database, |table, change| {
                format!(
                    "CREATE TRIGGER fault_{table}_{change} AFTER {change} ON {table} BEGIN INSERT INTO fault_promised VALUES (1); END;"
                )
            });
            format!("{promise}{}", each.await)
        }
        Address::Postgres(_) => {
            let function = "CREATE FUNCTION fault() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN \
                RAISE EXCEPTION 'the disk is full'; END $$;";
            let each = triggers(database, |table, change| {
                format!(
                    "CREATE CONSTRAINT TRIGGER fault_{change} AFTER {change} ON {table} DEFERRABLE INITIALLY DEFERRED \
                     FOR EACH ROW EXECUTE FUNCTION fault();"
                )
            });
            format!("{function}{}", each.await)
        }
    }
}

/// What takes all of that away.
async fn healed(database: &Database) -> String {
    let mut statements = match database.address() {
        Address::Folder(_) => {
            triggers(database, |table, change| format!("DROP TRIGGER IF EXISTS fault_{table}_{change};")).await
        }
        Address::Postgres(_) => "DROP FUNCTION fault CASCADE;".to_owned(),
    };
    if let Database::Folder(_) = database {
        statements.push_str("DROP TRIGGER IF EXISTS fault_first;");
    }
    for table in ["fault_rows", "fault_promised", "fault_kept"] {
        // Writing to a string cannot fail.
        let _ = write!(statements, "DROP TABLE IF EXISTS {table};");
    }
    statements
}
