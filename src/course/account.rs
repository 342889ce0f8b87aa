//! The one account of points: what a student has for each item of an assignment, and why. Every page, table and statistic that shows
//! points takes them from here.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::assignment::{Correction, CorrectionChoice, Item};
use super::handed_in::{Override, OverrideRule, Sheet};
use super::key::Key;
use super::people::Member;
use super::score::Score;
use super::stored_report::StoredReport;

/// The records of an assignment that decide about points, of a class or of one student.
#[derive(Clone, Copy, Debug)]
pub struct Ledger<'a> {
    /// The items.
    pub items: &'a [Item],
    /// The corrections of items, the earliest first.
    pub corrections: &'a [Correction],
    /// The sheets, of every issue.
    pub sheets: &'a [Sheet],
    /// The stored report of the last attempt at each sheet.
    pub last: &'a BTreeMap<Key<Sheet>, StoredReport>,
    /// The points set by hand or kept by a regrade, the earliest first.
    pub by_hand: &'a [Override],
}

/// A ledger in which what concerns one student and item is found at once.
#[derive(Clone, Debug)]
pub struct Accounts<'a> {
    /// The items in their order.
    items: Vec<&'a Item>,
    corrections: BTreeMap<Key<Item>, Vec<&'a Correction>>,
    sheets: BTreeMap<(Key<Member>, Key<Item>), Vec<&'a Sheet>>,
    last: &'a BTreeMap<Key<Sheet>, StoredReport>,
    by_hand: BTreeMap<Key<Sheet>, Vec<&'a Override>>,
}

/// Standings of a student in an assignment.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Account {
    /// The standing for each item, in their order; items that were dropped included.
    pub standings: Vec<Standing>,
    /// The sum of the points.
    #[serde(with = "exact")]
    pub total: Rational,
    /// The points that can be reached.
    pub out_of: u32,
}

/// The standing of a student for an item.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Standing {
    /// The item.
    pub item: Key<Item>,
    /// Its points.
    pub out_of: u32,
    /// The points, and how they came about.
    pub mark: GradeMark,
    /// The words with which points were set by hand, or those of marking let count again, last.
    pub by_hand: Option<Said>,
    /// The words with which a correction of the problem was taken in last.
    pub corrected: Option<Said>,
}

/// The words to a student about a decision.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Said {
    /// Why it was taken.
    pub reason: String,
    /// A further remark to the student; empty where there is none.
    pub comment: String,
}

/// The points that a student has for an item, and how they came about.
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
    /// Points from before a correction, which was not to lower any.
    Kept {
        /// The points.
        #[serde(with = "exact")]
        points: Rational,
    },
    /// The item no longer counts.
    Dropped,
}

impl GradeMark {
    /// The points; nothing where nothing was handed in, or the item no longer counts.
    #[must_use]
    pub fn points(&self) -> Option<&Rational> {
        match self {
            Self::Missing | Self::Dropped => None,
            Self::Marked { points } | Self::ByHand { points } | Self::Full { points } | Self::Kept { points } => {
                Some(points)
            }
        }
    }

    /// How they came about, in a few words; empty where it was by marking, as is usual.
    #[must_use]
    pub fn how(&self) -> &'static str {
        match self {
            Self::Missing | Self::Marked { .. } => "",
            Self::ByHand { .. } => "by hand",
            Self::Full { .. } => "full marks",
            Self::Kept { .. } => "as before the correction",
            Self::Dropped => "no longer counts",
        }
    }
}

/// All that decides about one student's points for an item.
#[derive(Clone, Debug)]
pub(super) struct Deciding<'a> {
    pub(super) item: &'a Item,
    pub(super) dropped: bool,
    pub(super) full_marks: bool,
    /// The decision made by hand last at the sheet that counts.
    pub(super) by_hand: Option<&'a Override>,
    /// The most that a correction was not to lower.
    pub(super) at_least: Option<Rational>,
    /// The score of the attempt that counts.
    pub(super) score: Option<Score>,
}

impl Deciding<'_> {
    /// The points: what was set by hand, else full marks, else what marking found, and no less than was promised.
    pub(super) fn mark(&self) -> GradeMark {
        if self.dropped {
            return GradeMark::Dropped;
        }
        let by_hand = self.by_hand.and_then(|decision| decision.points.as_deref()?.parse::<Rational>().ok());
        if let Some(points) = by_hand {
            return GradeMark::ByHand { points };
        }
        let most = Rational::from(self.item.points);
        if self.full_marks {
            return GradeMark::Full { points: most };
        }
        let marked = self.score.as_ref().map(|score| score.scaled(self.item.points).points);
        let kept = self.at_least.clone().map(|points| points.min(most));
        match (marked, kept) {
            (marked, Some(points)) if marked.as_ref().is_none_or(|marked| *marked < points) => {
                GradeMark::Kept { points }
            }
            (Some(points), _) => GradeMark::Marked { points },
            (None, _) => GradeMark::Missing,
        }
    }
}

impl<'a> Accounts<'a> {
    /// The accounts of a ledger.
    #[must_use]
    pub fn of(ledger: Ledger<'a>) -> Self {
        let mut account = Self {
            items: ledger.items.iter().collect(),
            corrections: BTreeMap::new(),
            sheets: BTreeMap::new(),
            last: ledger.last,
            by_hand: BTreeMap::new(),
        };
        account.items.sort_by_key(|item| item.position);
        for correction in ledger.corrections {
            account.corrections.entry(correction.item).or_default().push(correction);
        }
        for sheet in ledger.sheets {
            account.sheets.entry((sheet.member, sheet.item)).or_default().push(sheet);
        }
        for set in ledger.by_hand {
            account.by_hand.entry(set.sheet).or_default().push(set);
        }
        account
    }

    /// The items that count, in their order.
    pub(super) fn counted(&self) -> impl Iterator<Item = &'a Item> {
        self.items.iter().copied().filter(|item| !item.dropped)
    }

    /// Whether a sheet is one of those that count: of the last issue of an item that was not dropped.
    pub(super) fn counts(&self, sheet: &Sheet) -> bool {
        self.counted().any(|item| item.key == sheet.item && item.issue == sheet.issue)
    }

    /// The standings of a student.
    #[must_use]
    pub fn account(&self, member: Key<Member>) -> Account {
        let standings: Vec<Standing> = self.items.iter().map(|item| self.standing(member, item)).collect();
        Account {
            total: standings
                .iter()
                .filter_map(|standing| standing.mark.points())
                .fold(Rational::ZERO, |sum, points| sum + points),
            out_of: self.counted().fold(0, |sum, item| sum.saturating_add(item.points)),
            standings,
        }
    }

    /// The standing of a student for an item. Of its sheets that of the last issue counts.
    #[must_use]
    pub fn standing(&self, member: Key<Member>, item: &'a Item) -> Standing {
        let deciding = self.deciding(member, item);
        let said = |reason: &str, comment: &str| {
            let is_said = !reason.is_empty() || !comment.is_empty();
            is_said.then(|| Said { reason: reason.to_owned(), comment: comment.to_owned() })
        };
        let correction = self.corrections.get(&item.key).and_then(|all| all.last());
        Standing {
            item: item.key,
            out_of: item.points,
            mark: deciding.mark(),
            by_hand: deciding.by_hand.and_then(|decision| said(&decision.reason, &decision.comment)),
            corrected: correction.and_then(|correction| said(&correction.reason, &correction.comment)),
        }
    }

    /// All that decides about a student's points for an item.
    pub(super) fn deciding(&self, member: Key<Member>, item: &'a Item) -> Deciding<'a> {
        let sheets = self.sheets.get(&(member, item.key)).map_or(&[][..], Vec::as_slice);
        let set = |sheet: &Sheet| self.by_hand.get(&sheet.key).map_or(&[][..], Vec::as_slice);
        let counting = sheets.iter().find(|sheet| sheet.issue == item.issue);
        let exactly = |decision: &&&Override| decision.rule == OverrideRule::Exactly;
        let kept = sheets.iter().flat_map(|sheet| set(sheet)).filter(|decision| decision.rule == OverrideRule::AtLeast);
        Deciding {
            item,
            dropped: item.dropped,
            full_marks: has_full_marks(self.corrections.get(&item.key).map_or(&[][..], Vec::as_slice)),
            by_hand: counting.and_then(|sheet| set(sheet).iter().rfind(exactly).copied()),
            at_least: kept.filter_map(|decision| decision.points.as_deref()?.parse().ok()).max(),
            score: counting.and_then(|sheet| Score::of(self.last.get(&sheet.key)?)),
        }
    }
}

/// Whether everybody has full marks after these corrections of an item: one gave them, and none after it was free to take them back.
fn has_full_marks(corrections: &[&Correction]) -> bool {
    corrections.iter().fold(false, |full, correction| {
        correction.choice == CorrectionChoice::FullMarks || (full && correction.never_lower)
    })
}

/// The points that somebody types for an item, as a record keeps them: `4.5`, `4,5` or `9/2`; nothing lets those of marking count again.
///
/// ```
/// use momentous_course::points_by_hand;
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
