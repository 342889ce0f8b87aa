//! `momentous serve retention`

use clap::Args;

use crate::course_pages::Clock;
use crate::course_pages::retention::Retained;

use super::super::super::exit::Exit;
use super::super::super::failure::Failure;
use super::super::super::output::Output;
use super::data::Data;

/// Say until when each course keeps answers, and delete those that were kept long enough
#[derive(Args, Debug)]
pub(in crate::cli::serve) struct Retention {
    #[command(flatten)]
    data: Data,
    /// Delete the answers of courses whose time is over, with their marks: save the gradebooks first
    #[arg(long)]
    delete: bool,
}

impl Retention {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let clock = Clock::default();
        let all = self.data.beside(async |store| {
            let all = Retained::all(&store, &clock).await?;
            if self.delete {
                for retained in &all {
                    retained.forget(&store, &clock).await?;
                }
            }
            Ok(all)
        })?;
        let lines: String = all.iter().map(|retained| self.line(retained)).collect();
        Output::whole(None, if lines.is_empty() { "There is no course.\n" } else { &lines })?;
        Ok(Exit::Fine)
    }

    fn line(&self, retained: &Retained) -> String {
        let state = match retained.until.map(|until| until.shown(&retained.course.zone)) {
            Some(until) if !retained.is_over => format!("kept until {until}"),
            Some(_) if self.delete => "deleted".to_owned(),
            Some(until) => format!("kept long enough since {until}; --delete deletes them"),
            None if retained.course.retention_days.is_some() => "kept; there is no assignment".to_owned(),
            None => "kept without end".to_owned(),
        };
        format!("{}: {}, {state}\n", retained.course.title, retained.detail())
    }
}
