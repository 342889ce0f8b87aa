//! The rules of a course, through the public API: handing in, release, corrections, marks of a class, rosters and redaction.

#![cfg(feature = "serve")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test says bluntly what it expects")]

#[path = "course_rules/class.rs"]
mod class;
#[path = "course_rules/corrections.rs"]
mod corrections;
#[path = "course_rules/hand_ins.rs"]
mod hand_ins;
#[path = "course_rules/marks.rs"]
mod marks;
#[path = "course_rules/records.rs"]
mod records;
