//! Values for the template of every page of a course: the visitor and the course.

use serde::Serialize;

/// The values that every page of a course knows besides its own.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct VisitFrame {
    pub(super) signed_in: Option<String>,
    pub(super) operator: bool,
    pub(super) course: Option<CourseFrame>,
}

/// The same of the course of the address.
#[derive(Clone, Debug, Serialize)]
pub(super) struct CourseFrame {
    pub(super) key: String,
    pub(super) title: String,
    pub(super) role: &'static str,
    pub(super) staff: bool,
}
