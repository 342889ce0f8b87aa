//! Connections that read: a few, each for one statement at a time.

use std::mem;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;
use std::time::Duration;
use std::time::Instant;

use sqlx::AnyConnection;
use sqlx::Connection;
use sqlx::any::AnyRow;
use tokio::sync::Semaphore;
use tokio::time::timeout;

use super::address::Address;
use super::connection::connect;
use super::fault::StoreFault;
use super::writer::Statement;

/// Statements that are read at the same time.
const MOST: usize = 8;
/// How long somebody waits for a connection.
const PATIENCE: Duration = Duration::from_secs(5);
/// After how long without work a connection is asked whether its server is still there.
const QUIET: Duration = Duration::from_secs(1);

/// Connections that read. The pool of `sqlx` asks each connection before and after every statement whether it is still there, which
/// costs more than the statement itself: a page reads ten times.
pub(super) struct Readers {
    address: Address,
    admitted: Semaphore,
    idle: Mutex<Vec<Idle>>,
}

/// A connection without work.
struct Idle {
    connection: AnyConnection,
    since: Instant,
}

impl Readers {
    /// None yet: each is opened when it is needed.
    pub(super) fn new(address: Address) -> Self {
        Self { address, admitted: Semaphore::new(MOST), idle: Mutex::default() }
    }

    /// The rows that a statement finds.
    pub(super) async fn rows(&self, statement: Statement) -> Result<Vec<AnyRow>, StoreFault> {
        let late = |_| StoreFault::from(sqlx::Error::Io(std::io::ErrorKind::TimedOut.into()));
        let admitted = timeout(PATIENCE, self.admitted.acquire()).await.map_err(late)?;
        let _admitted = admitted.map_err(|_| StoreFault::Stopped)?;
        let mut connection = timeout(PATIENCE, self.connection()).await.map_err(late)??;
        // One whose statement failed, or was given up halfway, is closed and not used again.
        let rows = statement.fetch_all(&mut connection).await?;
        self.idle().push(Idle { connection, since: Instant::now() });
        Ok(rows)
    }

    /// The connection that was used last, which is there, or a new one.
    async fn connection(&self) -> Result<AnyConnection, StoreFault> {
        loop {
            let last = self.idle().pop();
            let Some(Idle { mut connection, since }) = last else { return connect(&self.address).await };
            let is_file = matches!(self.address, Address::Folder(_));
            if is_file || since.elapsed() < QUIET || connection.ping().await.is_ok() {
                return Ok(connection);
            }
        }
    }

    /// Ends every connection; whoever reads later is refused.
    pub(super) async fn close(&self) {
        self.admitted.close();
        let idle = mem::take(&mut *self.idle());
        for Idle { connection, .. } in idle {
            // There is nobody to tell of what is wrong with a connection that nobody needs.
            let _ = connection.close().await;
        }
    }

    fn idle(&self) -> MutexGuard<'_, Vec<Idle>> {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
