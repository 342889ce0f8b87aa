//! The state that the pages of courses share.

use std::sync::Arc;

use momentous_store::Store;

use super::clock::Clock;
use super::hidden::Hidden;
use super::library::CourseLibrary;
use super::limits::Limits;
use super::mail::Post;
use super::processes::Processes;

/// The state that the pages of courses share: the records, the time, and the problems as their sheets were drawn.
pub struct Courses {
    pub(super) store: Store,
    pub(super) clock: Clock,
    pub(super) limits: Limits,
    pub(super) library: CourseLibrary,
    /// The processes that read or check a teacher's file.
    pub(super) processes: Arc<Processes>,
    /// The server that takes letters, where one is configured.
    pub(super) post: Option<Post>,
    /// The kinds of problems that are not solved at the moment.
    pub(super) hidden: Hidden,
}

impl Courses {
    /// Courses whose records are kept here.
    #[must_use]
    pub fn new(store: Store, clock: Clock) -> Self {
        Self {
            store,
            clock,
            limits: Limits::new(),
            library: CourseLibrary::default(),
            processes: Processes::new(),
            post: None,
            hidden: Hidden::default(),
        }
    }

    /// The same, with letters by a server of mail.
    #[must_use]
    pub fn with_post(self, post: Option<Post>) -> Self {
        Self { post, ..self }
    }

    /// The records.
    #[must_use]
    pub fn store(&self) -> &Store {
        &self.store
    }
}
