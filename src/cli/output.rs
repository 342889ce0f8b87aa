//! Where results go: standard output, or a file that appears whole or not at all.

use std::fs;
use std::fs::File;
use std::io;
use std::io::BufWriter;
use std::io::StdoutLock;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

use super::failure::Failure;

/// A place to write to. A file gets its name only in [`Output::finish`]; before, it is a temporary one beside it.
#[derive(Debug)]
pub(super) enum Output {
    Stdout(BufWriter<StdoutLock<'static>>),
    File(Box<Pending>),
}

/// A file on its way; what is left of it goes when it is dropped.
#[derive(Debug)]
pub(super) struct Pending {
    writer: Option<BufWriter<File>>,
    temporary: PathBuf,
    path: PathBuf,
}

impl Output {
    /// Standard output where no path is given.
    pub(super) fn to(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self::Stdout(BufWriter::new(io::stdout().lock()))) };
        if path.is_dir() {
            return Err(Failure::unusable(format!("{} is a folder; name a file", path.display())));
        }
        let written = |error: io::Error| Failure::file(path, "written", &error);
        let name = path.file_name().ok_or_else(|| Failure::unusable(format!("{} is no file", path.display())))?;
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(written)?;
        }
        let temporary = path.with_file_name(format!(".{}.{}.tmp", name.to_string_lossy(), std::process::id()));
        let writer = Some(BufWriter::new(File::create(&temporary).map_err(written)?));
        Ok(Self::File(Box::new(Pending { writer, temporary, path: path.to_owned() })))
    }

    /// Writes a whole file, or a whole text to standard output.
    pub(super) fn whole(path: Option<&Path>, text: &str) -> Result<(), Failure> {
        let mut output = Self::to(path)?;
        output.write_all(text.as_bytes())?;
        output.finish()
    }

    /// Lets the result appear.
    pub(super) fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Stdout(mut stdout) => Ok(stdout.flush()?),
            Self::File(mut pending) => {
                let done = pending.complete();
                done.map_err(|error| Failure::file(&pending.path, "written", &error))
            }
        }
    }
}

impl Pending {
    fn complete(&mut self) -> io::Result<()> {
        if let Some(writer) = self.writer.take() {
            writer.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
            fs::rename(&self.temporary, &self.path)?;
        }
        Ok(())
    }
}

impl Drop for Pending {
    fn drop(&mut self) {
        // After it was renamed there is nothing left to remove, and nothing to tell.
        self.writer = None;
        let _ = fs::remove_file(&self.temporary);
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(stdout) => stdout.write(bytes),
            Self::File(pending) => match &mut pending.writer {
                Some(writer) => writer.write(bytes),
                None => Err(io::Error::other("the file is finished")),
            },
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(stdout) => stdout.flush(),
            Self::File(pending) => pending.writer.as_mut().map_or(Ok(()), Write::flush),
        }
    }
}

/// What somebody typed or a file said, as a part of a file's name: no separators, and nothing hidden.
pub(super) fn file_stem(text: &str) -> String {
    let plain = |letter: char| if letter.is_alphanumeric() || "-_.".contains(letter) { letter } else { '-' };
    let stem: String = text.trim().chars().map(plain).take(100).collect();
    let stem = stem.trim_start_matches(['.', '-']);
    if stem.is_empty() { "unnamed".to_owned() } else { stem.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/a.md");
        let mut output = Output::to(Some(&path)).unwrap();
        output.write_all(b"half").unwrap();
        drop(output);
        assert_eq!(fs::read_dir(folder.path().join("deep")).unwrap().count(), 0);
        Output::whole(Some(&path), "whole").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "whole");
        assert_eq!(fs::read_dir(folder.path().join("deep")).unwrap().count(), 1);
    }

    #[test]
    fn a_stem_leaves_no_folder() {
        let stems = ["../../etc/passwd", "Ana María", ".hidden", "", "a/b c"].map(file_stem);
        assert_eq!(stems, ["etc-passwd", "Ana-María", "hidden", "unnamed", "a-b-c"]);
    }
}
