//! Destinations of documents.

use std::ffi::OsStr;
use std::path::Path;
use std::path::PathBuf;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::output::is_device;

/// The file that says who has which seed.
pub(in crate::cli) const SEEDS: &str = "seeds.csv";

/// The destination of documents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Destination {
    /// To standard output, as one document.
    Stdout,
    /// Into one file, as one document.
    File(PathBuf),
    /// Into a folder, a file for each document.
    Folder(PathBuf),
}

impl Destination {
    /// A folder is one that is there, or a path that ends as folders do.
    pub(super) fn of(path: Option<&Path>) -> Self {
        match path {
            None => Self::Stdout,
            Some(path) if path.is_dir() || path.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR]) => {
                Self::Folder(path.to_owned())
            }
            Some(path) => Self::File(path.to_owned()),
        }
    }

    /// The one file.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            Self::File(path) => Some(path),
            Self::Stdout | Self::Folder(_) => None,
        }
    }

    /// The folder for what is the teacher's alone: beside `sheets` or `sheets.html` it is `sheets-teacher`, so that the
    /// students' folder can be handed out as it is.
    pub(super) fn for_teacher(&self) -> Result<PathBuf, Failure> {
        let beside = |path: &Path, name: Option<&OsStr>| match name.map(OsStr::to_owned) {
            None => path.join("teacher"),
            Some(mut name) => {
                name.push("-teacher");
                path.with_file_name(name)
            }
        };
        match self {
            Self::Folder(folder) => Ok(beside(folder, folder.file_name())),
            Self::File(file) if !is_device(file) => Ok(beside(file, file.file_stem())),
            Self::File(file) => {
                let place = file.display();
                Err(Failure::unusable(format!("{place} has no folder for {SEEDS}; name a folder, or a file")))
            }
            Self::Stdout => Err(Failure::unusable(format!("there is no folder for {SEEDS}; name one with -o"))),
        }
    }

    /// Writes a file that is the teacher's alone.
    pub(super) fn write_for_teacher(&self, name: &str, text: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
        Output::private(&self.make_for_teacher()?.join(name), text)
    }

    /// Makes the folder for what is the teacher's alone.
    pub(super) fn make_for_teacher(&self) -> Result<PathBuf, Failure> {
        let folder = self.for_teacher()?;
        make_private(&folder).map_err(|error| Failure::file(&folder, "made", &error))?;
        Ok(folder)
    }
}

/// Makes a folder that only its owner may enter; one that is there stays as it is.
fn make_private(folder: &Path) -> std::io::Result<()> {
    let mut builder = std::fs::DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.recursive(true).create(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slash_makes_a_folder() {
        assert_eq!(Destination::of(Some(Path::new("a/"))), Destination::Folder("a/".into()));
        assert_eq!(Destination::of(Some(Path::new("src"))), Destination::Folder("src".into()));
        assert_eq!(Destination::of(Some(Path::new("a.md"))), Destination::File("a.md".into()));
    }

    #[test]
    fn the_teachers_folder_is_not_inside_the_students() {
        let for_teacher = |path: &str| Destination::of(Some(Path::new(path))).for_teacher().unwrap();
        assert_eq!(for_teacher("a/sheets/"), Path::new("a/sheets-teacher"));
        assert_eq!(for_teacher("all.html"), Path::new("all-teacher"));
        assert_eq!(for_teacher("./"), Path::new("./teacher"));
    }
}
