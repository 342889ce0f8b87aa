//! The points of each student, as Moodle and Canvas import them.

use std::collections::BTreeMap;
use std::path::Path;
use std::path::PathBuf;

use clap::ValueEnum;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::exercise::Key;
use crate::exercise::Place;
use crate::exercise::defused;
use crate::grade::Report;
use crate::quantity::Rational;

use super::register::Entry;

/// The column by which Brightspace knows students, and what it wants behind the title and at the end of each row.
const BRIGHTSPACE: &str = "OrgDefinedId";
const POINTS_GRADE: &str = " Points Grade";
const END_OF_LINE: [&str; 2] = ["End-of-Line Indicator", "#"];

/// The points are written to five decimal places, as Moodle keeps them.
const PLACES: f64 = 1e5;

/// The name of a student in Canvas' gradebook; it only has to be there, unless students are known by it.
const NAME: &str = "Student";
/// By what a table of Canvas knows students, under which heading its gradebook finds them, and all headings before the points: those
/// that it asks for, and the identity of an institution only beside its login.
const CANVAS: [(&str, &str, &[&str]); 3] = [
    ("id", "ID", &[NAME, "ID", "Section"]),
    ("sis_id", "SIS User ID", &[NAME, "ID", "SIS User ID", "SIS Login ID", "Section"]),
    ("name", NAME, &[NAME, "ID", "Section"]),
];

/// Which of a student's attempts at a quiz counts. Each may have other variants of its questions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Attempts {
    /// The one with the most points
    #[default]
    Best,
    /// The last
    Last,
    /// The first
    First,
    /// The mean of all
    Mean,
}

impl Attempts {
    /// The points that count of those of the attempts, the earliest first.
    fn counted(self, attempts: &[Rational]) -> Rational {
        let points = match self {
            Self::Best => attempts.iter().max().cloned(),
            Self::Last => attempts.last().cloned(),
            Self::First => attempts.first().cloned(),
            Self::Mean => {
                let sum = attempts.iter().fold(Rational::ZERO, |sum, points| sum + points);
                (!attempts.is_empty()).then(|| sum / Rational::from(attempts.len()))
            }
        };
        points.unwrap_or(Rational::ZERO)
    }
}

/// How students are known to who imports the points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Students {
    /// By a column of that heading.
    Column(String),
    /// As in Canvas, which calls the column so in its responses.
    Canvas(String),
}

impl Students {
    /// The headings before the points.
    fn headings(&self) -> Vec<&str> {
        match self {
            Self::Column(heading) => vec![heading],
            Self::Canvas(column) => canvas(column).1.to_vec(),
        }
    }

    /// What stands under them for a student.
    fn cells<'s>(&self, student: &'s str) -> Vec<&'s str> {
        match self {
            Self::Column(_) => vec![student],
            Self::Canvas(column) => {
                let (found_by, headings) = canvas(column);
                let cell = |heading: &&str| if [NAME, found_by].contains(heading) { student } else { "" };
                headings.iter().map(cell).collect()
            }
        }
    }
}

/// The heading under which Canvas finds students that a column of its responses identifies, and all headings before the points.
fn canvas(column: &str) -> (&'static str, &'static [&'static str]) {
    let row = CANVAS.iter().find(|(listed, ..)| listed.eq_ignore_ascii_case(column)).unwrap_or(&CANVAS[0]);
    (row.1, row.2)
}

/// The numbers of attempts that a table says, by its lines.
pub(super) type Numbers = BTreeMap<u64, u64>;

/// The points so far.
pub(super) struct Gradebook {
    path: PathBuf,
    /// The heading of the points.
    title: String,
    students: Students,
    /// Which attempt counts, where each row of the table is one, and the numbers that the table gives them; nothing where rows are
    /// problems, which are added up.
    attempts: Option<(Attempts, Numbers)>,
    /// By student and attempt: its number, and its line.
    points: BTreeMap<String, BTreeMap<(u64, u64), Rational>>,
}

impl Gradebook {
    pub(super) fn to(path: &Path, title: String, students: Students, attempts: Option<(Attempts, Numbers)>) -> Self {
        Self { path: path.to_owned(), title, students, attempts, points: BTreeMap::new() }
    }

    /// Adds what counts of a report.
    pub(super) fn add(&mut self, entry: &Entry, report: &Report) {
        let attempt = match (&self.attempts, &entry.submission.place) {
            (Some((_, numbers)), Place::Line(line)) => (numbers.get(line).copied().unwrap_or(*line), *line),
            _ => (0, 0),
        };
        let student = self.points.entry(entry.submission.key(Key::Student).to_owned()).or_default();
        let points = student.entry(attempt).or_default();
        // Of attempts by rows each is worth what it earned.
        for part in report.parts.iter().filter(|part| part.counts || self.attempts.is_some()) {
            *points += &entry.facts.earned(part).points.0;
        }
    }

    /// Writes the table.
    pub(super) fn finish(self) -> Result<(), Failure> {
        let mut table = csv::Writer::from_writer(Vec::new());
        let unwritten = |error: csv::Error| Failure::unusable(format!("the gradebook cannot be written: {error}"));
        let headings = self.students.headings();
        let is_of_brightspace = headings.iter().any(|heading| heading.eq_ignore_ascii_case(BRIGHTSPACE));
        let [end, mark] = END_OF_LINE.map(|text| is_of_brightspace.then_some(text));
        let title = format!("{}{}", self.title, if is_of_brightspace { POINTS_GRADE } else { "" });
        let title = defused(&title);
        table.write_record(headings.iter().copied().chain([&*title]).chain(end)).map_err(unwritten)?;
        for (student, attempts) in &self.points {
            let attempts: Vec<Rational> = attempts.values().cloned().collect();
            let counts = self.attempts.as_ref().map(|(counts, _)| *counts).unwrap_or_default();
            let points = counts.counted(&attempts);
            let points = ((points.to_f64().value() * PLACES).round() / PLACES).to_string();
            let cells = self
                .students
                .cells(student)
                .into_iter()
                .chain([points.as_str()])
                .chain(mark)
                .map(|cell| defused(cell).into_owned());
            table.write_record(cells).map_err(unwritten)?;
        }
        let bytes = table.into_inner().map_err(|error| Failure::unusable(error.to_string()))?;
        Output::whole(Some(&self.path), &bytes)
    }
}
