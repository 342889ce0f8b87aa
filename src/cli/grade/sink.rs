//! Where the marks go: a table, or JSON lines.

use std::io::Write;
use std::path::Path;

use clap::ValueEnum;
use serde::Serialize;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::grade::PartReport;

use super::source::is_json;
use super::submission::Submission;

/// The headings of the table.
pub(super) const HEAD: [&str; 12] = [
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

/// The format of the marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum MarksFormat {
    /// A table.
    Csv,
    /// One JSON object a line.
    Json,
}

/// Where the marks go.
pub(super) enum Sink {
    Table(Box<csv::Writer<Output>>),
    Lines(Output),
}

/// A line of the marks as JSON: the columns of the table under the same names.
#[derive(Serialize)]
struct MarksRow<'a> {
    line: String,
    student: &'a str,
    problem: &'a str,
    seed: &'a str,
    form: &'a str,
    attempt: &'a str,
    part: &'a str,
    marks: &'a crate::grade::Points,
    out_of: u32,
    verdict: &'static str,
    message: &'a str,
    understood: Option<&'a str>,
}

impl Sink {
    /// To a file or standard output; JSON where that is said, or where the file's name says so.
    pub(super) fn to(path: Option<&Path>, format: Option<MarksFormat>) -> Result<Self, Failure> {
        let output = Output::to(path)?;
        let format = format.unwrap_or_else(|| match path {
            Some(path) if is_json(path) => MarksFormat::Json,
            _ => MarksFormat::Csv,
        });
        Ok(match format {
            MarksFormat::Json => Self::Lines(output),
            MarksFormat::Csv => {
                let mut table = csv::Writer::from_writer(output);
                table.write_record(HEAD).map_err(unwritten)?;
                Self::Table(Box::new(table))
            }
        })
    }

    /// Writes what was found about one part.
    pub(super) fn part(&mut self, submission: &Submission, part: &PartReport) -> Result<(), Failure> {
        let place = submission.place.to_string();
        match self {
            Self::Table(table) => {
                let copied = ["student", "problem", "seed", "form", "attempt"].map(|key| submission.key(key));
                let marks = [part.points.to_string(), part.out_of.to_string()];
                let understood = part.understood.as_deref().unwrap_or_default();
                let found = [&part.id, marks[0].as_str(), &marks[1], part.verdict.code(), &part.message, understood];
                table.write_record(std::iter::once(place.as_str()).chain(copied).chain(found)).map_err(unwritten)
            }
            Self::Lines(output) => {
                let line = MarksRow {
                    line: place,
                    student: submission.key("student"),
                    problem: submission.key("problem"),
                    seed: submission.key("seed"),
                    form: submission.key("form"),
                    attempt: submission.key("attempt"),
                    part: &part.id,
                    marks: &part.points,
                    out_of: part.out_of,
                    verdict: part.verdict.code(),
                    message: &part.message,
                    understood: part.understood.as_deref(),
                };
                serde_json::to_writer(&mut *output, &line)?;
                Ok(output.write_all(b"\n")?)
            }
        }
    }

    /// Lets the result appear.
    pub(super) fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Lines(output) => output.finish(),
            Self::Table(table) => {
                let output = table.into_inner();
                output.map_err(|error| Failure::from(std::io::Error::other(error.error().to_string())))?.finish()
            }
        }
    }
}

fn unwritten(error: csv::Error) -> Failure {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => Failure::from(error),
        kind => Failure::unusable(format!("the marks cannot be written: {kind:?}")),
    }
}
