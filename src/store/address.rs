//! Addresses of the data.

use std::fmt;
use std::fmt::Write;
use std::path::Path;
use std::path::PathBuf;
use std::str::FromStr;

use super::fault::StoreFault;

/// The file of the database in a folder.
const FILE: &str = "momentous.sqlite";

/// The address of the data.
///
/// ```
/// use momentous_store::Address;
/// let folder: Address = "momentous-data".parse()?;
/// assert_eq!(folder, Address::Folder("momentous-data".into()));
/// let server: Address = "postgres://momentous:hidden@db/courses".parse()?;
/// assert_eq!(server.to_string(), "PostgreSQL at db/courses"); // a log holds no password
/// # Ok::<(), momentous_store::StoreFault>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Address {
    /// A folder, with a database of SQLite in it.
    Folder(PathBuf),
    /// A database of PostgreSQL, by its address.
    Postgres(String),
}

impl Address {
    /// The database of SQLite in a folder.
    pub(super) fn file(folder: &Path) -> PathBuf {
        folder.join(FILE)
    }

    /// The address as the database's driver takes it.
    pub(super) fn url(&self) -> String {
        match self {
            Self::Folder(folder) => sqlite(&Self::file(folder)),
            Self::Postgres(url) => url.clone(),
        }
    }
}

/// The address of a file of SQLite. Letters that mean something in an address are escaped.
pub(super) fn sqlite(file: &Path) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/._-".contains(&byte);
    let path = file.to_string_lossy().bytes().fold(String::new(), |mut path, byte| {
        if plain(byte) {
            path.push(char::from(byte));
        } else {
            // Writing to a string cannot fail.
            let _ = write!(path, "%{byte:02X}");
        }
        path
    });
    format!("sqlite://{path}?mode=rwc")
}

impl FromStr for Address {
    type Err = StoreFault;

    fn from_str(text: &str) -> Result<Self, StoreFault> {
        let is_postgres = text.starts_with("postgres://") || text.starts_with("postgresql://");
        match text.split_once("://") {
            Some(_) if is_postgres => Ok(Self::Postgres(text.to_owned())),
            None if !text.is_empty() => Ok(Self::Folder(PathBuf::from(text))),
            _ => Err(StoreFault::Address(text.to_owned())),
        }
    }
}

/// Without name and password.
impl fmt::Display for Address {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Folder(folder) => folder.display().fmt(out),
            Self::Postgres(url) => {
                let rest = url.split_once("://").map_or(url.as_str(), |(_, rest)| rest);
                let place = rest.rsplit_once('@').map_or(rest, |(_, place)| place);
                let place = place.split('?').next().unwrap_or_default();
                write!(out, "PostgreSQL at {place}")
            }
        }
    }
}
