//! One writer: each work is a transaction of its own, and what it returns is on the disk.

use std::sync::PoisonError;
use std::time::{Duration, Instant};

use sqlx::Any;
use sqlx::AnyConnection;
use sqlx::Connection;
use sqlx::Executor;
use sqlx::any::AnyArguments;
use sqlx::query;
use sqlx::query::Query;
use tokio::sync::Mutex;
use tokio::time::timeout;

use super::address::Address;
use super::connection::connect;
use super::fault::StoreFault;

/// A statement with its values.
pub(super) type Statement = Query<'static, Any, AnyArguments>;

/// The longest time that a work may take, its wait for those before it included.
const PATIENCE: Duration = Duration::from_secs(15);

/// How long a work says of the next one whether it is kept.
const FRESH: Duration = Duration::from_secs(1);

/// The bytes that are written on trial: more than fits into a page of the file that has room left.
const TRIAL: usize = 16 * 1024;

/// The outcome of the last work, and its time.
#[derive(Default)]
struct Last(std::sync::Mutex<Option<(Instant, bool)>>);

impl Last {
    fn note(&self, is_kept: bool) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some((Instant::now(), is_kept));
    }

    /// Whether it was kept, where that was just now.
    fn known(&self) -> Option<bool> {
        let last = *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        last.filter(|(at, _)| at.elapsed() < FRESH).map(|(_, is_kept)| is_kept)
    }
}

/// Writes to the database at an address, one work after the other.
///
/// The statements that begin and end a transaction are sent as they stand here: nothing counts how deep a transaction is, and a
/// `COMMIT` that succeeds is one that the database has carried out.
pub(super) struct Writer {
    address: Address,
    /// Whoever holds it writes.
    line: Mutex<Line>,
    /// The outcome of the last work.
    last: Last,
    /// Whoever holds it writes on trial.
    trial: Mutex<()>,
}

/// The connection that writes.
enum Line {
    /// It stands, in no transaction.
    Idle(AnyConnection),
    /// There is none: something has failed, or was given up halfway.
    Lost,
    /// Nothing is written any more.
    Closed,
}

impl Writer {
    /// A writer with a connection to the database at this address, which is in no transaction.
    pub(super) fn new(address: Address, connection: AnyConnection) -> Self {
        Self { address, line: Mutex::new(Line::Idle(connection)), last: Last::default(), trial: Mutex::default() }
    }

    /// Carries statements out, all or none, and says how many rows each changed. What it returns is kept: it is on the disk.
    pub(super) async fn write(&self, statements: Vec<Statement>) -> Result<Vec<u64>, StoreFault> {
        self.write_if(0, statements).await
    }

    /// The same, where each of the first statements, so many, changes something; else nothing is done, and nothing was changed.
    pub(super) async fn write_if(&self, guards: usize, statements: Vec<Statement>) -> Result<Vec<u64>, StoreFault> {
        let done = timeout(PATIENCE, self.transaction(guards, statements)).await;
        let done = done.unwrap_or_else(|_| Err(StoreFault::late()));
        match &done {
            // Where nothing was to be done, nothing is known of the next work.
            Ok(changed) if changed.is_empty() => {}
            _ => self.last.note(done.is_ok()),
        }
        done
    }

    /// Whether what is written is kept: as of the last work where that was just now, else by one that changes nothing. Everybody may
    /// ask, so it is not tried more than once in [`FRESH`].
    pub(super) async fn keeps(&self) -> bool {
        let _alone = self.trial.lock().await;
        if let Some(is_kept) = self.last.known() {
            return is_kept;
        }
        // Until it is known: whoever asks may not wait for the answer.
        self.last.note(false);
        let insertion = query("INSERT INTO draft (sheet, data) VALUES ('', $1) ON CONFLICT (sheet) DO NOTHING");
        let statements = vec![insertion.bind("-".repeat(TRIAL)), query("DELETE FROM draft WHERE sheet = ''")];
        self.write(statements).await.is_ok()
    }

    async fn transaction(&self, guards: usize, statements: Vec<Statement>) -> Result<Vec<u64>, StoreFault> {
        let mut line = self.line.lock().await;
        let mut connection = self.begun(&mut line).await?;
        let changed = carried_out(&mut connection, guards, statements).await?;
        connection.execute(if changed.is_empty() { "ROLLBACK" } else { "COMMIT" }).await?;
        *line = Line::Idle(connection);
        Ok(changed)
    }

    /// A connection in a transaction. It is taken out of the line, so that it is thrown away by whatever fails from here on, or is
    /// given up.
    async fn begun(&self, line: &mut Line) -> Result<AnyConnection, StoreFault> {
        if let Some(mut connection) = taken(line)? {
            match (connection.execute(self.begin()).await, &self.address) {
                (Ok(_), _) => return Ok(connection),
                (Err(error), Address::Folder(_)) => return Err(error.into()),
                // The server was started anew since the last work, perhaps, and nothing was done yet.
                (Err(_), Address::Postgres(_)) => {}
            }
        }
        let mut connection = connect(&self.address).await?;
        connection.execute(self.begin()).await?;
        Ok(connection)
    }

    fn begin(&self) -> &'static str {
        match self.address {
            // Whoever reads first and writes then is not refused halfway.
            Address::Folder(_) => "BEGIN IMMEDIATE",
            Address::Postgres(_) => "BEGIN",
        }
    }

    /// Carries out a setting of the connection that writes; it holds as long as that connection.
    pub(super) async fn set(&self, setting: &'static str) -> Result<(), StoreFault> {
        let mut line = self.line.lock().await;
        let mut connection = match taken(&mut line)? {
            Some(connection) => connection,
            None => connect(&self.address).await?,
        };
        connection.execute(setting).await?;
        *line = Line::Idle(connection);
        Ok(())
    }

    /// Ends the connection once nobody writes; whoever writes later is refused.
    pub(super) async fn close(&self) {
        let mut line = self.line.lock().await;
        if let Line::Idle(connection) = std::mem::replace(&mut *line, Line::Closed) {
            // There is nobody to tell of what is wrong with a connection that nobody needs.
            let _ = connection.close().await;
        }
    }
}

/// The connection of a line, which has none from then on.
fn taken(line: &mut Line) -> Result<Option<AnyConnection>, StoreFault> {
    match std::mem::replace(line, Line::Lost) {
        Line::Idle(connection) => Ok(Some(connection)),
        Line::Lost => Ok(None),
        Line::Closed => {
            *line = Line::Closed;
            Err(StoreFault::Stopped)
        }
    }
}

/// The number of rows that each statement changed; none where one of the first, so many, changed nothing.
async fn carried_out(
    connection: &mut AnyConnection,
    guards: usize,
    statements: Vec<Statement>,
) -> Result<Vec<u64>, StoreFault> {
    let mut changed = Vec::with_capacity(statements.len());
    for statement in statements {
        changed.push(statement.execute(&mut *connection).await?.rows_affected());
        if changed.len() <= guards && changed.last() == Some(&0) {
            return Ok(Vec::new());
        }
    }
    Ok(changed)
}
