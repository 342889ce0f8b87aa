//! The students of a course, as a table lists them.

use std::collections::BTreeMap;
use std::io::BufRead;

use super::submission::excerpt;
use super::table::Table;

/// The headings under which systems of teaching keep what they know students by, the surest first: `id` of a table made for this
/// program, then the numbers, logins and addresses of other systems. A name is the last.
const IDENTITIES: [&str; 22] = [
    "id",
    "student id",
    "student_id",
    "id number",
    "sid",
    "sis user id",
    "sis_id",
    "orgdefinedid",
    "matrikelnummer",
    "uin",
    "uid",
    "username",
    "user_id",
    "login",
    "login id",
    "sis login id",
    "email",
    "email address",
    "e-mail",
    "student",
    "name",
    "full name",
];
/// Those of them that are names.
const NAMES: [&str; 5] = ["name", "full name", "student name", "student", "name of the student"];
/// Names in two columns: the first and the last one.
const TWO_NAMES: [[&str; 2]; 5] = [
    ["first name", "last name"],
    ["first name", "surname"],
    ["first_name", "last_name"],
    ["given name", "family name"],
    ["vorname", "nachname"],
];
/// The beginning of a line that a program writes before the first heading.
const BEFORE_HEADINGS: &str = "# Field order:";
/// The heading whose identities have a sign before them that is none of theirs.
const WITH_SIGN: (&str, char) = ("orgdefinedid", '#');
/// How a row of Canvas begins that is of no student.
const NO_STUDENT: &str = "Points Possible";

/// By what students are known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KnownBy {
    /// The heading.
    pub heading: String,
    /// Whether it is a name, which two may have.
    pub is_name: bool,
    /// Whether other columns of the table identify students, too.
    pub is_one_of_several: bool,
}

/// A student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Student {
    /// The identity by which the course knows the student.
    pub id: String,
    /// The name of the student; the identity where the table has no names.
    pub name: String,
}

impl Student {
    /// The students of a roster, in its order: a table with a column `id`, or `name`, or both, or with the columns of another system.
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
    pub fn all(table: Table<impl BufRead>) -> Result<Vec<Self>, Vec<String>> {
        Self::listed(table).map(|(students, _)| students)
    }

    /// The same, with by what they are known.
    ///
    /// # Errors
    /// As [`Student::all`].
    pub fn listed(mut table: Table<impl BufRead>) -> Result<(Vec<Self>, KnownBy), Vec<String>> {
        // Two columns of one heading are told, whether they are needed or not.
        for heading in ["id", "name"] {
            table.column(heading).map_err(|message| vec![format!(": {message}")])?;
        }
        let headings: Vec<String> = table.headings().iter().map(|heading| bare(heading)).collect();
        let column = |heading: &str| headings.iter().position(|listed| listed == heading);
        let Some(identity) = IDENTITIES.iter().find_map(|heading| column(heading)) else {
            return Err(vec![" has neither a column `id` nor a column `name`".to_owned()]);
        };
        let names: Vec<usize> =
            match NAMES.iter().find_map(|heading| column(heading).filter(|column| *column != identity)) {
                Some(one) => vec![one],
                None => TWO_NAMES
                    .iter()
                    .find_map(|[first, last]| Some(vec![column(first)?, column(last)?]))
                    .unwrap_or_default(),
            };
        let identifies =
            |heading: &&String| IDENTITIES.contains(&heading.as_str()) && !NAMES.contains(&heading.as_str());
        let known_by = KnownBy {
            is_one_of_several: headings.iter().filter(identifies).count() > 1,
            heading: table.headings().get(identity).cloned().unwrap_or_default(),
            is_name: headings.get(identity).is_some_and(|heading| ["name", "full name"].contains(&heading.as_str())),
        };
        let sign = WITH_SIGN.1;
        let has_sign = headings.get(identity).is_some_and(|heading| heading == WITH_SIGN.0);
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
            let name: Vec<&str> =
                names.iter().map(|column| row.cell(*column)).filter(|name| !name.is_empty()).collect();
            let name = name.join(" ");
            let id = row.cell(identity);
            let id = if has_sign { id.trim_start_matches(sign) } else { id }.to_owned();
            if id.is_empty() && name.trim_start().starts_with(NO_STUDENT) {
                continue;
            }
            if id.is_empty() {
                fail(match known_by.heading.as_str() {
                    "id" => "this student has no identity".to_owned(),
                    other => format!("this student has no identity: nothing stands under `{}`", excerpt(other)),
                });
            } else if let Some(first) = lines.insert(id.clone(), line) {
                fail(format!("`{}` is already in line {first}", excerpt(&id)));
            } else {
                let name = if name.is_empty() { id.clone() } else { name };
                students.push(Self { id, name });
            }
        }
        if students.is_empty() && faults.is_empty() {
            faults.push(" has no students".to_owned());
        }
        if faults.is_empty() { Ok((students, known_by)) } else { Err(faults) }
    }

    /// Name and identity, as a sheet shows them.
    #[must_use]
    pub fn shown(&self) -> String {
        if self.name == self.id { self.id.clone() } else { format!("{} ({})", self.name, self.id) }
    }
}

/// A heading in small letters, without what a program writes before the first.
fn bare(heading: &str) -> String {
    heading.strip_prefix(BEFORE_HEADINGS).unwrap_or(heading).trim().to_lowercase()
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

    /// A heading of each table below that identifies students in two ways.
    const SEVERAL: [&str; 5] = ["SIS User ID", "Email", "UIN", "user_id", "Username"];

    #[test]
    fn tables_of_other_systems_are_known_by_their_headings() {
        for (text, by, id, name) in [
            (
                "Student,ID,SIS User ID,Section\n    Points Possible,,,\n\"Adams, Ada\",494030,S1,A\n",
                "ID",
                "494030",
                "Adams, Ada",
            ),
            (
                "First name,Last name,ID number,Email address\nAda,Adams,0071234,a@x\n",
                "ID number",
                "0071234",
                "Ada Adams",
            ),
            ("First Name,Last Name,SID,Email,Role\nAda,Adams,0071234,a@x,Student\n", "SID", "0071234", "Ada Adams"),
            ("UID,UIN,Username,Name,Role\na@x,650001,ada,Ada Adams,Student\n", "UIN", "650001", "Ada Adams"),
            (
                "# Field order: student_id,last_name,first_name,user_id\n1001,Adams,Ada,aadams\n",
                "# Field order: student_id",
                "1001",
                "Ada Adams",
            ),
            (
                "\"Last Name\",\"First Name\",\"Username\",\"Student ID\"\n\"Adams\",\"Ada\",\"aadams\",\"7\"\n",
                "Student ID",
                "7",
                "Ada Adams",
            ),
            (
                "OrgDefinedId,Username,Last Name,First Name\n#0071234,#aadams,Adams,Ada\n",
                "OrgDefinedId",
                "0071234",
                "Ada Adams",
            ),
            ("ID,Name,Credits\n0071234,\"Adams, Ada\",3\n", "ID", "0071234", "Adams, Ada"),
            ("email,name\na@x,Ada\n", "email", "a@x", "Ada"),
            ("student\tname\n\u{200b}s1\tAda\n", "student", "s1", "Ada"),
            ("sep=;\nMatrikelnummer;Nachname;Vorname\n1;Adams;Ada\n", "Matrikelnummer", "1", "Ada Adams"),
        ] {
            let (students, known_by) = Student::listed(Table::read(text.as_bytes()).unwrap()).unwrap();
            assert_eq!((known_by.heading.as_str(), known_by.is_name), (by, false), "{text}");
            assert_eq!(known_by.is_one_of_several, SEVERAL.iter().any(|heading| text.contains(heading)), "{text}");
            assert_eq!((students.len(), students[0].id.as_str(), students[0].name.as_str()), (1, id, name), "{text}");
        }
        let (_, known_by) = Student::listed(Table::read("name\nAda\n".as_bytes()).unwrap()).unwrap();
        assert!(known_by.is_name);
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
        assert_eq!(students("post\na@b\n").unwrap_err(), [" has neither a column `id` nor a column `name`"]);
        assert_eq!(students("id\n").unwrap_err(), [" has no students"]);
    }
}
