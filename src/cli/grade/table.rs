//! Many submissions, marked chunk by chunk in memory that does not grow with them.

use std::path::Path;

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::grade::Gathering;

use super::Grade;
use super::changes::Changes;
use super::junit::Junit;
use super::marked::{Marked, marked};
use super::problems::Problems;
use super::sink::Sink;
use super::source::{Next, Source};
use super::summary;

/// Submissions that are marked at once, while the next ones are read.
const CHUNK: usize = 8192;

impl Grade {
    /// Marks a file or a folder of submissions.
    pub(super) fn table(&self, path: &Path) -> Result<Exit, Failure> {
        let mut problems = Problems::here(self.secret.read()?)?;
        let mut source = Source::open(path)?;
        let mut changes = self.changes.as_deref().map(Changes::since).transpose()?;
        let mut sink = Sink::to(self.output.as_deref(), self.marks)?;
        let mut gathering = self.summary.as_ref().map(|_| Gathering::default());
        let mut junit = self.junit.as_ref().map(|_| Junit::default());
        let mark = self.decimal.into();
        let (mut exit, mut unusable) = (Exit::Fine, 0_u64);
        let mut read = || source.by_ref().take(CHUNK).collect::<Vec<Next>>();
        let mut chunk = read();
        while !chunk.is_empty() {
            let (found, next) = rayon::join(|| marked(chunk, &mut problems, mark), &mut read);
            chunk = next;
            for marked in found {
                let (submission, report) = match marked {
                    Marked::Report(submission, report) => (submission, report),
                    Marked::Unusable(place, message) => {
                        unusable += 1;
                        Failure::unusable(format!("{}:{place}: {message}", path.display())).report();
                        if let Some(junit) = &mut junit {
                            junit.unusable(&place, &message);
                        }
                        continue;
                    }
                };
                if !report.is_right() {
                    exit = exit.max(Exit::NotRight);
                }
                for part in &report.parts {
                    sink.part(&submission, part)?;
                    if let Some(changes) = &mut changes {
                        changes.part(&submission, part)?;
                    }
                    if let Some(gathering) = &mut gathering {
                        let key = |key| submission.key(key);
                        gathering.add(key("student"), key("problem"), key("form"), part);
                    }
                    if let Some(junit) = &mut junit {
                        junit.part(&submission, part);
                    }
                }
            }
        }
        sink.finish()?;
        changes.map_or(Ok(()), Changes::finish)?;
        if let (Some(gathering), Some(path)) = (gathering, &self.summary) {
            summary::write(&gathering.statistics(), path)?;
        }
        if let (Some(junit), Some(path)) = (junit, &self.junit) {
            junit.write(path)?;
        }
        match unusable {
            0 => Ok(exit),
            1 => Err(Failure::unusable("1 row cannot be used")),
            _ => Err(Failure::unusable(format!("{unusable} rows cannot be used"))),
        }
    }
}
