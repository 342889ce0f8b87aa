//! People who are let in from outside the pages: by whoever has the data.

use momentous_course::{MailAddress, Moment, Person};
use momentous_store::{Entry, Membership, Reach, Store, StoreFault, TicketKind};

use super::clock::Clock;
use super::session;

/// Adds a person, and gives the path of a link with which it signs in; nothing where the name is taken.
///
/// # Errors
/// Where the database refuses.
pub async fn add(
    store: &Store,
    login: &str,
    name: &str,
    operator: bool,
    clock: &Clock,
) -> Result<Option<String>, StoreFault> {
    let now = clock.now();
    let person = Person { key: session::key(), login: login.to_owned(), name: name.to_owned(), operator, erased: None };
    match store.add_people(std::slice::from_ref(&person), &entry(now, "person added")).await {
        Err(fault) if fault.is_taken() => Ok(None),
        added => {
            added?;
            Ok(Some(link_for(store, &person, now).await?))
        }
    }
}

/// The path of a new link for a person; nothing where nobody has the name.
///
/// # Errors
/// Where the database refuses.
pub async fn link(store: &Store, login: &str, clock: &Clock) -> Result<Option<String>, StoreFault> {
    let now = clock.now();
    match store.person_named(login).await? {
        Some(person) => Ok(Some(link_for(store, &person, now).await?)),
        None => Ok(None),
    }
}

/// Gives a person an e-mail address, or takes it away; says whether somebody has the name.
///
/// # Errors
/// Where the database refuses.
pub async fn set_address(
    store: &Store,
    login: &str,
    address: Option<&MailAddress>,
    clock: &Clock,
) -> Result<bool, StoreFault> {
    let Some(person) = store.person_named(login).await? else { return Ok(false) };
    let entries = entries(store, &person, clock.now(), ADDRESS).await?;
    store.set_mail_address(person.key, address, &entries).await?;
    Ok(true)
}

async fn link_for(store: &Store, person: &Person, now: Moment) -> Result<String, StoreFault> {
    let (token, ticket) = session::token(person.key, (TicketKind::Link, Reach::Anew), now);
    let entries = entries(store, person, now, LINK).await?;
    store.add_tickets(vec![ticket], now, &entries).await?;
    Ok(format!("/sign-in/{token}"))
}

/// What the trail calls a link that whoever runs the server made.
const LINK: &str = "link created by the operator";
/// What it calls an address that whoever runs the server set.
pub(super) const ADDRESS: &str = "e-mail address set by the operator";

/// The entries for something that happens to a person: in the trail of each course of that person, and in the server's.
async fn entries(store: &Store, person: &Person, now: Moment, what: &str) -> Result<Vec<Entry>, StoreFault> {
    let courses = store.courses_of(person.key).await?.into_iter();
    let in_course = |place: Membership| Entry {
        course: Some(place.course.key),
        detail: format!("member {}", place.member.key),
        ..entry(now, what)
    };
    Ok(courses.map(in_course).chain([entry(now, what)]).collect())
}

fn entry(at: Moment, what: &str) -> Entry {
    Entry { key: session::key(), at, by: None, course: None, what: what.to_owned(), detail: String::new() }
}
