//! `momentous check` in a process of its own, whose time and memory are bounded: whatever a file asks for, the server goes on.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde::Serialize;

use crate::bank::{COURSE_FILE, FOLDER};
use crate::course::ProblemFile;
use crate::fault::Input;

use super::super::super::super::workers::NotDone;
use super::super::super::outcome::NotShown;
use super::super::super::visit::Visit;

/// The seeds of each form.
const SEEDS: &str = "100";
/// How long a check may take.
const LONGEST: Duration = Duration::from_mins(1);
/// The memory of a check in kilobytes; addresses are counted, of which it takes more than it fills.
const MEMORY: &str = "4000000";
/// The processor time of a check in seconds: the system ends it even if the server has gone.
const PROCESSOR: &str = "60";
/// The blocks of 512 bytes that a check may write.
const WRITTEN: &str = "4096";
/// How often it is looked whether a check has ended.
const PAUSE: Duration = Duration::from_millis(20);
/// The bytes of a report that are read.
const SHOWN: u64 = 1 << 22;

/// The file in the folder of a check.
const FILE: &str = "problem.yaml";
/// Where a check writes.
const REPORT: &str = "report.txt";

/// What a check says.
#[derive(Serialize)]
pub(super) struct Checked {
    /// Its outcome in a sentence.
    outcome: String,
    is_fine: bool,
    /// What the command printed.
    report: String,
}

/// Checks a file. One is checked at a time: a check takes a processor for itself.
pub(super) async fn run(visit: &Visit, file: &ProblemFile) -> Result<Checked, NotShown> {
    let _alone = visit.courses.checks.try_acquire().map_err(|_| NotShown::NotDone(NotDone::Busy))?;
    let (program, text) = (visit.app.settings.program.clone(), file.text.clone());
    let done = tokio::task::spawn_blocking(move || checked(program, &text)).await;
    match done {
        Ok(Ok(checked)) => Ok(checked),
        Ok(Err(error)) => {
            eprintln!("momentous serve: a check cannot be made: {error}");
            Err(NotShown::NotDone(NotDone::Broken))
        }
        Err(_) => Err(NotShown::NotDone(NotDone::Broken)),
    }
}

fn checked(program: Option<PathBuf>, text: &str) -> io::Result<Checked> {
    let program = program.map_or_else(std::env::current_exe, Ok)?;
    let folder = tempfile::tempdir()?;
    let bank = folder.path().join(FOLDER);
    fs::create_dir(&bank)?;
    fs::write(bank.join(FILE), text)?;
    let settings = Path::new(FOLDER).join(COURSE_FILE);
    if settings.is_file() {
        fs::copy(settings, bank.join(COURSE_FILE))?;
    }
    let report = folder.path().join(REPORT);
    let output = fs::File::create(&report)?;
    let mut child = limited(&program)
        .args(["check", &format!("{FOLDER}/{FILE}"), "--seeds", SEEDS])
        .current_dir(folder.path())
        .env_clear()
        .env("RAYON_NUM_THREADS", "1")
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .stdout(output.try_clone()?)
        .stderr(output)
        .spawn()?;
    let start = Instant::now();
    let status = loop {
        match child.try_wait()? {
            Some(status) => break Some(status),
            None if start.elapsed() > LONGEST => {
                child.kill()?;
                child.wait()?;
                break None;
            }
            None => thread::sleep(PAUSE),
        }
    };
    let (is_fine, outcome) = match status.map(|status| status.code()) {
        Some(Some(0)) => (true, "Every promise that was checked holds.".to_owned()),
        Some(Some(1)) => (false, "A promise is broken.".to_owned()),
        Some(Some(2)) => (false, "The file cannot be used.".to_owned()),
        Some(_) => (false, "The check took too much memory or processor time and was ended.".to_owned()),
        None => (false, format!("The check took longer than {} seconds and was ended.", LONGEST.as_secs())),
    };
    let report = Input::open(&report)?.text(SHOWN)?;
    Ok(Checked { outcome, is_fine, report })
}

/// The program with less memory and time than it would have.
#[cfg(unix)]
fn limited(program: &Path) -> Command {
    const LIMITS: &str = "ulimit -v \"$1\" && ulimit -t \"$2\" && ulimit -f \"$3\" && shift 3 && exec \"$@\"";
    let mut command = Command::new("/bin/sh");
    command.args(["-c", LIMITS, "sh", MEMORY, PROCESSOR, WRITTEN]).arg(program);
    command
}

/// Elsewhere only its time is bounded.
#[cfg(not(unix))]
fn limited(program: &Path) -> Command {
    Command::new(program)
}
