//! Asking for a link by mail, and opening it.

use std::sync::Arc;

use serde::Serialize;

use momentous_course::{MailAddress, Moment, Person};
use momentous_store::{Reach, TicketKind};

use super::super::account;
use super::super::cookie::Cookie;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::state::Courses;
use super::super::tries;
use super::super::visit::Visit;
use super::letter::{Linked, NotSent, Writer, hash};
use super::post::Post;

/// The server of mail, where one is configured.
pub(super) fn post(visit: &Visit) -> Result<&Post, NotShown> {
    visit.courses.post.as_ref().ok_or_else(|| NotShown::missing("this server sends no mail"))
}

/// The token of the browser that asks: the one it has, so that an earlier letter opens, too.
pub(super) fn browser(visit: &Visit) -> String {
    visit.browser.clone().unwrap_or_else(session::secret)
}

/// Sends links to those who have the address of the form. The reply is the same, and as fast, whether somebody has it or nobody.
pub(crate) async fn ask(visit: &Visit) -> Result<Reply, NotShown> {
    let post = post(visit)?.clone();
    let typed = visit.fields.text("address");
    let address = match MailAddress::read(typed) {
        Ok(address) => address,
        Err(fault) => return account::sign_in_page_with(visit, fault.to_string()).await,
    };
    tries::letter(visit, &address).await?;
    let browser = browser(visit);
    let writer = Writer::new(visit, &browser, visit.fields.get("to").filter(|to| !to.is_empty()));
    let (courses, now) = (Arc::clone(&visit.courses), visit.now);
    tokio::spawn(async move {
        let people = match courses.store.people_at(&address).await {
            Ok(people) => people,
            Err(fault) => return eprintln!("momentous serve: {fault}"),
        };
        for person in people {
            let linked = writer.write((person.key, person.shown()), &address);
            match send(&courses, &post, linked, now).await {
                Ok(()) => {}
                Err(NotSent::Store(fault)) => eprintln!("momentous serve: {fault}"),
                Err(NotSent::Refused(reason)) => eprintln!("momentous serve: a letter could not be sent: {reason}"),
            }
        }
    });
    Ok(Reply::ToWith { to: visit.address("/mail"), cookie: Cookie::Browser, token: Some(browser) })
}

/// Keeps the link of a letter, and sends the letter.
pub(super) async fn send(
    courses: &Courses,
    post: &Post,
    Linked { letter, link }: Linked,
    now: Moment,
) -> Result<(), NotSent> {
    courses.store.add_mailed_links(vec![link], now).await.map_err(NotSent::Store)?;
    post.send(letter).await.map_err(NotSent::Refused)
}

#[derive(Serialize)]
struct AskedPage {
    title: &'static str,
}

/// The page after a link was asked for.
pub(crate) async fn asked_page(visit: &Visit) -> Result<Reply, NotShown> {
    post(visit)?;
    visit.page("courses/mailed", AskedPage { title: "Look into your mail" }).await
}

/// Whose link is in the address, where it was sent, and what is kept of it, if this browser asked for it.
async fn holder(visit: &Visit) -> Result<Option<(Person, MailAddress, String)>, NotShown> {
    let Some(browser) = &visit.browser else { return Ok(None) };
    let hash = hash(visit.part("token"), browser);
    let holder = visit.store().mailed_link(&hash, visit.now).await?;
    Ok(holder.map(|(person, address)| (person, address, hash)))
}

/// A page with a button: programs that open links in letters do not use it up.
pub(crate) async fn link_page(visit: &Visit) -> Result<Reply, NotShown> {
    let name = holder(visit).await?.map(|(person, ..)| person.shown().to_owned());
    account::link_page_with(visit, name, "mail").await
}

/// The button: it works once. Whoever reads letters to the address may choose a new password without the old one.
pub(crate) async fn link(visit: &Visit) -> Result<Reply, NotShown> {
    let Some((person, address, hash)) = holder(visit).await? else { return link_page(visit).await };
    let (token, session) = session::token(person.key, (TicketKind::Session, Reach::Anew), visit.now);
    let entries = account::entries_by(visit, person.key, "signed in by a mailed link").await?;
    if !visit.store().take_mailed_link(&hash, &address, session, &entries).await? {
        return link_page(visit).await;
    }
    Ok(Reply::signed_in(account::onward(visit), token))
}
