//! What people call problems: by the titles in their files.

use std::collections::BTreeMap;

use momentous_course::ProblemFile;
use momentous_exercise::calls::Refused;
use momentous_exercise::titled;
use momentous_problem::load;
use momentous_web::App;

use super::library;
use super::outcome::NotShown;
use super::visit::Visit;

/// The titles of problems as a course has them.
pub(super) struct Titles {
    /// Those that the course has written itself, by their identities.
    by_course: BTreeMap<String, String>,
}

impl Titles {
    /// The titles that the course of the address knows.
    pub(super) async fn of(visit: &Visit) -> Result<Self, NotShown> {
        let mut files = visit.store().problem_files(visit.course()?.key).await?;
        // A version that is published goes before drafts, the latest before others.
        files.sort_by_key(|file| (file.published, file.saved));
        let titled = |files: Vec<ProblemFile>| {
            let latest: BTreeMap<String, ProblemFile> =
                files.into_iter().map(|file| (file.problem.clone(), file)).collect();
            latest.into_iter().map(|(problem, file)| (problem, title(&file))).collect()
        };
        Ok(Self { by_course: visit.work(move |_| Ok(titled(files))).await? })
    }

    /// The title of a problem of the course or of the bank.
    pub(super) fn title(&self, app: &App, problem: &str) -> Result<String, Refused> {
        self.by_course.get(problem).map_or_else(|| app.pages.library.title(problem), |title| Ok(title.clone()))
    }

    /// The same; nothing where neither has a problem of this identity.
    pub(super) fn known(&self, app: &App, word: &str) -> Result<Option<String>, Refused> {
        match self.by_course.get(word) {
            Some(title) => Ok(Some(title.clone())),
            None => app.pages.library.known_title(word),
        }
    }
}

/// The title in a problem file; where an older program could read it and this one cannot, words made of the problem's identity.
pub(super) fn title(file: &ProblemFile) -> String {
    match load(library::source(file)) {
        Ok(loaded) => loaded.draft.title,
        Err(_) => titled(file.problem.rsplit('/').next().unwrap_or(&file.problem)),
    }
}
