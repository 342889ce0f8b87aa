//! A database, ready.

use std::fs;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use sqlx::AnyPool;
use sqlx::Connection;
use sqlx::Executor;
use sqlx::Row;

use super::address::Address;
use super::connection::connect;
use super::fault::StoreFault;
use super::lock::Lock;
use super::private;
use super::readers::readers;
use super::schema;
use super::writer::{Statement, Writer};

/// The records of all courses. Clones share their connections.
#[derive(Clone)]
pub struct Store {
    pub(super) address: Address,
    pub(super) readers: AnyPool,
    pub(super) writer: Arc<Writer>,
    pub(super) reads: Arc<AtomicU64>,
    pub(super) rows: Arc<AtomicU64>,
    pub(super) handed_in: Arc<AtomicU64>,
    /// Held while the folder is served.
    _lock: Option<Arc<Lock>>,
}

impl Store {
    /// Opens the data at an address to serve them, and makes what is missing. A folder is served by one process at a time.
    ///
    /// # Errors
    /// Where the folder or the database cannot be used, another server works on it, or a later program wrote it.
    pub async fn serve(address: &Address) -> Result<Self, StoreFault> {
        let lock = match address {
            Address::Folder(folder) => {
                made(folder)?;
                Some(Arc::new(Lock::of(folder)?))
            }
            Address::Postgres(_) => None,
        };
        Self::open(address, lock).await
    }

    /// Opens the data at an address beside the server that may work on them.
    ///
    /// # Errors
    /// Where the folder or the database cannot be used, or a later program wrote it.
    pub async fn beside(address: &Address) -> Result<Self, StoreFault> {
        if let Address::Folder(folder) = address {
            made(folder)?;
        }
        Self::open(address, None).await
    }

    async fn open(address: &Address, lock: Option<Arc<Lock>>) -> Result<Self, StoreFault> {
        if let Address::Folder(folder) = address {
            private::keep(&Address::file(folder))?;
        }
        let mut connection = connect(address).await?;
        let mut transaction = connection.begin().await?;
        schema::migrate(&mut transaction).await?;
        transaction.commit().await?;
        Ok(Self {
            address: address.clone(),
            readers: readers(address)?,
            writer: Arc::new(Writer::new(address.clone(), connection)),
            reads: Arc::default(),
            rows: Arc::default(),
            handed_in: Arc::default(),
            _lock: lock,
        })
    }

    /// The address of the data.
    #[must_use]
    pub fn address(&self) -> &Address {
        &self.address
    }

    /// How many statements have read so far, and how many rows they found: what tests hold pages to.
    #[must_use]
    pub fn reads(&self) -> (u64, u64) {
        (self.reads.load(Ordering::Relaxed), self.rows.load(Ordering::Relaxed))
    }

    /// The number of attempts that were handed in and kept since it was opened.
    #[must_use]
    pub fn handed_in(&self) -> u64 {
        self.handed_in.load(Ordering::Relaxed)
    }

    /// Whether the database answers.
    ///
    /// # Errors
    /// Where it does not.
    pub async fn ping(&self) -> Result<(), StoreFault> {
        self.rows(sqlx::query("SELECT 1")).await.map(|_| ())
    }

    /// Ends every connection, once nobody reads and writes; whoever comes later is refused.
    pub async fn close(&self) {
        self.writer.close().await;
        self.readers.close().await;
    }

    /// Carries out a setting of the connection that writes, such as `PRAGMA max_page_count = 100`, by which tests make a database
    /// refuse. It holds as long as that connection: until something fails.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn set(&self, setting: &'static str) -> Result<(), StoreFault> {
        self.writer.set(setting).await
    }

    /// How the writer's connection keeps what it was given: for SQLite its journal, and how far a commit waits for the disk (`2` is
    /// until all is on it); for PostgreSQL `fsync` and `synchronous_commit`.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn durability(&self) -> Result<[String; 2], StoreFault> {
        let mut connection = connect(&self.address).await?;
        match self.address {
            Address::Folder(_) => {
                let journal = connection.fetch_one("PRAGMA journal_mode").await?.try_get(0)?;
                let synchronous: i64 = connection.fetch_one("PRAGMA synchronous").await?.try_get(0)?;
                Ok([journal, synchronous.to_string()])
            }
            Address::Postgres(_) => {
                let fsync = connection.fetch_one("SHOW fsync").await?.try_get(0)?;
                Ok([fsync, connection.fetch_one("SHOW synchronous_commit").await?.try_get(0)?])
            }
        }
    }

    /// Carries statements out, all or none, and says how many rows each changed.
    pub(super) async fn write(&self, statements: Vec<Statement>) -> Result<Vec<u64>, StoreFault> {
        self.writer.write(statements).await
    }

    /// Carries statements out, all of them where each of the first, so many, changes something, else none. Says whether it did.
    pub(super) async fn write_if(&self, guards: usize, statements: Vec<Statement>) -> Result<bool, StoreFault> {
        Ok(!self.writer.write_if(guards, statements).await?.is_empty())
    }
}

/// A folder that only its owner can read, where it was not there.
fn made(folder: &std::path::Path) -> Result<(), StoreFault> {
    if folder.is_dir() {
        return Ok(());
    }
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder).map_err(|error| StoreFault::Folder(folder.to_owned(), error))
}
