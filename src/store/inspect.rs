//! Inspection of data without changing them.

use std::time::Duration;

use sqlx::AnyConnection;
use sqlx::Row;
use sqlx::query;

use momentous_course::Moment;

use super::address::{Address, sqlite};
use super::connection::connect_plainly;
use super::fault::StoreFault;
use super::lock::Lock;
use super::schema::VERSION;

/// The longest time that a database may take to answer.
const PATIENCE: Duration = Duration::from_secs(10);

/// The inspection of data without changing them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inspection {
    /// The version of their tables; nothing where there are none yet.
    pub version: Option<i64>,
    /// Whether a server works on the folder now.
    pub is_served: bool,
    /// The latest moment that was noted in them.
    pub latest: Option<Moment>,
    /// The time by the database's clock, where it has one of its own.
    pub now: Option<Moment>,
    /// Whether there are no tables yet, and the user of the database may not make them.
    pub lacks_rights: bool,
    /// The settings of a database server by which a loss of power can take away what it said was kept: `fsync`.
    pub unsafe_settings: Vec<String>,
}

impl Inspection {
    /// Looks at the data at an address. Nothing is made or brought to another version.
    ///
    /// # Errors
    /// Where the database does not answer or is none of this program's, or a later program wrote it.
    pub async fn of(address: &Address) -> Result<Self, StoreFault> {
        let inspection = tokio::time::timeout(PATIENCE, inspect(address)).await;
        inspection.unwrap_or_else(|_| Err(StoreFault::late()))
    }

    /// Whether the next start of the server brings the data to a new version.
    #[must_use]
    pub fn is_earlier(&self) -> bool {
        self.version.is_some_and(|version| version < VERSION)
    }
}

async fn inspect(address: &Address) -> Result<Inspection, StoreFault> {
    let is_served = match address {
        Address::Folder(folder) => Lock::is_held(folder)?,
        Address::Postgres(_) => false,
    };
    let (url, tables) = match address {
        Address::Folder(folder) => {
            let file = Address::file(folder);
            if !file.is_file() {
                return Ok(Inspection { is_served, ..Inspection::default() });
            }
            (sqlite(&file).replace("?mode=rwc", "?mode=rw"), "sqlite_master WHERE name = 'version'")
        }
        Address::Postgres(url) => {
            let tables = "information_schema.tables WHERE table_name = 'version' AND table_schema = current_schema()";
            (url.clone(), tables)
        }
    };
    let mut connection = connect_plainly(&url).await?;
    let mut inspection = Inspection { is_served, ..Inspection::default() };
    if let Address::Postgres(_) = address {
        let now = "SELECT CAST(EXTRACT(EPOCH FROM clock_timestamp()) * 1000 AS BIGINT)";
        inspection.now = number(&mut connection, now).await?.map(Moment::from_millis);
        let off = query(
            "SELECT name FROM pg_settings WHERE name IN ('fsync', 'full_page_writes') AND setting = 'off' ORDER BY name",
        );
        for row in off.fetch_all(&mut connection).await? {
            inspection.unsafe_settings.push(row.try_get(0)?);
        }
    }
    // A text of this file, of nothing that anybody typed.
    let tables = sqlx::AssertSqlSafe(format!("SELECT COUNT(*) FROM {tables}"));
    let has_tables: i64 = query(tables).fetch_one(&mut connection).await?.try_get(0)?;
    if has_tables == 0 {
        if let Address::Postgres(_) = address {
            let lacks = "SELECT NOT COALESCE(has_schema_privilege(current_schema(), 'CREATE'), false)";
            inspection.lacks_rights = query(lacks).fetch_one(&mut connection).await?.try_get(0)?;
        }
        return Ok(inspection);
    }
    let version = number(&mut connection, "SELECT MAX(number) FROM version").await?;
    if let Some(newer) = version.filter(|number| *number > VERSION) {
        return Err(StoreFault::Newer { found: newer, known: VERSION });
    }
    let latest = number(&mut connection, "SELECT MAX(at) FROM trail").await?.map(Moment::from_millis);
    Ok(Inspection { version, latest, ..inspection })
}

async fn number(connection: &mut AnyConnection, statement: &'static str) -> Result<Option<i64>, StoreFault> {
    Ok(query(statement).fetch_one(connection).await?.try_get(0)?)
}
