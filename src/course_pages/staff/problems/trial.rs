//! A teacher's file read and compiled on trial, before the server itself takes the time for it.

use std::fs;
use std::io;
use std::path::Path;
use std::time::Duration;

use super::super::super::outcome::NotShown;
use super::super::super::processes::{Ended, Turn};
use super::super::super::visit::Visit;
use momentous_web::NotDone;

/// The longest time that a file may take to compile. Those of the bank take less than a second.
const LONGEST: Duration = Duration::from_secs(10);
/// The name of the file in what is said of it.
pub(super) const NAME: &str = "problem.yaml";

/// The result of trying a file.
pub(super) enum Trial {
    /// It loads.
    Fine,
    /// It does not, or not yet: why, with every fault and its excerpt as the command line prints them.
    Not(String),
}

/// Reads and compiles a file on trial.
pub(super) async fn try_file(visit: &Visit, text: &str) -> Result<Trial, NotShown> {
    let Some(turn) = visit.courses.processes.turn(visit.person()?.key).await else {
        let message = "another file is being read, yours or several of others\nhelp: wait a moment and keep it again";
        return Ok(Trial::Not(message.to_owned()));
    };
    let (program, text) = (visit.app.settings.program.clone(), text.to_owned());
    let done = tokio::task::spawn_blocking(move || tried(turn, program.as_deref(), &text)).await;
    match done {
        Ok(Ok(trial)) => Ok(trial),
        Ok(Err(error)) => {
            eprintln!("momentous serve: a file cannot be read on trial: {error}");
            Err(NotShown::NotDone(NotDone::Broken))
        }
        Err(_) => Err(NotShown::NotDone(NotDone::Broken)),
    }
}

fn tried(turn: Turn, program: Option<&Path>, text: &str) -> io::Result<Trial> {
    let folder = tempfile::tempdir()?;
    fs::write(folder.path().join(NAME), text)?;
    let (ended, printed) = turn.run(program, folder.path(), &["check", "--load", NAME], LONGEST)?;
    Ok(match ended {
        Ended::Exit(0) => Trial::Fine,
        Ended::Exit(2) => Trial::Not(printed),
        Ended::Exit(_) | Ended::TooMuch | Ended::TooLong => Trial::Not(format!(
            "the file takes more than {} seconds or too much memory to compile\n\
             help: ask for less in one problem: fewer bodies, stages and questions; docs/language/reference.md names the limits",
            LONGEST.as_secs()
        )),
    })
}
