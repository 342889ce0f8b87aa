//! Sinks for the marks: a table, or JSON lines. Rows are written by every core into memory of its own, and joined in order.

use std::io::Write;
use std::path::Path;

use clap::ValueEnum;
use serde::Serialize;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::exercise::Key;
use crate::exercise::Submission;
use crate::exercise::defused;
use crate::grade::PartReport;
use crate::grade::Points;

use super::source::is_json;
use super::worth::Earned;

/// The headings of the table.
pub(super) const HEAD: [&str; 15] = [
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
    "counts",
    "mistakes",
    "follows_from",
];

/// The format of the marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum MarksFormat {
    /// A table.
    Csv,
    /// One JSON object a line.
    Json,
}

/// The sink of the marks.
pub(super) struct Sink {
    output: Output,
    format: MarksFormat,
}

/// Rows on their way.
pub(super) enum Rows {
    /// With the cells of the row that is written: a whole row is written faster than cell by cell.
    Table(Box<(csv::Writer<Vec<u8>>, csv::ByteRecord)>),
    Lines(Vec<u8>),
}

/// A row of the marks: the columns of the table, under the same names.
#[derive(Serialize)]
struct Row<'a> {
    line: &'a str,
    student: &'a str,
    problem: &'a str,
    seed: &'a str,
    form: &'a str,
    attempt: &'a str,
    part: &'a str,
    marks: &'a Points,
    out_of: &'a Points,
    verdict: &'static str,
    message: &'a str,
    understood: Option<&'a str>,
    counts: &'static str,
    mistakes: String,
    follows_from: String,
}

impl Sink {
    /// To a file or standard output; JSON where that is said, or where the file's name says so.
    pub(super) fn to(path: Option<&Path>, format: Option<MarksFormat>) -> Result<Self, Failure> {
        let mut output = Output::to(path)?;
        let format = format.unwrap_or_else(|| match path {
            Some(path) if is_json(path) => MarksFormat::Json,
            _ => MarksFormat::Csv,
        });
        if format == MarksFormat::Csv {
            writeln!(output, "{}", HEAD.join(","))?;
        }
        Ok(Self { output, format })
    }

    pub(super) fn format(&self) -> MarksFormat {
        self.format
    }

    /// Writes rows.
    pub(super) fn write(&mut self, rows: &[u8]) -> Result<(), Failure> {
        Ok(self.output.write_all(rows)?)
    }

    /// Lets the result appear.
    pub(super) fn finish(self) -> Result<(), Failure> {
        self.output.finish()
    }
}

impl Rows {
    /// No rows yet.
    pub(super) fn new(format: MarksFormat) -> Self {
        match format {
            MarksFormat::Json => Self::Lines(Vec::new()),
            MarksFormat::Csv => Self::Table(Box::new((csv::Writer::from_writer(Vec::new()), csv::ByteRecord::new()))),
        }
    }

    /// Adds what was found about one part.
    pub(super) fn part(&mut self, submission: &Submission, part: &PartReport, earned: &Earned) -> Result<(), Failure> {
        let place = submission.place.to_string();
        let row = Row {
            line: &place,
            student: submission.key(Key::Student),
            problem: submission.key(Key::Problem),
            seed: submission.key(Key::Seed),
            form: submission.key(Key::Form),
            attempt: submission.key(Key::Attempt),
            part: &part.id,
            marks: &earned.points,
            out_of: &earned.out_of,
            verdict: part.verdict.code(),
            message: &part.message,
            understood: part.understood.as_deref(),
            counts: if part.counts { "yes" } else { "no" },
            mistakes: part.diagnosis.as_ref().map(|diagnosis| diagnosis.codes.join(" ")).unwrap_or_default(),
            follows_from: part.follows.as_ref().map(|follows| follows.from.join(" ")).unwrap_or_default(),
        };
        match self {
            Self::Table(table) => {
                let (table, cells) = table.as_mut();
                row.put_in(cells);
                table.write_byte_record(cells).map_err(unwritten)
            }
            Self::Lines(lines) => {
                serde_json::to_writer(&mut *lines, &row)?;
                lines.push(b'\n');
                Ok(())
            }
        }
    }

    /// The number of bytes that the rows so far have.
    pub(super) fn length(&mut self) -> Result<usize, Failure> {
        match self {
            Self::Lines(lines) => Ok(lines.len()),
            Self::Table(table) => {
                table.0.flush()?;
                Ok(table.0.get_ref().len())
            }
        }
    }

    /// The bytes of all rows.
    pub(super) fn into_bytes(self) -> Result<Vec<u8>, Failure> {
        match self {
            Self::Lines(lines) => Ok(lines),
            Self::Table(table) => {
                table.0.into_inner().map_err(|error| Failure::from(std::io::Error::other(error.error().to_string())))
            }
        }
    }
}

impl Row<'_> {
    /// The cells, in the order of [`HEAD`].
    fn put_in(&self, record: &mut csv::ByteRecord) {
        let (marks, out_of) = (self.marks.to_string(), self.out_of.to_string());
        let cells: [&str; HEAD.len()] = [
            self.line,
            self.student,
            self.problem,
            self.seed,
            self.form,
            self.attempt,
            self.part,
            &marks,
            &out_of,
            self.verdict,
            self.message,
            self.understood.unwrap_or_default(),
            self.counts,
            &self.mistakes,
            &self.follows_from,
        ];
        record.clear();
        for cell in cells {
            record.push_field(defused(cell).as_bytes());
        }
    }
}

fn unwritten(error: csv::Error) -> Failure {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => Failure::from(error),
        kind => Failure::unusable(format!("the marks cannot be written: {kind:?}")),
    }
}
