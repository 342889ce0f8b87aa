//! One attempt of one student, as it was handed in.

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

use csv::StringRecord;

/// The columns, or keys, that are not parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Key {
    Student,
    Problem,
    Digest,
    Seed,
    Form,
    Attempt,
    Hints,
}

/// Every key with its heading, in the order of the type.
pub(super) const KEYS: [(Key, &str); 7] = [
    (Key::Student, "student"),
    (Key::Problem, "problem"),
    (Key::Digest, "digest"),
    (Key::Seed, "seed"),
    (Key::Form, "form"),
    (Key::Attempt, "attempt"),
    (Key::Hints, "hints"),
];

/// The keys that two attempts at the same question share.
const SHARED: [Key; 5] = [Key::Student, Key::Problem, Key::Digest, Key::Seed, Key::Form];

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
            match KEYS.iter().find(|(_, own)| own.eq_ignore_ascii_case(heading)) {
                Some((key, _)) => columns.keys[*key as usize] = columns.keys[*key as usize].or(Some(index)),
                None if heading.is_empty() => {}
                None => columns.parts.push((heading.to_owned(), index)),
            }
        }
        columns
    }

    /// Whether there is a column for that key.
    pub(super) fn has(&self, key: Key) -> bool {
        self.keys[key as usize].is_some()
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
    pub(super) fn key(&self, key: Key) -> &str {
        self.columns.keys[key as usize].and_then(|column| self.row.get(column)).unwrap_or_default().trim()
    }

    /// The parts that were answered, each with the answer.
    pub(super) fn answers(&self) -> impl Iterator<Item = (&str, &str)> {
        let parts = self.columns.parts.iter();
        let answers = parts.filter_map(|(part, column)| Some((part.as_str(), self.row.get(*column)?.trim())));
        answers.filter(|(_, answer)| !answer.is_empty())
    }

    /// Whether both are attempts of one student at one question. What has no student is nobody's second attempt.
    pub(super) fn is_beside(&self, other: &Self) -> bool {
        !self.key(Key::Student).is_empty() && SHARED.iter().all(|key| self.key(*key) == other.key(*key))
    }

    /// The number of the attempt, from 1; none where nothing, or no number, stands there.
    pub(super) fn attempt(&self) -> Option<u32> {
        self.key(Key::Attempt).parse().ok().filter(|number| *number > 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_keys_stand_in_the_order_of_the_type() {
        assert!(KEYS.iter().enumerate().all(|(place, (key, _))| *key as usize == place));
    }
}
