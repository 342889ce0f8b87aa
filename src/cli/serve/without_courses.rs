//! Courses asked of a program that was built without them.

use std::path::Path;

use clap::Args;

use super::super::failure::Failure;

/// The folder in which a program with courses keeps them where no other is named.
const FOLDER: &str = "momentous-data";

/// The way to a program with courses.
const HELP: &str = "build the program with `--features courses`, as the README shows";

/// The options that say where courses are.
#[derive(Args, Debug)]
pub(super) struct NoCourses {
    #[arg(long = "data", value_name = "FOLDER|URL", env = "MOMENTOUS_DATA", hide = true, hide_env_values = true)]
    data: Option<String>,
    /// Serve practice and simulators beside a folder that holds courses: problems of open assignments are shown, too
    #[arg(long)]
    no_courses: bool,
}

impl NoCourses {
    /// Refuses to serve where courses are: their open assignments would be shown with their solutions.
    pub(super) fn refuse(&self) -> Result<(), Failure> {
        if self.no_courses {
            return Ok(());
        }
        if self.data.is_some() {
            let why = "this program was built without courses, so it cannot serve those of --data (or MOMENTOUS_DATA)";
            return Err(Failure::unusable(format!("{why}\nhelp: {HELP}, or serve practice alone with --no-courses")));
        }
        if Path::new(FOLDER).is_dir() {
            let why = format!(
                "the folder `{FOLDER}` holds courses, and this program was built without them: \
                 it would show the solutions of open assignments"
            );
            return Err(Failure::unusable(format!("{why}\nhelp: {HELP}, or serve from another folder")));
        }
        Ok(())
    }
}

/// Refuses a command that works on courses.
pub(super) fn command(words: &[String]) -> Failure {
    let word = words.first().map_or("", String::as_str);
    if ["backup", "check", "restore", "retention", "user"].contains(&word) {
        let why = format!("`momentous serve {word}` works on courses, and this program was built without them");
        return Failure::unusable(format!("{why}\nhelp: {HELP}"));
    }
    Failure::unusable(format!("`momentous serve` has no command `{word}`\nhelp: see `momentous serve --help`"))
}
