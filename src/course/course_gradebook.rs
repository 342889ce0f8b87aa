//! The grades of a course: students by assignments, exactly, and as a table that spreadsheets open.

use momentous_quantity::Rational;

use super::account::GradeMark;
use super::assignment::Assignment;
use super::gradebook::Gradebook;
use super::gradebook_table::{FRONT, decimal, line};
use super::grading::{Grading, Part, Reached};
use super::key::Key;
use super::people::{Member, Person};

/// The grades of a course.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CourseGradebook {
    /// The assignments, in their order.
    pub columns: Vec<CourseColumn>,
    /// The students, in the order in which they were given.
    pub rows: Vec<CourseRow>,
}

/// An assignment of the gradebook of a course.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CourseColumn {
    /// The assignment.
    pub assignment: Key<Assignment>,
    /// Its title.
    pub title: String,
    /// The points that can be reached.
    pub out_of: u32,
    /// How much it counts beside the others.
    pub weight: u32,
}

/// The grades of a student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CourseRow {
    /// The student.
    pub member: Key<Member>,
    /// The name by which the student signs in.
    pub login: String,
    /// The name of the student.
    pub name: String,
    /// The section.
    pub section: String,
    /// The results of the assignments.
    pub cells: Vec<CourseCell>,
    /// The share of what could be reached; nothing as long as nothing counts.
    pub share: Option<Rational>,
}

/// The result of a student in an assignment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CourseCell {
    /// The points; nothing where nothing was handed in.
    pub points: Option<Rational>,
    /// Its part in the grade.
    pub part: Part,
}

/// An assignment with its marks.
pub struct MarkedAssignment<'a> {
    /// The assignment.
    pub assignment: &'a Assignment,
    /// The marks of the same students, in the same order.
    pub marks: &'a Gradebook,
    /// Whether it is over for each of these students.
    pub is_over: Vec<bool>,
}

impl CourseGradebook {
    /// The grades of these students.
    #[must_use]
    pub fn of(grading: &Grading, assignments: &[MarkedAssignment<'_>], students: &[(&Member, &Person)]) -> Self {
        let column = |marked: &MarkedAssignment<'_>| CourseColumn {
            assignment: marked.assignment.key,
            title: marked.assignment.title.clone(),
            out_of: marked.marks.out_of,
            weight: grading.weight(&marked.assignment.key.to_string(), marked.marks.out_of),
        };
        let row = |(place, (member, person)): (usize, &(&Member, &Person))| {
            let reached: Vec<Reached> = assignments
                .iter()
                .map(|marked| Reached {
                    assignment: marked.assignment.key.to_string(),
                    points: marked.marks.rows.get(place).map_or(Rational::ZERO, |row| row.total.clone()),
                    out_of: marked.marks.out_of,
                    is_over: marked.is_over.get(place).is_some_and(|is_over| *is_over),
                })
                .collect();
            let grade = grading.grade(&reached);
            let has_any = |marked: &MarkedAssignment<'_>| {
                let marks = marked.marks.rows.get(place).map_or(&[][..], |row| row.marks.as_slice());
                marks.iter().any(|mark| *mark != GradeMark::Missing)
            };
            let cells = assignments.iter().zip(reached).zip(grade.parts);
            CourseRow {
                member: member.key,
                login: person.login.clone(),
                name: person.shown().to_owned(),
                section: member.section.clone(),
                cells: cells
                    .map(|((marked, reached), part)| CourseCell {
                        points: has_any(marked).then_some(reached.points),
                        part,
                    })
                    .collect(),
                share: grade.share,
            }
        };
        Self { columns: assignments.iter().map(column).collect(), rows: students.iter().enumerate().map(row).collect() }
    }

    /// The table, as comma-separated values; the last column is the grade in percent. No cell is a formula to a spreadsheet.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let front = FRONT.map(str::to_owned);
        let headings =
            self.columns.iter().map(|course_column| format!("{} ({})", course_column.title, course_column.out_of));
        let head = line(front.into_iter().chain(headings).chain(["grade_percent".to_owned()]));
        let rows = self.rows.iter().map(|row| {
            let front = [&row.login, &row.name, &row.section].map(Clone::clone);
            let cells = row.cells.iter().map(|cell| cell.points.as_ref().map_or_else(String::new, decimal));
            let grade = row.share.as_ref().map_or_else(String::new, |share| decimal(&(share * Rational::from(100))));
            line(front.into_iter().chain(cells).chain([grade]))
        });
        std::iter::once(head).chain(rows).collect()
    }
}
