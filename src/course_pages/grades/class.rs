//! An assignment with everything that its students handed in.

use std::collections::BTreeMap;

use momentous_course::{
    Attempt, Extension, Gradebook, HintShown, Item, Key, Member, Person, Role, Sheet, StoredReport, Window, WorkedSheet,
};
use momentous_store::{AssignmentWithItems, Membership, StoreFault};
use momentous_web::App;

use super::super::at_close;
use super::super::ledger::Records;
use super::super::outcome::NotShown;
use super::super::titles::Titles;
use super::super::visit::Visit;

/// The assignment of the address, which belongs to the course of the address.
pub(super) async fn assignment(visit: &Visit) -> Result<AssignmentWithItems, NotShown> {
    let stored = visit.store().assignment(visit.key("assignment")?).await?;
    let course = visit.course()?.key;
    let assignment = stored.filter(|whole| whole.assignment.course == course);
    let assignment = assignment.ok_or_else(|| NotShown::missing("there is no such assignment in this course"))?;
    at_close::hand_in(visit, &assignment, None).await?;
    Ok(assignment)
}

/// The titles of the items of an assignment: place and title of their problems.
pub(super) async fn titles(
    visit: &Visit,
    whole: &AssignmentWithItems,
) -> Result<BTreeMap<Key<Item>, String>, NotShown> {
    let items: Vec<(Key<Item>, u32, String)> =
        whole.items.iter().map(|item| (item.key, item.position.saturating_add(1), item.problem.clone())).collect();
    let titles = Titles::of(visit).await?;
    let titled = move |app: &App| {
        let title =
            |(key, place, problem): &(_, _, String)| Ok((*key, format!("{place}. {}", titles.title(app, problem)?)));
        items.iter().map(title).collect()
    };
    visit.work(titled).await
}

/// The member of the address, which belongs to the course of the address.
pub(super) async fn member(visit: &Visit) -> Result<Membership, NotShown> {
    let key: Key<Member> = visit.key("member")?;
    let all = visit.store().members(visit.course()?.key).await?;
    let membership = all.into_iter().find(|membership| membership.member.key == key);
    membership.ok_or_else(|| NotShown::missing("there is no such member of this course"))
}

/// The students of the course, by name; those who left are not among them.
pub(super) async fn students(visit: &Visit) -> Result<Vec<Membership>, NotShown> {
    let all = visit.store().members(visit.course()?.key).await?;
    let is_student =
        |membership: &Membership| membership.member.role == Role::Student && membership.member.left.is_none();
    let mut students: Vec<Membership> = all.into_iter().filter(is_student).collect();
    students.sort_by(|one, other| {
        let name = |membership: &Membership| (membership.person.shown().to_lowercase(), membership.member.key);
        name(one).cmp(&name(other))
    });
    Ok(students)
}

/// Students as a gradebook takes them.
pub(super) fn people(students: &[Membership]) -> Vec<(&Member, &Person)> {
    students.iter().map(|membership| (&membership.member, &membership.person)).collect()
}

/// The stored reports of attempts that were marked.
pub(super) fn reports(attempts: &[Attempt]) -> Result<Vec<StoredReport>, NotShown> {
    let all: Result<Vec<_>, _> = attempts.iter().map(StoredReport::of).collect();
    all.map_err(|error| NotShown::Store(StoreFault::Record(error)))
}

/// The marks of an assignment: what a gradebook is made of.
pub(super) struct Class {
    pub(super) whole: AssignmentWithItems,
    pub(super) students: Vec<Membership>,
    pub(super) records: Records,
}

impl Class {
    /// The class of the assignment in the address. The number of reads does not depend on the number of students.
    pub(super) async fn of(visit: &Visit) -> Result<Self, NotShown> {
        let whole = assignment(visit).await?;
        Ok(Self { students: students(visit).await?, records: Records::of_class(visit, &whole).await?, whole })
    }

    /// The marks.
    pub(super) fn gradebook(&self) -> Gradebook {
        Gradebook::of(&self.records.accounts(), &people(&self.students))
    }
}

/// A sheet with everything that was handed in on it.
pub(super) struct HandedInSheet {
    pub(super) sheet: Sheet,
    pub(super) attempts: Vec<Attempt>,
    pub(super) hints: Vec<HintShown>,
    pub(super) reports: Vec<StoredReport>,
    pub(super) window: Window,
}

impl HandedInSheet {
    pub(super) fn worked(&self) -> WorkedSheet<'_> {
        WorkedSheet {
            sheet: &self.sheet,
            attempts: &self.attempts,
            hints: &self.hints,
            reports: &self.reports,
            window: self.window.clone(),
        }
    }
}

/// Every sheet of an assignment, with everything that was handed in on it.
pub(super) async fn handed_in_sheets(
    visit: &Visit,
    whole: &AssignmentWithItems,
) -> Result<Vec<HandedInSheet>, NotShown> {
    let (store, key) = (visit.store(), whole.assignment.key);
    let extensions: BTreeMap<Key<Member>, Extension> =
        store.extensions(key).await?.into_iter().map(|extension| (extension.member, extension)).collect();
    let mut attempts: BTreeMap<Key<Sheet>, Vec<Attempt>> = BTreeMap::new();
    for attempt in store.all_attempts(key).await? {
        attempts.entry(attempt.sheet).or_default().push(attempt);
    }
    let mut hints: BTreeMap<Key<Sheet>, Vec<HintShown>> = BTreeMap::new();
    for hint in store.all_hints(key).await? {
        hints.entry(hint.sheet).or_default().push(hint);
    }
    let zone = visit.course()?.zone.as_str();
    let mut with_attempts = |sheet: Sheet| {
        let attempts = attempts.remove(&sheet.key).unwrap_or_default();
        let hints = hints.remove(&sheet.key).unwrap_or_default();
        let window = Window::of(&whole.assignment.policy, extensions.get(&sheet.member), zone);
        Ok(HandedInSheet { reports: reports(&attempts)?, sheet, attempts, hints, window })
    };
    store.sheets(key).await?.into_iter().map(&mut with_attempts).collect()
}
