//! The courses of whoever has signed in, and what lets that person in: a password, and an address.

use serde::Serialize;

use momentous_store::{Reach, TicketKind};

use super::mail::AddressForm;
use super::outcome::NotShown;
use super::password;
use super::reply::Reply;
use super::session;
use super::tries;
use super::visit::Visit;

#[derive(Serialize)]
struct CoursesPage {
    title: &'static str,
    courses: Vec<OwnCourse>,
    /// Whether whoever asks signed in by the link of one course.
    in_one_course: bool,
    /// The form for a password, where whoever asks may choose one.
    password: Option<PasswordForm>,
    /// The form for an address, where whoever asks may set one.
    mail: Option<AddressForm>,
}

#[derive(Serialize)]
struct PasswordForm {
    /// Whether there is a password.
    is_there: bool,
    needs_old: bool,
    /// The fault of a new one.
    fault: Option<String>,
    changed: bool,
}

#[derive(Serialize)]
struct OwnCourse {
    key: String,
    title: String,
    role: &'static str,
}

/// The fault of a form of the page.
#[derive(Default)]
struct FormFaults {
    password: Option<String>,
    address: Option<String>,
}

/// The courses of whoever has signed in.
pub(super) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    with(visit, FormFaults::default()).await
}

/// The same page, with what is wrong with a new address.
pub(super) async fn with_address_fault(visit: &Visit, fault: String) -> Result<Reply, NotShown> {
    with(visit, FormFaults { address: Some(fault), ..FormFaults::default() }).await.map(Reply::wrong)
}

async fn with(visit: &Visit, faults: FormFaults) -> Result<Reply, NotShown> {
    let visitor = visit.visitor()?;
    let courses = visitor.places(visit.store()).await?.into_iter().map(|membership| OwnCourse {
        key: membership.course.key.to_string(),
        title: membership.course.title,
        role: membership.member.role.name(),
    });
    let courses = courses.collect();
    let (mut password, mut mail) = (None, None);
    if may_change_sign_in(visit).await? {
        let is_there = visit.store().password(visitor.person.key).await?.is_some();
        let needs_old = is_there && visitor.reach != Reach::Anew;
        let changed = faults.password.is_none() && visit.fields.get("password").is_some();
        password = Some(PasswordForm { is_there, needs_old, fault: faults.password, changed });
        mail = AddressForm::of(visit, needs_old, faults.address).await?;
    }
    let in_one_course = matches!(visitor.reach, Reach::Course(_));
    visit.page("courses/courses", CoursesPage { title: "Courses", courses, in_one_course, password, mail }).await
}

/// Whether the session lets its holder change what signs the person in: not where it is of one course, and the person is known outside
/// that.
async fn may_change_sign_in(visit: &Visit) -> Result<bool, NotShown> {
    let visitor = visit.visitor()?;
    let Reach::Course(own_course) = visitor.reach else { return Ok(true) };
    let places = visit.store().courses_of(visitor.person.key).await?;
    // What the session shows of the person leaves out that it runs the server.
    let runs = visit.store().person(visitor.person.key).await?.is_none_or(|person| person.operator);
    Ok(!runs && places.iter().all(|place| place.course.key == own_course))
}

/// Refuses a session that may not change what signs its holder in.
pub(super) async fn owner(visit: &Visit) -> Result<(), NotShown> {
    let message = "you signed in by the link of one course and take part in others, too; whoever runs the server makes a link with \
        which you choose a password";
    if may_change_sign_in(visit).await? { Ok(()) } else { Err(NotShown::Forbidden(message)) }
}

/// Whether the field `old` holds the password of whoever has signed in. A session by which the person gets a new one asks for none.
pub(super) async fn knows_password(visit: &Visit) -> Result<bool, NotShown> {
    let (person, reach) = (visit.person()?, visit.visitor()?.reach);
    tries::password(visit, &person.login).await?;
    let kept = visit.store().password(person.key).await?.filter(|_| reach != Reach::Anew);
    let Some(kept) = kept else { return Ok(true) };
    let old = visit.fields.text("old").to_owned();
    visit.work(move |_| Ok(password::is_right(&old, &kept))).await
}

/// A new password. Every session and link of the person ends, but for a new session here.
pub(super) async fn change_password(visit: &Visit) -> Result<Reply, NotShown> {
    owner(visit).await?;
    let person = visit.person()?;
    let (new, again) = (visit.fields.text("new").to_owned(), visit.fields.text("again"));
    let mut fault = password::fault(&new, again, &person.login);
    if fault.is_none() && !knows_password(visit).await? {
        fault = Some("the old password is not right".to_owned());
    }
    if fault.is_some() {
        return with(visit, FormFaults { password: fault, ..FormFaults::default() }).await.map(Reply::wrong);
    }
    let hash = visit.work(move |_| Ok(password::hash(&new))).await?;
    let hash = hash.ok_or_else(|| NotShown::field("the password cannot be kept; take another"))?;
    let (token, ticket) = session::token(person.key, (TicketKind::Session, Reach::All), visit.now);
    let entries = visit.entries(person.key, "password changed").await?;
    visit.store().set_password(person.key, hash, Some(ticket), &entries).await?;
    Ok(Reply::signed_in(visit.address("/courses?password=changed"), token))
}
