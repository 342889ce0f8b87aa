//! Problem files, kept by the digest of their text.

use sqlx::query;

use momentous_course::{Course, Key, ProblemFile};

use super::fault::StoreFault;
use super::open::Store;
use super::records::to_json;
use super::trail::Entry;

/// The column of what belongs to no course.
fn course_of(course: Option<Key<Course>>) -> String {
    course.map_or_else(String::new, |course| course.to_string())
}

impl Store {
    /// Keeps a problem file; one with that digest is replaced, whose text is the same.
    ///
    /// # Errors
    /// Where the database refuses, as for everything here.
    pub async fn save_problem_file(&self, file: &ProblemFile, entry: Option<&Entry>) -> Result<(), StoreFault> {
        let statement = query(
            "INSERT INTO problem_file (course, digest, problem, data) VALUES ($1, $2, $3, $4) \
             ON CONFLICT (course, digest) DO UPDATE SET data = excluded.data",
        );
        let statement = statement
            .bind(course_of(file.course))
            .bind(file.digest.clone())
            .bind(file.problem.clone())
            .bind(to_json(file)?);
        let entry = entry.map(Entry::statement).transpose()?;
        self.write([statement].into_iter().chain(entry).collect()).await.map(|_| ())
    }

    /// The file with that digest, of a course or of the bank.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn problem_file(&self, course: Key<Course>, digest: &str) -> Result<Option<ProblemFile>, StoreFault> {
        let statement =
            query("SELECT data FROM problem_file WHERE digest = $1 AND course IN ($2, '') ORDER BY course DESC");
        self.one(statement.bind(digest.to_owned()).bind(course.to_string())).await
    }

    /// The files of a course.
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn problem_files(&self, course: Key<Course>) -> Result<Vec<ProblemFile>, StoreFault> {
        let statement = query("SELECT data FROM problem_file WHERE course = $1 ORDER BY problem, digest");
        self.records(statement.bind(course.to_string())).await
    }
}
