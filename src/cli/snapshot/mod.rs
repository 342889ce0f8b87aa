//! `momentous snapshot`

mod change;
mod kept;
mod page;
mod report;
mod review;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use rayon::prelude::*;

use crate::bank::Bank;
use crate::render::Figures;

use super::exit::Exit;
use super::failure::Failure;
use super::open;
use super::output::Output;
use super::pages;

use change::{Change, Files, summary};
use kept::Kept;

const HELP: &str = "\
Examples:
  momentous snapshot --accept                  write snapshots/ for every problem of the bank
  momentous snapshot                           in the course's CI: compare, show what differs, exit with 1
  momentous snapshot --review                  look at the changes one by one, and accept or reject each
  momentous snapshot --page changes.html       a page with the figures before and now, too
  momentous snapshot impact --folder golden

A snapshot has up to four files below the folder, by topic: the words of sheet and worked solution at seed 1, the numbers and answers of 40 sheets, the marks of typical answers, and the figures. Commit the folder.";

/// Keep golden snapshots of problems, so that no change goes unnoticed
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Snapshot {
    /// Identities, topics, files or folders; the whole bank if nothing is named
    #[arg(value_name = "PATH")]
    problems: Vec<String>,
    /// Compare and show what differs; this is the default
    #[arg(long)]
    check: bool,
    /// Write new and changed snapshots
    #[arg(long, conflicts_with_all = ["check", "review"])]
    accept: bool,
    /// Show the changes problem by problem, and ask whether each is accepted
    #[arg(long, conflicts_with = "check")]
    review: bool,
    /// Write a page with every change to this file, with the figures before and now
    #[arg(long, value_name = "FILE.html")]
    page: Option<PathBuf>,
    /// The folder of the snapshots
    #[arg(long, value_name = "FOLDER", default_value = "snapshots")]
    folder: PathBuf,
}

impl Snapshot {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let (now, failures) = self.now()?;
        // Whose snapshots those of a file are that does not load is not known, so nothing counts as left over.
        let is_whole = self.problems.is_empty() && failures.is_empty();
        let kept = Kept::read(&self.folder, &now, is_whole)?;
        let changes = Change::all(&kept.files, &now);
        if let Some(path) = &self.page {
            Output::whole(Some(path), &report::page(&changes))?;
        }
        let exit = if self.accept {
            self.accept(&kept, &changes, now.len())?
        } else if self.review {
            review::review(&changes, &kept, &mut std::io::stdin().lock())?
        } else {
            report::tell(&changes, &kept, now.len())?
        };
        if failures.is_empty() { Ok(exit) } else { Err(Failure::all(failures)) }
    }

    /// Makes the snapshots of the problems, and lists those of which none could be made.
    fn now(&self) -> Result<(Files, Vec<Failure>), Failure> {
        let (bank, mut unusable) = Bank::gathered_here()?;
        let (sources, named) = bank.selected(&self.problems)?;
        if !self.problems.is_empty() {
            unusable = named;
        }
        let renderer = pages::renderer()?.figures(Figures::Beside(page::FIGURE.to_owned()));
        let snapshots: Vec<Result<Vec<(String, String)>, Failure>> = sources
            .into_par_iter()
            .map(|source| open::compiled(source, None).and_then(|problem| page::snapshots(&problem, &renderer)))
            .collect();
        let mut failures: Vec<Failure> = unusable.into_iter().map(Failure::from).collect();
        let mut now = Files::new();
        for snapshot in snapshots {
            match snapshot {
                Ok(files) => now.extend(files),
                Err(failure) => failures.push(failure),
            }
        }
        Ok((now, failures))
    }

    fn accept(&self, kept: &Kept, changes: &[Change], count: usize) -> Result<Exit, Failure> {
        let mut output = Output::to(None)?;
        for change in changes {
            kept.accept(change)?;
            writeln!(output, "{}: {}", change.problem, change.character())?;
        }
        kept.remove_former(&mut output)?;
        if !changes.is_empty() {
            writeln!(output, "{}", summary(changes))?;
        }
        writeln!(output, "{count} files in {}", self.folder.display())?;
        output.finish()?;
        Ok(Exit::Fine)
    }
}
