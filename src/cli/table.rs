//! Tables of comma-separated values in files.

use std::io;
use std::io::BufReader;
use std::io::Cursor;
use std::path::Path;

use serde::de::DeserializeOwned;

use crate::exercise::Table;
use crate::fault::Input;

use super::failure::Failure;

/// The longest table that is read as a whole, in bytes.
const LARGEST: u64 = 1 << 26;

/// Bytes that are read at once.
const BUFFER: usize = 1 << 16;

/// A file of any length, to be read piece by piece.
pub(super) fn input(path: &Path) -> io::Result<BufReader<Input>> {
    Ok(BufReader::with_capacity(BUFFER, Input::open(path)?))
}

/// Opens a table of any length.
pub(super) fn open(path: &Path) -> Result<Table<BufReader<Input>>, Failure> {
    let input = input(path).map_err(|error| Failure::file(path, "read", &error))?;
    Table::read(input).map_err(|message| failure(path, &message))
}

/// Opens a table of which all will be kept.
pub(super) fn whole(path: &Path) -> Result<Table<Cursor<Vec<u8>>>, Failure> {
    let bytes = Input::open(path).and_then(|input| input.bytes(LARGEST));
    let bytes = bytes.map_err(|error| Failure::file(path, "read", &error))?;
    Table::read(Cursor::new(bytes)).map_err(|message| failure(path, &message))
}

/// The failure of a table as a whole.
pub(super) fn failure(path: &Path, message: &str) -> Failure {
    Failure::unusable(format!("{}: {message}", path.display()))
}

/// Every row of a table whose columns are fields of a type.
pub(super) fn typed<T: DeserializeOwned>(path: &Path) -> csv::Result<Vec<T>> {
    let text = Input::open(path)?.text(LARGEST)?;
    csv::Reader::from_reader(text.as_bytes()).deserialize().collect()
}
