//! Many submissions, marked chunk by chunk in memory that does not grow with them.

use std::path::Path;

use crate::cli::exit::Exit;
use crate::cli::failure::{Failure, tell};
use crate::cli::generate;
use crate::cli::output;
use crate::cli::table;
use crate::exercise::Derived;
use crate::exercise::Listed;
use crate::exercise::Place;
use crate::exercise::Sheets;
use crate::grade::RowCounts;
use crate::problem::secret_mark;

use super::Grade;
use super::gradebook::Students;
use super::legibility::Legibility;
use super::marked::{Marked, marked};
use super::problems::Problems;
use super::reader::Reader;
use super::readers::Readers;
use super::register::Register;
use super::responses;
use super::sink::Sink;
use super::source::Source;
use super::summary;

/// The heading under which students stand in submissions.
const STUDENT: &str = "student";

impl Grade {
    /// Marks a file or a folder of submissions.
    pub(super) fn table(&self, path: &Path) -> Result<Exit, Failure> {
        self.keep_apart(path)?;
        let secret = self.secret.read()?;
        let sheets = self.sheets(secret.as_deref())?;
        if sheets.is_none() {
            tell("note: seeds are taken on trust; --sheets or --roster says which student has which");
        }
        let problems = Problems::here(&self.problem, secret, self.decimal.into())?;
        let (source, students) = match &self.codes {
            None => (Source::open(path)?, Students::Column(STUDENT.to_owned())),
            Some(codes) => {
                let (responses, students) = responses::read(path, codes, self.student.as_deref())?;
                (Source::Responses(responses.into_iter()), students)
            }
        };
        let register = Register::new(problems, sheets, self.scheme);
        let mut reader =
            if self.any_order { Reader::in_any_order(source, register)? } else { Reader::new(source, register) };
        let mut chunk = reader.chunk();
        reader.check_secret().map_err(|message| {
            let nothing = "help: nothing was marked; rows without a mark after the seed cannot be assigned to a secret";
            table::of(path, &format!("in most rows, {message}\n{nothing}"))
        })?;
        let mut sink = Sink::to(self.output.as_deref(), self.marks)?;
        let mut readers = Readers::of(self, students)?;
        let (mut exit, mut counts, mut legibility) = (Exit::Fine, RowCounts::default(), Legibility::default());
        while !chunk.is_empty() {
            let (format, keep, problems) = (sink.format(), readers.are_there(), reader.problems());
            let (found, next) = rayon::join(|| marked(chunk, &problems, format, keep), || reader.chunk());
            chunk = next;
            for portion in found? {
                sink.write(&portion.rows)?;
                counts += portion.counts;
                legibility += portion.legibility;
                if !portion.is_right {
                    exit = exit.max(Exit::NotRight);
                }
                for own in portion.marked {
                    match &own {
                        Marked::Report(..) => {}
                        Marked::NotIssued(place, message) => {
                            tell(&format!("not issued: {}: {message}", position(path, place)));
                        }
                        Marked::Refused(place, message) => {
                            tell(&format!("error: {}: {message}", position(path, place)));
                        }
                    }
                    readers.read(&own, &problems)?;
                }
            }
        }
        counts.read = reader.read;
        if counts.read == 0 {
            return Err(table::of(path, "it contains no submission"));
        }
        sink.finish()?;
        let have_changed = readers.finish(self, counts)?;
        tell(&counts.to_string());
        if let Some(told) = legibility.told(self.decimal) {
            tell(&told);
        }
        if !counts.is_complete() {
            return Err(Failure::unusable("rows were lost: this is a fault of the program; please report it"));
        }
        Ok(match have_changed {
            // Marked once more, the question is no longer whether the answers are right.
            Some(false) => Exit::Fine,
            Some(true) => Exit::NotRight,
            None if counts.refused > 0 => Exit::Unusable,
            None => exit,
        })
    }

    /// Whether nothing that is read would be written over.
    fn keep_apart(&self, path: &Path) -> Result<(), Failure> {
        let read =
            [Some(path), self.codes.as_deref(), self.sheets.as_deref(), self.roster.as_deref(), self.secret.path()];
        let named = self.problem.iter().map(Path::new).filter(|path| path.is_file());
        let summary = self.summary.iter().flat_map(|path| summary::paths(path));
        let tables = self.output.iter().chain(&self.junit).chain(&self.gradebook).chain(&self.changes_table);
        let written = tables.cloned().chain(summary);
        output::keep_apart(read.into_iter().flatten().chain(named), written)
    }

    /// Whose sheet is whose, where that is told.
    fn sheets(&self, secret: Option<&[u8]>) -> Result<Option<Sheets>, Failure> {
        if let Some(path) = &self.sheets {
            let listed = Listed::read(table::open(path)?);
            let failed =
                |faults: Vec<String>| Failure::all(faults.iter().map(|fault| table::of(path, fault)).collect());
            let listed = listed.map_err(failed)?;
            listed.check_secret(secret.map(secret_mark).as_deref()).map_err(|message| table::of(path, &message))?;
            return Ok(Some(Sheets::Listed(listed)));
        }
        let Some(path) = &self.roster else { return Ok(None) };
        let students = generate::students(path)?.into_iter().map(|student| student.id).collect();
        let secret = secret.map(<[u8]>::to_vec);
        Ok(Some(Sheets::Derived(Derived { students, derivation: self.derivation, secret, scheme: self.scheme })))
    }
}

/// Where a submission stands, for a message.
fn position(path: &Path, place: &Place) -> String {
    match place {
        Place::Line(line) => format!("{}:{line}", path.display()),
        Place::File(file) => file.display().to_string(),
    }
}
