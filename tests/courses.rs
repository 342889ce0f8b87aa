//! Courses, request by request, without a network: SQLite in a folder of the test's own, and a clock that the test sets.
#![cfg(feature = "serve")]
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

#[path = "courses/access.rs"]
mod access;
#[path = "courses/early.rs"]
mod early;
#[path = "courses/editor.rs"]
mod editor;
#[path = "courses/grades.rs"]
mod grades;
#[path = "courses/old_data.rs"]
mod old_data;
#[path = "courses/print.rs"]
mod print;
#[path = "courses/problems.rs"]
mod problems;
#[path = "courses/refused.rs"]
mod refused;
#[path = "courses/sign_in.rs"]
mod sign_in;
#[path = "courses/staff.rs"]
mod staff;
#[path = "courses/student.rs"]
mod student;
#[path = "courses/university.rs"]
mod university;
