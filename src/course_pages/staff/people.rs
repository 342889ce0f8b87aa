//! Everybody who can sign in, for the operator.

use std::collections::HashMap;

use serde::Serialize;

use momentous_course::{FieldFault, MailAddress, Person};

use super::super::invite::ADDRESS;
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
    /// The form for the address of a person, where this server sends mail.
    mail: Option<Form>,
}

#[derive(Serialize)]
struct Listed {
    key: String,
    login: String,
    name: String,
    operator: bool,
    address: String,
}

/// Everybody, and a form for one more.
pub(crate) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    with(visit, Forms::of(visit)).await
}

/// The fields that give a person an address.
const MAIL_FIELDS: [&str; 2] = ["whose", "address"];

/// The forms of the page.
struct Forms {
    person: Form,
    mail: Form,
}

impl Forms {
    fn of(visit: &Visit) -> Self {
        Self { person: Form::sent(visit, &person_form::FIELDS), mail: Form::sent(visit, &MAIL_FIELDS) }
    }
}

async fn with(visit: &Visit, Forms { person: form, mail }: Forms) -> Result<Reply, NotShown> {
    let is_wrong = form.is_wrong() || mail.is_wrong();
    let mail = visit.courses.post.is_some().then_some(mail);
    let addresses = if mail.is_some() { visit.store().mail_addresses().await? } else { HashMap::new() };
    let listed = |Person { key, login, name, operator, .. }| {
        let address = addresses.get(&key).map(ToString::to_string).unwrap_or_default();
        Listed { key: key.to_string(), login, name, operator, address }
    };
    let people = visit.store().people().await?.into_iter().map(listed).collect();
    let operator = is_wrong && visit.fields.get("operator").is_some();
    let page = visit.page("courses/staff/people", PeoplePage { title: "People", form, operator, people, mail }).await?;
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
        return with(visit, Forms { person: form.with(&faults), ..Forms::of(visit) }).await;
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
        let mut forms = Forms::of(visit);
        forms.person.say("login", "nobody was chosen for whom a link could be made\nhelp: use a button of the list");
        return with(visit, forms).await;
    };
    shown(visit, "New link", &person).await
}

/// Gives a person an address, or takes it away. Whoever runs the server is believed.
pub(crate) async fn set_address(visit: &Visit) -> Result<Reply, NotShown> {
    let mut forms = Forms::of(visit);
    let person = visit.store().person_named(forms.mail.value("whose")).await?;
    let address = match forms.mail.value("address") {
        "" => Ok(None),
        typed => MailAddress::read(typed).map(Some),
    };
    match (person, address) {
        (Some(person), Ok(address)) => {
            let entries = visit.entries(person.key, ADDRESS).await?;
            visit.store().set_mail_address(person.key, address.as_ref(), &entries).await?;
            Ok(Reply::To(visit.address("/people")))
        }
        (None, _) => {
            forms.mail.say("whose", "nobody signs in by this name\nhelp: the list below has all logins");
            with(visit, forms).await
        }
        (Some(_), Err(fault)) => {
            forms.mail.say("address", &fault.to_string());
            with(visit, forms).await
        }
    }
}

async fn shown(visit: &Visit, title: &'static str, person: &Person) -> Result<Reply, NotShown> {
    let link = Some(link(visit, person).await?);
    LinkPage::new(visit, title, person, link, visit.address("/people")).reply(visit).await
}
