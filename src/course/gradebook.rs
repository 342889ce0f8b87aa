//! The marks of a class: students by items, exactly.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::quantity::Rational;
use crate::quantity::exact;

use super::assignment::Item;
use super::handed_in::{Override, Sheet};
use super::key::Key;
use super::people::{Member, Person};
use super::score::Score;
use super::stored_report::StoredReport;

/// A column: an item, and whether everybody has full marks.
#[derive(Clone, Copy, Debug)]
pub struct GradedItem<'a> {
    /// The item.
    pub item: &'a Item,
    /// Whether a correction gave full marks to everybody.
    pub full_marks: bool,
}

/// What a student has on a sheet.
#[derive(Clone, Copy, Debug)]
pub struct GradedSheet<'a> {
    /// The sheet.
    pub sheet: &'a Sheet,
    /// What was kept of the last attempt.
    pub last: Option<&'a StoredReport>,
    /// What was set by hand last.
    pub by_hand: Option<&'a Override>,
}

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
    /// What it is worth.
    pub points: u32,
}

/// The marks of a student.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GradeRow {
    /// The student.
    pub member: Key<Member>,
    /// The name by which the student signs in.
    pub login: String,
    /// What the student is called.
    pub name: String,
    /// The section.
    pub section: String,
    /// A mark for each column.
    pub marks: Vec<GradeMark>,
    /// The sum of their points.
    #[serde(with = "exact")]
    pub total: Rational,
}

/// What a student has for an item.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum GradeMark {
    /// Nothing was handed in.
    Missing,
    /// Points of the attempt that counts.
    Marked {
        /// The points.
        #[serde(with = "exact")]
        points: Rational,
    },
    /// Points that were set by hand.
    ByHand {
        /// The points.
        #[serde(with = "exact")]
        points: Rational,
    },
    /// Full marks, which a correction gave to everybody.
    Full {
        /// The points.
        #[serde(with = "exact")]
        points: Rational,
    },
}

impl GradeMark {
    /// The points; nothing where nothing was handed in.
    #[must_use]
    pub fn points(&self) -> Option<&Rational> {
        match self {
            Self::Missing => None,
            Self::Marked { points } | Self::ByHand { points } | Self::Full { points } => Some(points),
        }
    }
}

impl Gradebook {
    /// The marks of these students. Of each item the sheets of its last issue count.
    #[must_use]
    pub fn of(items: &[GradedItem<'_>], students: &[(&Member, &Person)], sheets: &[GradedSheet<'_>]) -> Self {
        let mut counted: Vec<GradedItem<'_>> = items.iter().copied().filter(|own| !own.item.dropped).collect();
        counted.sort_by_key(|own| own.item.position);
        let found: BTreeMap<(Key<Member>, Key<Item>, u32), &GradedSheet<'_>> =
            sheets.iter().map(|own| ((own.sheet.member, own.sheet.item, own.sheet.issue), own)).collect();
        let row = |(member, person): &(&Member, &Person)| {
            let sheet = |own: &GradedItem<'_>| found.get(&(member.key, own.item.key, own.item.issue)).copied();
            let marks: Vec<GradeMark> = counted.iter().map(|own| mark(own, sheet(own))).collect();
            GradeRow {
                member: member.key,
                login: person.login.clone(),
                name: person.shown().to_owned(),
                section: member.section.clone(),
                total: marks.iter().filter_map(GradeMark::points).fold(Rational::ZERO, |sum, own| sum + own),
                marks,
            }
        };
        let column = |own: &GradedItem<'_>| Column {
            item: own.item.key,
            heading: format!("{} {}", own.item.position.saturating_add(1), own.item.problem),
            points: own.item.points,
        };
        Self {
            rows: students.iter().map(row).collect(),
            columns: counted.iter().map(column).collect(),
            out_of: counted.iter().fold(0, |sum, own| sum.saturating_add(own.item.points)),
        }
    }
}

/// The mark of an item: what was set by hand, else full marks, else what marking found.
fn mark(own: &GradedItem<'_>, sheet: Option<&GradedSheet<'_>>) -> GradeMark {
    let by_hand = sheet.and_then(|sheet| sheet.by_hand?.points.as_deref()?.parse::<Rational>().ok());
    let marked = || Some(Score::of(sheet?.last?)?.scaled(own.item.points).points);
    match (by_hand, own.full_marks) {
        (Some(points), _) => GradeMark::ByHand { points },
        (None, true) => GradeMark::Full { points: Rational::from(own.item.points) },
        (None, false) => marked().map_or(GradeMark::Missing, |points| GradeMark::Marked { points }),
    }
}

/// The points that somebody types for an item, as a record keeps them: `4.5`, `4,5` or `9/2`; nothing lets those of marking count again.
///
/// ```
/// use momentous::course::points_by_hand;
/// assert_eq!(points_by_hand("4,5", 10), Ok(Some("9/2".to_owned())));
/// assert_eq!(points_by_hand(" ", 10), Ok(None));
/// assert_eq!(points_by_hand("12", 10).unwrap_err(), "write points from 0 to 10, or nothing to let those of marking count");
/// ```
///
/// # Errors
/// What is wrong, and the way out.
pub fn points_by_hand(text: &str, most: u32) -> Result<Option<String>, String> {
    let text = text.trim();
    if text.is_empty() {
        return Ok(None);
    }
    let points = super::share::fraction(text).filter(|points| *points <= Rational::from(most));
    let wrong = || format!("write points from 0 to {most}, or nothing to let those of marking count");
    points.map(|points| Some(points.to_string())).ok_or_else(wrong)
}
