//! One attempt of one student, as it was handed in.

mod beside;
mod object;

use std::fmt;
use std::path::PathBuf;

pub use beside::is_beside;

/// The bytes that a submission usually has.
const USUAL_LENGTH: usize = 96;

/// The longest text of a key, in bytes. Longer ones are no names, and would be kept for as long as a class is marked.
const LONGEST_KEY: usize = 256;

/// The bytes that are kept of an answer: more than any reader takes, so that the verdict is the same.
const LONGEST_ANSWER: usize = 1 << 14;

/// The columns, or keys, that are not parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the table below gives each its heading")]
pub enum Key {
    Student,
    Problem,
    Digest,
    Seed,
    Form,
    Scheme,
    Given,
    Attempt,
    Hints,
    FurtherHints,
}

/// Every key with its heading, in the order of the type.
const KEYS: [(Key, &str); 10] = [
    (Key::Student, "student"),
    (Key::Problem, "problem"),
    (Key::Digest, "digest"),
    (Key::Seed, "seed"),
    (Key::Form, "form"),
    (Key::Scheme, "scheme"),
    (Key::Given, "given"),
    (Key::Attempt, "attempt"),
    (Key::Hints, "hints"),
    (Key::FurtherHints, "further_hints"),
];

impl Key {
    /// The key of that heading, in small or capital letters.
    fn of(heading: &str) -> Option<Self> {
        KEYS.iter().find(|(_, spelt)| spelt.eq_ignore_ascii_case(heading)).map(|(key, _)| *key)
    }

    fn heading(self) -> &'static str {
        KEYS[self as usize].1
    }
}

/// The place of a submission.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
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
pub enum Column {
    /// The cell says what stands under a key.
    Key(Key),
    /// The cell answers a part.
    Part(String),
    /// A column without a heading.
    Nothing,
}

impl Column {
    /// Reads the headings of a table. A column that is no key is a part.
    ///
    /// # Errors
    /// Where one stands there twice, or one is missing that must be there.
    pub fn all(headings: &[String]) -> Result<Vec<Self>, String> {
        let columns: Vec<Self> = headings.iter().map(|heading| Self::of(heading)).collect();
        for (key, heading) in KEYS {
            let count = columns.iter().filter(|column| **column == Self::Key(key)).count();
            match (count, key) {
                (0, Key::Problem | Key::Seed) => return Err(format!("there is no column `{heading}`")),
                (0 | 1, _) => {}
                _ => {
                    return Err(format!(
                        "two columns have the heading `{heading}`\nhelp: rename or remove one of them"
                    ));
                }
            }
        }
        Ok(columns)
    }

    fn of(heading: &str) -> Self {
        match Key::of(heading) {
            Some(key) => Self::Key(key),
            None if heading.is_empty() => Self::Nothing,
            None => Self::Part(heading.to_owned()),
        }
    }
}

/// One attempt of one student. Its texts stand one after the other in one piece of memory, for many wait in a queue.
///
/// ```
/// use momentous_exercise::{Key, Place, Submission};
/// let line = r#"{"student": "s17", "problem": "impact/two-carts", "seed": 7, "answers": {"v_A2": 0.500}}"#;
/// let submission = Submission::of_json(Place::Line(1), line)?;
/// assert_eq!(submission.key(Key::Seed), "7");
/// assert_eq!(submission.answers().collect::<Vec<_>>(), [("v_A2", "0.500")]);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug)]
pub struct Submission {
    /// Its place.
    pub place: Place,
    text: String,
    keys: [Span; KEYS.len()],
    /// The parts that were answered, each with the answer.
    answers: Vec<[Span; 2]>,
}

/// The beginning and the end of a text.
#[derive(Clone, Copy, Debug, Default)]
struct Span(usize, usize);

impl Submission {
    /// A submission in which nothing is said yet.
    fn new(place: Place) -> Self {
        Self { place, text: String::with_capacity(USUAL_LENGTH), keys: Default::default(), answers: Vec::new() }
    }

    /// Takes what stands in a row, cell by cell.
    ///
    /// # Errors
    /// Where a key is too long to be one.
    pub fn of_row<'a>(place: Place, columns: &[Column], row: impl Iterator<Item = &'a str>) -> Result<Self, String> {
        let mut submission = Self::new(place);
        for (column, cell) in columns.iter().zip(row).filter(|(_, cell)| !cell.is_empty()) {
            match column {
                Column::Key(key) => submission.put_key(*key, cell)?,
                Column::Part(part) => submission.put_answer(part, cell),
                Column::Nothing => {}
            }
        }
        Ok(submission)
    }

    fn put_key(&mut self, key: Key, text: &str) -> Result<(), String> {
        if text.len() > LONGEST_KEY {
            return Err(format!("`{}` is longer than {LONGEST_KEY} bytes", key.heading()));
        }
        self.keys[key as usize] = self.put(text);
        Ok(())
    }

    /// Answers a part; an answer without anything in it is none.
    fn put_answer(&mut self, part: &str, answer: &str) {
        let answer = answer.trim();
        if !answer.is_empty() {
            let spans = [self.put(part), self.put(&answer[..answer.floor_char_boundary(LONGEST_ANSWER)])];
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

    /// The text under a key; none where there is none.
    #[must_use]
    pub fn key(&self, key: Key) -> &str {
        self.at(self.keys[key as usize])
    }

    /// The parts that were answered, each with the answer.
    pub fn answers(&self) -> impl Iterator<Item = (&str, &str)> {
        self.answers.iter().map(|[part, answer]| (self.at(*part), self.at(*answer)))
    }

    /// The number under a key, if anything stands there.
    ///
    /// # Errors
    /// Where it is no number from `least` on.
    pub fn number(&self, key: Key, least: u32) -> Result<Option<u32>, String> {
        match self.key(key) {
            "" => Ok(None),
            text => match text.parse() {
                Ok(number) if number >= least => Ok(Some(number)),
                _ => Err(format!(
                    "`{}` under `{}` is not a whole number of at least {least}",
                    excerpt(text),
                    key.heading()
                )),
            },
        }
    }

    /// The memory that it takes, in bytes.
    #[must_use]
    pub fn weight(&self) -> usize {
        size_of::<Self>() + self.text.capacity() + self.answers.capacity() * size_of::<[Span; 2]>()
    }
}

/// A text that somebody typed, short enough for a message.
#[must_use]
pub fn excerpt(text: &str) -> std::borrow::Cow<'_, str> {
    const MOST: usize = 60;
    match text.char_indices().nth(MOST) {
        None => text.into(),
        Some((end, _)) => format!("{}...", &text[..end]).into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_keys_stand_in_the_order_of_the_type() {
        assert!(KEYS.iter().enumerate().all(|(place, (key, _))| *key as usize == place));
    }

    #[test]
    fn headings_that_are_missing_or_twice_there_are_told() {
        let read = |text: &str| Column::all(&text.split(',').map(str::to_owned).collect::<Vec<_>>());
        assert_eq!(read("problem,form").unwrap_err(), "there is no column `seed`");
        assert!(read("Seed,problem,seed").unwrap_err().starts_with("two columns have the heading `seed`"));
        let expected = [Column::Key(Key::Problem), Column::Key(Key::Seed), Column::Nothing, Column::Part("v".into())];
        assert_eq!(read("PROBLEM,seed,,v").unwrap(), expected);
    }

    #[test]
    fn a_key_has_a_length_that_can_be_kept() {
        let columns = [Column::Key(Key::Student)];
        let row =
            |length: usize| Submission::of_row(Place::Line(2), &columns, ["x".repeat(length).as_str()].into_iter());
        assert!(row(LONGEST_KEY).is_ok());
        assert_eq!(row(LONGEST_KEY + 1).unwrap_err(), "`student` is longer than 256 bytes");
    }
}
