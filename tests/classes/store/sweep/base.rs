//! What a write is tried on: copies of the same data, and all that is in them.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicU32, Ordering};

use momentous::store::Address;
use momentous::store::sqlx;
use momentous::store::sqlx::any::AnyRow;
use momentous::store::sqlx::{AnyConnection, AssertSqlSafe, Column, Connection, Executor, Row};

use super::super::database::Database;
use super::writes::{Tried, WRITES};

/// Every row of every table.
pub type Whole = BTreeMap<String, BTreeSet<Vec<String>>>;

/// Data of which copies are made.
pub struct Base {
    database: Database,
    pub tried: Tried,
    /// What is in them.
    pub before: Whole,
    /// What is in them after each write.
    pub after: Vec<Whole>,
}

impl Base {
    /// Makes the data, and looks at what each write makes of them where nothing goes wrong.
    pub async fn made(database: Database) -> Self {
        if let Address::Folder(folder) = database.address() {
            // Small pages, so that a file grows at many places of a write.
            std::fs::create_dir_all(&folder).unwrap();
            sqlx::any::install_default_drivers();
            let url = format!("sqlite://{}?mode=rwc", folder.join("momentous.sqlite").display());
            let mut connection = AnyConnection::connect(&url).await.unwrap();
            connection.execute("PRAGMA page_size = 512; VACUUM").await.unwrap();
            connection.close().await.unwrap();
        }
        let store = database.serve().await;
        let tried = Tried::kept(&store).await;
        store.close().await;
        drop(store);
        let before = whole(&database).await;
        let mut base = Self { database, tried, before, after: Vec::new() };
        for write in WRITES {
            let copy = base.copy().await;
            let store = copy.serve().await;
            assert!((write.run)(&store, &base.tried).await.unwrap(), "{}", write.name);
            store.close().await;
            let after = whole(&copy).await;
            assert_ne!(after, base.before, "{} changes something", write.name);
            base.after.push(after);
            base.forget(copy).await;
        }
        base
    }

    /// A copy, which nobody serves yet.
    pub async fn copy(&self) -> Database {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        match self.database.address() {
            Address::Folder(folder) => {
                let copy = folder.with_extension(number.to_string());
                std::fs::create_dir(&copy).unwrap();
                let file = "momentous.sqlite";
                std::fs::copy(folder.join(file), copy.join(file)).unwrap();
                Database::Folder(Address::Folder(copy))
            }
            Address::Postgres(url) => {
                let (server, name) = url.rsplit_once('/').unwrap();
                let copy = format!("{name}_{number}");
                self.ask(&format!("CREATE DATABASE {copy} TEMPLATE {name}")).await;
                Database::Postgres(format!("{server}/{copy}"))
            }
        }
    }

    /// Takes a copy away.
    pub async fn forget(&self, copy: Database) {
        match copy.address() {
            Address::Folder(folder) => std::fs::remove_dir_all(folder).unwrap(),
            Address::Postgres(url) => {
                let name = url.rsplit_once('/').unwrap().1.to_owned();
                self.ask(&format!("DROP DATABASE {name} WITH (FORCE)")).await;
            }
        }
    }

    /// Asks the server of the databases.
    async fn ask(&self, statement: &str) {
        let Database::Postgres(url) = &self.database else { return };
        let mut connection =
            AnyConnection::connect(&format!("{}/postgres", url.rsplit_once('/').unwrap().0)).await.unwrap();
        connection.execute(sqlx::raw_sql(AssertSqlSafe(statement.to_owned()))).await.unwrap();
        connection.close().await.unwrap();
    }
}

/// The tables of the store.
pub async fn tables(connection: &mut AnyConnection, database: &Database) -> Vec<String> {
    let named = match database {
        Database::Folder(_) => "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name",
        Database::Postgres(_) => "SELECT CAST(tablename AS TEXT) FROM pg_tables WHERE schemaname = 'public' ORDER BY 1",
    };
    connection.fetch_all(named).await.unwrap().iter().map(|row| row.try_get(0).unwrap()).collect()
}

/// All that is kept.
pub async fn whole(database: &Database) -> Whole {
    let mut connection = database.connection().await;
    let mut whole = Whole::new();
    for table in tables(&mut connection, database).await {
        let rows =
            sqlx::query(AssertSqlSafe(format!("SELECT * FROM {table}"))).fetch_all(&mut connection).await.unwrap();
        let count = rows.len();
        let rows: BTreeSet<_> = rows.iter().map(values).collect();
        assert_eq!(rows.len(), count, "no row of {table} is there twice");
        whole.insert(table, rows);
    }
    connection.close().await.unwrap();
    whole
}

fn values(row: &AnyRow) -> Vec<String> {
    let value = |place: usize| {
        let text = row.try_get::<Option<String>, _>(place).map(|text| format!("{text:?}"));
        text.or_else(|_| row.try_get::<Option<i64>, _>(place).map(|number| format!("{number:?}"))).unwrap()
    };
    row.columns().iter().map(|column| value(column.ordinal())).collect()
}
