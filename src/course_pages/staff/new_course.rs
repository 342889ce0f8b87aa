//! A new course, made by the operator for its first instructor.

use serde::Serialize;

use momentous_course::{Course, Grading, Member, Role, zones};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::course_form;
use super::course_form::{Choice, CourseForm};
use super::form::Form;
use super::links::{LinkPage, link};
use super::person_form;
use super::person_form::Named;

#[derive(Serialize)]
struct NewCoursePage {
    title: &'static str,
    form: Form,
    decimals: Vec<Choice>,
    zones: Vec<String>,
    /// Whether nothing was typed yet, so that the browser's time zone is proposed.
    preset: bool,
}

/// The form.
pub(crate) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    let empty = course_form::FIELDS.into_iter().chain(person_form::FIELDS).map(|name| (name, String::new()));
    // Whoever makes a course mostly teaches it.
    let login = visit.visitor.as_ref().map(|visitor| visitor.person.login.clone()).unwrap_or_default();
    let usual = [("zone", "UTC".to_owned()), ("decimal", "either".to_owned()), ("login", login)];
    with(visit, Form::new(empty.chain(usual))).await
}

async fn with(visit: &Visit, form: Form) -> Result<Reply, NotShown> {
    let is_wrong = form.is_wrong();
    let (decimals, zones) = (course_form::decimals(), zones());
    let page = NewCoursePage { title: "New course", form, decimals, zones, preset: !is_wrong };
    let page = visit.page("courses/staff/new-course", page).await?;
    Ok(if is_wrong { page.wrong() } else { page })
}

/// Makes the course, with a secret of its own, and opens it where its instructor is the one who makes it. Another signs in by a link where
/// there is no password yet.
pub(crate) async fn make(visit: &Visit) -> Result<Reply, NotShown> {
    let names: Vec<&str> = course_form::FIELDS.into_iter().chain(person_form::FIELDS).collect();
    let form = Form::sent(visit, &names);
    let mut faults = person_form::faults(&form);
    let read = match CourseForm::read(&form) {
        Ok(read) if faults.is_empty() => read,
        read => {
            faults.extend(read.err().unwrap_or_default());
            return with(visit, form.with(&faults)).await;
        }
    };
    let Named { person, is_new } = person_form::named(visit, &form).await?;
    let CourseForm { title, zone, decimal, retention_days } = read;
    let (key, secret, created) = (session::key(), session::secret(), visit.now);
    let grading = Grading::default();
    let course = Course { key, title, zone, decimal, secret, retention_days, grading, created };
    let first = Member {
        key: session::key(),
        course: key,
        person: person.key,
        role: Role::Instructor,
        section: String::new(),
        left: None,
    };
    if is_new {
        let entry = visit.entry("person added", person.key.to_string());
        person_form::unless_taken(visit.store().add_people(std::slice::from_ref(&person), &entry).await)?;
    }
    visit.store().add_course(&course, &first, &visit.entry("course created", key.to_string())).await?;
    if visit.visitor.as_ref().is_some_and(|visitor| visitor.person.key == person.key) {
        return Ok(Reply::To(visit.address(&format!("/courses/{key}"))));
    }
    let link = match visit.store().password(person.key).await? {
        Some(_) => None,
        None => Some(link(visit, &person).await?),
    };
    LinkPage::new(visit, "Course created", &person, link, visit.address("/people")).reply(visit).await
}
