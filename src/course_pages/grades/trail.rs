//! The trail of a course: who did what.

use std::collections::BTreeMap;
use std::collections::btree_map;

use serde::Serialize;

use momentous_course::Moment;
use momentous_exercise::calls::Refused;
use momentous_pages::words;
use momentous_problem::is_digest;
use momentous_store::{Entry, Membership};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::titles::Titles;
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

/// The trail of a course, the latest first.
pub(crate) async fn trail(visit: &Visit) -> Result<Reply, NotShown> {
    let course = visit.course()?;
    let members = visit.store().members(course.key).await?;
    let mut names: BTreeMap<_, _> =
        members.iter().map(|membership| (membership.person.key, membership.person.shown().to_owned())).collect();
    let entries = visit.store().trail(course.key, MOST + 1).await?;
    for by in entries.iter().filter_map(|entry| entry.by) {
        // Operators need not be members.
        if let btree_map::Entry::Vacant(unnamed) = names.entry(by) {
            let person = visit.store().person(by).await?;
            unnamed.insert(person.map_or_else(|| "(unknown)".to_owned(), |person| person.shown().to_owned()));
        }
    }
    let called = called(visit, &members).await?;
    let is_cut = entries.len() > MOST as usize;
    let (zone, titles) = (course.zone.clone(), Titles::of(visit).await?);
    let shown = visit.work(move |app| {
        let shown = |entry: Entry| {
            Ok(EntryShown {
                at: entry.at.shown(&zone),
                by: entry.by.and_then(|by| names.get(&by).cloned()).unwrap_or_else(|| "the program".to_owned()),
                what: entry.what,
                detail: said(&entry.detail, &called, &zone, |word| titles.known(app, word))?,
            })
        };
        entries.into_iter().take(MOST as usize).map(shown).collect()
    });
    let page = TrailPage { title: words::HISTORY, most: MOST, is_cut, entries: shown.await? };
    visit.page("courses/grades/trail", page).await
}

/// What people call that which has a key in the trail: members and assignments, by their keys.
async fn called(visit: &Visit, members: &[Membership]) -> Result<BTreeMap<String, String>, NotShown> {
    let people =
        members.iter().map(|membership| (membership.member.key.to_string(), membership.person.shown().to_owned()));
    let assignments = visit.store().assignments(visit.course()?.key).await?;
    let assignments = assignments.into_iter().map(|assignment| (assignment.key.to_string(), assignment.title));
    Ok(people.chain(assignments).collect())
}

/// A detail as people read it: names in place of keys, titles in place of the problems' identities, moments in the zone of the course, and
/// no digest of a file.
fn said(
    detail: &str,
    called: &BTreeMap<String, String>,
    zone: &str,
    title: impl Fn(&str) -> Result<Option<String>, Refused>,
) -> Result<String, Refused> {
    let mut said: Vec<String> = Vec::new();
    // Behind a colon stand a reason and other words of people.
    let mut is_head = true;
    for word in detail.split(' ') {
        let bare = word.trim_end_matches([':', ',', '.', ';']);
        let mark = word.strip_prefix(bare).unwrap_or_default();
        if let Some(name) = called.get(bare) {
            said.push(format!("{name}{mark}"));
        } else if is_head && is_digest(bare) {
            if let Some(before) = said.last_mut() {
                before.push_str(mark);
            }
        } else if let Some(title) = title(bare)? {
            said.push(format!("{title}{mark}"));
        } else if let Ok(at) = bare.parse::<Moment>() {
            said.push(format!("{}{mark}", at.shown(zone)));
        } else {
            said.push(word.to_owned());
        }
        is_head &= !word.ends_with(':');
    }
    Ok(said.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_by_name_is_named_and_a_reason_stays_as_it_was_typed() {
        let called = BTreeMap::from([("0a".to_owned(), "Ada".to_owned())]);
        let title = |word: &str| Ok((word == "class/carts").then(|| "Two carts".to_owned()));
        let cases = [
            ("member 0a, class/carts: 3", "member Ada, Two carts: 3"),
            ("class/carts 0123456789abcdef 0123456789abcdee: once more", "Two carts: once more"),
            ("class/carts: and/or 0123456789abcdef", "Two carts: and/or 0123456789abcdef"),
            ("0a until 2025-12-01T08:00:00Z, closes", "Ada until Mon, 1 Dec 2025, 09:00, closes"),
        ];
        for (detail, text) in cases {
            assert_eq!(said(detail, &called, "Europe/Berlin", title).unwrap(), text);
        }
    }
}
