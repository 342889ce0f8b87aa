//! Problem files in folders.

use std::fs;
use std::io;
use std::path::Path;
use std::path::PathBuf;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Source;

use super::collection::Bank;
use super::collection::topic_of;
use super::course::COURSE_FILE;
use super::course::FOLDER;
use super::read_file::read_file;
use super::read_file::unreadable;
use super::repository::course_folder;

/// How deep folders may lie in each other; a bank has topics, and perhaps chapters.
const DEEPEST: usize = 16;

impl Bank {
    /// The bank of the course's `problem_bank/`, in the current folder or above it in the repository, else the one that is built in.
    /// A folder without problems sets only how those are printed, by a `course.yaml`.
    ///
    /// # Errors
    /// Where the folder is there and cannot be read.
    pub fn here() -> Result<Self, Faults> {
        let (bank, unusable) = Self::gathered_here()?;
        unusable.into_iter().next().map_or(Ok(bank), Err)
    }

    /// The same beside the files that are no problem of it: those that cannot be read, and those that have the identity of another.
    ///
    /// # Errors
    /// Where the folder is there and cannot be read.
    pub fn gathered_here() -> Result<(Self, Vec<Faults>), Faults> {
        let folder = course_folder().join(FOLDER);
        let (bank, unusable) =
            if folder.is_dir() { Self::gathered(&folder)? } else { (Self::of(Vec::new()), Vec::new()) };
        let is_empty = bank.problems.is_empty() && unusable.is_empty();
        Ok((if is_empty { Self::built_in() } else { bank }, unusable))
    }

    /// Every problem file under a folder.
    ///
    /// # Errors
    /// Where the folder or a file in it cannot be read, or two files have one identity.
    pub fn in_folder(folder: &Path) -> Result<Self, Faults> {
        let (bank, unusable) = Self::gathered(folder)?;
        unusable.into_iter().next().map_or(Ok(bank), Err)
    }

    fn gathered(folder: &Path) -> Result<(Self, Vec<Faults>), Faults> {
        let (mut sources, mut unusable) = (Vec::new(), Vec::new());
        for path in files_under(folder)? {
            match read_file(&path) {
                Ok(source) => sources.push(source),
                Err(faults) => unusable.push(faults),
            }
        }
        let mut bank = Self::of(sources);
        let mut problems: Vec<(String, Source)> = Vec::new();
        for (id, source) in std::mem::take(&mut bank.problems) {
            match problems.last().filter(|(known, _)| *known == id) {
                None => problems.push((id, source)),
                Some((_, first)) => {
                    let message = format!("`{id}` is also the identity of {}", first.name);
                    let fault = Fault::new(Code::Duplicate, message).help("give one of them another `id`");
                    unusable.push(Faults { source, list: vec![fault] });
                }
            }
        }
        bank.problems = problems;
        Ok((bank, unusable))
    }

    /// The file that a user means by an identity or by a path.
    ///
    /// # Errors
    /// Where there is no such problem, or the file cannot be read.
    pub fn open(&self, name: &str) -> Result<Source, Faults> {
        if is_path(name) { read_file(Path::new(name)) } else { self.find(name).cloned() }
    }

    /// The files that a user means by identities, topics, paths of files and of folders; all of the bank where nothing is
    /// named. Each name that cannot be followed is told.
    ///
    /// # Errors
    /// Every name that means nothing.
    pub fn select(&self, names: &[String]) -> Result<Vec<Source>, Vec<Faults>> {
        let (sources, unusable) = self.selected(names)?;
        if unusable.is_empty() { Ok(sources) } else { Err(unusable) }
    }

    /// The same beside the files of folders that are no problems: those that cannot be read, and those that have the identity of
    /// another.
    ///
    /// # Errors
    /// Every name that means nothing.
    pub fn selected(&self, names: &[String]) -> Result<(Vec<Source>, Vec<Faults>), Vec<Faults>> {
        if names.is_empty() {
            return Ok((self.sources().cloned().collect(), Vec::new()));
        }
        let mut sources: Vec<Source> = Vec::new();
        let (mut faults, mut files) = (Vec::new(), Vec::new());
        for name in names {
            let (path, topic) = (Path::new(name), name.trim_end_matches('/'));
            let matching = if self.ids().any(|id| topic_of(id) == topic) && !is_path(name) {
                self.topic(topic).map(|sources| sources.into_iter().cloned().collect())
            } else if path.is_dir() {
                Self::gathered(path).map(|(bank, unusable)| {
                    files.extend(unusable);
                    bank.sources().cloned().collect()
                })
            } else {
                self.open(name).map(|source| vec![source])
            };
            match matching {
                Ok(matching) => {
                    let new: Vec<Source> = matching.into_iter().filter(|source| !sources.contains(source)).collect();
                    sources.extend(new);
                }
                Err(found) => faults.push(found),
            }
        }
        if faults.is_empty() { Ok((sources, files)) } else { Err(faults) }
    }
}

/// Every problem file under a folder, in the order of the paths. Folders that are links are not entered, and hidden files passed over.
///
/// # Errors
/// Where a folder cannot be read.
pub fn files_under(folder: &Path) -> Result<Vec<PathBuf>, Faults> {
    let mut files = Vec::new();
    walk(folder, DEEPEST, &mut files).map_err(|error| unreadable(folder, &error))?;
    files.sort();
    Ok(files)
}

fn walk(folder: &Path, depth: usize, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        // What editors and systems leave: `._carts.yaml`, `.git`.
        if entry.file_name().as_encoded_bytes().starts_with(b".") {
            continue;
        }
        let path = entry.path();
        if entry.file_type()?.is_dir() {
            if depth > 0 {
                walk(&path, depth - 1, files)?;
            }
        } else if has_yaml_ending(&path) && entry.file_name() != COURSE_FILE && path.is_file() {
            files.push(path);
        }
    }
    Ok(())
}

fn has_yaml_ending(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "yaml" || ending == "yml")
}

/// Whether a user means a file by this name rather than an identity.
fn is_path(name: &str) -> bool {
    let path = Path::new(name);
    has_yaml_ending(path) || path.is_absolute() || name.starts_with('.') || path.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_mean_nothing_are_all_told() {
        let names = ["zzz".into(), "impact".into(), "yyy".into()];
        assert_eq!(Bank::built_in().select(&names).unwrap_err().len(), 2);
    }

    #[test]
    fn names_that_overlap_select_a_file_once() {
        let bank = Bank::built_in();
        let once = bank.select(&["impact".into(), "impact/two-carts".into()]).unwrap();
        assert_eq!(once.len(), bank.topic("impact").unwrap().len());
    }
}
