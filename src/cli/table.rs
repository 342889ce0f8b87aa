//! Reading tables of comma-separated values as people's programs write them.

use std::io::BufRead;
use std::io::BufReader;
use std::path::Path;

use serde::de::DeserializeOwned;

use crate::fault::Input;

use super::failure::Failure;

/// A table with a line of headings, read row by row.
pub(super) struct Table {
    /// The headings, without spaces around them and without the byte order mark that some programs write.
    pub headings: Vec<String>,
    rows: csv::Reader<BufReader<Input>>,
    /// The row that was read last, in memory that the next one takes over.
    row: csv::StringRecord,
    line: u64,
}

impl Table {
    /// Opens a table; semicolons separate its cells where the first line has some and no comma.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        Self::trimmed(path, csv::Trim::All)
    }

    /// The same with cells as they stand, spaces around them included: much faster where a table has many columns.
    pub(super) fn as_it_stands(path: &Path) -> Result<Self, Failure> {
        Self::trimmed(path, csv::Trim::None)
    }

    fn trimmed(path: &Path, trim: csv::Trim) -> Result<Self, Failure> {
        let unreadable = |error: &std::io::Error| Failure::file(path, "read", error);
        let mut file = BufReader::new(Input::open(path).map_err(|error| unreadable(&error))?);
        let start = file.fill_buf().map_err(|error| unreadable(&error))?;
        let line = start.split(|byte| *byte == b'\n').next().unwrap_or_default();
        let delimiter = if line.contains(&b';') && !line.contains(&b',') { b';' } else { b',' };
        let mut rows = csv::ReaderBuilder::new().delimiter(delimiter).trim(trim).from_reader(file);
        let said =
            |error: &csv::Error| Failure::unusable(format!("{} cannot be read as a table: {error}", path.display()));
        let headings = rows.headers().map_err(|error| said(&error))?;
        let headings =
            headings.iter().map(|heading| heading.trim_start_matches('\u{feff}').trim().to_owned()).collect();
        Ok(Self { headings, rows, row: csv::StringRecord::new(), line: 1 })
    }

    /// The position of the column with that heading, in small or capital letters.
    pub(super) fn column(&self, heading: &str) -> Option<usize> {
        self.headings.iter().position(|own| own.eq_ignore_ascii_case(heading))
    }

    /// The next row with its line number, or what is wrong with it.
    pub(super) fn next_row(&mut self) -> Option<(u64, Result<&csv::StringRecord, String>)> {
        match self.rows.read_record(&mut self.row) {
            Ok(false) => None,
            Ok(true) => {
                self.line = self.row.position().map_or(self.line + 1, csv::Position::line);
                Some((self.line, Ok(&self.row)))
            }
            Err(error) => {
                self.line = error.position().map_or(self.line + 1, csv::Position::line);
                Some((self.line, Err(malformed(error.kind()))))
            }
        }
    }
}

/// The longest table that is read as a whole, in bytes.
const LARGEST: u64 = 1 << 26;

/// Every row of a table whose columns are fields of a type.
pub(super) fn typed<T: DeserializeOwned>(path: &Path) -> csv::Result<Vec<T>> {
    let text = Input::open(path)?.text(LARGEST)?;
    csv::Reader::from_reader(text.as_bytes()).deserialize().collect()
}

/// What is wrong with a row, without the place, which stands before it.
fn malformed(kind: &csv::ErrorKind) -> String {
    match kind {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("the row has {len} cells, the headings are {expected_len}")
        }
        csv::ErrorKind::Utf8 { .. } => "the row is not UTF-8".to_owned(),
        csv::ErrorKind::Io(error) => error.to_string(),
        _ => "the row cannot be read".to_owned(),
    }
}
