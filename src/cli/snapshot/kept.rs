//! The snapshots in the folder.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::fault::Input;

use super::change::{Change, Files};
use super::page::Kind;

/// The longest snapshot that is read, in bytes.
const LARGEST: u64 = 1 << 24;

/// How deep folders may lie in each other.
const DEEPEST: usize = 16;

/// Snapshots that are kept.
#[derive(Debug)]
pub(super) struct Kept {
    folder: PathBuf,
    /// The snapshots by their names.
    pub(super) files: Files,
    /// Those that earlier versions of the program wrote, in other files.
    pub(super) former: Vec<String>,
}

impl Kept {
    /// Reads the snapshots of these names, and all others where the whole bank is meant. What else is in the folder is not ours.
    pub(super) fn read(folder: &Path, now: &Files, is_whole: bool) -> Result<Self, Failure> {
        let mut names: Vec<String> = Vec::new();
        if folder.is_dir() {
            walk(folder, "", DEEPEST, &mut names)?;
        }
        let problems: Vec<&str> = now.keys().filter_map(|name| Some(Kind::of(name)?.1)).collect();
        let is_meant = |name: &str| Kind::of(name).is_some_and(|(_, problem)| is_whole || problems.contains(&problem));
        let mut files = Files::new();
        for name in names.iter().filter(|name| is_meant(name)) {
            let path = folder.join(name);
            let text = Input::open(&path).and_then(|file| file.text(LARGEST));
            let text = text.map_err(|error| Failure::file(&path, "read", &error))?;
            files.insert(name.clone(), text.replace("\r\n", "\n"));
        }
        let former = names.into_iter().filter(|name| is_whole && is_former(name)).collect();
        Ok(Self { folder: folder.to_owned(), files, former })
    }

    /// Writes the files of a change as they are now.
    pub(super) fn accept(&self, change: &Change) -> Result<(), Failure> {
        for file in &change.files {
            let path = self.folder.join(&file.name);
            match &file.now {
                Some(text) => Output::whole(Some(&path), text)?,
                None => fs::remove_file(&path).map_err(|error| Failure::file(&path, "removed", &error))?,
            }
        }
        Ok(())
    }

    /// Removes the snapshots that earlier versions of the program wrote.
    pub(super) fn remove_former(&self, output: &mut Output) -> Result<(), Failure> {
        for name in &self.former {
            let path = self.folder.join(name);
            fs::remove_file(&path).map_err(|error| Failure::file(&path, "removed", &error))?;
        }
        if !self.former.is_empty() {
            writeln!(output, "removed {} snapshots of an earlier version of the program", self.former.len())?;
        }
        Ok(())
    }
}

/// Whether an earlier version of the program gave a file that name: `impact.two-carts.find-e.seed-1.md`.
fn is_former(name: &str) -> bool {
    let stem = name.strip_suffix(".md").or_else(|| name.strip_suffix(".json"));
    let seed = stem.and_then(|stem| stem.rsplit_once(".seed-"));
    seed.is_some_and(|(stem, seed)| !stem.contains('/') && ["1", "2", "3"].contains(&seed))
}

/// The files below a folder, by their ways from there.
fn walk(folder: &Path, way: &str, depth: usize, names: &mut Vec<String>) -> Result<(), Failure> {
    let failed = |error: &std::io::Error| Failure::file(folder, "read", error);
    for entry in fs::read_dir(folder).map_err(|error| failed(&error))? {
        let entry = entry.map_err(|error| failed(&error))?;
        let Ok(name) = entry.file_name().into_string() else { continue };
        let kind = entry.file_type().map_err(|error| failed(&error))?;
        if kind.is_dir() && depth > 0 {
            walk(&entry.path(), &format!("{way}{name}/"), depth - 1, names)?;
        } else if kind.is_file() {
            names.push(format!("{way}{name}"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn former_snapshots_are_known_by_their_names() {
        assert!(is_former("impact.two-carts.find-e.seed-2.md") && is_former("impact.two-carts.seed-1.json"));
        assert!(["notes.md", "a.seed-x.md", "a.seed-1.txt", "a/b.seed-1.md"].iter().all(|name| !is_former(name)));
    }
}
