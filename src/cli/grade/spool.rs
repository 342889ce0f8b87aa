//! Text that is written in many pieces and read in another order: it waits in one temporary file.

use std::fs::File;
use std::io;
use std::io::Read;
use std::io::Seek;
use std::io::SeekFrom;
use std::io::Write;
use std::path::Path;

/// The bytes that wait in memory before they go to the file.
const BLOCK: usize = 1 << 16;

/// The file.
pub(super) struct Spool {
    file: File,
    length: u64,
}

/// One text that waits.
#[derive(Default)]
pub(super) struct WaitingText {
    /// The bytes that are not in the file yet.
    pub(super) waiting: Vec<u8>,
    /// The beginnings of its pieces in the file, and their lengths.
    pieces: Vec<(u64, u64)>,
}

impl Spool {
    /// In the folder in which a file will be written: there is room for one there, there must be for the other.
    pub(super) fn beside(path: &Path) -> io::Result<Self> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder)?;
        Ok(Self { file: tempfile::tempfile_in(folder)?, length: 0 })
    }

    /// Moves what waits into the file, once it is a block.
    pub(super) fn keep(&mut self, kept: &mut WaitingText) -> io::Result<()> {
        if kept.waiting.len() < BLOCK {
            return Ok(());
        }
        self.file.write_all(&kept.waiting)?;
        let length = kept.waiting.len() as u64;
        kept.pieces.push((self.length, length));
        self.length += length;
        kept.waiting.clear();
        Ok(())
    }

    /// Writes a whole text.
    pub(super) fn write(&mut self, kept: WaitingText, to: &mut impl Write) -> io::Result<()> {
        for (start, length) in kept.pieces {
            self.file.seek(SeekFrom::Start(start))?;
            io::copy(&mut Read::take(&mut self.file, length), to)?;
        }
        to.write_all(&kept.waiting)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_text_comes_back_whole() {
        let folder = tempfile::tempdir().unwrap();
        let mut spool = Spool::beside(&folder.path().join("a.xml")).unwrap();
        let mut kept = [WaitingText::default(), WaitingText::default()];
        for number in 0..60_000 {
            let spooled = &mut kept[number % 2];
            writeln!(spooled.waiting, "{number}").unwrap();
            spool.keep(spooled).unwrap();
            assert!(spooled.waiting.len() < BLOCK);
        }
        for (odd, kept) in kept.into_iter().enumerate() {
            assert!(kept.pieces.len() > 1);
            let mut text = Vec::new();
            spool.write(kept, &mut text).unwrap();
            let mut expected = Vec::new();
            for number in (odd..60_000).step_by(2) {
                writeln!(expected, "{number}").unwrap();
            }
            assert!(text == expected);
        }
    }
}
