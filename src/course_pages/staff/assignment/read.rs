//! From the fields of the editor to an assignment, or to what is wrong with them.

use std::collections::BTreeSet;

use momentous_course::{Assignment, Course, FieldFault, Item, Key, Policy, Weights};
use momentous_problem::CourseSymbols;
use momentous_store::AssignmentWithItems;

use super::super::super::session;
use super::super::person_form::text_fault;
use super::catalogue::Catalogue;
use super::draft::{Draft, Row};

/// The most points of a problem.
const MOST_POINTS: u32 = 1000;

/// The faults: of fields, and of rows by their places.
pub(super) type Wrong = (Vec<FieldFault>, Vec<(usize, String)>);

/// The assignment that the fields say, in place of `before` where there is one.
///
/// # Errors
/// Every fault, with its field or the place of its row.
pub(super) fn read(
    draft: &Draft,
    course: &Course,
    catalogue: &Catalogue,
    before: Option<&AssignmentWithItems>,
) -> Result<AssignmentWithItems, Wrong> {
    let mut faults = Vec::new();
    let title = draft.form.value("title").to_owned();
    let message = if title.is_empty() { Some("an assignment has a title".to_owned()) } else { text_fault(&title) };
    faults.extend(message.map(|message| FieldFault { field: "title", message }));
    let policy = Policy::read(&draft.policy(), &course.zone).map_err(|wrong| faults.extend(wrong)).ok();
    let key = before.map_or_else(session::key, |before| before.assignment.key);
    let (mut items, mut wrong) = (Vec::new(), Vec::new());
    for (place, row) in draft.rows.iter().enumerate() {
        match item(row, key, place, catalogue, before) {
            Err(message) => wrong.push((place, message)),
            Ok(item) => items.push(item),
        }
    }
    number_repeats(&mut items);
    if draft.rows.is_empty() {
        faults.push(FieldFault {
            field: "items",
            message: "there is no problem yet\nhelp: search for one and add it".to_owned(),
        });
    }
    let kept: BTreeSet<Key<Item>> = items.iter().map(|item| item.key).collect();
    let pinned = before.filter(|before| before.assignment.pinned.is_some());
    let is_lost = |item: &Item| !kept.contains(&item.key);
    if wrong.is_empty() && pinned.is_some_and(|before| before.items.iter().any(is_lost)) {
        let message = "a problem that students have seen cannot be taken out or exchanged\nhelp: a correction drops it, with what becomes of its points";
        faults.push(FieldFault { field: "items", message: message.to_owned() });
    }
    match policy {
        Some(policy) if faults.is_empty() && wrong.is_empty() => {
            let pinned = before.and_then(|before| before.assignment.pinned);
            let assignment = Assignment { key, course: course.key, title, policy, pinned };
            Ok(AssignmentWithItems { assignment, items, revision: before.map_or(0, |before| before.revision) })
        }
        _ => Err((faults, wrong)),
    }
}

fn item(
    row: &Row,
    assignment: Key<Assignment>,
    place: usize,
    catalogue: &Catalogue,
    before: Option<&AssignmentWithItems>,
) -> Result<Item, String> {
    let points = row.points.trim().parse().ok().filter(|points| (1..=MOST_POINTS).contains(points));
    let points = points.ok_or_else(|| format!("its points are a whole number from 1 to {MOST_POINTS}"))?;
    row.order
        .trim()
        .parse::<u32>()
        .ok()
        .or(row.order.trim().is_empty().then_some(0))
        .ok_or("its place is a whole number")?;
    let position = u32::try_from(place).unwrap_or(u32::MAX);
    let old = before.into_iter().flat_map(|before| &before.items).find(|item| item.key.to_string() == row.key);
    let is_pinned = before.is_some_and(|before| before.assignment.pinned.is_some());
    if let Some(old) = old.filter(|_| is_pinned) {
        return Ok(Item { position, points, ..old.clone() });
    }
    let weights: Weights = row.weights.parse().map_err(|wrong| format!("{wrong}"))?;
    if let Some(old) = old.filter(|old| is_same(old, row)) {
        return Ok(Item { position, points, weights, ..old.clone() });
    }
    let offered = catalogue.find(row.problem.trim());
    let card =
        &offered.ok_or_else(|| format!("there is no problem `{}`\nhelp: search for it below", row.problem))?.card;
    let form = match (row.form.trim(), card.forms.first()) {
        ("", first) => first.cloned(),
        (name, _) if card.forms.iter().any(|form| form == name) => Some(name.to_owned()),
        (name, _) => return Err(format!("it has no form `{name}`")),
    };
    let problem = card.id.clone();
    Ok(Item {
        key: session::key(),
        assignment,
        position,
        problem,
        form,
        points,
        weights,
        repeat: 0,
        digest: None,
        letters: CourseSymbols::default(),
        issue: 0,
        dropped: false,
    })
}

/// Numbers the items that ask the same problem in the same form, since each draws other numbers. One that was pinned keeps its number.
fn number_repeats(items: &mut [Item]) {
    let mut taken: BTreeSet<(String, Option<String>, u32)> = BTreeSet::new();
    let asked = |item: &Item, repeat| (item.problem.clone(), item.form.clone(), repeat);
    taken.extend(items.iter().filter(|item| item.digest.is_some()).map(|item| asked(item, item.repeat)));
    for item in items.iter_mut().filter(|item| item.digest.is_none()) {
        item.repeat = (0..=u32::MAX).find(|repeat| taken.insert(asked(item, *repeat))).unwrap_or(0);
    }
}

/// Whether a row asks what its item does.
fn is_same(item: &Item, row: &Row) -> bool {
    item.problem == row.problem && item.form.as_deref().unwrap_or_default() == row.form.trim()
}
