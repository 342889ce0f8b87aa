//! Signing in and out, and the courses of whoever did.

use std::time::Duration;

use serde::Serialize;
use tokio::time::Instant;
use tokio::time::sleep_until;

use momentous_course::Person;
use momentous_store::{Entry, Reach, TicketKind};

use super::outcome::NotShown;
use super::password;
use super::reply::Reply;
use super::session;
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
}

/// Where somebody goes after signing in: a page of this server, and no other site.
fn onward(visit: &Visit) -> String {
    // Browsers take `\\` for `/`, and leave out tabs and ends of lines.
    let leads_away = |to: &str| to.starts_with("//") || to.contains(|own: char| own == '\\' || own.is_control());
    let to = visit.fields.get("to").filter(|to| to.starts_with('/') && !leads_away(to));
    visit.address(to.unwrap_or("/courses"))
}

pub(super) async fn sign_in_page(visit: &Visit) -> Result<Reply, NotShown> {
    if visit.visitor.is_some() {
        return Ok(Reply::To(onward(visit)));
    }
    let to = visit.fields.text("to").to_owned();
    visit.page("courses/sign-in", SignInPage { title: "Sign in", login: String::new(), to, wrong: false }).await
}

/// By name and password. Whether the name or the password is wrong is not told. A name that nobody has costs no processor's time.
pub(super) async fn sign_in(visit: &Visit) -> Result<Reply, NotShown> {
    let refused_at = Instant::now() + REFUSED_AFTER;
    let login = visit.fields.text("login").trim();
    let person = if login.len() <= LONGEST_LOGIN { let_in(visit, login).await? } else { None };
    let Some(person) = person else {
        sleep_until(refused_at).await;
        let login = if login.len() <= LONGEST_LOGIN { login.to_owned() } else { String::new() };
        let to = visit.fields.text("to").to_owned();
        let page = visit.page("courses/sign-in", SignInPage { title: "Sign in", login, to, wrong: true }).await?;
        return Ok(page.wrong());
    };
    let (token, ticket) = session::token(person.key, (TicketKind::Session, Reach::All), visit.now);
    visit.store().add_tickets(vec![ticket], visit.now, &[]).await?;
    Ok(Reply::Sign { to: onward(visit), token: Some(token) })
}

/// The person of that name, where the password is right.
async fn let_in(visit: &Visit, login: &str) -> Result<Option<Person>, NotShown> {
    visit.courses.limits.password(visit.from, login)?;
    let Some(person) = visit.store().person_named(login).await? else { return Ok(None) };
    let Some(kept) = visit.store().password(person.key).await? else { return Ok(None) };
    visit.courses.limits.compared(visit.from)?;
    let typed = visit.fields.text("password").to_owned();
    let is_right = visit.work(move |_| Ok(password::is_right(&typed, &kept))).await?;
    Ok(is_right.then_some(person))
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
    let name = holder.map(|(person, _)| person.shown().to_owned());
    visit.page("courses/link", LinkPage { title: "Sign in", name, token }).await
}

/// The button: it works once. A link of a course opens that course.
pub(super) async fn link(visit: &Visit) -> Result<Reply, NotShown> {
    let hash = session::hash(visit.part("token"));
    let holder = visit.store().holder(&hash, TicketKind::Link, visit.now).await?;
    let Some((person, reach)) = holder else { return link_page(visit).await };
    let (token, ticket) = session::token(person.key, (TicketKind::Session, reach), visit.now);
    let entries = visit.entries(person.key, "signed in by a link").await?.into_iter();
    let entries: Vec<Entry> = entries.map(|entry| Entry { by: Some(person.key), ..entry }).collect();
    if !visit.store().take_ticket(&hash, Some(ticket), &entries).await? {
        return link_page(visit).await;
    }
    Ok(Reply::Sign { to: visit.address("/courses"), token: Some(token) })
}

pub(super) async fn sign_out(visit: &Visit) -> Result<Reply, NotShown> {
    visit.store().take_ticket(&visit.visitor()?.session, None, &[]).await?;
    Ok(Reply::Sign { to: visit.address("/"), token: None })
}

#[derive(Serialize)]
struct CoursesPage {
    title: &'static str,
    courses: Vec<OwnCourse>,
    /// Whether whoever asks signed in by the link of one course.
    in_one_course: bool,
    /// The form for a password, where whoever asks may choose one.
    password: Option<PasswordForm>,
    /// What is wrong with a new password.
    fault: Option<String>,
    changed: bool,
}

#[derive(Serialize)]
struct PasswordForm {
    /// Whether there is a password.
    is_there: bool,
    needs_old: bool,
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
    let visitor = visit.visitor()?;
    let courses = visitor.places(visit.store()).await?.into_iter().map(|own| OwnCourse {
        key: own.course.key.to_string(),
        title: own.course.title,
        role: own.member.role.name(),
    });
    let courses = courses.collect();
    let is_there = visit.store().password(visitor.person.key).await?.is_some();
    let password = PasswordForm { is_there, needs_old: is_there && visitor.reach != Reach::Anew };
    let password = may_choose_password(visit).await?.then_some(password);
    let in_one_course = matches!(visitor.reach, Reach::Course(_));
    let page = CoursesPage { title: "Courses", courses, in_one_course, password, fault, changed };
    visit.page("courses/courses", page).await
}

/// Whether the session lets its holder choose a password: not where it is of one course, and the person is known outside that.
async fn may_choose_password(visit: &Visit) -> Result<bool, NotShown> {
    let visitor = visit.visitor()?;
    let Reach::Course(own) = visitor.reach else { return Ok(true) };
    let places = visit.store().courses_of(visitor.person.key).await?;
    // What the session shows of the person leaves out that it runs the server.
    let runs = visit.store().person(visitor.person.key).await?.is_none_or(|person| person.operator);
    Ok(!runs && places.iter().all(|place| place.course.key == own))
}

/// A new password. Every session and link of the person ends, but for a new session here.
pub(super) async fn password(visit: &Visit) -> Result<Reply, NotShown> {
    let (person, reach) = (visit.person()?, visit.visitor()?.reach);
    if !may_choose_password(visit).await? {
        return Err(NotShown::Forbidden(
            "you signed in by the link of one course and take part in others, too; whoever runs the server makes a link with which you choose a password",
        ));
    }
    visit.courses.limits.password(visit.from, &person.login)?;
    let kept = visit.store().password(person.key).await?.filter(|_| reach != Reach::Anew);
    let field = |name: &str| visit.fields.text(name).to_owned();
    let (old, new, again) = (field("old"), field("new"), field("again"));
    let fault = match (password::fault(&new, &again, &person.login), kept) {
        (Some(fault), _) => Some(fault),
        (None, None) => None,
        (None, Some(kept)) => {
            let is_right = visit.work(move |_| Ok(password::is_right(&old, &kept))).await?;
            (!is_right).then(|| "the old password is not right".to_owned())
        }
    };
    if fault.is_some() {
        return Ok(courses_with(visit, fault, false).await?.wrong());
    }
    let hash = visit.work(move |_| Ok(password::hash(&new))).await?;
    let hash = hash.ok_or_else(|| NotShown::field("the password cannot be kept; take another"))?;
    let (token, ticket) = session::token(person.key, (TicketKind::Session, Reach::All), visit.now);
    let entries = visit.entries(person.key, "password changed").await?;
    visit.store().set_password(person.key, hash, Some(ticket), &entries).await?;
    Ok(Reply::Sign { to: visit.address("/courses?password=changed"), token: Some(token) })
}
