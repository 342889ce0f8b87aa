//! The students of a course, and the table of who has which seed.

use std::collections::BTreeMap;
use std::path::Path;

use crate::cli::failure::Failure;
use crate::cli::table;
use crate::exercise::SeedSource;
use crate::exercise::VariantRef;
use crate::exercise::defused;

use super::job::Asked;
use super::names;

/// A student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::cli) struct Student {
    /// What the course knows the student by.
    pub id: String,
    /// What the student is called; the identity where the table has no names.
    pub name: String,
    /// The beginning of the names of the student's files.
    pub stem: String,
}

/// The students, in the order of the table.
#[derive(Clone, Debug)]
pub(in crate::cli) struct Roster {
    pub students: Vec<Student>,
}

impl Roster {
    /// Reads the table.
    pub(in crate::cli) fn read(path: &Path) -> Result<Self, Failure> {
        let mut table = table::whole(path)?;
        let column = |heading: &str| table.column(heading).map_err(|message| table::of(path, &message));
        let (id, name) = (column("id")?, column("name")?);
        let Some(identity) = id.or(name) else {
            return Err(Failure::unusable(format!("{} has neither a column `id` nor a column `name`", path.display())));
        };
        let mut students: Vec<Student> = Vec::new();
        let mut lines: BTreeMap<String, u64> = BTreeMap::new();
        let mut failures = Vec::new();
        while let Some((line, row)) = table.next_row() {
            let mut fail =
                |message: String| failures.push(Failure::unusable(format!("{}:{line}: {message}", path.display())));
            let row = match row {
                Ok(row) => row,
                Err(message) => {
                    fail(message);
                    continue;
                }
            };
            let cell = |column: usize| row.cell(column).to_owned();
            let id = cell(identity);
            if id.is_empty() {
                fail("this student has no identity".to_owned());
            } else if let Some(first) = lines.insert(id.clone(), line) {
                fail(format!("`{id}` stands in line {first} already"));
            } else {
                let name = name.map(cell).filter(|name| !name.is_empty()).unwrap_or_else(|| id.clone());
                students.push(Student { id, name, stem: String::new() });
            }
        }
        if students.is_empty() && failures.is_empty() {
            failures.push(Failure::unusable(format!("{} has no students", path.display())));
        }
        let ids: Vec<String> = students.iter().map(|student| student.id.clone()).collect();
        for (student, stem) in students.iter_mut().zip(names::distinct(&ids)) {
            student.stem = stem;
        }
        if failures.is_empty() { Ok(Self { students }) } else { Err(Failure::all(failures)) }
    }

    /// The table of who has which seed.
    pub(super) fn seeds(&self, asked: &[Asked], seeds: SeedSource<'_>) -> Result<String, Failure> {
        let mut table = csv::Writer::from_writer(Vec::new());
        let failed = |error: csv::Error| Failure::unusable(format!("the table of seeds cannot be written: {error}"));
        let headings = ["student", "name", "problem", "digest", "form", "seed", "derivation", "secret", "file"];
        table.write_record(headings).map_err(failed)?;
        for student in &self.students {
            for own in asked {
                let variant = student.variant(own, seeds);
                let (seed, derivation) = (variant.seed.to_string(), seeds.derivation.to_string());
                let digest = &own.problem.loaded().digest;
                let (mark, file) = (own.problem.secret_mark().unwrap_or_default(), student.file_stem(own));
                let (id, name) = (&student.id, &student.name);
                let row = [id, name, variant.problem, digest, variant.form, &seed, &derivation, mark, &file];
                table.write_record(row.map(|cell| defused(cell).into_owned())).map_err(failed)?;
            }
        }
        let bytes = table.into_inner().map_err(|error| Failure::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl Student {
    /// The variant that the student gets; it stays the same when others come or go.
    pub(super) fn variant<'a>(&self, asked: &'a Asked, seeds: SeedSource<'_>) -> VariantRef<'a> {
        seeds.variant(&self.id, asked.problem.id(), asked.form_name())
    }

    /// Name and identity, as a sheet shows them.
    pub(super) fn shown(&self) -> String {
        if self.name == self.id { self.id.clone() } else { format!("{} ({})", self.name, self.id) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roster(text: &str) -> Result<Vec<Student>, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("class.csv");
        std::fs::write(&path, text).unwrap();
        let read = Roster::read(&path);
        let place = format!("{}:", path.display());
        read.map(|roster| roster.students).map_err(|failure| failure.to_string().replace(&place, "class.csv:"))
    }

    #[test]
    fn a_table_may_have_other_columns_marks_and_orders() {
        let alone = roster("id\nb\n").unwrap();
        let both = roster("\u{feff}Name;ID\nAda;a\nBob;b\n").unwrap();
        assert_eq!(alone[0].id, both[1].id);
        assert_eq!((both[1].shown(), alone[0].shown()), ("Bob (b)".into(), "b".into()));
    }

    #[test]
    fn files_of_students_never_collide() {
        let stems = |text: &str| roster(text).unwrap().into_iter().map(|student| student.stem).collect::<Vec<_>>();
        assert_eq!(stems("id\na b\na/b\na-b-2\n"), ["a-b-c8687a08", "a-b-c14cddc0", "a-b-2"]);
    }

    #[test]
    fn every_row_that_is_wrong_is_told() {
        let message = roster("id,name\na,Ada\na,Again\n,Nobody\nc\n").unwrap_err();
        let expected = "error: class.csv:3: `a` stands in line 2 already\nerror: class.csv:4: this student has no identity\nerror: class.csv:5: the row has 1 cell, and there are 2 headings";
        assert_eq!(message, expected);
        assert!(roster("mail\na@b\n").unwrap_err().ends_with("has neither a column `id` nor a column `name`"));
        assert!(roster("id\n").unwrap_err().ends_with("has no students"));
    }
}
