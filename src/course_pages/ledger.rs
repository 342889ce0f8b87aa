//! The records that decide about points, read for a class or for one student.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course::{
    Accounts, Attempt, Correction, Item, Key, Ledger, Member, Override, Said, Sheet, Standing, StoredReport,
};
use momentous_grade::Points;
use momentous_store::{AssignmentWithItems, StoreFault};

use super::outcome::NotShown;
use super::visit::Visit;

/// The records of an assignment that decide about points.
pub(super) struct Records {
    pub(super) items: Vec<Item>,
    pub(super) corrections: Vec<Correction>,
    pub(super) sheets: Vec<Sheet>,
    /// The stored report of the last attempt at each sheet.
    last: BTreeMap<Key<Sheet>, StoredReport>,
    pub(super) by_hand: Vec<Override>,
}

/// The standing of a student for an item, as pages show it.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Has {
    /// The points; nothing where nothing was handed in, or the item no longer counts.
    pub(super) points: Option<String>,
    pub(super) out_of: u32,
    /// How they came about, where it was not by marking.
    pub(super) how: &'static str,
    /// The words with which points were set by hand.
    pub(super) by_hand: Option<Said>,
    /// The words with which the problem was corrected.
    pub(super) corrected: Option<Said>,
}

impl Has {
    pub(super) fn of(standing: &Standing) -> Self {
        Self {
            points: standing.mark.points().map(|points| Points(points.clone()).to_string()),
            out_of: standing.out_of,
            how: standing.mark.how(),
            by_hand: standing.by_hand.clone(),
            corrected: standing.corrected.clone(),
        }
    }
}

impl Records {
    /// Those of the whole class. The number of reads does not depend on the number of students.
    pub(super) async fn of_class(visit: &Visit, whole: &AssignmentWithItems) -> Result<Self, NotShown> {
        let (store, key) = (visit.store(), whole.assignment.key);
        Ok(Self {
            items: whole.items.clone(),
            corrections: store.corrections(key).await?,
            sheets: store.sheets(key).await?,
            last: last(&store.last_attempts(key).await?)?,
            by_hand: store.set_by_hand(key).await?,
        })
    }

    /// Those of one student.
    pub(super) async fn of_student(
        visit: &Visit,
        whole: &AssignmentWithItems,
        member: Key<Member>,
    ) -> Result<Self, NotShown> {
        let (store, key) = (visit.store(), whole.assignment.key);
        let attempts: Vec<Attempt> = store.attempts_of(key, member).await?.into_values().flatten().collect();
        Ok(Self {
            items: whole.items.clone(),
            corrections: store.corrections(key).await?,
            sheets: store.sheets_of(member).await?,
            last: last(&attempts)?,
            by_hand: store.set_by_hand_of(key, member).await?,
        })
    }

    /// Those of the student of a sheet, as far as they concern its item; `last` was kept of the last attempt at it.
    pub(super) async fn of_sheet(
        visit: &Visit,
        whole: &AssignmentWithItems,
        sheet: &Sheet,
        last: Option<&StoredReport>,
    ) -> Result<Self, NotShown> {
        let (store, key) = (visit.store(), whole.assignment.key);
        Ok(Self {
            items: whole.items.clone(),
            corrections: store.corrections(key).await?,
            sheets: store.sheets_of(sheet.member).await?,
            last: last.map(|last| (sheet.key, last.clone())).into_iter().collect(),
            by_hand: store.set_by_hand_of(key, sheet.member).await?,
        })
    }

    /// The accounts.
    pub(super) fn accounts(&self) -> Accounts<'_> {
        Accounts::of(Ledger {
            items: &self.items,
            corrections: &self.corrections,
            sheets: &self.sheets,
            last: &self.last,
            by_hand: &self.by_hand,
        })
    }

    /// Whether something was set at a sheet of an item, in whichever issue.
    pub(super) fn is_at(&self, set: &Override, item: Key<Item>) -> bool {
        self.sheets.iter().any(|sheet| sheet.key == set.sheet && sheet.item == item)
    }

    /// The number of times that something was handed in at the sheets of an item that count.
    pub(super) fn attempts_at(&self, item: &Item) -> u32 {
        let is_counted = |sheet: &&Sheet| sheet.item == item.key && sheet.issue == item.issue;
        let last = self.sheets.iter().filter(is_counted).filter_map(|sheet| self.last.get(&sheet.key));
        last.map(|report| report.history.handed_in()).sum()
    }

    /// The standing of a student for one of the items.
    pub(super) fn standing(&self, member: Key<Member>, item: Key<Item>) -> Option<Standing> {
        let item = self.items.iter().find(|listed| listed.key == item)?;
        Some(self.accounts().standing(member, item))
    }
}

/// The stored report of the last attempt at each sheet, of attempts in their order.
fn last(attempts: &[Attempt]) -> Result<BTreeMap<Key<Sheet>, StoredReport>, NotShown> {
    let last: BTreeMap<Key<Sheet>, &Attempt> = attempts.iter().map(|attempt| (attempt.sheet, attempt)).collect();
    let report = |(sheet, attempt): (Key<Sheet>, &Attempt)| Ok((sheet, StoredReport::of(attempt)?));
    let all: Result<_, serde_json::Error> = last.into_iter().map(report).collect();
    all.map_err(|error| NotShown::Store(StoreFault::Record(error)))
}
