//! The students of a course, and the table of who has which seed.

use std::path::Path;

use crate::cli::failure::Failure;
use crate::cli::table;
use crate::exercise::Drawer;
use crate::exercise::SeedSource;
use crate::exercise::Student;
use crate::exercise::VariantRef;
use crate::exercise::defused;
use crate::problem::Scheme;

use super::asked::Asked;
use super::names;

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
        let of = |fault: String| Failure::unusable(format!("{}{fault}", path.display()));
        Failure::all(faults.into_iter().map(of).collect())
    };
    Student::all(table::whole(path)?).map_err(failed)
}

impl Roster {
    /// Reads the table, and finds names for files.
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let students = students(path)?;
        let ids: Vec<String> = students.iter().map(|student| student.id.clone()).collect();
        let sitters = students.into_iter().zip(names::distinct(&ids)).map(|(student, stem)| Sitter { student, stem });
        Ok(Self(sitters.collect()))
    }

    /// The table of who has which seed.
    pub(super) fn seeds(&self, asked: &[Asked], seeds: SeedSource<'_>, scheme: Scheme) -> Result<String, Failure> {
        let mut table = csv::Writer::from_writer(Vec::new());
        let failed = |error: csv::Error| Failure::unusable(format!("the table of seeds cannot be written: {error}"));
        let headings =
            ["student", "name", "problem", "digest", "form", "seed", "scheme", "given", "derivation", "secret", "file"];
        table.write_record(headings).map_err(failed)?;
        let number = scheme.to_string();
        let mut drawers: Vec<Option<Drawer<'_>>> =
            asked.iter().map(|own| Drawer::new(&own.problem, own.form).ok()).collect();
        for sitter in &self.0 {
            for (own, drawer) in asked.iter().zip(&mut drawers) {
                let variant = sitter.variant(own, seeds);
                let (seed, derivation) = (variant.seed.to_string(), seeds.derivation.to_string());
                // A seed without numbers has no sheet, which is told where sheets are made.
                let drawn = drawer.as_mut().and_then(|drawer| drawer.draw_by(variant.seed, scheme).ok());
                let given = drawn.map(|exercise| exercise.sheet_numbers().to_string()).unwrap_or_default();
                let digest = &own.problem.loaded().digests.draw;
                let (mark, file) = (own.problem.secret_mark().unwrap_or_default(), sitter.file_stem(own));
                let (id, name) = (&sitter.student.id, &sitter.student.name);
                let row =
                    [id, name, variant.problem, digest, variant.form, &seed, &number, &given, &derivation, mark, &file];
                table.write_record(row.map(|cell| defused(cell).into_owned())).map_err(failed)?;
            }
        }
        let bytes = table.into_inner().map_err(|error| Failure::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl Sitter {
    /// The variant that the student gets; it stays the same when others come or go.
    pub(super) fn variant<'a>(&self, asked: &'a Asked, seeds: SeedSource<'_>) -> VariantRef<'a> {
        let drawn = seeds.variant(&self.student.id, asked.problem.drawn_as(), asked.form_name());
        VariantRef { problem: asked.problem.id(), ..drawn }
    }

    /// The name of the student's files without an ending.
    pub(super) fn file_stem(&self, asked: &Asked) -> String {
        format!("{}-{}", self.stem, asked.stem)
    }
}
