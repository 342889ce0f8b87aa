//! Which marks moved when the same submissions are marked again.

use std::io::BufReader;
use std::io::Write;
use std::path::Path;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::table;
use crate::exercise::Key;
use crate::exercise::Row;
use crate::exercise::Submission;
use crate::exercise::Table;
use crate::fault::Input;
use crate::grade::PartReport;

/// The columns that are read.
const READ: [&str; 10] =
    ["line", "student", "problem", "seed", "form", "attempt", "part", "marks", "out_of", "verdict"];

/// The marks of an earlier run, read beside those of this one: both are in the order of the submissions.
pub(super) struct Changes {
    name: String,
    old: Table<BufReader<Input>>,
    columns: [usize; READ.len()],
    output: Output,
    moved: u64,
    compared: u64,
}

impl Changes {
    /// Opens the marks of an earlier run, a table that `momentous grade` wrote.
    pub(super) fn since(path: &Path) -> Result<Self, Failure> {
        let old = table::open(path)?;
        let mut columns = [0; READ.len()];
        for (index, heading) in READ.iter().enumerate() {
            let column = old.column(heading).map_err(|message| table::of(path, &message))?;
            columns[index] = column.ok_or_else(|| {
                let help = "give the file that an earlier `momentous grade -o` wrote";
                Failure::unusable(format!("{} has no column `{heading}`\nhelp: {help}", path.display()))
            })?;
        }
        Ok(Self { name: path.display().to_string(), old, columns, output: Output::to(None)?, moved: 0, compared: 0 })
    }

    /// Compares what was found about one part with the earlier marks.
    pub(super) fn part(&mut self, submission: &Submission, part: &PartReport) -> Result<(), Failure> {
        let [line, student, problem, seed, form, attempt, name, marks, out_of, verdict] = self.columns;
        let key = [
            submission.place.to_string(),
            submission.key(Key::Student).to_owned(),
            submission.key(Key::Problem).to_owned(),
            submission.key(Key::Seed).to_owned(),
            submission.key(Key::Form).to_owned(),
            submission.key(Key::Attempt).to_owned(),
            part.id.clone(),
        ];
        let same = |row: &Row| {
            let cells = [line, student, problem, seed, form, attempt, name].map(|column| row.cell(column));
            cells.into_iter().zip(&key).all(|(cell, own)| cell == own.trim())
        };
        let row = match self.old.next_row() {
            Some((_, Ok(row))) if same(row) => row,
            Some((place, Err(message))) => return Err(Failure::unusable(format!("{}:{place}: {message}", self.name))),
            other => {
                let place = other.map_or_else(|| "its end".to_owned(), |(place, _)| format!("line {place}"));
                return Err(Failure::unusable(format!(
                    "{} does not belong to these submissions: at {place}, part `{}` of line {} is missing\n\
                     help: mark the same file as in that run",
                    self.name, part.id, submission.place
                )));
            }
        };
        self.compared += 1;
        let old = |column: usize| row.cell(column);
        let new = [part.points.to_string(), part.out_of.to_string(), part.verdict.code().to_owned()];
        if [old(marks), old(out_of), old(verdict)].into_iter().eq(new.iter().map(String::as_str)) {
            return Ok(());
        }
        self.moved += 1;
        let who = if key[1].is_empty() { String::new() } else { format!("{}, ", key[1]) };
        writeln!(
            self.output,
            "line {}: {who}{} `{}`: {}/{} [{}] -> {}/{} [{}]",
            key[0],
            key[2],
            part.id,
            old(marks),
            old(out_of),
            old(verdict),
            new[0],
            new[1],
            new[2]
        )?;
        Ok(())
    }

    /// Says how many marks moved.
    pub(super) fn finish(mut self) -> Result<(), Failure> {
        let marks = if self.compared == 1 { "mark" } else { "marks" };
        writeln!(self.output, "{} of {} {marks} changed", self.moved, self.compared)?;
        self.output.finish()
    }
}
