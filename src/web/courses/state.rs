//! What the pages of courses share.

use tokio::sync::Semaphore;

use crate::store::Store;

use super::clock::Clock;
use super::library::CourseLibrary;
use super::limits::Limits;

/// What the pages of courses share: the records, the time, and the problems as their sheets were drawn.
pub struct Courses {
    pub(super) store: Store,
    pub(super) clock: Clock,
    pub(super) limits: Limits,
    pub(super) library: CourseLibrary,
    /// Lets one check of a problem file run at a time.
    pub(super) checks: Semaphore,
}

impl Courses {
    /// Courses whose records are kept here.
    #[must_use]
    pub fn new(store: Store, clock: Clock) -> Self {
        Self { store, clock, limits: Limits::new(), library: CourseLibrary::default(), checks: Semaphore::new(1) }
    }

    /// The records.
    #[must_use]
    pub fn store(&self) -> &Store {
        &self.store
    }
}
