//! A file on its way: a temporary one beside its place, which takes that place when it is whole and is gone otherwise.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::io::BufWriter;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::Once;
use std::sync::PoisonError;

use tempfile::Builder;
use tempfile::NamedTempFile;

/// The exit code of a program that a signal ended, as shells know it from an interrupt.
const INTERRUPTED: i32 = 130;

/// The temporary files of this program that are there now.
static THERE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The readers of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Readers {
    /// Those who could read the file in whose place it comes; for a new one, those whom the system's settings let.
    AsBefore,
    /// Its owner.
    Owner,
}

/// A file on its way.
#[derive(Debug)]
pub(super) struct Pending {
    writer: Option<BufWriter<NamedTempFile>>,
    temporary: PathBuf,
    path: PathBuf,
}

impl Pending {
    /// Begins a file in the place of the one that was found there.
    pub(super) fn at(path: PathBuf, metadata: Option<&fs::Metadata>, readers: Readers) -> io::Result<Self> {
        path.file_name().ok_or_else(|| io::Error::other("it names no file"))?;
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        remove_on_signals();
        // Held until the file is on the list: a signal in between waits.
        let mut there = THERE.lock().unwrap_or_else(PoisonError::into_inner);
        let file = builder(readers).prefix(".momentous-").suffix(".tmp").tempfile_in(folder)?;
        if let (Readers::AsBefore, Some(metadata)) = (readers, metadata) {
            fs::set_permissions(file.path(), metadata.permissions())?;
        }
        let temporary = file.path().to_owned();
        there.insert(temporary.clone());
        Ok(Self { writer: Some(BufWriter::new(file)), temporary, path })
    }

    /// The path that the file will have.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Lets the file appear.
    pub(super) fn complete(&mut self) -> io::Result<()> {
        if let Some(writer) = self.writer.take() {
            let file = writer.into_inner().map_err(io::IntoInnerError::into_error)?;
            file.as_file().sync_all()?;
            file.persist(&self.path).map_err(|error| error.error)?;
        }
        Ok(())
    }
}

impl Write for Pending {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.as_mut().map_or_else(|| Err(io::Error::other("the file is finished")), |writer| writer.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for Pending {
    fn drop(&mut self) {
        // What was not written yet is not wanted any more; the file goes with its handle.
        if let Some(writer) = self.writer.take() {
            let (file, _) = writer.into_parts();
            drop(file);
        }
        THERE.lock().unwrap_or_else(PoisonError::into_inner).remove(&self.temporary);
    }
}

/// Temporary files are made with a random name, and never in the place of something that is there.
#[cfg_attr(not(unix), allow(unused_mut, unused_variables, reason = "there are no modes to set"))]
fn builder(readers: Readers) -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = if readers == Readers::Owner { 0o600 } else { 0o666 };
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    builder
}

/// From the first temporary file on, a signal that ends the program removes them all first.
fn remove_on_signals() {
    static LISTEN: Once = Once::new();
    LISTEN.call_once(|| {
        // Where signals are ignored already, as under nohup, they stay so.
        let _ = ctrlc::try_set_handler(|| {
            for path in &*THERE.lock().unwrap_or_else(PoisonError::into_inner) {
                let _ = fs::remove_file(path);
            }
            std::process::exit(INTERRUPTED);
        });
    });
}
