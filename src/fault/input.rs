//! Files that are read: regular files and standard input, never more of one than its reader has a use for.

use std::fs::File;
use std::io;
use std::io::Read;
use std::io::Seek;
use std::io::SeekFrom;
use std::path::Path;

/// The names of standard input.
const STDIN: [&str; 2] = ["-", "/dev/stdin"];

/// Something to read from, of any length: whoever reads it to its end bounds what is kept.
#[derive(Debug)]
pub enum Input {
    /// A regular file.
    File(File),
    /// Standard input.
    Stdin(io::Stdin),
}

impl Input {
    /// Opens a regular file, or standard input where the name is `-`.
    ///
    /// # Errors
    /// Where there is no such file, it may not be read, or it is a folder, a device or a pipe: these may never end.
    pub fn open(path: &Path) -> io::Result<Self> {
        if STDIN.iter().any(|name| path.as_os_str() == *name) {
            return Ok(Self::Stdin(io::stdin()));
        }
        // Asked before it is opened: to open a pipe waits for somebody to write into it.
        let metadata = path.metadata()?;
        if metadata.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
        }
        if !metadata.is_file() {
            let message = "it is not a regular file; to read from a pipe, write `-` and give it as standard input";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        File::open(path).map(Self::File)
    }

    /// The whole of it.
    ///
    /// # Errors
    /// Where it cannot be read, or is longer than so many bytes ([`io::ErrorKind::FileTooLarge`]); no more than these are read.
    pub fn bytes(self, most: u64) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        self.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > most {
            let message = format!("it is longer than {most} bytes");
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
        }
        Ok(bytes)
    }

    /// The whole of it as text.
    ///
    /// ```
    /// use momentous_fault::Input;
    /// let text = Input::open("Cargo.toml".as_ref())?.text(64 * 1024)?;
    /// assert!(text.contains("momentous"));
    /// assert_eq!(Input::open("Cargo.toml".as_ref())?.text(8).unwrap_err().to_string(), "it is longer than 8 bytes");
    /// assert_eq!(Input::open("..".as_ref()).unwrap_err().to_string(), "it is a folder");
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Input::bytes`], and where it is not UTF-8.
    pub fn text(self, most: u64) -> io::Result<String> {
        let not_text = |_| io::Error::new(io::ErrorKind::InvalidData, "it is not UTF-8 text");
        String::from_utf8(self.bytes(most)?).map_err(not_text)
    }
}

impl Read for Input {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.read(bytes),
            Self::Stdin(stdin) => stdin.read(bytes),
        }
    }
}

impl Seek for Input {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            Self::File(file) => file.seek(to),
            Self::Stdin(_) => Err(io::Error::new(io::ErrorKind::Unsupported, "standard input is read only once")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_of_just_that_length_is_read_and_one_byte_more_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        std::fs::write(&path, "four").unwrap();
        assert_eq!(Input::open(&path).unwrap().text(4).unwrap(), "four");
        assert_eq!(Input::open(&path).unwrap().text(3).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        std::fs::write(&path, [0xff]).unwrap();
        assert_eq!(Input::open(&path).unwrap().text(4).unwrap_err().to_string(), "it is not UTF-8 text");
    }

    #[cfg(unix)]
    #[test]
    fn what_may_never_end_is_not_opened() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for path in [Path::new("/dev/zero"), &pipe] {
            assert!(Input::open(path).unwrap_err().to_string().starts_with("it is not a regular file"));
        }
    }
}
