//! Who did what in a course.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use serde::Serialize;

use momentous_pages::words;
use momentous_store::Membership;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;

/// The entries that a page shows.
const MOST: u32 = 500;

#[derive(Serialize)]
struct TrailPage {
    title: &'static str,
    most: u32,
    is_cut: bool,
    entries: Vec<EntryShown>,
}

#[derive(Serialize)]
struct EntryShown {
    at: String,
    by: String,
    what: String,
    detail: String,
}

/// What was done in a course, the latest first.
pub(crate) async fn trail(visit: &Visit) -> Result<Reply, NotShown> {
    let course = visit.course()?;
    let members = visit.store().members(course.key).await?;
    let mut names: BTreeMap<_, _> =
        members.iter().map(|membership| (membership.person.key, membership.person.shown().to_owned())).collect();
    let found = visit.store().trail(course.key, MOST + 1).await?;
    for by in found.iter().filter_map(|entry| entry.by) {
        // Operators need not be members.
        if let Entry::Vacant(unnamed) = names.entry(by) {
            let person = visit.store().person(by).await?;
            unnamed.insert(person.map_or_else(|| "(unknown)".to_owned(), |person| person.shown().to_owned()));
        }
    }
    let called = called(visit, &members).await?;
    let shown = found.iter().take(MOST as usize).map(|entry| EntryShown {
        at: entry.at.shown(&course.zone),
        by: entry.by.and_then(|by| names.get(&by).cloned()).unwrap_or_else(|| "the program".to_owned()),
        what: entry.what.clone(),
        detail: named(&entry.detail, &called),
    });
    let page =
        TrailPage { title: words::HISTORY, most: MOST, is_cut: found.len() > MOST as usize, entries: shown.collect() };
    visit.page("courses/grades/trail", page).await
}

/// What people call that which has a key in the trail: members and assignments, by their keys.
async fn called(visit: &Visit, members: &[Membership]) -> Result<Vec<(String, String)>, NotShown> {
    let people =
        members.iter().map(|membership| (membership.member.key.to_string(), membership.person.shown().to_owned()));
    let assignments = visit.store().assignments(visit.course()?.key).await?;
    let assignments = assignments.into_iter().map(|assignment| (assignment.key.to_string(), assignment.title));
    Ok(people.chain(assignments).collect())
}

/// A detail with names in place of keys.
fn named(detail: &str, called: &[(String, String)]) -> String {
    called.iter().fold(detail.to_owned(), |detail, (key, name)| detail.replace(key, name))
}
