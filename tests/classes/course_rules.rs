//! The rules of a course, through the public API: handing in, release, corrections, marks of a class, rosters and redaction.

mod class;
mod corrections;
mod hand_ins;
mod marks;
mod records;
