//! Courses beside the pages, in a program that was built with them.

mod check;
mod copy;
mod data;
mod finding;
mod folder;
mod health;
mod mail;
mod options;
mod retention;
mod user;

use clap::Subcommand;

use super::super::exit::Exit;
use super::super::failure::Failure;

pub(super) use options::Courses;

pub(super) const HELP: &str = "\
Examples:
  momentous serve                                    practice, simulators and courses on http://127.0.0.1:8080
  momentous serve --bind 0.0.0.0:80                  for everybody who reaches this machine
  momentous serve --base-url https://physics.example.edu/momentous
  momentous serve --data postgres://momentous:password@db/courses
  momentous serve --watch problem_bank               an author's preview: pages follow the files as they are saved
  momentous serve user add ada --operator            a link with which Ada signs in and runs the server
  momentous serve check                              what is misconfigured, with the way out
  momentous serve backup 2026-11-30.sqlite           a copy of everything, while the server works

Ctrl-C stops it. docs/serving.md has the rest: proxy, service, backup, upgrade.";

/// Work on the data while the server runs, or before it starts.
#[derive(Debug, Subcommand)]
pub(super) enum Beside {
    Backup(copy::Backup),
    Check(check::Check),
    Restore(copy::Restore),
    Retention(retention::Retention),
    User(user::User),
}

impl Beside {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        match self {
            Self::Backup(backup) => backup.run(),
            Self::Check(check) => check.run(),
            Self::Restore(restore) => restore.run(),
            Self::Retention(retention) => retention.run(),
            Self::User(user) => user.run(),
        }
    }
}
