//! Many submissions, marked chunk by chunk in memory that does not grow with them.

use std::path::Path;

use crate::cli::exit::Exit;
use crate::cli::failure::{Failure, tell};
use crate::cli::generate;
use crate::cli::generate::SEEDS;
use crate::cli::open;
use crate::cli::output;
use crate::cli::table;
use crate::exercise::Derived;
use crate::exercise::Listed;
use crate::exercise::Place;
use crate::exercise::SeedSource;
use crate::exercise::Sheets;
use crate::grade::RowCounts;
use crate::problem::secret_mark;

use super::Grade;
use super::gradebook::{Numbers, Students};
use super::homework;
use super::homework::{Answers, Drawn};
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
use super::worth::Worths;

/// The heading under which students stand in submissions.
const STUDENT: &str = "student";

impl Grade {
    /// Marks a file or a folder of submissions, or a table of answers to a homework.
    pub(super) fn table(&self, path: &Path, homework: Option<&Path>) -> Result<Exit, Failure> {
        self.keep_apart(path, homework)?;
        let secret = self.secret.read()?;
        let (sheets, answers) = match homework {
            Some(homework) => {
                let (sheets, answers) = self.homework(homework, path, secret.as_deref())?;
                (Some(sheets), Some(answers))
            }
            None => (self.sheets(self.sheets.as_deref(), secret.as_deref())?, None),
        };
        if sheets.is_none() {
            tell("note: seeds are taken on trust; --sheets or --roster says which student has which");
        }
        let problems = Problems::here(&self.problem, secret, self.decimal.into())?;
        let (mut worths, mut students) = (Worths::new(), Students::Column(STUDENT.to_owned()));
        let (mut numbers, mut title) = (Numbers::new(), self.title(path));
        let source = match (answers, &self.codes) {
            (Some(answers), _) => {
                worths = answers.worths;
                title = self.title.clone().unwrap_or(answers.title);
                Source::Responses(answers.submissions.into_iter())
            }
            (None, None) => Source::open(path)?,
            (None, Some(codes)) => {
                let read = responses::read(path, codes, self.student.as_deref())?;
                (students, numbers) = (read.students, read.numbers);
                Source::Responses(read.submissions.into_iter())
            }
        };
        let register =
            Register::new(problems, sheets, self.scheme).with_worths(worths).of_responses(self.codes.is_some());
        let mut reader =
            if self.any_order { Reader::in_any_order(source, register)? } else { Reader::new(source, register) };
        let mut chunk = reader.chunk();
        reader.check_secret().map_err(|message| {
            let nothing = "help: nothing was marked; rows without a mark after the seed cannot be assigned to a secret";
            table::failure(path, &format!("in most rows, {message}\n{nothing}"))
        })?;
        let mut sink = Sink::to(self.output.as_deref(), self.marks)?;
        let mut readers = Readers::of(self, students, numbers, title)?;
        let (mut exit, mut counts, mut legibility) = (Exit::Fine, RowCounts::default(), Legibility::default());
        while !chunk.is_empty() {
            let (format, keep, problems) = (sink.format(), readers.are_there(), reader.problems());
            let (portions, next) = rayon::join(|| marked(chunk, &problems, format, keep), || reader.chunk());
            chunk = next;
            for portion in portions? {
                sink.write(&portion.rows)?;
                counts += portion.counts;
                legibility += portion.legibility;
                if !portion.is_right {
                    exit = exit.max(Exit::NotRight);
                }
                for marked in portion.marked {
                    match &marked {
                        Marked::Report(..) => {}
                        Marked::NotIssued(place, message) => {
                            tell(&format!("not issued: {}: {message}", position(path, place)));
                        }
                        Marked::Refused(place, message) => {
                            tell(&format!("error: {}: {message}", position(path, place)));
                        }
                    }
                    readers.read(&marked, &problems)?;
                }
            }
        }
        counts.read = reader.read;
        if counts.read == 0 {
            return Err(table::failure(path, "it contains no submission"));
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

    /// The heading of the points in the gradebook: each quiz has its own, so that none is imported over another.
    fn title(&self, path: &Path) -> String {
        let stem = || path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        self.title.clone().unwrap_or_else(stem)
    }

    /// Whether nothing that is read would be written over.
    fn keep_apart(&self, path: &Path, homework: Option<&Path>) -> Result<(), Failure> {
        let read = [
            Some(path),
            homework,
            self.codes.as_deref(),
            self.sheets.as_deref(),
            self.roster.as_deref(),
            self.secret.path(),
        ];
        let named = self.problem.iter().map(Path::new).filter(|path| path.is_file());
        let summary = self.summary.iter().flat_map(|path| summary::paths(path));
        let tables = self.output.iter().chain(&self.junit).chain(&self.gradebook).chain(&self.changes_table);
        let written = tables.cloned().chain(summary);
        output::keep_apart(read.into_iter().flatten().chain(named), written)
    }

    /// Whose sheet of a homework is whose, and the answers to it.
    fn homework(&self, file: &Path, path: &Path, secret: Option<&[u8]>) -> Result<(Sheets, Answers), Failure> {
        let name = file.display().to_string();
        let (_, homework) = open::homework(std::slice::from_ref(&name), secret)?.ok_or_else(|| {
            let help = "name the file of the homework first, then the table of answers";
            Failure::unusable(format!("{name} is no homework\nhelp: {help}"))
        })?;
        let beside = path.with_file_name(SEEDS);
        let (sheets, drawn) = match (&self.sheets, &self.roster) {
            (None, Some(roster)) => {
                let students = generate::students(roster)?.into_iter().map(|student| student.id).collect::<Vec<_>>();
                let seeds = SeedSource { derivation: self.derivation, secret };
                let (drawn, listed) = homework::derived(&students, &homework, seeds, self.scheme);
                (Some(Sheets::Listed(listed)), drawn)
            }
            (Some(table), _) => (self.sheets(Some(table), secret)?, homework::drawn(table, &homework)?),
            (None, None) if beside.is_file() => {
                tell(&format!("note: {} says whose sheet is whose", beside.display()));
                (self.sheets(Some(&beside), secret)?, homework::drawn(&beside, &homework)?)
            }
            (None, None) => (None, Drawn::new()),
        };
        let sheets = sheets.ok_or_else(|| {
            Failure::unusable(
                "nobody says whose sheet of the homework is whose\n\
                 help: give --sheets, the seeds.csv that `momentous generate` wrote, or --roster and --secret",
            )
        })?;
        Ok((sheets, homework::answers(path, &homework, &drawn)?))
    }

    /// Whose sheet is whose, where that is told.
    fn sheets(&self, listed: Option<&Path>, secret: Option<&[u8]>) -> Result<Option<Sheets>, Failure> {
        if let Some(path) = listed {
            let listed = Listed::read(table::open(path)?);
            let failed =
                |faults: Vec<String>| Failure::all(faults.iter().map(|fault| table::failure(path, fault)).collect());
            let listed = listed.map_err(failed)?;
            listed
                .check_secret(secret.map(secret_mark).as_deref())
                .map_err(|message| table::failure(path, &message))?;
            return Ok(Some(Sheets::Listed(listed)));
        }
        let Some(path) = &self.roster else { return Ok(None) };
        let students = generate::students(path)?.into_iter().map(|student| student.id).collect();
        let secret = secret.map(<[u8]>::to_vec);
        Ok(Some(Sheets::Derived(Derived { students, derivation: self.derivation, secret, scheme: self.scheme })))
    }
}

/// The position of a submission, for a message.
fn position(path: &Path, place: &Place) -> String {
    match place {
        Place::Line(line) => format!("{}:{line}", path.display()),
        Place::File(file) => file.display().to_string(),
    }
}
