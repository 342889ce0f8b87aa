//! The marks of a class: students by items, exactly.

use serde::Serialize;

use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::account::{Account, Accounts, GradeMark};
use super::assignment::Item;
use super::key::Key;
use super::people::{Member, Person};

/// The marks of a class. Items that were dropped have no column.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Gradebook {
    /// The items, in their order.
    pub columns: Vec<Column>,
    /// The students, in the order in which they were given.
    pub rows: Vec<GradeRow>,
    /// The points that can be reached.
    pub out_of: u32,
}

/// An item of a gradebook.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Column {
    /// The item.
    pub item: Key<Item>,
    /// Its heading: its place, counted from 1, and the problem.
    pub heading: String,
    /// Its points.
    pub points: u32,
}

/// The marks of a student.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GradeRow {
    /// The student.
    pub member: Key<Member>,
    /// The name by which the student signs in.
    pub login: String,
    /// The name of the student.
    pub name: String,
    /// The section.
    pub section: String,
    /// A mark for each column.
    pub marks: Vec<GradeMark>,
    /// The sum of their points.
    #[serde(with = "exact")]
    pub total: Rational,
}

impl Gradebook {
    /// The marks of these students, by their accounts.
    #[must_use]
    pub fn of(accounts: &Accounts<'_>, students: &[(&Member, &Person)]) -> Self {
        let row = |(member, person): &(&Member, &Person)| {
            let Account { standings, total, .. } = accounts.account(member.key);
            let counted = standings.into_iter().filter(|standing| standing.mark != GradeMark::Dropped);
            GradeRow {
                member: member.key,
                login: person.login.clone(),
                name: person.shown().to_owned(),
                section: member.section.clone(),
                marks: counted.map(|standing| standing.mark).collect(),
                total,
            }
        };
        let column = |item: &Item| Column {
            item: item.key,
            heading: format!("{} {}", item.position.saturating_add(1), item.problem),
            points: item.points,
        };
        let columns: Vec<Column> = accounts.counted().map(column).collect();
        Self {
            rows: students.iter().map(row).collect(),
            out_of: columns.iter().fold(0, |sum, column| sum.saturating_add(column.points)),
            columns,
        }
    }
}
