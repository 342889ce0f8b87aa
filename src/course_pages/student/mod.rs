//! A course as its students see it.

mod course;
mod hand_in;
mod hint;
mod item_page;
mod own_sheet;
mod solution;
mod work;

pub(super) use course::{assignment, course};
pub(super) use hand_in::{draft, hand_in, read};
pub(super) use hint::{further, hint};
pub(super) use item_page::item;
pub(super) use solution::solution;
