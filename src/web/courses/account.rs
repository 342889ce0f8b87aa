//! Signing in and out, and the courses of whoever did.

use serde::Serialize;

use crate::store::TicketKind;

use super::outcome::NotShown;
use super::password;
use super::reply::Reply;
use super::session;
use super::visit::Visit;

#[derive(Serialize)]
struct SignInPage {
    title: &'static str,
    login: String,
    to: String,
    wrong: bool,
}

/// Where somebody goes after signing in: a page of this server, and no other site.
fn onward(visit: &Visit) -> String {
    // Browsers take `\\` for `/`, and leave out tabs and ends of lines.
    let leads_away = |to: &str| to.starts_with("//") || to.contains(|own: char| own == '\\' || own.is_control());
    let to = visit.fields.get("to").filter(|to| to.starts_with('/') && !leads_away(to));
    visit.address(to.unwrap_or("/courses"))
}

pub(super) async fn sign_in_page(visit: &Visit) -> Result<Reply, NotShown> {
    if visit.person.is_some() {
        return Ok(Reply::To(onward(visit)));
    }
    let to = visit.fields.text("to").to_owned();
    visit.page("courses/sign-in", SignInPage { title: "Sign in", login: String::new(), to, wrong: false }).await
}

/// By name and password. Whether the name or the password is wrong is not told.
pub(super) async fn sign_in(visit: &Visit) -> Result<Reply, NotShown> {
    let login = visit.fields.text("login").trim().to_owned();
    visit.courses.limits.password(&login)?;
    let person = visit.store().person_named(&login).await?;
    let kept = match &person {
        Some(person) => visit.store().password(person.key).await?,
        None => None,
    };
    let typed = visit.fields.text("password").to_owned();
    let is_right = visit.work(move |_| Ok(password::is_right(&typed, kept.as_deref()))).await?;
    match person.filter(|_| is_right) {
        Some(person) => {
            let (token, ticket) = session::token(person.key, TicketKind::Session, visit.now);
            visit.store().add_tickets(vec![ticket], visit.now, None).await?;
            Ok(Reply::Sign { to: onward(visit), token: Some(token) })
        }
        None => {
            let to = visit.fields.text("to").to_owned();
            let page = visit.page("courses/sign-in", SignInPage { title: "Sign in", login, to, wrong: true }).await?;
            Ok(page.wrong())
        }
    }
}

#[derive(Serialize)]
struct LinkPage {
    title: &'static str,
    /// Whose link it is; nothing where it is used up or has ended.
    name: Option<String>,
    token: String,
}

/// A link to sign in shows a button: programs that open links in letters do not use it up.
pub(super) async fn link_page(visit: &Visit) -> Result<Reply, NotShown> {
    let token = visit.part("token").to_owned();
    let holder = visit.store().holder(&session::hash(&token), TicketKind::Link, visit.now).await?;
    let name = holder.map(|person| person.shown().to_owned());
    visit.page("courses/link", LinkPage { title: "Sign in", name, token }).await
}

/// The button: it works once.
pub(super) async fn link(visit: &Visit) -> Result<Reply, NotShown> {
    let hash = session::hash(visit.part("token"));
    let holder = visit.store().holder(&hash, TicketKind::Link, visit.now).await?;
    let Some(person) = holder else { return link_page(visit).await };
    if !visit.store().take_ticket(&hash).await? {
        return link_page(visit).await;
    }
    let (token, ticket) = session::token(person.key, TicketKind::Session, visit.now);
    visit.store().add_tickets(vec![ticket], visit.now, None).await?;
    Ok(Reply::Sign { to: visit.address("/courses"), token: Some(token) })
}

pub(super) async fn sign_out(visit: &Visit) -> Result<Reply, NotShown> {
    if let Some(hash) = &visit.session {
        visit.store().take_ticket(hash).await?;
    }
    Ok(Reply::Sign { to: visit.address("/"), token: None })
}

#[derive(Serialize)]
struct CoursesPage {
    title: &'static str,
    courses: Vec<OwnCourse>,
    has_password: bool,
    /// What is wrong with a new password.
    fault: Option<String>,
    changed: bool,
}

#[derive(Serialize)]
struct OwnCourse {
    key: String,
    title: String,
    role: &'static str,
}

/// The courses of whoever has signed in.
pub(super) async fn courses(visit: &Visit) -> Result<Reply, NotShown> {
    courses_with(visit, None, visit.fields.get("password").is_some()).await
}

async fn courses_with(visit: &Visit, fault: Option<String>, changed: bool) -> Result<Reply, NotShown> {
    let person = visit.person()?.key;
    let all = visit.store().courses_of(person).await?;
    let courses = all.into_iter().map(|own| OwnCourse {
        key: own.course.key.to_string(),
        title: own.course.title,
        role: own.member.role.name(),
    });
    let has_password = visit.store().password(person).await?.is_some();
    let page = CoursesPage { title: "Courses", courses: courses.collect(), has_password, fault, changed };
    visit.page("courses/courses", page).await
}

/// A new password. Every session of the person ends, but for a new one here.
pub(super) async fn password(visit: &Visit) -> Result<Reply, NotShown> {
    let person = visit.person()?;
    let field = |name: &str| visit.fields.text(name).to_owned();
    visit.courses.limits.password(&person.login)?;
    let kept = visit.store().password(person.key).await?;
    let (old, new, again) = (field("old"), field("new"), field("again"));
    let fault = match password::fault(&new, &again) {
        Some(fault) => Some(fault),
        None if kept.is_none() => None,
        None => {
            let is_right = visit.work(move |_| Ok(password::is_right(&old, kept.as_deref()))).await?;
            (!is_right).then(|| "the old password is not right".to_owned())
        }
    };
    if fault.is_some() {
        return Ok(courses_with(visit, fault, false).await?.wrong());
    }
    let hash = visit.work(move |_| Ok(password::hash(&new))).await?;
    let hash = hash.ok_or_else(|| NotShown::field("the password cannot be kept; take another"))?;
    visit.store().set_password(person.key, hash, &visit.entry("password changed", "")).await?;
    let (token, ticket) = session::token(person.key, TicketKind::Session, visit.now);
    visit.store().add_tickets(vec![ticket], visit.now, None).await?;
    Ok(Reply::Sign { to: visit.address("/courses?password=changed"), token: Some(token) })
}
