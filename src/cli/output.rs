//! Outputs of results: standard output, a file that appears whole or not at all, or a device that takes what comes.

use std::collections::BTreeMap;
use std::fs;
use std::fs::File;
use std::io;
use std::io::BufWriter;
use std::io::IsTerminal;
use std::io::StdoutLock;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

use super::failure::Failure;
use super::pending::Pending;
use super::pending::Readers;
use super::terminal::Terminal;

/// How many links one after the other are followed, as the kernel does.
const LINKS: usize = 40;

/// A place to write to. A file gets its name only in [`Output::finish`]; before, it is a temporary one beside it.
#[derive(Debug)]
pub(super) enum Output {
    Stdout(BufWriter<StdoutLock<'static>>),
    /// Standard output where somebody looks.
    Terminal(Terminal<BufWriter<StdoutLock<'static>>>),
    /// A device or a pipe: anything that is there and is no regular file. It is written to; it is never replaced.
    Device(BufWriter<File>, PathBuf),
    File(Box<Pending>),
}

impl Output {
    /// Standard output where no path is given.
    pub(super) fn to(path: Option<&Path>) -> Result<Self, Failure> {
        match path.filter(|path| *path != "/dev/stdout") {
            Some(path) => Self::at(path, Readers::AsBefore),
            None if io::stdout().is_terminal() => {
                Ok(Self::Terminal(Terminal::new(BufWriter::new(io::stdout().lock()))))
            }
            None => Ok(Self::Stdout(BufWriter::new(io::stdout().lock()))),
        }
    }

    fn at(path: &Path, readers: Readers) -> Result<Self, Failure> {
        let written = |error: io::Error| Failure::file(path, "written", &error);
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => {
                Err(Failure::unusable(format!("{} is a folder; name a file", path.display())))
            }
            Ok(metadata) if !metadata.is_file() && readers == Readers::AsBefore => {
                let device = File::options().write(true).open(path).map_err(written)?;
                Ok(Self::Device(BufWriter::new(device), path.to_owned()))
            }
            metadata => {
                // What is its owner's alone replaces a link or a pipe, which somebody else may have put there.
                let target = if readers == Readers::Owner { path.to_owned() } else { behind_links(path) };
                let pending = Pending::at(target, metadata.ok().as_ref(), readers);
                Ok(Self::File(Box::new(pending.map_err(written)?)))
            }
        }
    }

    /// Writes a whole file, or a whole text to standard output.
    pub(super) fn whole(path: Option<&Path>, text: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
        let mut output = Self::to(path)?;
        output.write_all(text.as_ref())?;
        output.finish()
    }

    /// Writes a whole file that only its owner may read, whoever could read the one that was there.
    pub(super) fn private(path: &Path, text: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
        let mut output = Self::at(path, Readers::Owner)?;
        output.write_all(text.as_ref())?;
        output.finish()
    }

    /// Lets the result appear.
    pub(super) fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Stdout(mut stdout) => Ok(stdout.flush()?),
            Self::Terminal(mut terminal) => Ok(terminal.flush()?),
            Self::Device(mut device, path) => device.flush().map_err(|error| Failure::file(&path, "written", &error)),
            Self::File(mut pending) => {
                let done = pending.complete();
                done.map_err(|error| Failure::file(pending.path(), "written", &error))
            }
        }
    }
}

/// Refuses to write a result over what is read, or two results into one file.
pub(super) fn keep_apart<'a>(
    read: impl IntoIterator<Item = &'a Path>,
    written: impl IntoIterator<Item = PathBuf>,
) -> Result<(), Failure> {
    let mut taken: BTreeMap<PathBuf, &str> =
        read.into_iter().map(|path| (resolved(path), "is read by this command")).collect();
    for path in written.into_iter().filter(|path| !is_device(path)) {
        if let Some(why) = taken.insert(resolved(&path), "is to hold another result, too") {
            let shown = path.display();
            return Err(Failure::unusable(format!("{shown} {why}; it would be lost\nhelp: name another file")));
        }
    }
    Ok(())
}

/// The same path for the same file, whether it is there or not.
fn resolved(path: &Path) -> PathBuf {
    let path = behind_links(path);
    let (folder, name) = (path.parent().filter(|folder| !folder.as_os_str().is_empty()), path.file_name());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize();
    path.canonicalize().ok().or_else(|| Some(folder.ok()?.join(name?))).unwrap_or(path)
}

/// Whether something is there that is neither a file nor a folder, and so has nothing beside it.
pub(super) fn is_device(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// The path at which a chain of symbolic links ends, also where nothing is there yet: a link stays a link.
fn behind_links(path: &Path) -> PathBuf {
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        let Ok(target) = fs::read_link(&path) else { break };
        path = path.parent().unwrap_or(Path::new("")).join(target);
    }
    path
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(stdout) => stdout.write(bytes),
            Self::Terminal(terminal) => terminal.write(bytes),
            Self::Device(device, _) => device.write(bytes),
            Self::File(pending) => pending.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(stdout) => stdout.flush(),
            Self::Terminal(terminal) => terminal.flush(),
            Self::Device(device, _) => device.flush(),
            Self::File(pending) => pending.flush(),
        }
    }
}

/// The bytes of a name's part: a student's and a problem's, with digits and endings, fit into the 255 of most file systems.
const LONGEST_STEM: usize = 100;

/// The part of a file's name that is made of a text that somebody typed or a file holds: no separators, and nothing hidden.
pub(super) fn file_stem(text: &str) -> String {
    let plain = |letter: char| if letter.is_alphanumeric() || "-_.".contains(letter) { letter } else { '-' };
    let mut stem: String = text.trim().trim_start_matches(['.', '-']).chars().map(plain).collect();
    stem.truncate(stem.floor_char_boundary(LONGEST_STEM));
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

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_its_target_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("far")).unwrap();
        std::os::unix::fs::symlink("far/target.md", at("second.md")).unwrap();
        std::os::unix::fs::symlink("second.md", at("first.md")).unwrap();
        for text in ["nothing was there", "something was there"] {
            Output::whole(Some(&at("first.md")), text).unwrap();
            assert_eq!(fs::read_to_string(at("far/target.md")).unwrap(), text);
            assert!(at("first.md").is_symlink() && at("second.md").is_symlink() && !at("far/target.md").is_symlink());
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_file_that_is_private_stays_private() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("key.md");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
        Output::whole(Some(&path), "new").unwrap();
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o600);
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_is_written_to_and_stays_a_pipe() {
        use std::os::unix::fs::FileTypeExt;
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let read = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read_to_string(pipe).unwrap()
        });
        Output::whole(Some(&pipe), "whole").unwrap();
        assert_eq!(read.join().unwrap(), "whole");
        assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_device_stays_a_device_behind_a_link_too() {
        use std::os::unix::fs::FileTypeExt;
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("nowhere");
        std::os::unix::fs::symlink("/dev/null", &link).unwrap();
        Output::whole(Some(&link), "lost").unwrap();
        assert!(is_device(&link) && link.is_symlink());
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }

    #[test]
    fn two_at_once_to_one_name_do_not_mix() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("both.md");
        let [mut first, mut second] = [(); 2].map(|()| Output::to(Some(&path)).unwrap());
        first.write_all(b"first").unwrap();
        second.write_all(b"the second").unwrap();
        second.finish().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "the second");
        first.finish().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "first");
    }

    #[test]
    fn a_stem_leaves_no_folder() {
        let stems = ["../../etc/passwd", "Ana María", ".hidden", "", "a/b c"].map(file_stem);
        assert_eq!(stems, ["etc-passwd", "Ana-María", "hidden", "unnamed", "a-b-c"]);
        assert_eq!(file_stem(&"한".repeat(100)).len(), 99);
    }
}
