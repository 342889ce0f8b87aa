//! Records read from their column `data`.

use std::sync::atomic::Ordering;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sqlx::Row;
use sqlx::any::AnyRow;

use super::fault::StoreFault;
use super::open::Store;
use super::writer::Statement;

impl Store {
    /// The rows that a statement finds.
    pub(super) async fn rows(&self, statement: Statement) -> Result<Vec<AnyRow>, StoreFault> {
        self.reads.fetch_add(1, Ordering::Relaxed);
        let rows = statement.fetch_all(&self.readers).await?;
        self.rows.fetch_add(rows.len() as u64, Ordering::Relaxed);
        Ok(rows)
    }

    /// The records in the first column of what a statement finds.
    pub(super) async fn records<T: DeserializeOwned>(&self, statement: Statement) -> Result<Vec<T>, StoreFault> {
        self.rows(statement).await?.iter().map(record).collect()
    }

    /// The first of these records.
    pub(super) async fn one<T: DeserializeOwned>(&self, statement: Statement) -> Result<Option<T>, StoreFault> {
        Ok(self.records(statement).await?.into_iter().next())
    }
}

/// The record in the first column of a row.
pub(super) fn record<T: DeserializeOwned>(row: &AnyRow) -> Result<T, StoreFault> {
    Ok(serde_json::from_str(row.try_get::<&str, _>(0)?)?)
}

/// A record as it is kept.
pub(super) fn to_json(record: &impl Serialize) -> Result<String, StoreFault> {
    Ok(serde_json::to_string(record)?)
}
