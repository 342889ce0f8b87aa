//! The settings of the course to which a problem file belongs.

#[cfg(feature = "files")]
use std::path::Path;

use momentous_fault::Faults;
use momentous_fault::Source;
#[cfg(feature = "files")]
use momentous_problem::Course;
#[cfg(feature = "files")]
use momentous_problem::CourseSymbols;
use momentous_problem::Loaded;
use momentous_problem::load;

#[cfg(feature = "files")]
use super::read_file::read_file;

/// The folder in which a course keeps its problems.
pub const FOLDER: &str = "problem_bank";

/// The name of the file with a course's settings.
pub const COURSE_FILE: &str = "course.yaml";

/// Reads a problem file with the settings of its course: the nearest `course.yaml`, in its own folder or in one above it, up to
/// `problem_bank`. Outside such a folder only its own is looked at, so that nothing far away changes what is printed.
///
/// # Errors
/// Every fault of the problem file; if it has none, those of the settings.
#[cfg(feature = "files")]
pub fn load_in_course(source: Source) -> Result<Loaded, Faults> {
    let course = settings_for(Path::new(&*source.name));
    let loaded = load(source)?;
    Ok(match course? {
        Some(course) => loaded.in_course(&course),
        None => loaded,
    })
}

/// Reads a problem file. Without the feature `files` there are no folders, and so no settings of a course.
///
/// # Errors
/// Every fault of the file.
#[cfg(not(feature = "files"))]
pub fn load_in_course(source: Source) -> Result<Loaded, Faults> {
    load(source)
}

/// The letters that the course of a file uses now, by its settings.
///
/// # Errors
/// Every fault of the settings.
#[cfg(feature = "files")]
pub fn course_letters(source: &Source) -> Result<CourseSymbols, Faults> {
    Ok(settings_for(Path::new(&*source.name))?.unwrap_or_default().symbols)
}

#[cfg(feature = "files")]
fn settings_for(file: &Path) -> Result<Option<Course>, Faults> {
    course_file(file)?.as_ref().map(Course::read).transpose()
}

/// The file with the settings of the course to which a problem file belongs, if there is one.
///
/// # Errors
/// That file cannot be read.
#[cfg(feature = "files")]
pub fn course_file(file: &Path) -> Result<Option<Source>, Faults> {
    // A file of the current folder may lie in the bank all the same.
    let file = &std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let folders: Vec<&Path> = file.ancestors().skip(1).collect();
    let is_bank = |folder: &&Path| folder.file_name().is_some_and(|name| name == FOLDER);
    let searched = folders.iter().position(is_bank).map_or(1, |top| top + 1);
    let candidates = folders.into_iter().take(searched).map(|folder| folder.join(COURSE_FILE));
    // What cannot be looked for is read, which says why.
    match candidates.into_iter().find(|path| std::fs::exists(path).unwrap_or(true)) {
        Some(path) => read_file(&path).map(Some),
        None => Ok(None),
    }
}
