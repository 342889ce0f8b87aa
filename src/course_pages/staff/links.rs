//! Links with which people sign in, shown once to whoever made them.

use serde::Serialize;

use momentous_course::Person;
use momentous_store::{Entry, Reach, TicketKind};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;

/// The page that shows a link.
#[derive(Serialize)]
pub(super) struct LinkPage {
    /// The title: what was done.
    pub(super) title: &'static str,
    /// For whom or what.
    pub(super) name: String,
    /// The link; nothing where the person signs in as before.
    pub(super) link: Option<String>,
    /// The page from which the reader came, as an address.
    pub(super) back: String,
    /// The course that the link opens; nothing where it opens all that the person may see.
    course: Option<String>,
    /// Whether the link leads to this machine only.
    only_here: bool,
}

impl LinkPage {
    pub(super) fn new(visit: &Visit, title: &'static str, person: &Person, link: Option<String>, back: String) -> Self {
        let course = visit.place.as_ref().map(|place| place.course.title.clone());
        let (name, only_here) = (person.shown().to_owned(), visit.leads_here_only());
        Self { title, name, link, back, course, only_here }
    }

    pub(super) async fn reply(self, visit: &Visit) -> Result<Reply, NotShown> {
        visit.page("courses/staff/link", self).await
    }
}

/// A new link for a person, with the server's name.
pub(super) async fn link(visit: &Visit, person: &Person) -> Result<String, NotShown> {
    Ok(links(visit, std::slice::from_ref(person)).await?.pop().unwrap_or_default())
}

/// A new link for each person, in their order. Earlier ones end. From the pages of a course a link opens that course alone.
pub(super) async fn links(visit: &Visit, people: &[Person]) -> Result<Vec<String>, NotShown> {
    let course = visit.place.as_ref().map(|place| place.course.key);
    let reach = course.map_or(Reach::Anew, Reach::Course);
    let links = people.iter().map(|person| session::token(person.key, (TicketKind::Link, reach), visit.now));
    let (tokens, tickets): (Vec<String>, Vec<_>) = links.unzip();
    let mut entries = Vec::new();
    match course {
        None => {
            for person in people {
                entries.extend(visit.entries(person.key, "link created by the operator").await?);
            }
        }
        Some(course) => {
            let elsewhere = visit.store().elsewhere(course).await?.into_iter();
            let of_these =
                elsewhere.filter(|membership| people.iter().any(|person| person.key == membership.person.key));
            entries.extend(of_these.map(|membership| {
                let entry = visit.entry("link created in another course", format!("member {}", membership.member.key));
                Entry { course: Some(membership.course.key), ..entry }
            }));
            entries.push(visit.entry("links created", format!("{} links", tokens.len())));
        }
    }
    visit.store().add_tickets(tickets, visit.now, &entries).await?;
    Ok(tokens.into_iter().map(|token| visit.public(&format!("/sign-in/{token}"))).collect())
}
