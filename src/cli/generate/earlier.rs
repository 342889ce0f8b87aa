//! Remains of an earlier run at the same place: nothing of it is lost, and what no run will write again is named.

use std::collections::BTreeSet;
use std::path::Path;
use std::path::PathBuf;

use serde::Deserialize;

use crate::cli::failure::Failure;
use crate::cli::failure::tell;
use crate::cli::table;
use crate::exercise::SeedSource;
use crate::exercise::SheetSeed;
use crate::exercise::SpoiltSeed;
use crate::problem::Scheme;

use super::asked::Asked;

/// The endings of sheets and solutions.
const ENDINGS: [&str; 8] =
    [".md", ".tex", ".html", ".json", "-solution.md", "-solution.tex", "-solution.html", "-1.svg"];

/// A row of a table of seeds.
#[derive(Debug, Deserialize)]
struct Row {
    student: String,
    problem: String,
    form: String,
    seed: String,
    /// How its numbers were drawn; the first version did not write it.
    scheme: Option<u32>,
    /// The beginning of the names of its files; earlier versions did not write it.
    #[serde(default)]
    file: String,
}

impl Row {
    /// Whether its seed is this one, whole or as a spreadsheet has left it.
    fn has(&self, seed: u64) -> bool {
        let whole = self.seed.parse::<SheetSeed>().is_ok_and(|sheet_seed| sheet_seed.number == seed);
        whole || SpoiltSeed::read(&self.seed).is_some_and(|spoilt| spoilt.is_of(seed))
    }
}

/// The table of seeds of an earlier run.
#[derive(Debug, Default)]
pub(super) struct Earlier(Vec<Row>);

impl Earlier {
    /// Reads the table that lies there, if there is one, and refuses to write over rows of what is not asked this time, or of sheets
    /// that were drawn from other seeds.
    pub(super) fn at(path: &Path, asked: &[Asked], seeds: SeedSource<'_>, scheme: Scheme) -> Result<Self, Failure> {
        if !path.exists() {
            return Ok(Self::default());
        }
        let rows: Vec<Row> = table::typed(path).map_err(|error| {
            Failure::unusable(format!("{} exists, but is not a table of seeds: {error}", path.display()))
        })?;
        // A homework may ask the same twice.
        let asked_by = |row: &Row, question: &Asked| {
            [question.problem.id(), question.problem.drawn_as()].contains(&row.problem.as_str())
                && question.form_name() == row.form
        };
        let is_asked = |row: &Row| asked.iter().any(|question| asked_by(row, question));
        let lost: BTreeSet<[&str; 2]> =
            rows.iter().filter(|row| !is_asked(row)).map(|row| [row.problem.as_str(), &row.form]).collect();
        if lost.is_empty() {
            let is_same = |row: &Row| {
                // The table has an apostrophe where a spreadsheet would run the cell.
                let student = row.student.strip_prefix('\'').unwrap_or(&row.student);
                row.scheme.unwrap_or(Scheme::Solvable.number()) == scheme.number()
                    && asked
                        .iter()
                        .filter(|question| asked_by(row, question))
                        .any(|question| [student, &row.student].iter().any(|id| row.has(question.seed_of(id, seeds))))
            };
            if rows.iter().all(is_same) {
                return Ok(Self(rows));
            }
            return Err(Failure::unusable(format!(
                "{} has the seeds of sheets that were made with another secret, derivation or scheme, which would be lost\n\
                 help: write into another folder, or give what those sheets were made with",
                path.display()
            )));
        }
        let lost: Vec<String> = lost.iter().map(|names| names.join(" ").trim_end().to_owned()).collect();
        Err(Failure::unusable(format!(
            "{} also says who has which seed of {}, which would be lost\n\
             help: write into another folder, or make all of them in one run",
            path.display(),
            lost.join(", ")
        )))
    }

    /// Names the files in these folders of sheets that nobody has any more: those of rows whose names are not these.
    pub(super) fn tell_what_is_left(&self, folders: &[PathBuf], now: &BTreeSet<String>) {
        let gone = self.0.iter().filter(|row| !row.file.is_empty() && !now.contains(&row.file));
        let names = gone.flat_map(|row| ENDINGS.map(|ending| format!("{}{ending}", row.file)));
        let files = names.flat_map(|name| folders.iter().map(move |folder| folder.join(&name)));
        let files: Vec<String> =
            files.filter(|path| path.is_file()).map(|path| format!("\n  {}", path.display())).collect();
        if !files.is_empty() {
            tell(&format!("note: an earlier run left sheets of students who are not on the roster:{}", files.concat()));
        }
    }
}
