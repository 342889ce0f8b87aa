//! The problems of courses, as their sheets were drawn.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};

use lru::LruCache;

use momentous_bank::FOLDER;
use momentous_course::{Course, Key, ProblemFile};
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_problem::{self as problem, CourseSymbols, Problem, compile, load};

/// The compiled problems that are kept; each takes up to a few megabytes.
const MOST: NonZeroUsize = NonZeroUsize::new(128).expect("not zero");

/// Problems compiled with the secret of a course; those least asked for are forgotten.
pub(super) struct CourseLibrary(Mutex<Compiled>);

/// Compiled problems by course, digest and the course's letters.
type Compiled = LruCache<(Key<Course>, String, CourseSymbols), Arc<Problem>>;

impl Default for CourseLibrary {
    fn default() -> Self {
        Self(Mutex::new(LruCache::new(MOST)))
    }
}

impl CourseLibrary {
    /// A problem that was compiled before and is still kept.
    pub(super) fn known(&self, course: Key<Course>, digest: &str, letters: &CourseSymbols) -> Option<Arc<Problem>> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        kept.get(&(course, digest.to_owned(), letters.clone())).map(Arc::clone)
    }

    /// A problem as a course draws it, printed in these letters.
    ///
    /// # Errors
    /// Where the file is no problem.
    pub(super) fn problem(
        &self,
        course: &Course,
        file: &ProblemFile,
        letters: &CourseSymbols,
    ) -> Result<Arc<Problem>, Faults> {
        if let Some(problem) = self.known(course.key, &file.digest, letters) {
            return Ok(problem);
        }
        // Others are served while it compiles.
        let loaded = load(source(file))?.in_course(&problem::Course { symbols: letters.clone() });
        let problem = Arc::new(compile(loaded, Some(course.secret.as_bytes()))?);
        let name = (course.key, file.digest.clone(), letters.clone());
        self.0.lock().unwrap_or_else(PoisonError::into_inner).put(name, Arc::clone(&problem));
        Ok(problem)
    }
}

/// A problem file for its readers. In this folder it is under the settings of the bank, as it was when it was read from there.
pub(super) fn source(file: &ProblemFile) -> Source {
    Source::new(&format!("{FOLDER}/{}.yaml", file.problem), &file.text)
}
