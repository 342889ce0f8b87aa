//! Those that read every mark, besides the table of marks itself.

use std::sync::Arc;

use crate::cli::failure::Failure;
use crate::exercise::Key;
use crate::grade::Gathering;
use crate::grade::RowCounts;

use super::Grade;
use super::changes::Changes;
use super::gradebook::{Gradebook, Numbers, Students};
use super::junit::Junit;
use super::marked::Marked;
use super::problems::OpenProblem;
use super::summary;

/// Those that were asked for.
pub(super) struct Readers {
    changes: Option<Changes>,
    gathering: Option<Gathering>,
    junit: Option<Junit>,
    gradebook: Option<Gradebook>,
}

impl Readers {
    pub(super) fn of(grade: &Grade, students: Students, numbers: Numbers, title: String) -> Result<Self, Failure> {
        Ok(Self {
            changes: grade
                .changes
                .as_deref()
                .map(|path| Changes::since(path, grade.changes_table.as_deref()))
                .transpose()?,
            gathering: grade.summary.as_ref().map(|_| Gathering::default()),
            junit: grade.junit.as_deref().map(Junit::to).transpose()?,
            gradebook: grade.gradebook.as_deref().map(|path| {
                let attempts = grade.codes.as_ref().map(|_| (grade.attempts, numbers));
                Gradebook::to(path, title, students, attempts)
            }),
        })
    }

    pub(super) fn are_there(&self) -> bool {
        self.changes.is_some() || self.gathering.is_some() || self.junit.is_some() || self.gradebook.is_some()
    }

    /// Reads what was found about the next submission.
    pub(super) fn read(&mut self, marked: &Marked, problems: &[Arc<OpenProblem>]) -> Result<(), Failure> {
        let (entry, report) = match marked {
            Marked::Report(marked) => &**marked,
            Marked::NotIssued(..) => return Ok(()),
            Marked::Refused(place, message) => {
                return self.junit.as_mut().map_or(Ok(()), |junit| junit.refused(place, message));
            }
        };
        let question = entry.facts.question;
        let Some(variant) = problems.get(question.problem).map(|opened| opened.variant(question)) else {
            return Ok(());
        };
        if let Some(gradebook) = &mut self.gradebook {
            gradebook.add(entry, report);
        }
        for part in &report.parts {
            if let Some(changes) = &mut self.changes {
                changes.part(&entry.submission, part, &entry.facts.earned(part))?;
            }
            if let Some(gathering) = &mut self.gathering {
                gathering.add(entry.submission.key(Key::Student), variant.problem, variant.form, part);
            }
            if let Some(junit) = &mut self.junit {
                junit.part(&entry.submission, variant, part)?;
            }
        }
        Ok(())
    }

    /// Writes what was asked for; whether a mark has changed, where earlier marks are there to compare with.
    pub(super) fn finish(self, grade: &Grade, counts: RowCounts) -> Result<Option<bool>, Failure> {
        let have_changed = self.changes.map(Changes::finish).transpose()?;
        if let (Some(gathering), Some(path)) = (self.gathering, &grade.summary) {
            summary::write(&gathering.statistics(counts), path)?;
        }
        self.gradebook.map_or(Ok(()), Gradebook::finish)?;
        self.junit.map_or(Ok(()), Junit::finish)?;
        Ok(have_changed)
    }
}
