//! What the answers of a course say about its problems.

use crate::grade::Gathering;
use crate::grade::RowCounts;
use crate::grade::Statistics;

use super::handed_in::Sheet;
use super::stored_report::StoredReport;

/// Facility, discrimination, usual mistakes and frequent wrong answers of what was handed in: each sheet with what was kept of its
/// attempts, the earliest first. Students stand in it by their keys.
#[must_use]
pub fn statistics<'a>(sheets: impl IntoIterator<Item = (&'a Sheet, &'a [StoredReport])>) -> Statistics {
    let mut gathering = Gathering::default();
    let mut rows = RowCounts::default();
    for (sheet, reports) in sheets {
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
    gathering.statistics(rows)
}
