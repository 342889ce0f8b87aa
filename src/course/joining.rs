//! How people come into a course without being on a roster: a code with which they ask for a place, which whoever teaches confirms.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::key::Key;
use super::moment::Moment;
use super::people::{Course, Person};

/// The characters of codes. Those that look alike (I and 1, O and 0) are left out.
const CHARACTERS: &[u8; 32] = b"ABCDEFGHJKLMNPQRSTUVWXYZ23456789";
/// The characters of a code: as many codes as nobody tries out.
const LENGTH: usize = 8;

/// A code with which people ask for a place, as it is written on a board: in capitals, with a hyphen in the middle.
///
/// ```
/// use momentous_course::Code;
/// let code = Code::drawn([0, 1, 2, 3, 28, 29, 30, 31]);
/// assert_eq!(code.to_string(), "ABCD-6789");
/// assert_eq!(Code::read(" abcd 6789"), Some(code));
/// assert_eq!(Code::read("ABCD-0000"), None, "no code has a zero");
/// ```
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Code(String);

impl Code {
    /// The code of random bytes.
    #[must_use]
    pub fn drawn(bytes: [u8; LENGTH]) -> Self {
        Self(bytes.map(|byte| char::from(CHARACTERS[usize::from(byte) % CHARACTERS.len()])).iter().collect())
    }

    /// A code as people type it; nothing where no code can be meant.
    #[must_use]
    pub fn read(typed: &str) -> Option<Self> {
        let code: String = typed.chars().filter(|sign| !sign.is_whitespace() && *sign != '-').collect();
        let code = code.to_ascii_uppercase();
        (code.len() == LENGTH && code.bytes().all(|byte| CHARACTERS.contains(&byte))).then_some(Self(code))
    }

    /// Its characters alone, as they stand in an address.
    #[must_use]
    pub fn plain(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Code {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (first, second) = self.0.split_at(LENGTH / 2);
        write!(out, "{first}-{second}")
    }
}

/// The code of a course, as long as it is good.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct CourseCode {
    /// The course.
    pub course: Key<Course>,
    /// The code.
    pub code: Code,
    /// When it ends.
    pub expires: Moment,
}

/// Somebody asks for a place in a course.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct PlaceRequest {
    /// The key by which other records name it.
    pub key: Key<PlaceRequest>,
    /// The course.
    pub course: Key<Course>,
    /// The person who asks.
    pub asker: Asker,
    /// When.
    pub at: Moment,
}

/// A person who asks for a place.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Asker {
    /// Somebody who was signed in.
    Known(Key<Person>),
    /// Somebody who says so, and whom nobody knows before the request is confirmed.
    New {
        /// The name by which this person wants to sign in.
        login: String,
        /// The name of the person.
        name: String,
        /// The hash of the password that the person has chosen.
        password: String,
    },
}
