//! Whether the database answers, and keeps what it is given.

use super::open::Store;

/// Faults that keep the server from storing anything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ill {
    /// The database does not answer.
    Silent,
    /// It answers, and takes nothing new: its disk is full or cannot be written, or another program holds it locked.
    TakesNothing,
}

impl Store {
    /// Whether the database answers and keeps what it is given. Where nothing was written in the last second, something is written that
    /// changes nothing.
    ///
    /// # Errors
    /// Where it does not: what is wrong.
    pub async fn health(&self) -> Result<(), Ill> {
        self.ping().await.map_err(|_| Ill::Silent)?;
        if self.writer.keeps().await { Ok(()) } else { Err(Ill::TakesNothing) }
    }
}
