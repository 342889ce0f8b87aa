//! Where documents go.

use std::path::Path;
use std::path::PathBuf;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::output::is_device;

/// The file in a folder that says who has which seed.
const SEEDS: &str = "seeds.csv";

/// Where documents go.
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

    /// Writes the table of seeds into the folder, or beside the file.
    pub(super) fn write_seeds(&self, table: &str) -> Result<(), Failure> {
        let path = match self {
            Self::Folder(folder) => folder.join(SEEDS),
            Self::File(file) if is_device(file) => {
                let place = file.display();
                return Err(Failure::unusable(format!("{place} has no folder for {SEEDS}; name a folder, or a file")));
            }
            Self::File(file) => {
                let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
                file.with_file_name(format!("{stem}-{SEEDS}"))
            }
            Self::Stdout => return Output::whole(None, table),
        };
        Output::whole(Some(&path), table)
    }
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
}
