//! `momentous secret`

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;

use crate::problem::secret_mark;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
Examples:
  momentous secret secret.txt
  momentous generate impact/two-carts --roster class.csv --secret secret.txt -o sheets/

The file has 256 random bits, and only its owner can read it. An existing file is not changed: sheets made with a secret can be made again and marked only with the same secret. Keep a copy, and keep it private.";

/// The bytes of a secret.
const BYTES: usize = 32;

/// Write a secret of the course that cannot be guessed
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Secret {
    /// The new file
    file: PathBuf,
}

impl Secret {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes)
            .map_err(|error| Failure::unusable(format!("the system has no random numbers: {error}")))?;
        let secret = bytes.iter().fold(String::new(), |mut digits, byte| {
            // Writing to a string cannot fail.
            let _ = write!(digits, "{byte:02x}");
            digits
        });
        let shown = self.file.display();
        let mut options = fs::File::options();
        options.write(true).create_new(true);
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        let mut file = options.open(&self.file).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => Failure::unusable(format!("{shown} already exists; it was not changed")),
            _ => Failure::file(&self.file, "written", &error),
        })?;
        let written = file.write_all(format!("{secret}\n").as_bytes()).and_then(|()| file.sync_all());
        written.map_err(|error| Failure::file(&self.file, "written", &error))?;
        let mark = secret_mark(secret.as_bytes());
        Output::whole(
            None,
            &format!("{shown} has been written. Sheets made with it have `-{mark}` after their seeds.\n"),
        )?;
        Ok(Exit::Fine)
    }
}
