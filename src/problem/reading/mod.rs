//! From the text of a file to its draft, or to all its faults, each at its place.

mod advice;
pub(super) mod check;
mod course_file;
pub(super) mod digest;
pub(super) mod document;
mod homework_file;
pub(super) mod limits;
pub(super) mod load;
pub(super) mod mentions;
pub(super) mod numerals;
pub(super) mod origin;
pub(super) mod position;
pub(super) mod schema;
mod settings_file;
pub(super) mod shape;
mod syntax;
pub(super) mod turning;
pub(super) mod unsound;
