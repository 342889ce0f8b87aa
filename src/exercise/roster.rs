//! The students of a course, as a table lists them.

use std::collections::BTreeMap;
use std::io::BufRead;

use super::submission::excerpt;
use super::table::Table;

/// A student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Student {
    /// What the course knows the student by.
    pub id: String,
    /// What the student is called; the identity where the table has no names.
    pub name: String,
}

impl Student {
    /// The students of a roster, in its order: a table with a column `id`, or `name`, or both.
    ///
    /// ```
    /// use momentous_exercise::{Student, Table};
    /// let students = Student::all(Table::read("Name;ID\nAda;a\nBob;b\n".as_bytes())?).unwrap();
    /// assert_eq!(students[1].shown(), "Bob (b)");
    /// let faults = Student::all(Table::read("id\na\na\n".as_bytes())?).unwrap_err();
    /// assert_eq!(faults, [":3: `a` is already in line 2"]);
    /// # Ok::<(), String>(())
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, each as it follows the name of the file.
    pub fn all(mut table: Table<impl BufRead>) -> Result<Vec<Self>, Vec<String>> {
        let column = |heading: &str| table.column(heading).map_err(|message| vec![format!(": {message}")]);
        let (id, name) = (column("id")?, column("name")?);
        let Some(identity) = id.or(name) else {
            return Err(vec![" has neither a column `id` nor a column `name`".to_owned()]);
        };
        let mut students: Vec<Self> = Vec::new();
        let mut lines: BTreeMap<String, u64> = BTreeMap::new();
        let mut faults = Vec::new();
        while let Some((line, row)) = table.next_row() {
            let mut fail = |message: String| faults.push(format!(":{line}: {message}"));
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
                fail(format!("`{}` is already in line {first}", excerpt(&id)));
            } else {
                let name = name.map(cell).filter(|name| !name.is_empty()).unwrap_or_else(|| id.clone());
                students.push(Self { id, name });
            }
        }
        if students.is_empty() && faults.is_empty() {
            faults.push(" has no students".to_owned());
        }
        if faults.is_empty() { Ok(students) } else { Err(faults) }
    }

    /// Name and identity, as a sheet shows them.
    #[must_use]
    pub fn shown(&self) -> String {
        if self.name == self.id { self.id.clone() } else { format!("{} ({})", self.name, self.id) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn students(text: &str) -> Result<Vec<Student>, Vec<String>> {
        Student::all(Table::read(text.as_bytes()).unwrap())
    }

    #[test]
    fn a_table_may_have_other_columns_marks_and_orders() {
        let alone = students("id\nb\n").unwrap();
        let both = students("\u{feff}Name;ID\nAda;a\nBob;b\n").unwrap();
        assert_eq!(alone[0].id, both[1].id);
        assert_eq!((both[1].shown(), alone[0].shown()), ("Bob (b)".into(), "b".into()));
    }

    #[test]
    fn every_row_that_is_wrong_is_told() {
        let faults = students("id,name\na,Ada\na,Again\n,Nobody\nc\n").unwrap_err();
        let expected = [
            ":3: `a` is already in line 2",
            ":4: this student has no identity",
            ":5: the row has 1 cell, and there are 2 headings",
        ];
        assert_eq!(faults, expected);
        assert_eq!(students("mail\na@b\n").unwrap_err(), [" has neither a column `id` nor a column `name`"]);
        assert_eq!(students("id\n").unwrap_err(), [" has no students"]);
    }
}
