//! The students of a course, and the table of who has which seed.

use std::path::Path;

use crate::cli::failure::Failure;
use crate::cli::failure::tell;
use crate::cli::table;
use crate::exercise::Drawer;
use crate::exercise::SeedSource;
use crate::exercise::Student;
use crate::exercise::defused;
use crate::problem::Scheme;
use crate::render::SeedWord;

use super::asked::Asked;
use super::names;

/// The column with the number that a problem has on the sheet of a homework.
pub(in crate::cli) const NUMBER: &str = "number";

/// A student, with the beginning of the names of his or her files.
#[derive(Clone, Debug)]
pub(super) struct Sitter {
    pub student: Student,
    pub stem: String,
}

/// The students, in the order of the table.
#[derive(Clone, Debug)]
pub(super) struct Roster(pub Vec<Sitter>);

/// Reads the table.
pub(in crate::cli) fn students(path: &Path) -> Result<Vec<Student>, Failure> {
    let failed = |faults: Vec<String>| {
        let failure = |fault: String| Failure::unusable(format!("{}{fault}", path.display()));
        Failure::all(faults.into_iter().map(failure).collect())
    };
    let (students, known_by) = Student::listed(table::whole(path)?).map_err(failed)?;
    if known_by.is_name {
        tell("note: students are known by their names; a column `id` tells two of one name apart");
    } else if known_by.is_one_of_several || !known_by.heading.eq_ignore_ascii_case("id") {
        tell(&format!("note: students are known by `{}`", known_by.heading));
    }
    Ok(students)
}

impl Roster {
    /// Reads the table, and finds names for files.
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let students = students(path)?;
        let ids: Vec<String> = students.iter().map(|student| student.id.clone()).collect();
        let sitters = students.into_iter().zip(names::distinct(&ids)).map(|(student, stem)| Sitter { student, stem });
        Ok(Self(sitters.collect()))
    }

    /// The table of who has which seed; of a homework with the number of the problem on the sheet.
    pub(super) fn seeds(&self, asked: &[Asked], seeds: SeedSource<'_>, scheme: Scheme) -> Result<String, Failure> {
        let mut table = csv::Writer::from_writer(Vec::new());
        let failed = |error: csv::Error| Failure::unusable(format!("the table of seeds cannot be written: {error}"));
        let headings =
            ["student", "name", "problem", "digest", "form", "seed", "scheme", "given", "derivation", "secret", "file"];
        let numbered = asked.iter().any(|question| question.slot.is_some());
        table.write_record(headings.into_iter().chain(numbered.then_some(NUMBER))).map_err(failed)?;
        let number = scheme.to_string();
        let mut drawers: Vec<Option<Drawer<'_>>> =
            asked.iter().map(|question| Drawer::new(&question.problem, question.form).ok()).collect();
        for sitter in &self.0 {
            for (question, drawer) in asked.iter().zip(&mut drawers) {
                let seed = question.seed_of(&sitter.student.id, seeds);
                let derivation = seeds.derivation.to_string();
                // A seed without numbers has no sheet, which is told where sheets are made.
                let drawn = drawer.as_mut().and_then(|drawer| drawer.draw_by(seed, scheme).ok());
                let given = drawn.map(|exercise| exercise.sheet_numbers().to_string()).unwrap_or_default();
                let (digest, seed) = (&question.problem.loaded().digests.draw, SeedWord(seed).to_string());
                let (mark, file) =
                    (question.problem.secret_mark().unwrap_or_default(), sitter.file_stem(&question.stem));
                let (id, name, problem) = (&sitter.student.id, &sitter.student.name, question.problem.id());
                let row =
                    [id, name, problem, digest, question.form_name(), &seed, &number, &given, &derivation, mark, &file];
                let place = question.slot.as_ref().map(|(place, _)| place.to_string());
                let cells = row.into_iter().chain(place.as_deref());
                table.write_record(cells.map(|cell| defused(cell).into_owned())).map_err(failed)?;
            }
        }
        let bytes = table.into_inner().map_err(|error| Failure::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// The table into which answers to a homework are written: a row for each student, and a column for each part.
    pub(super) fn answers(&self, asked: &[Asked]) -> Result<String, Failure> {
        let mut table = csv::Writer::from_writer(Vec::new());
        let failed = |error: csv::Error| Failure::unusable(format!("the table of answers cannot be written: {error}"));
        let parts = |question: &Asked| {
            let number = question.slot.as_ref().map_or(0, |(number, _)| *number);
            let form = question.problem.forms().get(question.form);
            let parts = form.into_iter().flat_map(|form| &form.parts);
            parts.map(|part| format!("{number}.{}", part.id)).collect::<Vec<_>>()
        };
        let headings: Vec<String> = asked.iter().flat_map(parts).collect();
        table
            .write_record(["student", "name"].into_iter().chain(headings.iter().map(String::as_str)))
            .map_err(failed)?;
        for Sitter { student, .. } in &self.0 {
            let cells = [student.id.as_str(), &student.name].into_iter().chain(headings.iter().map(|_| ""));
            table.write_record(cells.map(|cell| defused(cell).into_owned())).map_err(failed)?;
        }
        let bytes = table.into_inner().map_err(|error| Failure::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl Sitter {
    /// The name of the student's files without an ending.
    pub(super) fn file_stem(&self, stem: &str) -> String {
        format!("{}-{stem}", self.stem)
    }
}
