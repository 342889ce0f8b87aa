//! Problems that belong to a course.

use serde::{Deserialize, Serialize};

use super::key::Key;
use super::moment::Moment;
use super::people::Course;

/// The text of a problem file, kept by its digest for as long as a sheet was drawn from it.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct ProblemFile {
    /// The digest of the text.
    pub digest: String,
    /// The problem's identity.
    pub problem: String,
    /// The text.
    pub text: String,
    /// The course that it belongs to; nothing where it is one of the bank's.
    pub course: Option<Key<Course>>,
    /// When it was published; a draft was not.
    pub published: Option<Moment>,
    /// When it was saved.
    pub saved: Moment,
}
