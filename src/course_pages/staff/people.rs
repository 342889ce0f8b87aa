//! Everybody who can sign in, for the operator.

use serde::Serialize;

use momentous_course::{FieldFault, Person};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::form::Form;
use super::links::{LinkPage, link};
use super::person_form;
use super::person_form::Named;

#[derive(Serialize)]
struct PeoplePage {
    title: &'static str,
    form: Form,
    /// Whether the new person is to be an operator.
    operator: bool,
    people: Vec<Listed>,
}

#[derive(Serialize)]
struct Listed {
    key: String,
    login: String,
    name: String,
    operator: bool,
}

/// Everybody, and a form for one more.
pub(crate) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    with(visit, Form::sent(visit, &person_form::FIELDS)).await
}

async fn with(visit: &Visit, form: Form) -> Result<Reply, NotShown> {
    let is_wrong = form.is_wrong();
    let listed = |Person { key, login, name, operator, .. }| Listed { key: key.to_string(), login, name, operator };
    let people = visit.store().people().await?.into_iter().map(listed).collect();
    let operator = is_wrong && visit.fields.get("operator").is_some();
    let page = visit.page("courses/staff/people", PeoplePage { title: "People", form, operator, people }).await?;
    Ok(if is_wrong { page.wrong() } else { page })
}

/// Adds a person, and shows the link with which it signs in.
pub(crate) async fn add(visit: &Visit) -> Result<Reply, NotShown> {
    let form = Form::sent(visit, &person_form::FIELDS);
    let mut faults = person_form::faults(&form);
    let Named { person, is_new } = person_form::named(visit, &form).await?;
    if !is_new {
        let help = "help: the list below has a button for a new link";
        faults.push(FieldFault { field: "login", message: format!("somebody signs in by this name already\n{help}") });
    }
    if !faults.is_empty() {
        return with(visit, form.with(&faults)).await;
    }
    let person = Person { operator: visit.fields.get("operator").is_some(), ..person };
    let what = if person.operator { "operator added" } else { "person added" };
    let entry = visit.entry(what, person.key.to_string());
    person_form::unless_taken(visit.store().add_people(std::slice::from_ref(&person), &entry).await)?;
    shown(visit, "Added", &person).await
}

/// A new link for somebody who lost the password.
pub(crate) async fn new_link(visit: &Visit) -> Result<Reply, NotShown> {
    let key = visit.fields.get("person").and_then(|text| text.parse().ok());
    let person = match key {
        Some(key) => visit.store().person(key).await?,
        None => None,
    };
    let Some(person) = person.filter(|person| person.erased.is_none()) else {
        let mut form = Form::sent(visit, &person_form::FIELDS);
        form.say("login", "nobody was chosen for whom a link could be made\nhelp: use a button of the list");
        return with(visit, form).await;
    };
    shown(visit, "New link", &person).await
}

async fn shown(visit: &Visit, title: &'static str, person: &Person) -> Result<Reply, NotShown> {
    let link = Some(link(visit, person).await?);
    LinkPage::new(visit, title, person, link, visit.address("/people")).reply(visit).await
}
