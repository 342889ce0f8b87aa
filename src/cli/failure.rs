//! Why a command could not do its work, and what is said of it.

use std::fmt;
use std::io;
use std::io::Write;
use std::path::Path;

use crate::export::NotWritten;
use crate::fault::Code;
use crate::fault::Faults;
use crate::problem::NoVariant;

use super::exit::Exit;
use super::terminal::visible;

/// Why a command could not do its work.
#[derive(Debug)]
pub(super) struct Failure {
    exit: Exit,
    message: String,
}

impl Failure {
    /// Input that cannot be used.
    pub(super) fn unusable(message: impl Into<String>) -> Self {
        Self { exit: Exit::Unusable, message: format!("error: {}", message.into()) }
    }

    /// A file that cannot be read or written.
    pub(super) fn file(path: &Path, does: &str, error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::from_pipe();
        }
        Self::unusable(format!("{} cannot be {does}: {error}", path.display()))
    }

    /// Several that were met at once.
    pub(super) fn all(failures: Vec<Self>) -> Self {
        let exit = failures.iter().map(|failure| failure.exit).min().unwrap_or(Exit::Unusable);
        let messages: Vec<String> = failures.into_iter().map(|failure| failure.message).collect();
        Self { exit, message: messages.join("\n") }
    }

    /// The failure behind a seed that draws nothing: the problem does not keep what it promises.
    pub(super) fn no_variant(problem: &str, seed: u64, reason: &NoVariant) -> Self {
        let message = format!(
            "error: {problem}, seed {seed}: {reason}\nhelp: `momentous check {problem}` says how often this happens"
        );
        Self { exit: Exit::NotRight, message }
    }

    /// Whoever read the output has read enough.
    fn from_pipe() -> Self {
        Self { exit: Exit::Fine, message: String::new() }
    }

    /// The message, for a place that says it is an error.
    pub(super) fn message(&self) -> String {
        let message = self.message.trim_end();
        message.strip_prefix("error: ").unwrap_or(message).to_owned()
    }

    /// Says on standard error what went wrong; gives the exit code.
    pub(super) fn report(&self) -> Exit {
        let message = self.message.trim_end();
        if !message.is_empty() {
            tell(message);
        }
        self.exit
    }
}

/// Says something on standard error, whatever signs are in it; where that is closed there is nobody left to tell.
pub(super) fn tell(text: &str) {
    let _ = writeln!(io::stderr(), "{}", visible(text));
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.message.trim_end())
    }
}

impl From<Faults> for Failure {
    fn from(faults: Faults) -> Self {
        let stuck = !faults.list.is_empty() && faults.list.iter().all(|fault| fault.code == Code::Stuck);
        Self { exit: if stuck { Exit::Stuck } else { Exit::Unusable }, message: faults.to_string() }
    }
}

impl From<NotWritten> for Failure {
    fn from(reason: NotWritten) -> Self {
        match reason {
            NotWritten::Output(error) => error.into(),
            NotWritten::Text(faults) => faults.into(),
            NotWritten::Package(_) => Self::unusable(reason.to_string()),
        }
    }
}

impl From<Vec<Faults>> for Failure {
    fn from(faults: Vec<Faults>) -> Self {
        Self::all(faults.into_iter().map(Self::from).collect())
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::from_pipe(),
            _ => Self::unusable(format!("the output cannot be written: {error}")),
        }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::from(io::Error::from(error))
    }
}

#[cfg(test)]
mod tests {
    use crate::fault::{Fault, Source};

    use super::*;

    fn exit_of(codes: &[Code]) -> Exit {
        let list = codes.iter().map(|code| Fault::new(*code, "no")).collect();
        Failure::from(Faults { source: Source::new("a.yaml", ""), list }).exit
    }

    #[test]
    fn only_a_solver_that_is_stuck_ends_with_3() {
        assert_eq!(exit_of(&[Code::Stuck, Code::Stuck]), Exit::Stuck);
        assert_eq!(exit_of(&[Code::Stuck, Code::UnknownName]), Exit::Unusable);
        assert_eq!(exit_of(&[Code::UnderDetermined]), Exit::Unusable);
    }

    #[test]
    fn a_closed_pipe_is_no_fault() {
        let failure = Failure::from(io::Error::from(io::ErrorKind::BrokenPipe));
        assert_eq!((failure.report(), failure.to_string().as_str()), (Exit::Fine, ""));
    }
}
