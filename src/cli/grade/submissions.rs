//! A table of submissions, marked row by row in memory that does not grow with it.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use csv::StringRecord;
use rayon::prelude::*;

use crate::bank::Bank;
use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::open;
use crate::cli::output::Output;
use crate::cli::table::Table;
use crate::exercise::Exercise;
use crate::grade::DecimalMark;
use crate::grade::Report;
use crate::problem::Problem;

use super::Grade;

/// Rows that are marked at once, by all cores, before they are written in order.
const CHUNK: usize = 1024;

/// The columns that are not parts.
const COLUMNS: [&str; 6] = ["student", "problem", "digest", "seed", "form", "attempt"];

/// The headings of the result.
const HEAD: [&str; 12] = [
    "line",
    "student",
    "problem",
    "seed",
    "form",
    "attempt",
    "part",
    "marks",
    "out_of",
    "verdict",
    "message",
    "understood",
];

/// A row whose problem is known.
struct Submission {
    line: u64,
    row: StringRecord,
    problem: Result<Arc<Problem>, String>,
}

/// Where the columns of a table stand.
struct Columns {
    known: [Option<usize>; COLUMNS.len()],
    parts: Vec<(String, usize)>,
}

/// The problems of a table, each compiled when it is first met.
struct Problems<'a> {
    bank: Bank,
    secret: Option<&'a [u8]>,
    met: BTreeMap<String, Result<Arc<Problem>, String>>,
}

impl Grade {
    /// Marks a table.
    pub(super) fn table(&self, path: &Path) -> Result<Exit, Failure> {
        let secret = self.secret.read()?;
        let mut table = Table::open(path)?;
        let columns = Columns::of(&table, path)?;
        let mut problems = Problems { bank: Bank::here()?, secret: secret.as_deref(), met: BTreeMap::new() };
        let mut output = csv::Writer::from_writer(Output::to(self.output.as_deref())?);
        output.write_record(HEAD).map_err(unwritten)?;
        let mark = DecimalMark::from(self.decimal);
        let (mut exit, mut malformed) = (Exit::Fine, 0_u64);
        let mut rows = table.rows();
        loop {
            let chunk: Vec<_> = rows.by_ref().take(CHUNK).collect();
            if chunk.is_empty() {
                break;
            }
            // The problems are compiled one after the other, then the rows are marked by all cores.
            let chunk: Vec<Result<Submission, (u64, String)>> = chunk
                .into_iter()
                .map(|(line, row)| {
                    let row = row.map_err(|message| (line, message))?;
                    let problem = problems.open(columns.cell(&row, "problem"));
                    Ok(Submission { line, row, problem })
                })
                .collect();
            let marked: Vec<_> = chunk
                .into_par_iter()
                .map(|submission| {
                    let submission = submission?;
                    let line = submission.line;
                    submission.marked(&columns, mark).map_err(|message| (line, message))
                })
                .collect();
            for marked in marked {
                match marked {
                    Ok((right, lines)) => {
                        if !right {
                            exit = exit.max(Exit::NotRight);
                        }
                        lines.iter().try_for_each(|line| output.write_record(line)).map_err(unwritten)?;
                    }
                    Err((line, message)) => {
                        malformed += 1;
                        Failure::unusable(format!("{}:{line}: {message}", path.display())).report();
                    }
                }
            }
        }
        let output =
            output.into_inner().map_err(|error| Failure::from(std::io::Error::other(error.error().to_string())))?;
        output.finish()?;
        match malformed {
            0 => Ok(exit),
            1 => Err(Failure::unusable("1 row cannot be used")),
            _ => Err(Failure::unusable(format!("{malformed} rows cannot be used"))),
        }
    }
}

fn unwritten(error: csv::Error) -> Failure {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => Failure::from(error),
        kind => Failure::unusable(format!("the marks cannot be written: {kind:?}")),
    }
}

impl Columns {
    fn of(table: &Table, path: &Path) -> Result<Self, Failure> {
        for needed in ["problem", "seed"] {
            if table.column(needed).is_none() {
                return Err(Failure::unusable(format!("{} has no column `{needed}`", path.display())));
            }
        }
        let is_part =
            |heading: &str| !heading.is_empty() && !COLUMNS.iter().any(|own| own.eq_ignore_ascii_case(heading));
        let headings = table.headings.iter().enumerate();
        let parts = headings.filter(|(_, heading)| is_part(heading)).map(|(index, heading)| (heading.clone(), index));
        Ok(Self { known: COLUMNS.map(|name| table.column(name)), parts: parts.collect() })
    }

    /// What stands in one of the columns that are not parts; nothing where the table has no such column.
    fn cell<'r>(&self, row: &'r StringRecord, name: &str) -> &'r str {
        let column = COLUMNS.iter().position(|own| *own == name).and_then(|index| self.known[index]);
        column.and_then(|column| row.get(column)).unwrap_or_default()
    }
}

impl Problems<'_> {
    fn open(&mut self, name: &str) -> Result<Arc<Problem>, String> {
        if let Some(met) = self.met.get(name) {
            return met.clone();
        }
        let source = self.bank.open(name).map_err(Failure::from);
        let problem = source.and_then(|source| open::compiled(source, self.secret));
        let problem = problem.map_err(|failure| failure.to_string());
        self.met.insert(name.to_owned(), problem.clone());
        problem
    }
}

impl Submission {
    /// Whether all is right, and the lines of the result; or why the row cannot be used.
    fn marked(&self, columns: &Columns, mark: DecimalMark) -> Result<(bool, Vec<Vec<String>>), String> {
        let cell = |name: &str| columns.cell(&self.row, name);
        let problem = self.problem.clone()?;
        let digest = &problem.loaded().digest;
        if !cell("digest").is_empty() && cell("digest") != digest {
            return Err(format!("the sheet was made from another version of {}: its digest is {digest}", problem.id()));
        }
        let seed = open::seed(cell("seed")).map_err(|why| format!("`{}` is no seed: {why}", cell("seed")))?;
        let form = Some(cell("form")).filter(|form| !form.is_empty());
        let form = open::form(&problem, form).map_err(|failure| failure.to_string())?;
        let exercise = Exercise::draw(&problem, form, seed).map_err(|reason| reason.to_string())?;
        let answers: BTreeMap<String, String> = columns
            .parts
            .iter()
            .filter_map(|(part, column)| Some((part.clone(), self.row.get(*column)?.to_owned())))
            .filter(|(_, answer)| !answer.is_empty())
            .collect();
        let report = exercise.grade(&answers, mark);
        if let Some(name) = report.not_asked.first() {
            return Err(format!("`{name}` has an answer, and {} does not ask for it in this form", problem.id()));
        }
        Ok((report.is_right(), self.lines(columns, &report)))
    }

    fn lines(&self, columns: &Columns, report: &Report) -> Vec<Vec<String>> {
        let line = |part: &crate::grade::PartReport| {
            let copied =
                ["student", "problem", "seed", "form", "attempt"].map(|name| columns.cell(&self.row, name).to_owned());
            let found = [
                part.id.clone(),
                part.points.to_string(),
                part.out_of.to_string(),
                part.verdict.to_string(),
                part.message.clone(),
                part.understood.clone().unwrap_or_default(),
            ];
            std::iter::once(self.line.to_string()).chain(copied).chain(found).collect()
        };
        report.parts.iter().map(line).collect()
    }
}
