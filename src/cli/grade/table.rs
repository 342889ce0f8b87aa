//! Many submissions, marked chunk by chunk in memory that does not grow with them.

use std::path::Path;

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::grade::Gathering;

use super::Grade;
use super::changes::Changes;
use super::junit::Junit;
use super::marked::{Marked, are_beside, marked};
use super::problems::Problems;
use super::sink::Sink;
use super::source::{Next, Source};
use super::submission::Key;
use super::summary;

/// Submissions that are marked at once, while the next ones are read.
const CHUNK: usize = 16384;
/// The most attempts that one student can have at one question.
const MOST_ATTEMPTS: usize = 1000;

impl Grade {
    /// Marks a file or a folder of submissions.
    pub(super) fn table(&self, path: &Path) -> Result<Exit, Failure> {
        let mut problems = Problems::here(self.secret.read()?, self.decimal.into())?;
        let mut source = Source::open(path)?.peekable();
        let mut sink = Sink::to(self.output.as_deref(), self.marks)?;
        let mut readers = Readers::of(self)?;
        let (mut exit, mut unusable) = (Exit::Fine, 0_u64);
        let mut chunk = read(&mut source);
        while !chunk.is_empty() {
            let (format, keep) = (sink.format(), readers.are_there());
            let (found, next) = rayon::join(|| marked(chunk, &mut problems, format, keep), || read(&mut source));
            chunk = next;
            for portion in found? {
                sink.write(&portion.rows)?;
                if !portion.is_right {
                    exit = exit.max(Exit::NotRight);
                }
                for own in portion.marked {
                    if let Marked::Unusable(place, message) = &own {
                        unusable += 1;
                        Failure::unusable(format!("{}:{place}: {message}", path.display())).report();
                    }
                    readers.read(&own)?;
                }
            }
        }
        sink.finish()?;
        readers.finish(self)?;
        match unusable {
            0 => Ok(exit),
            1 => Err(Failure::unusable("1 row cannot be used")),
            _ => Err(Failure::unusable(format!("{unusable} rows cannot be used"))),
        }
    }
}

/// The next chunk: attempts of one student at one question are not torn apart.
fn read(source: &mut std::iter::Peekable<Source>) -> Vec<Next> {
    let mut chunk: Vec<Next> = source.by_ref().take(CHUNK).collect();
    while chunk.len() < CHUNK + MOST_ATTEMPTS
        && let Some(next) = source.next_if(|next| chunk.last().is_some_and(|last| are_beside(last, next)))
    {
        chunk.push(next);
    }
    chunk
}

/// Those that read every mark, besides the table itself.
struct Readers {
    changes: Option<Changes>,
    gathering: Option<Gathering>,
    junit: Option<Junit>,
}

impl Readers {
    fn of(grade: &Grade) -> Result<Self, Failure> {
        Ok(Self {
            changes: grade.changes.as_deref().map(Changes::since).transpose()?,
            gathering: grade.summary.as_ref().map(|_| Gathering::default()),
            junit: grade.junit.as_ref().map(|_| Junit::default()),
        })
    }

    fn are_there(&self) -> bool {
        self.changes.is_some() || self.gathering.is_some() || self.junit.is_some()
    }

    fn read(&mut self, marked: &Marked) -> Result<(), Failure> {
        let (submission, report) = match marked {
            Marked::Report(submission, report) => (submission, report),
            Marked::Unusable(place, message) => {
                if let Some(junit) = &mut self.junit {
                    junit.unusable(place, message);
                }
                return Ok(());
            }
        };
        for part in &report.parts {
            if let Some(changes) = &mut self.changes {
                changes.part(submission, part)?;
            }
            if let Some(gathering) = &mut self.gathering {
                let key = |key| submission.key(key);
                gathering.add(key(Key::Student), key(Key::Problem), key(Key::Form), part);
            }
            if let Some(junit) = &mut self.junit {
                junit.part(submission, part);
            }
        }
        Ok(())
    }

    fn finish(self, grade: &Grade) -> Result<(), Failure> {
        self.changes.map_or(Ok(()), Changes::finish)?;
        if let (Some(gathering), Some(path)) = (self.gathering, &grade.summary) {
            summary::write(&gathering.statistics(), path)?;
        }
        if let (Some(junit), Some(path)) = (self.junit, &grade.junit) {
            junit.write(path)?;
        }
        Ok(())
    }
}
