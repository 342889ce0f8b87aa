//! Faults of a database.

use std::path::PathBuf;

/// Why something was not read or kept.
#[derive(Debug, thiserror::Error)]
pub enum StoreFault {
    /// The address is none.
    #[error(
        "`{0}` is no folder and no address of PostgreSQL; an address looks like postgres://user:password@host/database"
    )]
    Address(String),
    /// The folder cannot be used.
    #[error("{folder} cannot be used: {reason}", folder = .0.display(), reason = .1)]
    Folder(PathBuf, std::io::Error),
    /// Another server works on the folder.
    #[error("another server works on {}", .0.display())]
    Locked(PathBuf),
    /// A later version of the program wrote it.
    #[error("the data are of version {found}, and this program knows versions up to {known}; use a later program")]
    Newer {
        /// The version of the data.
        found: i64,
        /// The latest version that this program knows.
        known: i64,
    },
    /// Data are to be restored over others.
    #[error("there are data already; restore into an empty folder or database")]
    NotEmpty,
    /// A record that cannot be read.
    #[error("a record of the database cannot be read: {0}")]
    Record(#[from] serde_json::Error),
    /// The database refuses.
    #[error("the database: {0}")]
    Database(sqlx::Error),
    /// The connections have been closed.
    #[error("the database takes nothing more; the server is about to stop")]
    Stopped,
}

impl From<sqlx::Error> for StoreFault {
    fn from(error: sqlx::Error) -> Self {
        match error {
            sqlx::Error::PoolClosed => Self::Stopped,
            other => Self::Database(other),
        }
    }
}

impl StoreFault {
    /// The database has not answered in time.
    pub(super) fn late() -> Self {
        Self::Database(sqlx::Error::Io(std::io::ErrorKind::TimedOut.into()))
    }

    /// Whether a record of the same name was there already.
    #[must_use]
    pub fn is_taken(&self) -> bool {
        matches!(self, Self::Database(sqlx::Error::Database(error)) if error.is_unique_violation())
    }
}
