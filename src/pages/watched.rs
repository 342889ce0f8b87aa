//! A folder of problems that is followed as its files are saved.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::time::SystemTime;

use momentous_bank::{Bank, files_under};
use momentous_fault::Faults;

/// The bank of a folder, or of the current one.
pub(super) fn bank(folder: Option<&Path>) -> Result<Bank, Faults> {
    folder.map_or_else(Bank::here, Bank::in_folder)
}

/// A number that changes with the names, lengths and times of the files of a folder.
pub(super) fn stamp(folder: &Path) -> u64 {
    let mut hasher = DefaultHasher::new();
    for path in files_under(folder).unwrap_or_default() {
        let file = path.metadata();
        let changed = file.as_ref().ok().and_then(|file| file.modified().ok()).unwrap_or(SystemTime::UNIX_EPOCH);
        (path, file.map_or(0, |file| file.len()), changed).hash(&mut hasher);
    }
    hasher.finish()
}
