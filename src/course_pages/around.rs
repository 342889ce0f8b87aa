//! What the template of every page of a course is told of who asks and of the course.

use serde::Serialize;

/// What every page of a course knows besides its own.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Around {
    pub(super) signed_in: Option<String>,
    pub(super) operator: bool,
    pub(super) course: Option<AroundCourse>,
}

/// The same of the course of the address.
#[derive(Clone, Debug, Serialize)]
pub(super) struct AroundCourse {
    pub(super) key: String,
    pub(super) title: String,
    pub(super) role: &'static str,
    pub(super) staff: bool,
}
