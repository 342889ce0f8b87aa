//! The roster of a course: what a table that somebody pastes or uploads would change, and the records that change it.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_exercise::Table;
use momentous_exercise::excerpt;

use super::key::Key;
use super::moment::Moment;
use super::people::{Course, Member, Person, Role};

/// The most students that a roster may have.
const MOST: usize = 10_000;

/// The bytes of the longest name, login or section.
const LONGEST: usize = 200;

/// A student as a roster names one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RosterRow {
    /// The name by which the student signs in.
    pub login: String,
    /// The name of the student.
    pub name: String,
    /// The section; empty where the table has none.
    pub section: String,
}

/// A change that a roster makes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum RosterChange {
    /// Somebody joins the course.
    New {
        /// The row of the student.
        row: RosterRow,
    },
    /// Somebody who had left the course is back.
    Back {
        /// The member.
        member: Key<Member>,
        /// The row of the roster that names the student.
        row: RosterRow,
    },
    /// Somebody is called otherwise.
    Renamed {
        /// The member.
        member: Key<Member>,
        /// The name so far.
        from: String,
        /// The name from now on.
        to: String,
    },
    /// Somebody moves to another section.
    Moved {
        /// The member.
        member: Key<Member>,
        /// The section so far.
        from: String,
        /// The section from now on.
        to: String,
    },
    /// Somebody is no longer on the roster. Sheets and marks stay.
    Gone {
        /// The member.
        member: Key<Member>,
        /// The name of the student.
        name: String,
    },
}

/// The records that a roster changes or adds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RosterRecords {
    /// People who are new, or called otherwise.
    pub people: Vec<Person>,
    /// Members who are new, back, gone or in another section.
    pub members: Vec<Member>,
}

impl RosterRow {
    /// The students of a table with a column `id` or `login`, and perhaps `name` and `section`.
    ///
    /// ```
    /// use momentous_course::RosterRow;
    /// let rows = RosterRow::all("login;name;section\ns1;Ada;A\n").unwrap();
    /// assert_eq!((rows[0].name.as_str(), rows[0].section.as_str()), ("Ada", "A"));
    /// assert_eq!(RosterRow::all("id\na\na\n").unwrap_err(), ["line 3: `a` is already in line 2"]);
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, each with its line.
    pub fn all(text: &str) -> Result<Vec<Self>, Vec<String>> {
        let mut table = Table::read(text.as_bytes()).map_err(|message| vec![message])?;
        let column = |heading: &str| table.column(heading).map_err(|message| vec![message]);
        let (login, id, name, section) = (column("login")?, column("id")?, column("name")?, column("section")?);
        let Some(login) = login.or(id) else {
            return Err(vec!["there is neither a column `login` nor a column `id`".to_owned()]);
        };
        let (mut rows, mut lines, mut faults) = (Vec::new(), BTreeMap::<String, u64>::new(), Vec::new());
        while let Some((line, row)) = table.next_row() {
            let read = row.and_then(|row| {
                let cell = |column: Option<usize>| column.map_or("", |place| row.cell(place)).to_owned();
                let row = Self { login: cell(Some(login)), name: cell(name), section: cell(section) };
                row.check().map(|()| row)
            });
            let row = match read {
                Ok(row) => row,
                Err(message) => {
                    faults.push(format!("line {line}: {message}"));
                    continue;
                }
            };
            if let Some(first) = lines.insert(row.login.clone(), line) {
                faults.push(format!("line {line}: `{}` is already in line {first}", excerpt(&row.login)));
            }
            if rows.len() == MOST {
                faults.push(format!("line {line}: a roster has at most {MOST} students"));
                break;
            }
            rows.push(row);
        }
        if rows.is_empty() && faults.is_empty() {
            faults.push("there are no students".to_owned());
        }
        if faults.is_empty() { Ok(rows) } else { Err(faults) }
    }

    fn check(&self) -> Result<(), String> {
        if self.login.is_empty() {
            return Err("this student has no login".to_owned());
        }
        for cell in [&self.login, &self.name, &self.section] {
            if cell.len() > LONGEST {
                return Err(format!("`{}` is longer than {LONGEST} bytes", excerpt(cell)));
            }
            if cell.chars().any(char::is_control) {
                return Err(format!(
                    "`{}` has a character that cannot be printed",
                    excerpt(&cell.escape_debug().to_string())
                ));
            }
        }
        Ok(())
    }
}

/// The changes that a roster would make in a course with these members, those who left included: who is new comes first, who is
/// gone last. Staff are never changed by a roster.
///
/// # Errors
/// The logins that belong to staff of the course.
pub fn roster_changes(rows: &[RosterRow], course: &[(Member, Person)]) -> Result<Vec<RosterChange>, Vec<String>> {
    let known: BTreeMap<&str, &(Member, Person)> = course.iter().map(|place| (place.1.login.as_str(), place)).collect();
    let is_staff = |row: &&RosterRow| known.get(row.login.as_str()).is_some_and(|(member, _)| member.role.is_staff());
    let staff: Vec<String> = rows.iter().filter(is_staff).map(|row| row.login.clone()).collect();
    if !staff.is_empty() {
        return Err(staff);
    }
    let (mut new, mut changed) = (Vec::new(), Vec::new());
    for row in rows {
        let Some((member, person)) = known.get(row.login.as_str()) else {
            new.push(RosterChange::New { row: row.clone() });
            continue;
        };
        let member = (member.key, member);
        if member.1.left.is_some() {
            new.push(RosterChange::Back { member: member.0, row: row.clone() });
            continue;
        }
        if !row.name.is_empty() && row.name != person.name {
            changed.push(RosterChange::Renamed { member: member.0, from: person.name.clone(), to: row.name.clone() });
        }
        if row.section != member.1.section {
            changed.push(RosterChange::Moved {
                member: member.0,
                from: member.1.section.clone(),
                to: row.section.clone(),
            });
        }
    }
    let stays = |place: &(Member, Person)| rows.iter().any(|row| row.login == place.1.login);
    let is_student = |place: &&(Member, Person)| place.0.role == Role::Student && place.0.left.is_none();
    let gone = course.iter().filter(is_student).filter(|place| !stays(place));
    let gone = gone.map(|(member, person)| RosterChange::Gone { member: member.key, name: person.shown().to_owned() });
    Ok(new.into_iter().chain(changed).chain(gone).collect())
}

/// The records with which a roster's changes are made. People who are known to the server by their logins keep their names; keys of new
/// people and members are made of `random` bytes.
#[must_use]
pub fn roster_records(
    changes: &[RosterChange],
    course: (Key<Course>, &[(Member, Person)]),
    others: &[Person],
    at: Moment,
    random: &mut dyn FnMut() -> [u8; 16],
) -> RosterRecords {
    let mut people: BTreeMap<Key<Person>, Person> = BTreeMap::new();
    let mut members: BTreeMap<Key<Member>, Member> = BTreeMap::new();
    let mut fresh = RosterRecords::default();
    for change in changes {
        let (key, row) = match change {
            RosterChange::New { row } => {
                let known = others.iter().find(|person| person.login == row.login).map(|person| person.key);
                let person = known.unwrap_or_else(|| {
                    let key = Key::new(random());
                    let (login, name) = (row.login.clone(), row.name.clone());
                    fresh.people.push(Person { key, login, name, operator: false, erased: None });
                    key
                });
                let (section, role) = (row.section.clone(), Role::Student);
                let key = Key::new(random());
                fresh.members.push(Member { key, course: course.0, person, role, section, left: None });
                continue;
            }
            RosterChange::Back { member, row } => (*member, Some(row)),
            RosterChange::Renamed { member, .. }
            | RosterChange::Moved { member, .. }
            | RosterChange::Gone { member, .. } => (*member, None),
        };
        let Some((member, person)) = course.1.iter().find(|place| place.0.key == key) else { continue };
        let mut rename = |to: &String| {
            people.entry(person.key).or_insert_with(|| person.clone()).name.clone_from(to);
        };
        if let RosterChange::Renamed { to, .. } = change {
            rename(to);
            continue;
        }
        if let Some(row) = row.filter(|row| !row.name.is_empty() && row.name != person.name) {
            rename(&row.name);
        }
        let changed = members.entry(key).or_insert_with(|| member.clone());
        match change {
            RosterChange::Back { row, .. } => {
                changed.left = None;
                changed.section.clone_from(&row.section);
            }
            RosterChange::Moved { to, .. } => changed.section.clone_from(to),
            _ => changed.left = Some(at),
        }
    }
    fresh.people.extend(people.into_values());
    fresh.members.extend(members.into_values());
    fresh
}
