//! Links with which people sign in, shown once to whoever made them.

use serde::Serialize;

use crate::course::Person;
use crate::store::TicketKind;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;

/// The page that shows a link.
#[derive(Serialize)]
pub(super) struct LinkPage {
    /// What was done.
    pub(super) title: &'static str,
    /// For whom or what.
    pub(super) name: String,
    /// The link; nothing where the person signs in as before.
    pub(super) link: Option<String>,
    /// The page from which the reader came, as an address.
    pub(super) back: String,
}

impl LinkPage {
    pub(super) async fn reply(self, visit: &Visit) -> Result<Reply, NotShown> {
        visit.page("courses/staff/link", self).await
    }
}

/// A new link for a person, with the server's name.
pub(super) async fn link(visit: &Visit, person: &Person) -> Result<String, NotShown> {
    Ok(links(visit, std::slice::from_ref(person)).await?.pop().unwrap_or_default())
}

/// A new link for each person, in their order.
pub(super) async fn links(visit: &Visit, people: &[Person]) -> Result<Vec<String>, NotShown> {
    let made = people.iter().map(|person| session::token(person.key, TicketKind::Link, visit.now));
    let (tokens, tickets): (Vec<String>, Vec<_>) = made.unzip();
    let entry = visit.entry("links made", format!("{} links", tokens.len()));
    visit.store().add_tickets(tickets, visit.now, Some(&entry)).await?;
    Ok(tokens.into_iter().map(|token| visit.public(&format!("/sign-in/{token}"))).collect())
}
