//! People, and the courses in which they take part.

use serde::{Deserialize, Serialize};

use momentous_grade::DecimalMark;

use super::grading::Grading;
use super::key::Key;
use super::moment::Moment;

/// Somebody who may sign in. This record alone says who it is; it can be erased while everything else stays.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Person {
    /// The key by which other records name this person.
    pub key: Key<Person>,
    /// The name by which the person signs in, which is the identity in rosters: a number, an address. Unique; empty once erased.
    pub login: String,
    /// The name of the person; empty once erased.
    pub name: String,
    /// Whether the person runs this server.
    pub operator: bool,
    /// When it was erased, where it was.
    pub erased: Option<Moment>,
}

impl Person {
    /// The name, or what stands for it once the person is erased.
    #[must_use]
    pub fn shown(&self) -> &str {
        match (&self.erased, self.name.as_str(), self.login.as_str()) {
            (Some(_), ..) => "(erased)",
            (None, "", login) => login,
            (None, name, _) => name,
        }
    }
}

/// A course.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Course {
    /// The key by which other records name it.
    pub key: Key<Course>,
    /// Its title.
    pub title: String,
    /// The IANA name of its time zone.
    pub zone: String,
    /// The sign between whole and decimal digits in its students' answers.
    pub decimal: DecimalMark,
    /// The secret with which its seeds and its problems' numbers are drawn.
    #[serde(skip_serializing)]
    #[serde(default)]
    pub secret: String,
    /// The days for which answers are kept after the last assignment has closed; without end where none are named.
    pub retention_days: Option<u32>,
    /// How its assignments make the grade.
    #[serde(default)]
    pub grading: Grading,
    /// When it was made.
    pub created: Moment,
}

/// The milliseconds of a day.
const DAY: i64 = 86_400_000;

impl Course {
    /// Until when answers are kept, by the close of the last assignment; nothing where they are kept without end.
    #[must_use]
    pub fn keeps_until(&self, closes: Moment) -> Option<Moment> {
        Some(closes.after(i64::from(self.retention_days?).saturating_mul(DAY)))
    }
}

/// The role of somebody in a course, each with the rights of those before it.
#[derive(Clone, Copy, Debug, Deserialize, Eq, Hash, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Hands in answers.
    Student,
    /// Sees what students handed in.
    Assistant,
    /// Makes assignments, and decides on marks.
    Instructor,
}

impl Role {
    /// Every role.
    pub const ALL: [Self; 3] = [Self::Student, Self::Assistant, Self::Instructor];

    /// The word by which tables and pages name it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Student => "student",
            Self::Assistant => "assistant",
            Self::Instructor => "instructor",
        }
    }

    /// The role of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.name() == name)
    }

    /// Whether it is one of those who teach.
    #[must_use]
    pub fn is_staff(self) -> bool {
        self > Self::Student
    }
}

/// Somebody in a course. Sheets and attempts hold this key, not the person's.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Member {
    /// The key by which other records name this member; seeds are drawn from it.
    pub key: Key<Member>,
    /// The course.
    pub course: Key<Course>,
    /// The person.
    pub person: Key<Person>,
    /// The role of the person in the course.
    pub role: Role,
    /// The section; empty where the course has none.
    pub section: String,
    /// When the person left the course, or was taken off its roster.
    pub left: Option<Moment>,
}
