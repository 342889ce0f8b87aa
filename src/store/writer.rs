//! One writer: whoever waits while it commits is committed together next time.

use sqlx::Any;
use sqlx::AnyConnection;
use sqlx::Connection;
use sqlx::any::AnyArguments;
use sqlx::query::Query;
use tokio::sync::mpsc;
use tokio::sync::oneshot;

use super::address::Address;
use super::connection::connect;
use super::fault::StoreFault;

/// A statement with its values.
pub(super) type Statement = Query<'static, Any, AnyArguments>;

/// The most works of one transaction.
const TOGETHER: usize = 256;

/// Works that may wait; whoever comes later waits to be let in.
const WAITING: usize = 1024;

/// Statements that are kept all or none.
struct Work {
    statements: Vec<Statement>,
    /// How many of them are guards, at the beginning: nothing is done where one of these changes nothing.
    guards: usize,
    tell: oneshot::Sender<Result<Vec<u64>, StoreFault>>,
}

/// The way to the writer.
#[derive(Clone)]
pub(super) struct Writer {
    works: mpsc::Sender<Work>,
}

impl Writer {
    /// A writer with a connection of its own to the database at this address. It ends once nobody has a way to it any more.
    pub(super) fn start(address: Address, connection: AnyConnection) -> Self {
        let (works, waiting) = mpsc::channel(WAITING);
        tokio::spawn(run(address, connection, waiting));
        Self { works }
    }

    /// Carries statements out, all or none, and says how many rows each changed. What it returns is kept: it is on the disk.
    pub(super) async fn write(&self, statements: Vec<Statement>) -> Result<Vec<u64>, StoreFault> {
        self.write_if(0, statements).await
    }

    /// The same, where each of the first statements, so many, changes something; else nothing is done, and nothing was changed.
    pub(super) async fn write_if(&self, guards: usize, statements: Vec<Statement>) -> Result<Vec<u64>, StoreFault> {
        let (tell, told) = oneshot::channel();
        self.works.send(Work { statements, guards, tell }).await.map_err(|_| StoreFault::Stopped)?;
        told.await.map_err(|_| StoreFault::Stopped)?
    }
}

async fn run(address: Address, mut connection: AnyConnection, mut waiting: mpsc::Receiver<Work>) {
    while let Some(first) = waiting.recv().await {
        let mut works = vec![first];
        while works.len() < TOGETHER {
            let Ok(next) = waiting.try_recv() else { break };
            works.push(next);
        }
        if is_lost(&address, &mut connection).await
            && let Ok(another) = connect(&address).await
        {
            connection = another;
        }
        together(&mut connection, works).await;
    }
    // The connection is closed with its last commit; there is nobody to tell of what is wrong with that.
    let _ = connection.close().await;
}

/// Whether the database has closed the connection, as a server does that is started anew.
async fn is_lost(address: &Address, connection: &mut AnyConnection) -> bool {
    matches!(address, Address::Postgres(_)) && connection.ping().await.is_err()
}

/// One transaction for several works. One that fails leaves the others alone.
async fn together(connection: &mut AnyConnection, works: Vec<Work>) {
    let mut transaction = match connection.begin().await {
        Ok(transaction) => transaction,
        Err(error) => {
            let mut error = Some(StoreFault::from(error));
            for work in works {
                let _ = work.tell.send(Err(error.take().unwrap_or(StoreFault::Stopped)));
            }
            return;
        }
    };
    let mut done = Vec::with_capacity(works.len());
    for Work { statements, guards, tell } in works {
        let result = alone(&mut transaction, statements, guards).await;
        done.push((tell, result));
    }
    let mut failed = transaction.commit().await.err();
    let is_kept = failed.is_none();
    for (tell, result) in done {
        let result = if is_kept { result } else { Err(failed.take().map_or(StoreFault::Stopped, StoreFault::from)) };
        // Whoever has stopped waiting is not told.
        let _ = tell.send(result);
    }
}

async fn alone(
    connection: &mut AnyConnection,
    statements: Vec<Statement>,
    guards: usize,
) -> Result<Vec<u64>, StoreFault> {
    let mut savepoint = connection.begin().await?;
    let mut changed = Vec::with_capacity(statements.len());
    for statement in statements {
        changed.push(statement.execute(&mut *savepoint).await?.rows_affected());
        if changed.len() <= guards && changed.last() == Some(&0) {
            savepoint.rollback().await?;
            return Ok(Vec::new());
        }
    }
    savepoint.commit().await?;
    Ok(changed)
}
