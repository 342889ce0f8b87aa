//! Files that nobody else on the machine reads, wherever their folder came from.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use super::fault::StoreFault;

/// Makes a file where there is none, and takes it from everybody but its owner. What SQLite writes beside it is as private as the file.
///
/// # Errors
/// Where it cannot be made.
#[cfg(unix)]
pub(super) fn keep(file: &Path) -> Result<(), StoreFault> {
    use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};

    let unusable = |error| StoreFault::Folder(file.to_owned(), error);
    // One that is there is not opened: to close it would end the locks that SQLite may hold on it in this process.
    match fs::OpenOptions::new().create_new(true).write(true).mode(0o600).open(file) {
        Err(error) if error.kind() != ErrorKind::AlreadyExists => return Err(unusable(error)),
        _ => {}
    }
    for beside in ["", "-wal", "-shm"] {
        let mut name = file.as_os_str().to_owned();
        name.push(beside);
        let is_open = |metadata: fs::Metadata| metadata.permissions().mode() & 0o077 != 0;
        if fs::metadata(&name).is_ok_and(is_open) {
            // Whose owner is another user stays as it is; `momentous serve check` says so.
            let _ = fs::set_permissions(&name, fs::Permissions::from_mode(0o600));
        }
    }
    Ok(())
}

#[cfg(not(unix))]
pub(super) fn keep(_: &Path) -> Result<(), StoreFault> {
    Ok(())
}
