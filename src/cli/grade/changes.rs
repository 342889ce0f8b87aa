//! Which marks moved when the same submissions are marked again.

use std::io::BufReader;
use std::io::Write;
use std::path::Path;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::table;
use crate::exercise::Key;
use crate::exercise::Place;
use crate::exercise::Row;
use crate::exercise::Submission;
use crate::exercise::Table;
use crate::exercise::defused;
use crate::fault::Input;
use crate::grade::PartReport;

use super::worth::Earned;

/// The columns that are read.
const READ: [&str; 10] =
    ["line", "student", "problem", "seed", "form", "attempt", "part", "marks", "out_of", "verdict"];

/// The headings of the table of changes: what is marked, and the mark before and now.
const WRITTEN: [&str; 13] = [
    "line",
    "student",
    "problem",
    "seed",
    "form",
    "attempt",
    "part",
    "marks_before",
    "out_of_before",
    "verdict_before",
    "marks",
    "out_of",
    "verdict",
];

/// How many of the columns say what is marked.
const KEYS: usize = 7;

/// A mark as a table says it: marks, points, verdict; empty where the row was not marked.
type Mark = [String; 3];

/// The marks of an earlier run, read beside those of this one: both are in the order of the submissions.
pub(super) struct Changes {
    name: String,
    old: Table<BufReader<Input>>,
    /// A row that is read and not compared yet, with its line in the file.
    next: Option<(u64, Row)>,
    columns: [usize; READ.len()],
    output: Output,
    table: Option<csv::Writer<Output>>,
    moved: u64,
    compared: u64,
}

impl Changes {
    /// Opens the marks of an earlier run, a table that `momentous grade` wrote; what changed goes into a table of its own where
    /// one is named.
    pub(super) fn since(path: &Path, table: Option<&Path>) -> Result<Self, Failure> {
        let old = table::open(path)?;
        let mut columns = [0; READ.len()];
        for (index, heading) in READ.iter().enumerate() {
            let column = old.column(heading).map_err(|message| table::failure(path, &message))?;
            columns[index] = column.ok_or_else(|| {
                let help = "give the file that an earlier `momentous grade -o` wrote";
                Failure::unusable(format!("{} has no column `{heading}`\nhelp: {help}", path.display()))
            })?;
        }
        let table = table.map(|path| Output::to(Some(path))).transpose()?;
        let mut table = table.map(csv::Writer::from_writer);
        if let Some(table) = &mut table {
            table.write_record(WRITTEN).map_err(|error| unwritten(&error))?;
        }
        let (name, output) = (path.display().to_string(), Output::to(None)?);
        Ok(Self { name, old, next: None, columns, output, table, moved: 0, compared: 0 })
    }

    /// Compares what was found about one part with the earlier marks.
    pub(super) fn part(&mut self, submission: &Submission, part: &PartReport, earned: &Earned) -> Result<(), Failure> {
        let key = [
            submission.place.to_string(),
            submission.key(Key::Student).to_owned(),
            submission.key(Key::Problem).to_owned(),
            submission.key(Key::Seed).to_owned(),
            submission.key(Key::Form).to_owned(),
            submission.key(Key::Attempt).to_owned(),
            part.id.clone(),
        ]
        .map(|cell| cell.trim().to_owned());
        let now = [earned.points.to_string(), earned.out_of.to_string(), part.verdict.code().to_owned()];
        loop {
            let Some((place, row)) = self.peek()? else { return self.changed(&key, &Mark::default(), &now) };
            let (key_before, before) = self.read(&row);
            if key_before == key {
                self.next = None;
                self.compared += 1;
                return if before == now { Ok(()) } else { self.changed(&key, &before, &now) };
            }
            match &submission.place {
                // Rows that are refused now were marked then, or the other way round.
                Place::Line(line) if key_before[0].parse().is_ok_and(|number: u64| number < *line) => {
                    self.next = None;
                    self.changed(&key_before, &before, &Mark::default())?;
                }
                Place::Line(line) if key_before[0].parse().is_ok_and(|number: u64| number > *line) => {
                    return self.changed(&key, &Mark::default(), &now);
                }
                _ => {
                    return Err(Failure::unusable(format!(
                        "{} does not belong to these submissions: at line {place}, part `{}` of line {} is missing\n\
                         help: mark the same file as in that run",
                        self.name, part.id, submission.place
                    )));
                }
            }
        }
    }

    /// The next row of the earlier marks, which stays the next one.
    fn peek(&mut self) -> Result<Option<(u64, Row)>, Failure> {
        if self.next.is_none() {
            self.next = match self.old.next_row() {
                None => None,
                Some((place, Ok(row))) => Some((place, row.clone())),
                Some((place, Err(message))) => {
                    return Err(Failure::unusable(format!("{}:{place}: {message}", self.name)));
                }
            };
        }
        Ok(self.next.clone())
    }

    /// Reads the subject of a row of the earlier marks, and the mark.
    fn read(&self, row: &Row) -> ([String; KEYS], Mark) {
        let cell = |place: usize| row.cell(self.columns[place]).to_owned();
        (std::array::from_fn(cell), std::array::from_fn(|place| cell(KEYS + place)))
    }

    fn changed(&mut self, key: &[String; KEYS], before: &Mark, now: &Mark) -> Result<(), Failure> {
        self.moved += 1;
        let [line, student, problem, .., part] = key;
        let who = if student.is_empty() { String::new() } else { format!("{student}, ") };
        let said = |[marks, out_of, verdict]: &Mark| {
            if verdict.is_empty() { "not marked".to_owned() } else { format!("{marks}/{out_of} [{verdict}]") }
        };
        writeln!(self.output, "line {line}: {who}{problem} `{part}`: {} -> {}", said(before), said(now))?;
        if let Some(table) = &mut self.table {
            let cells = key.iter().chain(before).chain(now).map(|cell| defused(cell).into_owned());
            table.write_record(cells).map_err(|error| unwritten(&error))?;
        }
        Ok(())
    }

    /// Says how many marks moved, and gives whether any did.
    pub(super) fn finish(mut self) -> Result<bool, Failure> {
        while let Some((_, row)) = self.peek()? {
            self.next = None;
            let (key_before, before) = self.read(&row);
            self.changed(&key_before, &before, &Mark::default())?;
        }
        let marks = if self.compared == 1 { "mark" } else { "marks" };
        writeln!(self.output, "{} of {} {marks} changed", self.moved, self.compared)?;
        self.output.finish()?;
        if let Some(table) = self.table {
            table.into_inner().map_err(|error| Failure::from(error.into_error()))?.finish()?;
        }
        Ok(self.moved > 0)
    }
}

fn unwritten(error: &csv::Error) -> Failure {
    Failure::unusable(format!("the table of changes cannot be written: {error}"))
}
