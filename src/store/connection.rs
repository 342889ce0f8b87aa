//! Connections to a database, with the settings under which a commit is kept.

use std::sync::Once;

use sqlx::AnyConnection;
use sqlx::Connection;
use sqlx::Executor;

use super::address::Address;
use super::fault::StoreFault;

/// How SQLite keeps what it was given: a commit is on the disk when it returns, also if the power fails then, and readers never
/// wait for the writer.
const SQLITE: &str =
    "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA busy_timeout = 5000; PRAGMA foreign_keys = ON";

/// The same for PostgreSQL, whatever its configuration says; a stricter setting stays. That it writes to the disk at all (`fsync`) is
/// not for a connection to say.
const POSTGRES: &str =
    "SELECT set_config('synchronous_commit', 'on', false) WHERE current_setting('synchronous_commit') = 'off'";

/// Makes both databases known, before the first connection.
pub(super) fn install_drivers() {
    static DRIVERS: Once = Once::new();
    DRIVERS.call_once(sqlx::any::install_default_drivers);
}

/// A connection that changes nothing of how the database works.
pub(super) async fn connect_plainly(url: &str) -> Result<AnyConnection, StoreFault> {
    install_drivers();
    Ok(AnyConnection::connect(url).await?)
}

/// A connection of its own, set up as all are.
pub(super) async fn connect(address: &Address) -> Result<AnyConnection, StoreFault> {
    let mut connection = connect_plainly(&address.url()).await?;
    connection.execute(settings(address)).await?;
    Ok(connection)
}

/// The statement with which each connection begins.
pub(super) fn settings(address: &Address) -> &'static str {
    match address {
        Address::Folder(_) => SQLITE,
        Address::Postgres(_) => POSTGRES,
    }
}
