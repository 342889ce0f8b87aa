//! Connections that read: a few, each for one statement at a time.

use std::time::Duration;

use sqlx::AnyPool;
use sqlx::Executor;
use sqlx::any::AnyPoolOptions;

use super::address::Address;
use super::connection::{install_drivers, settings};
use super::fault::StoreFault;

/// Statements that are read at the same time.
const MOST: u32 = 8;
/// The time for which somebody waits for a connection.
const PATIENCE: Duration = Duration::from_secs(5);

/// Connections that read the database at an address; each is opened when it is needed, and asked whether it is still there before it
/// is used again.
pub(super) fn readers(address: &Address) -> Result<AnyPool, StoreFault> {
    install_drivers();
    let settings = settings(address);
    let options = AnyPoolOptions::new().max_connections(MOST).acquire_timeout(PATIENCE);
    let options = options.after_connect(move |connection, _| {
        Box::pin(async move {
            connection.execute(settings).await?;
            Ok(())
        })
    });
    Ok(options.connect_lazy(&address.url())?)
}
