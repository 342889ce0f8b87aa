//! Pages for those who teach, of what students handed in, and their decisions about it.

mod answers;
mod by_hand;
mod class;
mod correction;
mod course;
mod gradebook;
mod member;
mod part_title;
mod regrade;
mod retention;
mod statistics;
mod trail;

pub(super) use answers::answers;
pub(super) use by_hand::{redact, set_points};
pub(super) use course::{course_gradebook, course_gradebook_csv, own_grades, percent, save_grading};
pub(super) use gradebook::{gradebook, gradebook_csv};
pub(super) use member::{data, erase, member};
pub(super) use regrade::{regrade, regrade_apply};
pub(super) use retention::{forget, retention};
pub(super) use statistics::statistics;
pub(super) use trail::trail;
