//! Whether a folder can hold data: it can be written, nobody else reads it, and its disk has room.

use std::io;
use std::path::Path;

use super::finding::Finding;

/// The bytes that a disk has free at least. A course of 40 students takes a few of these a week; backups take more.
const FREE: u64 = 512 << 20;

/// The findings on a folder of data.
pub(super) fn findings(folder: &Path) -> Vec<Finding> {
    // Where it is not there yet the first start makes it.
    let Some(there) = folder
        .ancestors()
        .map(|ancestor| if ancestor == Path::new("") { Path::new(".") } else { ancestor })
        .find(|ancestor| ancestor.exists())
    else {
        return vec![Finding::wrong(format!("{} cannot be made", folder.display()), "choose a folder with --data")];
    };
    if !there.is_dir() {
        let what = format!("{} is a file, and no folder", there.display());
        return vec![Finding::wrong(
            what,
            "choose a folder with --data; a copy is taken in by `momentous serve restore`",
        )];
    }
    let mut findings = vec![match tempfile::tempfile_in(there) {
        Ok(_) => Finding::fine(format!("{} can be written", there.display())),
        Err(error) => Finding::wrong(
            format!("{} cannot be written: {error}", there.display()),
            "give it to the user who runs the server (`chown`), or choose another folder with --data",
        ),
    }];
    if there == folder {
        findings.extend(others(folder));
    }
    findings.push(disk(there, fs4::available_space(there)));
    findings
}

/// Whether other users of the machine read the folder.
#[cfg(unix)]
fn others(folder: &Path) -> Option<Finding> {
    use std::os::unix::fs::PermissionsExt;
    let mode = folder.metadata().ok()?.permissions().mode() & 0o777;
    // The last six bits are what the group and others may do.
    Some(if mode.trailing_zeros() >= 6 {
        Finding::fine(format!("nobody else reads {}", folder.display()))
    } else {
        let what = format!("other users of this machine can reach into {} (mode {mode:o})", folder.display());
        Finding::wrong(what, format!("chmod 700 {}", folder.display()))
    })
}

#[cfg(not(unix))]
fn others(_: &Path) -> Option<Finding> {
    None
}

/// Whether a disk has room.
fn disk(folder: &Path, free: io::Result<u64>) -> Finding {
    match free {
        Ok(free) if free < FREE => Finding::wrong(
            format!("the disk of {} is nearly full: {} MiB are free", folder.display(), free >> 20),
            "make room: once it is full, nothing more is kept, and students are told so",
        ),
        Ok(free) => Finding::fine(format!("{} MiB are free in {}", free >> 20, folder.display())),
        Err(error) => Finding::Note(format!("how much is free in {} is not known: {error}", folder.display())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disk_that_is_nearly_full_is_told() {
        assert!(disk(Path::new("data"), Ok(FREE - 1)).is_wrong());
        assert!(!disk(Path::new("data"), Ok(FREE)).is_wrong());
    }

    #[test]
    #[cfg(unix)]
    fn a_folder_that_others_read_is_told() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        for (mode, is_wrong) in [(0o700, false), (0o750, true), (0o705, true)] {
            std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(mode)).unwrap();
            assert_eq!(others(folder.path()).is_some_and(|reached| reached.is_wrong()), is_wrong, "{mode:o}");
        }
    }
}
