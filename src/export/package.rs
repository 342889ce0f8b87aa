//! Packages: zip files, written as their contents come.

use std::io;
use std::io::Write;

use zip::CompressionMethod;
use zip::DateTime;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;
use zip::write::StreamWriter;

use super::NotWritten;
use super::question::Pictures;

/// A package on its way. The same contents make the same bytes: no time of day goes in.
pub(super) struct Package<W: Write> {
    zip: ZipWriter<StreamWriter<W>>,
}

impl<W: Write> Package<W> {
    pub fn new(out: W) -> Self {
        Self { zip: ZipWriter::new_stream(out) }
    }

    /// Begins a file; what is written next goes into it.
    pub fn begin(&mut self, name: &str) -> Result<(), NotWritten> {
        let options = SimpleFileOptions::default();
        let options = options.compression_method(CompressionMethod::Deflated).last_modified_time(DateTime::default());
        Ok(self.zip.start_file(name, options)?)
    }

    /// Writes a whole file.
    pub fn put(&mut self, name: &str, content: &str) -> Result<(), NotWritten> {
        self.begin(name)?;
        Ok(self.zip.write_all(content.as_bytes())?)
    }

    /// Writes the files of pictures into a folder, whose name ends with a slash.
    pub fn pictures(&mut self, folder: &str, pictures: &Pictures) -> Result<(), NotWritten> {
        pictures.files.iter().try_for_each(|(name, svg)| self.put(&format!("{folder}{name}"), svg))
    }

    /// Ends the package.
    pub fn finish(self) -> Result<(), NotWritten> {
        self.zip.finish()?.into_inner().flush()?;
        Ok(())
    }
}

impl<W: Write> Write for Package<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.zip.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.zip.flush()
    }
}
