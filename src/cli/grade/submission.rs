//! One attempt of one student, as it was handed in.

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

use csv::StringRecord;

/// The columns, or keys, that are not parts.
pub(super) const KEYS: [&str; 6] = ["student", "problem", "digest", "seed", "form", "attempt"];

/// Where a submission stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A line of the file.
    Line(u64),
    /// A file of the folder.
    File(PathBuf),
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(out, "{line}"),
            Self::File(path) => write!(out, "{}", path.display()),
        }
    }
}

/// Which cell of a row is what.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    keys: [Option<usize>; KEYS.len()],
    parts: Vec<(String, usize)>,
}

impl Columns {
    /// Reads the headings of a table; every column that is no key is a part.
    pub(super) fn of<'a>(headings: impl Iterator<Item = &'a str>) -> Self {
        let mut columns = Self::default();
        for (index, heading) in headings.enumerate() {
            match KEYS.iter().position(|key| key.eq_ignore_ascii_case(heading)) {
                Some(key) => columns.keys[key] = columns.keys[key].or(Some(index)),
                None if heading.is_empty() => {}
                None => columns.parts.push((heading.to_owned(), index)),
            }
        }
        columns
    }

    /// Whether there is a column for that key.
    pub(super) fn has(&self, key: &str) -> bool {
        KEYS.iter().position(|own| *own == key).is_some_and(|index| self.keys[index].is_some())
    }
}

/// One attempt of one student.
#[derive(Clone, Debug)]
pub(super) struct Submission {
    pub place: Place,
    columns: Arc<Columns>,
    row: StringRecord,
}

impl Submission {
    pub(super) fn new(place: Place, columns: Arc<Columns>, row: StringRecord) -> Self {
        Self { place, columns, row }
    }

    /// What stands under a key; nothing where there is none.
    pub(super) fn key(&self, key: &str) -> &str {
        let column = KEYS.iter().position(|own| *own == key).and_then(|index| self.columns.keys[index]);
        column.and_then(|column| self.row.get(column)).unwrap_or_default()
    }

    /// The parts that were answered, each with the answer.
    pub(super) fn answers(&self) -> impl Iterator<Item = (&str, &str)> {
        let parts = self.columns.parts.iter();
        let answers = parts.filter_map(|(part, column)| Some((part.as_str(), self.row.get(*column)?)));
        answers.filter(|(_, answer)| !answer.is_empty())
    }
}
