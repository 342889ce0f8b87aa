//! Data about one member of a course: shown, handed over, and erased.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course::{Draft, Key, Override, Person, Role, Sheet, StudentData, Window};
use momentous_store::Membership;

use super::super::at_close;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::class::{self, HandedInSheet, reports};

#[derive(Serialize)]
struct MemberPage {
    title: String,
    member: String,
    login: String,
    role: &'static str,
    section: String,
    left: Option<String>,
    erased: Option<String>,
    sheets: usize,
    /// Whether who looks may erase, and why not.
    erases: bool,
    fault: Option<String>,
}

/// A member as those who teach see it.
pub(crate) async fn member(visit: &Visit) -> Result<Reply, NotShown> {
    page(visit, &class::member(visit).await?, None).await
}

async fn page(visit: &Visit, membership: &Membership, fault: Option<String>) -> Result<Reply, NotShown> {
    let zone = visit.course()?.zone.as_str();
    let Membership { member, person, .. } = membership;
    let page = MemberPage {
        title: person.shown().to_owned(),
        member: member.key.to_string(),
        login: person.login.clone(),
        role: member.role.name(),
        section: member.section.clone(),
        left: member.left.map(|left| left.shown(zone)),
        erased: person.erased.map(|erased| erased.shown(zone)),
        sheets: visit.store().sheets_of(member.key).await?.len(),
        erases: person.erased.is_none(),
        fault,
    };
    visit.page("courses/grades/member", page).await
}

/// Everything that is kept about a member in this course, as JSON. Students take their own.
pub(crate) async fn data(visit: &Visit) -> Result<Reply, NotShown> {
    let place = visit.place()?;
    if place.member.role != Role::Instructor && place.member.key.to_string() != visit.part("member") {
        return Err(NotShown::missing("you have no such data in this course"));
    }
    let membership = class::member(visit).await?;
    let store = visit.store();
    let mut windows = BTreeMap::new();
    let extensions = store.extensions_of(membership.member.key).await?;
    let (mut items, mut by_hand): (BTreeMap<_, _>, Vec<Override>) = Default::default();
    for assignment in store.assignments(place.course.key).await? {
        let extension = extensions.iter().find(|extension| extension.assignment == assignment.key);
        let window = Window::of(&assignment.policy, extension, &place.course.zone);
        windows.insert(assignment.key, window);
        by_hand.extend(store.set_by_hand(assignment.key).await?);
        let whole = store.assignment(assignment.key).await?;
        if let Some(whole) = &whole {
            at_close::hand_in(visit, whole, Some(membership.member.key)).await?;
        }
        items.extend(whole.into_iter().flat_map(|assignment| assignment.items).map(|item| (item.key, item.assignment)));
    }
    let (mut sheets, mut drafts): (Vec<(HandedInSheet, Vec<Override>)>, Vec<Draft>) = Default::default();
    for sheet in store.sheets_of(membership.member.key).await? {
        let window = items.get(&sheet.item).and_then(|assignment| windows.get(assignment));
        let Some(window) = window.cloned() else { continue };
        let (attempts, hints) = (store.attempts(sheet.key).await?, store.hints(sheet.key).await?);
        drafts.extend(store.draft(sheet.key).await?);
        let by_hand = of_sheet(&by_hand, sheet.key);
        sheets.push((HandedInSheet { reports: reports(&attempts)?, sheet, attempts, hints, window }, by_hand));
    }
    let worked: Vec<_> = sheets.iter().map(|(kept, by_hand)| (kept.worked(), by_hand.clone())).collect();
    let people = (&place.course, &membership.member, &membership.person);
    let data = StudentData::of(people, &worked, &extensions, &drafts, visit.now);
    let bytes = serde_json::to_vec_pretty(&data).map_err(|error| NotShown::Store(error.into()))?;
    Ok(Reply::Download { name: "data.json".to_owned(), kind: "application/json", bytes })
}

fn of_sheet(all: &[Override], sheet: Key<Sheet>) -> Vec<Override> {
    all.iter().filter(|decision| decision.sheet == sheet).cloned().collect()
}

/// Forgets who a member is. What was handed in stays under a random key, so that the marks of the class remain.
pub(crate) async fn erase(visit: &Visit) -> Result<Reply, NotShown> {
    let membership = class::member(visit).await?;
    let is_operator = visit.person()?.operator;
    let elsewhere = visit.store().courses_of(membership.person.key).await?.len() > 1;
    let typed = visit.fields.text("login").trim();
    let fault = match () {
        () if membership.person.erased.is_some() => Some("this name is erased already"),
        () if membership.person.key == visit.person()?.key => Some("nobody erases their own name"),
        () if (elsewhere || membership.person.operator) && !is_operator => Some(
            "this person takes part in other courses or runs the server, so that only an operator who is in this course may do it",
        ),
        () if typed != membership.person.login => {
            Some("type the name by which this person signs in, to say that you mean it")
        }
        () => None,
    };
    if let Some(fault) = fault {
        return Ok(page(visit, &membership, Some(fault.to_owned())).await?.wrong());
    }
    let erased = Person {
        login: String::new(),
        name: String::new(),
        operator: false,
        erased: Some(visit.now),
        key: membership.person.key,
    };
    let entries = visit.entries(membership.person.key, "name erased").await?;
    visit.store().erase_person(&erased, &entries).await?;
    Ok(Reply::To(visit.in_course(&format!("/members/{}", membership.member.key))?))
}
