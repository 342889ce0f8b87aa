//! Courses asked of a program that was built without them: the same face as `courses`.

use std::net::SocketAddr;
use std::path::Path;

use clap::{Args, Subcommand};

use crate::web::{self, Settings};

use super::super::exit::Exit;
use super::super::failure::Failure;
use super::unserved::{FOLDER, failure};

pub(super) const HELP: &str = "\
Examples:
  momentous serve                                    practice and simulators on http://127.0.0.1:8080
  momentous serve --bind 0.0.0.0:80                  for everybody who reaches this machine
  momentous serve --watch problem_bank               an author's preview: pages follow the files as they are saved

Ctrl-C stops it. Courses are a feature of the program: build it with `--features courses`. docs/serving.md has the rest.";

/// The way to a program with courses.
const WAY_OUT: &str = "build the program with `--features courses`, as the README shows";

/// The options that say where courses are.
#[derive(Args, Debug)]
pub(super) struct Courses {
    #[arg(long = "data", value_name = "FOLDER|URL", env = "MOMENTOUS_DATA", hide = true, hide_env_values = true)]
    data: Option<String>,
    /// Serve practice and simulators beside a folder that holds courses: problems of open assignments are shown, too
    #[arg(long)]
    no_courses: bool,
}

impl Courses {
    /// Serves the pages alone.
    pub(super) fn serve(
        &self,
        settings: Settings,
        ready: impl FnOnce(SocketAddr, Option<String>),
    ) -> Result<(), Failure> {
        self.refuse()?;
        web::serve(settings, async { Ok(None) }, |address| ready(address, None)).map_err(failure)
    }

    /// Refuses to serve where courses are: their open assignments would be shown with their solutions.
    fn refuse(&self) -> Result<(), Failure> {
        if self.no_courses {
            return Ok(());
        }
        if self.data.is_some() {
            let why = "this program was built without courses, so it cannot serve those of --data (or MOMENTOUS_DATA)";
            return Err(Failure::unusable(format!(
                "{why}\nhelp: {WAY_OUT}, or serve practice alone with --no-courses"
            )));
        }
        if Path::new(FOLDER).is_dir() {
            let why = format!(
                "the folder `{FOLDER}` holds courses, and this program was built without them: \
                 it would show the solutions of open assignments"
            );
            return Err(Failure::unusable(format!("{why}\nhelp: {WAY_OUT}, or serve from another folder")));
        }
        Ok(())
    }
}

/// The commands of a program that was built with courses.
#[derive(Debug, Subcommand)]
pub(super) enum Beside {
    #[command(external_subcommand)]
    OfCourses(Vec<String>),
}

impl Beside {
    /// Refuses a command that works on courses.
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let Self::OfCourses(words) = self;
        let word = words.first().map_or("", String::as_str);
        if ["backup", "check", "restore", "retention", "user"].contains(&word) {
            let why = format!("`momentous serve {word}` works on courses, and this program was built without them");
            return Err(Failure::unusable(format!("{why}\nhelp: {WAY_OUT}")));
        }
        Err(Failure::unusable(format!("`momentous serve` has no command `{word}`\nhelp: see `momentous serve --help`")))
    }
}
