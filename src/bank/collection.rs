//! A collection of problem files: those of the current folder, or those that are built in.

use std::fs;
use std::io;
use std::path::Path;
use std::path::PathBuf;

use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Faults;
use crate::fault::Input;
use crate::fault::Source;
use crate::fault::did_you_mean;

use super::course::COURSE_FILE;

/// The folder in which a course keeps its problems.
pub const FOLDER: &str = "problem_bank";

/// Path and text of every problem of this program's own bank.
const BUILT_IN: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/built_in_bank.rs"));

/// How deep folders may lie in each other; a bank has topics, and perhaps chapters.
const DEEPEST: usize = 16;

/// Problem files with their identities, in the order of these.
///
/// ```
/// use momentous::bank::Bank;
/// let bank = Bank::built_in();
/// assert!(bank.find("impact/two-carts").is_ok());
/// let faults = bank.find("impact/two-cart").unwrap_err();
/// assert_eq!(faults.list[0].help.as_deref(), Some("did you mean `impact/two-carts`?"));
/// ```
#[derive(Clone, Debug)]
pub struct Bank {
    problems: Vec<(String, Source)>,
}

impl Bank {
    /// The bank of the current folder's `problem_bank/`, else the one that is built in. A folder without problems sets only how
    /// those are printed, by a `course.yaml`.
    ///
    /// # Errors
    /// Where the folder is there and cannot be read.
    pub fn here() -> Result<Self, Faults> {
        let folder = Path::new(FOLDER);
        let own = if folder.is_dir() { Self::in_folder(folder)? } else { Self { problems: Vec::new() } };
        Ok(if own.problems.is_empty() { Self::built_in() } else { own })
    }

    /// The bank that is built into the program.
    #[must_use]
    pub fn built_in() -> Self {
        Self::of(BUILT_IN.iter().map(|(path, text)| Source::new(path, text)).collect())
    }

    /// Every problem file under a folder.
    ///
    /// # Errors
    /// Where the folder or a file in it cannot be read, or two files have one identity.
    pub fn in_folder(folder: &Path) -> Result<Self, Faults> {
        let bank = Self::of(files_under(folder)?.iter().map(|path| read(path)).collect::<Result<_, _>>()?);
        match bank.problems.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            None => Ok(bank),
            Some(twins) => {
                let [(id, first), (_, second)] = [&twins[0], &twins[1]];
                let message = format!("`{id}` is also the identity of {}", first.name);
                let fault = Fault::new(Code::Duplicate, message).help("give one of them another `id`");
                Err(Faults { source: second.clone(), list: vec![fault] })
            }
        }
    }

    fn of(sources: Vec<Source>) -> Self {
        let named = |source: Source| (declared_id(&source).unwrap_or_else(|| source.name.to_string()), source);
        let mut problems: Vec<(String, Source)> = sources.into_iter().map(named).collect();
        problems.sort_by(|left, right| (&left.0, &left.1.name).cmp(&(&right.0, &right.1.name)));
        Self { problems }
    }

    /// The identities, in order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.problems.iter().map(|(id, _)| id.as_str())
    }

    /// The topics: what stands before the first slash of the identities, each once, in order.
    #[must_use]
    pub fn topics(&self) -> Vec<&str> {
        let mut topics: Vec<&str> = self.ids().map(topic_of).collect();
        topics.dedup();
        topics
    }

    /// The files, in the order of their identities.
    pub fn sources(&self) -> impl Iterator<Item = &Source> {
        self.problems.iter().map(|(_, source)| source)
    }

    /// The files of one topic, in the order of their identities.
    ///
    /// # Errors
    /// Where no problem is of that topic.
    pub fn topic(&self, topic: &str) -> Result<Vec<&Source>, Faults> {
        let found: Vec<&Source> =
            self.problems.iter().filter(|(id, _)| topic_of(id) == topic).map(|(_, source)| source).collect();
        if found.is_empty() {
            let topics = self.topics();
            let near = did_you_mean(topic, topics.iter().copied());
            let help = near.map_or_else(|| format!("topics are {}", topics.join(", ")), meant);
            return Err(unknown(topic, format!("no problem is of the topic `{topic}`"), help));
        }
        Ok(found)
    }

    /// The file of the problem with that identity.
    ///
    /// # Errors
    /// Where there is none; the nearest known identity is named.
    pub fn find(&self, id: &str) -> Result<&Source, Faults> {
        let found = self.problems.iter().find(|(own, _)| own == id);
        found.map(|(_, source)| source).ok_or_else(|| {
            let same_name = || self.ids().find(|own| name_of(own) == name_of(id));
            let near = did_you_mean(id, self.ids()).or_else(same_name);
            let help = || "`momentous list` shows every problem; a file is named by its path".to_owned();
            let help = near.map_or_else(help, meant);
            unknown(id, format!("there is no problem `{id}`"), help)
        })
    }

    /// The file that a user means by an identity or by a path.
    ///
    /// # Errors
    /// Where there is no such problem, or the file cannot be read.
    pub fn open(&self, name: &str) -> Result<Source, Faults> {
        if is_path(name) { read(Path::new(name)) } else { self.find(name).cloned() }
    }

    /// The files that a user means by identities, topics, paths of files and of folders; all of the bank where nothing is
    /// named. Each name that cannot be followed is told.
    ///
    /// # Errors
    /// Every name that means nothing.
    pub fn select(&self, names: &[String]) -> Result<Vec<Source>, Vec<Faults>> {
        if names.is_empty() {
            return Ok(self.sources().cloned().collect());
        }
        let mut sources: Vec<Source> = Vec::new();
        let mut faults = Vec::new();
        for name in names {
            let path = Path::new(name);
            let found = if self.ids().any(|id| topic_of(id) == name) && !is_path(name) {
                self.topic(name).map(|sources| sources.into_iter().cloned().collect())
            } else if path.is_dir() {
                Self::in_folder(path).map(|bank| bank.sources().cloned().collect())
            } else {
                self.open(name).map(|source| vec![source])
            };
            match found {
                Ok(found) => {
                    let new: Vec<Source> = found.into_iter().filter(|source| !sources.contains(source)).collect();
                    sources.extend(new);
                }
                Err(found) => faults.push(found),
            }
        }
        if faults.is_empty() { Ok(sources) } else { Err(faults) }
    }
}

/// Every problem file under a folder, in the order of the paths. Folders that are links are not entered.
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

/// The longest file that is read as a problem, in bytes: a hundred times what the longest of the bank has.
const LARGEST: u64 = 256 * 1024;

pub(super) fn read(path: &Path) -> Result<Source, Faults> {
    let text = Input::open(path).and_then(|file| file.text(LARGEST)).map_err(|error| unreadable(path, &error))?;
    Ok(Source::new(&path.display().to_string(), &text))
}

fn unreadable(path: &Path, error: &io::Error) -> Faults {
    let source = Source::new(&path.display().to_string(), "");
    Faults { source, list: vec![Fault::new(Code::Unreadable, format!("this cannot be read: {error}"))] }
}

fn unknown(name: &str, message: String, help: String) -> Faults {
    Faults { source: Source::new(name, ""), list: vec![Fault::new(Code::UnknownName, message).help(help)] }
}

fn meant(name: &str) -> String {
    format!("did you mean `{name}`?")
}

/// What stands before the first slash of an identity.
pub(super) fn topic_of(id: &str) -> &str {
    id.split('/').next().unwrap_or(id)
}

/// What stands behind the last slash of an identity.
fn name_of(id: &str) -> &str {
    id.rsplit('/').next().unwrap_or(id)
}

/// The identity that a file says it has, found without reading the rest of it: a bank may hold hundreds of files, and
/// most commands need one.
fn declared_id(source: &Source) -> Option<String> {
    let value = source.text.lines().find_map(|line| line.strip_prefix("id:"))?;
    let value = value.split(" #").next().unwrap_or(value).trim().trim_matches(['"', '\'']);
    (!value.is_empty()).then(|| value.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_identity_is_found_without_reading_the_file() {
        let id = |text: &str| declared_id(&Source::new("a.yaml", text));
        assert_eq!(id("# id: not this\nid: impact/a # nor this\n").as_deref(), Some("impact/a"));
        assert_eq!(id("title: A\nid: \"b\"\n").as_deref(), Some("b"));
        assert_eq!(id("title: A\n  id: c\n"), None);
    }

    #[test]
    fn every_built_in_problem_is_found_by_its_identity_and_by_its_topic() {
        let bank = Bank::built_in();
        assert!(bank.ids().count() >= 14);
        for topic in bank.topics() {
            for source in bank.topic(topic).unwrap() {
                let id = declared_id(source).unwrap();
                assert_eq!(bank.find(&id).unwrap(), source);
            }
        }
    }

    #[test]
    fn a_name_that_means_nothing_is_told_with_the_nearest() {
        let bank = Bank::built_in();
        let help = |name: &str| bank.find(name).unwrap_err().list[0].help.clone().unwrap();
        assert_eq!(help("two-carts"), "did you mean `impact/two-carts`?");
        assert_eq!(help("zzz"), "`momentous list` shows every problem; a file is named by its path");
        assert_eq!(bank.topic("impakt").unwrap_err().list[0].help.as_deref(), Some("did you mean `impact`?"));
        assert_eq!(bank.select(&["zzz".into(), "impact".into(), "yyy".into()]).unwrap_err().len(), 2);
    }

    #[test]
    fn names_that_overlap_select_a_file_once() {
        let bank = Bank::built_in();
        let once = bank.select(&["impact".into(), "impact/two-carts".into()]).unwrap();
        assert_eq!(once.len(), bank.topic("impact").unwrap().len());
    }
}
