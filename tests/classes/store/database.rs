//! The databases that a test runs on.

use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;

use momentous::store::sqlx;
use momentous::store::sqlx::{AnyConnection, Connection, Executor};
use momentous::store::{Address, Store};

/// A database of a test's own.
pub enum Database {
    /// In a folder.
    Folder(Address),
    /// In PostgreSQL.
    Postgres(String),
}

/// Where PostgreSQL is, for tests: the address of a database whose user may make others.
fn postgres() -> Option<String> {
    let address = std::env::var("MOMENTOUS_POSTGRES").ok().filter(|address| !address.is_empty());
    assert!(address.is_some() || std::env::var_os("CI").is_none(), "MOMENTOUS_POSTGRES has to name a database");
    address
}

/// A database of PostgreSQL, asked with a setting of the connection's own.
pub fn postgres_with(url: &str, setting: &str) -> Address {
    let (name, value) = setting.split_once('=').unwrap();
    let before = if url.contains('?') { '&' } else { '?' };
    Address::Postgres(format!("{url}{before}options[{name}]={value}"))
}

/// Runs a test on SQLite, and on PostgreSQL where the machine has it.
#[allow(clippy::needless_pass_by_value, reason = "a test is written where it is passed")]
pub fn on_both(test: impl AsyncFn(&Database) + Sync) {
    let folder = tempfile::tempdir().unwrap();
    // Both wait for the disk most of the time.
    thread::scope(|scope| {
        scope.spawn(|| block_on(test(&Database::Folder(Address::Folder(folder.path().join("data"))))));
        match postgres() {
            Some(_) => block_on(async { test(&Database::made().await).await }),
            None => eprintln!("skipped on PostgreSQL: MOMENTOUS_POSTGRES names none"),
        }
    });
}

pub fn block_on<T>(future: impl Future<Output = T>) -> T {
    tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap().block_on(future)
}

impl Database {
    /// A new database of PostgreSQL.
    async fn made() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        sqlx::any::install_default_drivers();
        let server = postgres().unwrap();
        let name = format!("momentous_{}_{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let mut connection = AnyConnection::connect(&server).await.unwrap();
        let create = format!("CREATE DATABASE {name}");
        connection.execute(sqlx::raw_sql(sqlx::AssertSqlSafe(create))).await.unwrap();
        let (start, rest) = server.rsplit_once('/').unwrap();
        let options = rest.split_once('?').map_or(String::new(), |(_, options)| format!("?{options}"));
        Self::Postgres(format!("{start}/{name}{options}"))
    }

    /// Another of the same kind.
    pub async fn another(&self) -> Self {
        match self {
            Self::Folder(Address::Folder(folder)) => Self::Folder(Address::Folder(folder.with_extension("another"))),
            _ => Self::made().await,
        }
    }

    pub fn address(&self) -> Address {
        match self {
            Self::Folder(address) => address.clone(),
            Self::Postgres(url) => Address::Postgres(url.clone()),
        }
    }

    pub async fn serve(&self) -> Store {
        Store::serve(&self.address()).await.unwrap()
    }

    /// A connection past the store.
    pub async fn connection(&self) -> AnyConnection {
        let url = match self.address() {
            Address::Folder(folder) => format!("sqlite://{}", folder.join("momentous.sqlite").display()),
            Address::Postgres(url) => url,
        };
        AnyConnection::connect(&url).await.unwrap()
    }

    /// Carries out a statement past the store.
    pub async fn execute(&self, statement: &'static str) {
        self.connection().await.execute(statement).await.unwrap();
    }
}
