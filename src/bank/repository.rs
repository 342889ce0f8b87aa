//! The course repository in which the program runs.

use std::path::{Path, PathBuf};

use super::course::FOLDER;

/// The folder that marks the top of a repository.
const TOP: &str = ".git";

/// The way from the current folder to that of the course: the nearest one with a folder `problem_bank`, no higher than the top of the
/// repository. Outside a repository only the current folder is looked at, and the one above a `problem_bank` in which it lies; an empty
/// path is the current folder.
#[must_use]
pub fn course_folder() -> PathBuf {
    std::env::current_dir().map_or_else(|_| PathBuf::new(), |here| way_up(&here))
}

fn way_up(here: &Path) -> PathBuf {
    let mut way = PathBuf::new();
    let is_in_repository = here.ancestors().any(|folder| folder.join(TOP).exists());
    for folder in here.ancestors() {
        let below = here.strip_prefix(folder).ok().and_then(|below| below.components().next());
        let is_within = is_in_repository || below.is_none_or(|below| below.as_os_str() == FOLDER);
        if is_within && folder.join(FOLDER).is_dir() {
            return way;
        }
        if folder.join(TOP).exists() {
            break;
        }
        way.push("..");
    }
    PathBuf::new()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    #[test]
    fn the_course_is_found_upwards_within_its_repository_only() {
        let room = tempfile::tempdir().unwrap();
        let at = |path: &str| room.path().join(path);
        for folder in
            ["course/.git", "course/problem_bank/impact", "course/ci/jobs", "alone/problem_bank/impact", "alone/ci"]
        {
            std::fs::create_dir_all(at(folder)).unwrap();
        }
        for (here, way) in [
            ("course", ""),
            ("course/problem_bank/impact", "../.."),
            ("course/ci/jobs", "../.."),
            ("alone", ""),
            ("alone/problem_bank/impact", "../.."),
            ("alone/ci", ""),
        ] {
            assert_eq!(way_up(&at(here)), PathBuf::from(way), "{here}");
        }
    }
}
