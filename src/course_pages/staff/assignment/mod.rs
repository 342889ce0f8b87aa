//! Assignments as their instructors write them.

mod catalogue;
mod draft;
mod edit;
mod editor;
mod extensions;
mod homework;
mod look;
mod read;

pub(crate) use edit::{edit, make, new, save};
pub(crate) use extensions::{extend, extensions};
pub(crate) use look::look;
pub(super) use look::{SampleSheet, looked};

use momentous_store::AssignmentWithItems;

use super::super::outcome::NotShown;
use super::super::visit::Visit;

/// The assignment of the address, where it belongs to the course of the address.
pub(super) async fn assignment_of(visit: &Visit) -> Result<AssignmentWithItems, NotShown> {
    let missing = || NotShown::missing("there is no such assignment in this course");
    let whole = visit.store().assignment(visit.key("assignment")?).await?.ok_or_else(missing)?;
    if whole.assignment.course == visit.course()?.key { Ok(whole) } else { Err(missing()) }
}
