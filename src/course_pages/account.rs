//! Signing in and out.

use std::time::Duration;

use serde::Serialize;
use tokio::time::Instant;
use tokio::time::sleep_until;

use momentous_course::{Key, Person};
use momentous_store::{Entry, Reach, TicketKind};

use super::cookie::Cookie;
use super::outcome::NotShown;
use super::password;
use super::reply::Reply;
use super::session;
use super::tries;
use super::visit::Visit;

/// The bytes of the longest name by which anybody signs in.
pub(super) const LONGEST_LOGIN: usize = 200;
/// After how long a name or password that is not right is refused: longer than a password takes to compare, so that nobody learns by a
/// watch which names there are.
const REFUSED_AFTER: Duration = Duration::from_secs(1);

#[derive(Serialize)]
struct SignInPage {
    title: &'static str,
    login: String,
    to: String,
    wrong: bool,
    /// The form for a link by mail, where this server sends mail.
    mail: Option<MailForm>,
}

#[derive(Serialize)]
struct MailForm {
    address: String,
    fault: Option<String>,
}

impl SignInPage {
    fn new(visit: &Visit, login: String) -> Self {
        let to = visit.fields.text("to").to_owned();
        let mail = visit.courses.post.is_some().then(|| MailForm { address: String::new(), fault: None });
        Self { title: "Sign in", login, to, wrong: false, mail }
    }
}

/// The address to which somebody goes after signing in: a page of this server, and no other site.
pub(super) fn onward(visit: &Visit) -> String {
    // Browsers take `\\` for `/`, and leave out tabs and ends of lines.
    let leads_away = |to: &str| to.starts_with("//") || to.contains(|sign: char| sign == '\\' || sign.is_control());
    let to = visit.fields.get("to").filter(|to| to.starts_with('/') && !leads_away(to));
    visit.address(to.unwrap_or("/courses"))
}

pub(super) async fn sign_in_page(visit: &Visit) -> Result<Reply, NotShown> {
    if visit.visitor.is_some() {
        return Ok(Reply::To(onward(visit)));
    }
    visit.page("courses/sign-in", SignInPage::new(visit, String::new())).await
}

/// The same page, with what is wrong with the address to which a link should be sent.
pub(super) async fn sign_in_page_with(visit: &Visit, fault: String) -> Result<Reply, NotShown> {
    let mail = Some(MailForm { address: visit.fields.text("address").to_owned(), fault: Some(fault) });
    let page = SignInPage { mail, ..SignInPage::new(visit, String::new()) };
    visit.page("courses/sign-in", page).await.map(Reply::wrong)
}

/// By name and password. Whether the name or the password is wrong is not told. A name that nobody has costs no processor's time.
pub(super) async fn sign_in(visit: &Visit) -> Result<Reply, NotShown> {
    let refused_at = Instant::now() + REFUSED_AFTER;
    let login = visit.fields.text("login").trim();
    let person = if login.len() <= LONGEST_LOGIN { let_in(visit, login).await? } else { None };
    let Some(person) = person else {
        sleep_until(refused_at).await;
        let login = if login.len() <= LONGEST_LOGIN { login.to_owned() } else { String::new() };
        let page = SignInPage { wrong: true, ..SignInPage::new(visit, login) };
        return visit.page("courses/sign-in", page).await.map(Reply::wrong);
    };
    let (token, ticket) = session::token(person.key, (TicketKind::Session, Reach::All), visit.now);
    visit.store().add_tickets(vec![ticket], visit.now, &[]).await?;
    Ok(Reply::signed_in(onward(visit), token))
}

/// The person of that name, where the password is right.
async fn let_in(visit: &Visit, login: &str) -> Result<Option<Person>, NotShown> {
    tries::password(visit, login).await?;
    let Some(person) = visit.store().person_named(login).await? else { return Ok(None) };
    let Some(kept) = visit.store().password(person.key).await? else { return Ok(None) };
    let typed = visit.fields.text("password").to_owned();
    let is_right = visit.work(move |_| Ok(password::is_right(&typed, &kept))).await?;
    Ok(is_right.then_some(person))
}

#[derive(Serialize)]
struct LinkPage {
    title: &'static str,
    /// Whose link it is; nothing where it is used up or has ended.
    name: Option<String>,
    /// The page to which the button leads: `sign-in` for links that somebody gave, `mail` for those that were sent.
    kind: &'static str,
    token: String,
    to: String,
}

/// A link to sign in shows a button: programs that open links in letters do not use it up.
pub(super) async fn link_page(visit: &Visit) -> Result<Reply, NotShown> {
    let token = visit.part("token").to_owned();
    let holder = visit.store().holder(&session::hash(&token), TicketKind::Link, visit.now).await?;
    let name = holder.map(|(person, _)| person.shown().to_owned());
    link_page_with(visit, name, "sign-in").await
}

/// The page of a link, with whom it signs in.
pub(super) async fn link_page_with(visit: &Visit, name: Option<String>, kind: &'static str) -> Result<Reply, NotShown> {
    let (token, to) = (visit.part("token").to_owned(), visit.fields.text("to").to_owned());
    visit.page("courses/link", LinkPage { title: "Sign in", name, kind, token, to }).await
}

/// The entries of the trail about a person who signs in.
pub(super) async fn entries_by(visit: &Visit, person: Key<Person>, what: &str) -> Result<Vec<Entry>, NotShown> {
    let entries = visit.entries(person, what).await?.into_iter();
    Ok(entries.map(|entry| Entry { by: Some(person), ..entry }).collect())
}

/// The button: it works once. A link of a course opens that course.
pub(super) async fn link(visit: &Visit) -> Result<Reply, NotShown> {
    let hash = session::hash(visit.part("token"));
    let holder = visit.store().holder(&hash, TicketKind::Link, visit.now).await?;
    let Some((person, reach)) = holder else { return link_page(visit).await };
    let (token, ticket) = session::token(person.key, (TicketKind::Session, reach), visit.now);
    let entries = entries_by(visit, person.key, "signed in by a link").await?;
    if !visit.store().take_ticket(&hash, Some(ticket), &entries).await? {
        return link_page(visit).await;
    }
    Ok(Reply::signed_in(visit.address("/courses"), token))
}

pub(super) async fn sign_out(visit: &Visit) -> Result<Reply, NotShown> {
    visit.store().take_ticket(&visit.visitor()?.session, None, &[]).await?;
    Ok(Reply::ToWith { to: visit.address("/"), cookie: Cookie::Session, token: None })
}
