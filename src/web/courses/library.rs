//! The problems of courses, as their sheets were drawn.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};

use lru::LruCache;

use crate::bank::load_in_course;
use crate::course::{Course, Key};
use crate::fault::{Faults, Source};
use crate::problem::{Problem, compile};

/// The compiled problems that are kept; each takes up to a few megabytes.
const MOST: NonZeroUsize = NonZeroUsize::new(128).expect("not zero");

/// Problems compiled with the secret of a course, by course and digest; those least asked for are forgotten.
pub(super) struct CourseLibrary(Mutex<Compiled>);

/// Compiled problems by course and digest.
type Compiled = LruCache<(Key<Course>, String), Arc<Problem>>;

impl Default for CourseLibrary {
    fn default() -> Self {
        Self(Mutex::new(LruCache::new(MOST)))
    }
}

impl CourseLibrary {
    /// A problem that was compiled before and is still kept.
    pub(super) fn known(&self, course: Key<Course>, digest: &str) -> Option<Arc<Problem>> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        kept.get(&(course, digest.to_owned())).map(Arc::clone)
    }

    /// A problem as a course draws it, by its text and the digest of that.
    ///
    /// # Errors
    /// Where the text is no problem.
    pub(super) fn problem(&self, course: &Course, digest: &str, source: Source) -> Result<Arc<Problem>, Faults> {
        if let Some(problem) = self.known(course.key, digest) {
            return Ok(problem);
        }
        // Others are served while it compiles.
        let problem = Arc::new(compile(load_in_course(source)?, Some(course.secret.as_bytes()))?);
        self.0
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .put((course.key, digest.to_owned()), Arc::clone(&problem));
        Ok(problem)
    }
}
