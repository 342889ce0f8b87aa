//! People who are let in from outside the pages: by whoever has the data.

use momentous_course::{Moment, Person};
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

async fn link_for(store: &Store, person: &Person, now: Moment) -> Result<String, StoreFault> {
    let (token, ticket) = session::token(person.key, (TicketKind::Link, Reach::Anew), now);
    let courses = store.courses_of(person.key).await?.into_iter();
    let in_course = |own: Membership| Entry {
        course: Some(own.course.key),
        detail: format!("member {}", own.member.key),
        ..entry(now, LINK)
    };
    let entries: Vec<Entry> = courses.map(in_course).chain([entry(now, LINK)]).collect();
    store.add_tickets(vec![ticket], now, &entries).await?;
    Ok(format!("/sign-in/{token}"))
}

/// What the trail calls a link that whoever runs the server made.
const LINK: &str = "link made by the operator";

fn entry(at: Moment, what: &str) -> Entry {
    Entry { key: session::key(), at, by: None, course: None, what: what.to_owned(), detail: String::new() }
}
