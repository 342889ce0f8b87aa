//! `momentous check` of a teacher's file.

use std::fs;
use std::io;
use std::path::Path;
use std::time::Duration;

use serde::Serialize;

use momentous_bank::{COURSE_FILE, FOLDER};
use momentous_course::ProblemFile;

use super::super::super::outcome::NotShown;
use super::super::super::processes::{Ended, Turn};
use super::super::super::visit::Visit;
use momentous_web::NotDone;

/// The seeds of each form.
const SEEDS: &str = "100";
/// The longest time that a check may take.
const LONGEST: Duration = Duration::from_mins(1);
/// The file in the folder of a check.
const FILE: &str = "problem.yaml";

/// The result of a check.
#[derive(Serialize)]
pub(super) struct Checked {
    /// Its outcome in a sentence.
    outcome: String,
    is_fine: bool,
    /// The report that the command printed.
    report: String,
}

/// Checks a file.
pub(super) async fn run(visit: &Visit, file: &ProblemFile) -> Result<Checked, NotShown> {
    let turn = visit.courses.processes.turn(visit.person()?.key).await.ok_or(NotShown::NotDone(NotDone::Busy))?;
    let (program, text) = (visit.app.settings.program.clone(), file.text.clone());
    let done = tokio::task::spawn_blocking(move || checked(turn, program.as_deref(), &text)).await;
    match done {
        Ok(Ok(checked)) => Ok(checked),
        Ok(Err(error)) => {
            eprintln!("momentous serve: a check cannot be made: {error}");
            Err(NotShown::NotDone(NotDone::Broken))
        }
        Err(_) => Err(NotShown::NotDone(NotDone::Broken)),
    }
}

fn checked(turn: Turn, program: Option<&Path>, text: &str) -> io::Result<Checked> {
    let folder = tempfile::tempdir()?;
    let bank = folder.path().join(FOLDER);
    fs::create_dir(&bank)?;
    fs::write(bank.join(FILE), text)?;
    let settings = Path::new(FOLDER).join(COURSE_FILE);
    if settings.is_file() {
        fs::copy(settings, bank.join(COURSE_FILE))?;
    }
    let arguments = ["check", &format!("{FOLDER}/{FILE}"), "--seeds", SEEDS];
    let (ended, report) = turn.run(program, folder.path(), &arguments, LONGEST)?;
    let (is_fine, outcome) = match ended {
        Ended::Exit(0) => (true, "Every promise that was checked holds.".to_owned()),
        Ended::Exit(1) => (false, "A promise is broken.".to_owned()),
        Ended::Exit(2) => (false, "The file cannot be used.".to_owned()),
        Ended::Exit(_) | Ended::TooMuch => {
            (false, "The check took too much memory or processor time and was ended.".to_owned())
        }
        Ended::TooLong => (false, format!("The check took longer than {} seconds and was ended.", LONGEST.as_secs())),
    };
    Ok(Checked { outcome, is_fine, report })
}
