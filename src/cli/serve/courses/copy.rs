//! `momentous serve backup` and `momentous serve restore`

use std::path::PathBuf;

use clap::Args;

use super::super::super::exit::Exit;
use super::super::super::failure::Failure;
use super::super::super::output::Output;
use super::data::Data;

/// Write a copy of everything to a new file, while the server works. It holds the secrets of courses
#[derive(Args, Debug)]
pub(in crate::cli::serve) struct Backup {
    #[command(flatten)]
    data: Data,
    /// The new file
    file: PathBuf,
}

impl Backup {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        self.data.beside(async |store| store.backup(&self.file).await)?;
        Output::whole(
            None,
            &format!("{} has been written. It holds secrets; keep it private.\n", self.file.display()),
        )?;
        Ok(Exit::Fine)
    }
}

/// Take everything from a copy into a folder or database that is still empty
#[derive(Args, Debug)]
pub(in crate::cli::serve) struct Restore {
    #[command(flatten)]
    data: Data,
    /// The copy
    file: PathBuf,
}

impl Restore {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        self.data.beside(async |store| store.restore(&self.file).await)?;
        Output::whole(None, &format!("{} holds what {} does.\n", self.data.address, self.file.display()))?;
        Ok(Exit::Fine)
    }
}
