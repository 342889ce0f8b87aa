//! A consistent copy of everything while the server works, and the way back. A copy is one file of SQLite, whichever database it
//! was made of, so it also leads from one to the other.

use std::path::Path;

use futures_util::TryStreamExt;
use sqlx::AnyConnection;
use sqlx::AssertSqlSafe;
use sqlx::Connection;
use sqlx::Row;
use sqlx::TypeInfo;
use sqlx::ValueRef;
use sqlx::any::AnyRow;
use sqlx::query;

use super::address;
use super::address::Address;
use super::connection::{connect, connect_plainly};
use super::fault::StoreFault;
use super::open::Store;
use super::schema::{TABLES, VERSION, migrate};
use super::writer::Statement;

impl Store {
    /// Writes a copy of everything to a new file. It holds the secrets of courses: keep it as you keep the data.
    ///
    /// # Errors
    /// Where the file exists, or cannot be written.
    pub async fn backup(&self, file: &Path) -> Result<(), StoreFault> {
        let exists = std::fs::File::options().write(true).create_new(true).open(file);
        exists.map_err(|error| StoreFault::Folder(file.to_owned(), error))?;
        #[cfg(unix)]
        {
            let owner = std::os::unix::fs::PermissionsExt::from_mode(0o600);
            std::fs::set_permissions(file, owner).map_err(|error| StoreFault::Folder(file.to_owned(), error))?;
        }
        let copied = self.copy_to(file).await;
        if copied.is_err() {
            // Half a copy is worse than none.
            let _ = std::fs::remove_file(file);
        }
        copied
    }

    async fn copy_to(&self, file: &Path) -> Result<(), StoreFault> {
        let mut to = sqlite(file).await?;
        let mut from = connect(&self.address).await?;
        // What others write meanwhile is not in the copy, and nothing is copied by half.
        let begin = match self.address {
            Address::Folder(_) => "BEGIN",
            Address::Postgres(_) => "BEGIN ISOLATION LEVEL REPEATABLE READ, READ ONLY",
        };
        let mut source = from.begin_with(begin).await?;
        let mut transaction = to.begin().await?;
        copy(&mut source, &mut transaction).await?;
        transaction.commit().await?;
        source.rollback().await?;
        to.close().await?;
        Ok(())
    }

    /// Takes everything from a copy into data that are still empty.
    ///
    /// # Errors
    /// Where there are data, the file is no copy, or a later program wrote it.
    pub async fn restore(&self, file: &Path) -> Result<(), StoreFault> {
        if !file.is_file() {
            return Err(StoreFault::Folder(file.to_owned(), std::io::ErrorKind::NotFound.into()));
        }
        if !self.is_empty().await? {
            return Err(StoreFault::NotEmpty);
        }
        // The copy itself stays as it is: an earlier version of it is brought to this one on the side.
        let side = tempfile::tempdir().map_err(|error| StoreFault::Folder(file.to_owned(), error))?;
        let path_of_copy = side.path().join("copy.sqlite");
        std::fs::copy(file, &path_of_copy).map_err(|error| StoreFault::Folder(file.to_owned(), error))?;
        let mut from = sqlite(&path_of_copy).await?;
        let mut to = connect(&self.address).await?;
        let mut transaction = to.begin().await?;
        copy(&mut from, &mut transaction).await?;
        transaction.commit().await?;
        Ok(())
    }
}

/// A file of SQLite with the tables of this version.
async fn sqlite(file: &Path) -> Result<AnyConnection, StoreFault> {
    let mut connection = connect_plainly(&address::sqlite(file)).await?;
    let mut transaction = connection.begin().await?;
    migrate(&mut transaction).await?;
    transaction.commit().await?;
    Ok(connection)
}

/// Copies every row of every table, in a transaction of each side.
async fn copy(from: &mut AnyConnection, to: &mut AnyConnection) -> Result<(), StoreFault> {
    let version_found: i64 = query("SELECT MAX(number) FROM version").fetch_one(&mut *from).await?.try_get(0)?;
    if version_found > VERSION {
        return Err(StoreFault::Newer { found: version_found, known: VERSION });
    }
    for (table, columns) in TABLES {
        let count = columns.split(", ").count();
        let places: Vec<String> = (1..=count).map(|place| format!("${place}")).collect();
        let insert = format!("INSERT INTO {table} ({columns}) VALUES ({})", places.join(", "));
        // Both texts are made of the table above, of nothing that anybody typed.
        let mut rows = query(AssertSqlSafe(format!("SELECT {columns} FROM {table}"))).fetch(&mut *from);
        while let Some(row) = rows.try_next().await? {
            bound(query(AssertSqlSafe(insert.clone())), &row, count)?.execute(&mut *to).await?;
        }
    }
    Ok(())
}

/// A statement with the values of a row.
fn bound(mut statement: Statement, row: &AnyRow, count: usize) -> Result<Statement, StoreFault> {
    for column in 0..count {
        let value = row.try_get_raw(column)?;
        let is_whole = value.type_info().name() == "BIGINT";
        statement = match (value.is_null(), is_whole) {
            (true, _) => statement.bind(None::<String>),
            (false, true) => statement.bind(row.try_get::<i64, _>(column)?),
            (false, false) => statement.bind(row.try_get::<String, _>(column)?),
        };
    }
    Ok(statement)
}
