//! One attempt of one student, as it was handed in.

use std::fmt;
use std::path::PathBuf;

/// The bytes that a submission usually has.
const USUAL_LENGTH: usize = 96;

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
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Column {
    Key(Key),
    Part(String),
    /// A column without a heading.
    Nothing,
}

impl Column {
    /// Reads a heading of a table; every column that is no key is a part.
    pub(super) fn of(heading: &str) -> Self {
        match KEYS.iter().find(|(_, own)| own.eq_ignore_ascii_case(heading)) {
            Some((key, _)) => Self::Key(*key),
            None if heading.is_empty() => Self::Nothing,
            None => Self::Part(heading.to_owned()),
        }
    }
}

/// One attempt of one student. Its texts stand one after the other in one piece of memory, for many wait in a queue.
#[derive(Clone, Debug)]
pub(super) struct Submission {
    pub place: Place,
    text: String,
    keys: [Span; KEYS.len()],
    /// The parts that were answered, each with the answer.
    answers: Vec<[Span; 2]>,
}

/// Where a text begins and ends.
#[derive(Clone, Copy, Debug, Default)]
struct Span(usize, usize);

impl Submission {
    /// A submission in which nothing is said yet.
    pub(super) fn new(place: Place) -> Self {
        Self { place, text: String::with_capacity(USUAL_LENGTH), keys: Default::default(), answers: Vec::new() }
    }

    /// Takes what stands in a row, cell by cell.
    pub(super) fn of_row<'a>(place: Place, columns: &[Column], row: impl Iterator<Item = &'a str>) -> Self {
        let mut submission = Self::new(place);
        for (column, cell) in columns.iter().zip(row).filter(|(_, cell)| !cell.is_empty()) {
            match column {
                Column::Key(key) => submission.put_key(*key, cell),
                Column::Part(part) => submission.put_answer(part, cell),
                Column::Nothing => {}
            }
        }
        submission
    }

    /// Says what stands under a key; what was said first holds.
    pub(super) fn put_key(&mut self, key: Key, text: &str) {
        if self.key(key).is_empty() {
            self.keys[key as usize] = self.put(text);
        }
    }

    /// Answers a part; an answer without anything in it is none.
    pub(super) fn put_answer(&mut self, part: &str, answer: &str) {
        if !answer.trim().is_empty() {
            let spans = [self.put(part), self.put(answer)];
            self.answers.push(spans);
        }
    }

    fn put(&mut self, text: &str) -> Span {
        let start = self.text.len();
        self.text.push_str(text.trim());
        Span(start, self.text.len())
    }

    fn at(&self, span: Span) -> &str {
        self.text.get(span.0..span.1).unwrap_or_default()
    }

    /// What stands under a key; nothing where there is none.
    pub(super) fn key(&self, key: Key) -> &str {
        self.at(self.keys[key as usize])
    }

    /// The parts that were answered, each with the answer.
    pub(super) fn answers(&self) -> impl Iterator<Item = (&str, &str)> {
        self.answers.iter().map(|[part, answer]| (self.at(*part), self.at(*answer)))
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
