//! Statistics of the answers of a course.

use std::collections::BTreeSet;

use serde::Serialize;

use momentous_grade::Gathering;
use momentous_grade::RowCounts;
use momentous_grade::Statistics;
use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::account::Accounts;
use super::gradebook::{Column, GradeRow, Gradebook};
use super::handed_in::Sheet;
use super::key::Key;
use super::people::Member;
use super::stored_report::StoredReport;

/// The statistics of a class for the problems of an assignment.
#[derive(Clone, Debug)]
pub struct ClassStatistics {
    /// The students who have points for an item.
    pub students: usize,
    /// The mean of their shares of all points; nothing where there are none.
    pub mean: Option<Rational>,
    /// The items, in their order.
    pub items: Vec<ItemStatistics>,
    /// Facility, discrimination, usual mistakes and frequent wrong answers of the parts, as marking found them.
    pub parts: Statistics,
}

/// The standings of a class for an item.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ItemStatistics {
    /// Its heading in the gradebook.
    pub heading: String,
    /// Its points.
    pub out_of: u32,
    /// The students who have points for it.
    pub students: usize,
    /// The mean of their points; 0 where there are none.
    #[serde(with = "exact")]
    pub mean: Rational,
}

/// The statistics of these students: means from their gradebook, and those of parts from what was handed in, each sheet with what was kept
/// of its attempts, the earliest first. Students stand in it by their keys; sheets of others, and those that no longer count, are left out.
#[must_use]
pub fn statistics<'a>(
    accounts: &Accounts<'_>,
    book: &Gradebook,
    sheets: impl IntoIterator<Item = (&'a Sheet, &'a [StoredReport])>,
) -> ClassStatistics {
    let students: BTreeSet<Key<Member>> = book.rows.iter().map(|row| row.member).collect();
    let mut gathering = Gathering::default();
    let mut rows = RowCounts::default();
    let counts = |sheet: &Sheet| accounts.counts(sheet) && students.contains(&sheet.member);
    for (sheet, reports) in sheets.into_iter().filter(|(sheet, _)| counts(sheet)) {
        let student = sheet.member.to_string();
        let form = sheet.issued.form.as_deref().unwrap_or_default();
        let counting = reports.last().and_then(|last| last.history.counting());
        for (number, report) in (1_u32..).zip(reports) {
            for part in report.reports(counting == Some(number)) {
                gathering.add(&student, &sheet.issued.problem, form, &part);
                rows.answers += 1;
            }
            rows.read += 1;
            rows.marked += 1;
        }
    }
    let item = |(place, column): (usize, &Column)| {
        let points: Vec<&Rational> = book.rows.iter().filter_map(|row| row.marks.get(place)?.points()).collect();
        ItemStatistics {
            heading: column.heading.clone(),
            out_of: column.points,
            students: points.len(),
            mean: mean(points.into_iter()).unwrap_or(Rational::ZERO),
        }
    };
    let has_points = |row: &&GradeRow| row.marks.iter().any(|mark| mark.points().is_some());
    let totals: Vec<&Rational> = book.rows.iter().filter(has_points).map(|row| &row.total).collect();
    let out_of = Rational::from(book.out_of.max(1));
    ClassStatistics {
        students: totals.len(),
        mean: mean(totals.into_iter()).map(|mean| mean / out_of),
        items: book.columns.iter().enumerate().map(item).collect(),
        parts: gathering.statistics(rows),
    }
}

/// The mean of numbers; nothing where there are none.
fn mean<'a>(numbers: impl ExactSizeIterator<Item = &'a Rational>) -> Option<Rational> {
    let count = u32::try_from(numbers.len()).ok().filter(|count| *count > 0)?;
    Some(numbers.fold(Rational::ZERO, |sum, number| sum + number) / Rational::from(count))
}
