//! The points of each student, as Moodle and Canvas import them.

use std::collections::BTreeMap;
use std::path::Path;
use std::path::PathBuf;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::exercise::Key;
use crate::exercise::defused;
use crate::grade::Report;
use crate::quantity::Rational;

use super::register::Entry;

/// The column of the points.
const POINTS: &str = "momentous";

/// The headings of Canvas before the points. It finds students by their number; the other two only have to be there.
const CANVAS: [&str; 3] = ["Student", "ID", "Section"];

/// How students are known to who imports the points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Students {
    /// By a column of that heading.
    Column(String),
    /// As in Canvas.
    Canvas,
}

/// The points so far.
pub(super) struct Gradebook {
    path: PathBuf,
    students: Students,
    points: BTreeMap<String, Rational>,
}

impl Gradebook {
    pub(super) fn to(path: &Path, students: Students) -> Self {
        Self { path: path.to_owned(), students, points: BTreeMap::new() }
    }

    /// Adds what counts of a report.
    pub(super) fn add(&mut self, entry: &Entry, report: &Report) {
        let points = self.points.entry(entry.submission.key(Key::Student).to_owned()).or_default();
        for part in report.parts.iter().filter(|part| part.counts) {
            *points += &entry.facts.earned(part).points.0;
        }
    }

    /// Writes the table.
    pub(super) fn finish(self) -> Result<(), Failure> {
        let mut table = csv::Writer::from_writer(Vec::new());
        let unwritten = |error: csv::Error| Failure::unusable(format!("the gradebook cannot be written: {error}"));
        let headings: Vec<&str> = match &self.students {
            Students::Column(heading) => vec![heading],
            Students::Canvas => CANVAS.to_vec(),
        };
        table.write_record(headings.iter().copied().chain([POINTS])).map_err(unwritten)?;
        for (student, points) in &self.points {
            let points = points.to_f64().value().to_string();
            let who = [student.as_str(), student, ""].into_iter().take(headings.len());
            let cells = who.chain([points.as_str()]).map(|cell| defused(cell).into_owned());
            table.write_record(cells).map_err(unwritten)?;
        }
        let bytes = table.into_inner().map_err(|error| Failure::unusable(error.to_string()))?;
        Output::whole(Some(&self.path), &bytes)
    }
}
