//! People as a form names them: by the name with which they sign in.

use momentous_course::{FieldFault, Person};
use momentous_store::StoreFault;

use super::super::outcome::NotShown;
use super::super::session;
use super::super::visit::Visit;
use super::form::Form;

/// The bytes of the longest name.
const LONGEST: usize = 200;

/// The fields that name a person.
pub(super) const FIELDS: [&str; 2] = ["login", "name"];

/// Somebody whom a form names.
pub(super) struct Named {
    pub(super) person: Person,
    /// Whether nobody knows the person yet.
    pub(super) is_new: bool,
}

/// The faults of the fields that name a person.
pub(crate) fn faults(form: &Form) -> Vec<FieldFault> {
    let mut faults = Vec::new();
    if form.value("login").is_empty() {
        let help = "help: write what the person signs in with, such as a number or an address";
        faults.push(FieldFault { field: "login", message: format!("there is no login\n{help}") });
    }
    for field in FIELDS {
        faults.extend(text_fault(form.value(field)).map(|message| FieldFault { field, message }));
    }
    faults
}

/// The fault of a short text that is shown in lists.
pub(super) fn text_fault(text: &str) -> Option<String> {
    if text.len() > LONGEST {
        Some(format!("this is longer than {LONGEST} bytes"))
    } else if text.chars().any(char::is_control) {
        Some("this has a character that cannot be printed".to_owned())
    } else {
        None
    }
}

/// The person of the form: the one who signs in by that name, or a new one.
pub(super) async fn named(visit: &Visit, form: &Form) -> Result<Named, NotShown> {
    let login = form.value("login");
    if let Some(person) = visit.store().person_named(login).await? {
        return Ok(Named { person, is_new: false });
    }
    let (login, name) = (login.to_owned(), form.value("name").to_owned());
    let person = Person { key: session::key(), login, name, operator: false, erased: None };
    Ok(Named { person, is_new: true })
}

/// Keeps new people. Where somebody else was faster with a name the form is out of date.
pub(super) fn unless_taken<T>(added: Result<T, StoreFault>) -> Result<T, NotShown> {
    match added {
        Err(fault) if fault.is_taken() => {
            Err(NotShown::Conflict("somebody was added by this name a moment ago".to_owned()))
        }
        other => Ok(other?),
    }
}
