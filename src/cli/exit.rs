//! The end of the program.

use std::process::ExitCode;

/// The end of the program; scripts rely on the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Exit {
    /// All is well.
    Fine = 0,
    /// A promise is broken, or an answer is not fully right.
    NotRight = 1,
    /// The input cannot be used: a file that is missing or does not load, an answer that cannot be read.
    Unusable = 2,
    /// The solver is stuck.
    Stuck = 3,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}
