//! Columns that forms and other systems add to a table, and that answer nothing unless a part is called so.

/// Their headings, in small letters: when something was handed in, by whom, and what the other system made of it.
const BESIDE: [&str; 42] = [
    "timestamp",
    "zeitstempel",
    "horodateur",
    "marca temporal",
    "submitted",
    "submitted at",
    "submission date",
    "submission time",
    "started on",
    "start time",
    "completed",
    "completion time",
    "last modified time",
    "time taken",
    "id",
    "id number",
    "student id",
    "response id",
    "submission id",
    "ip address",
    "email",
    "email address",
    "e-mail",
    "e-mail address",
    "username",
    "user name",
    "login",
    "name",
    "first name",
    "last name",
    "surname",
    "full name",
    "student name",
    "section",
    "group",
    "class",
    "department",
    "institution",
    "comment",
    "comments",
    "score",
    "grade",
];

/// Whether a column of that heading answers nothing, where no part is called so.
///
/// ```
/// use momentous_exercise::is_beside;
/// assert!(is_beside("Timestamp") && is_beside("Email Address") && !is_beside("v_A2"));
/// ```
#[must_use]
pub fn is_beside(heading: &str) -> bool {
    BESIDE.iter().any(|beside| beside.eq_ignore_ascii_case(heading))
}
