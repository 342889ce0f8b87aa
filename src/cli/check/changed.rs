//! The problems that a change may touch, by git.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::bank::COURSE_FILE;
use crate::cli::failure::Failure;
use crate::cli::pages::templates;
use crate::fault::Source;

/// Selects the files that differ from a revision, or whose course settings or templates do.
pub(super) fn since(revision: &str, sources: Vec<Source>) -> Result<Vec<Source>, Failure> {
    let top = PathBuf::from(git(&["rev-parse", "--show-toplevel"])?.trim_end());
    // What is not known to git yet has changed, too.
    let named = git(&["diff", "--name-only", "-z", revision, "--"])?
        + &git(&["ls-files", "--others", "--exclude-standard", "--full-name", "-z", ":/"])?;
    let changed: BTreeSet<PathBuf> =
        named.split('\0').filter(|path| !path.is_empty()).map(|path| whole(&top.join(path))).collect();
    if templates().is_some_and(|folder| changed.iter().any(|path| path.starts_with(whole(&folder)))) {
        return Ok(sources);
    }
    let courses: Vec<&Path> = changed
        .iter()
        .filter(|path| path.file_name().is_some_and(|name| name == COURSE_FILE))
        .filter_map(|path| path.parent())
        .collect();
    let is_touched = |source: &Source| {
        let path = whole(Path::new(&*source.name));
        changed.contains(&path) || courses.iter().any(|folder| path.starts_with(folder))
    };
    Ok(sources.into_iter().filter(is_touched).collect())
}

/// A path without links and dots; where nothing lies any more, as it is.
fn whole(path: &Path) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

fn git(arguments: &[&str]) -> Result<String, Failure> {
    let unusable = |said: String| {
        Failure::unusable(format!(
            "--changed-since: git says: {said}\nhelp: name a revision of the repository: `origin/main`"
        ))
    };
    let output = Command::new("git").args(arguments).output().map_err(|error| unusable(error.to_string()))?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    } else {
        Err(unusable(String::from_utf8_lossy(&output.stderr).trim_end().to_owned()))
    }
}
