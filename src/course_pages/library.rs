//! The problems of courses, as their sheets were drawn.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};

use lru::LruCache;

use momentous_bank::FOLDER;
use momentous_course::{Course, Item, Key, ProblemFile, Weights};
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_problem::{self as problem, CourseSymbols, Problem, compile, load};

/// The compiled problems that are kept; each takes up to a few megabytes.
const MOST: NonZeroUsize = NonZeroUsize::new(128).expect("not zero");

/// Problems compiled with the secret of a course; those least asked for are forgotten.
pub(super) struct CourseLibrary(Mutex<Compiled>);

type Compiled = LruCache<Name, Arc<Problem>>;

/// By what compiled problems are told apart: the course, the digest, the course's letters, and where parts weigh otherwise than in the
/// file the form with their weights.
type Name = (Key<Course>, String, CourseSymbols, Option<(Option<String>, Weights)>);

fn name(course: Key<Course>, digest: &str, item: &Item) -> Name {
    let weighed = (!item.weights.is_empty()).then(|| (item.form.clone(), item.weights.clone()));
    (course, digest.to_owned(), item.letters.clone(), weighed)
}

impl Default for CourseLibrary {
    fn default() -> Self {
        Self(Mutex::new(LruCache::new(MOST)))
    }
}

impl CourseLibrary {
    /// A problem that was compiled before and is still kept.
    pub(super) fn known(&self, course: Key<Course>, digest: &str, item: &Item) -> Option<Arc<Problem>> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        kept.get(&name(course, digest, item)).map(Arc::clone)
    }

    /// A problem as a course draws it, printed in the letters of an item and with the weights of its parts.
    ///
    /// # Errors
    /// Where the file is no problem.
    pub(super) fn problem(&self, course: &Course, file: &ProblemFile, item: &Item) -> Result<Arc<Problem>, Faults> {
        if let Some(problem) = self.known(course.key, &file.digest, item) {
            return Ok(problem);
        }
        // Others are served while it compiles.
        let problem = compiled(course, file, item)?;
        let name = name(course.key, &file.digest, item);
        self.0.lock().unwrap_or_else(PoisonError::into_inner).put(name, Arc::clone(&problem));
        Ok(problem)
    }
}

/// The same, which nobody keeps: a file that is being written is another one after each word.
///
/// # Errors
/// Where the file is no problem.
pub(super) fn compiled(course: &Course, file: &ProblemFile, item: &Item) -> Result<Arc<Problem>, Faults> {
    let loaded = load(source(file))?.in_course(&problem::Course { symbols: item.letters.clone() });
    Ok(Arc::new(weighed(compile(loaded, Some(course.secret.as_bytes()))?, item)))
}

/// The problem with the weights of an item in place of its parts' points.
fn weighed(problem: Problem, item: &Item) -> Problem {
    let form = problem.form(item.form.as_deref()).filter(|_| !item.weights.is_empty());
    let parts = form.and_then(|place| Some((place, &problem.forms().get(place)?.parts)));
    match parts.map(|(place, parts)| (place, item.weights.over(parts))) {
        Some((place, points)) => problem.with_points(place, &points),
        None => problem,
    }
}

/// A problem file for its readers. In this folder it is under the settings of the bank, as it was when it was read from there.
pub(super) fn source(file: &ProblemFile) -> Source {
    Source::new(&format!("{FOLDER}/{}.yaml", file.problem), &file.text)
}
