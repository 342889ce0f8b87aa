//! The form for the address of whoever has signed in.

use serde::Serialize;

use super::super::outcome::NotShown;
use super::super::visit::Visit;

/// The news about an address, by the word for it in the address of the page.
const NEWS: [(&str, &str); 2] = [
    ("sent", "A letter is on its way. Open its link in this browser within 15 minutes; the address is saved then."),
    ("removed", "The address is removed."),
];

/// The form for an address.
#[derive(Serialize)]
pub(crate) struct AddressForm {
    /// The address that is saved.
    address: Option<String>,
    /// The text in the field.
    typed: String,
    needs_old: bool,
    fault: Option<String>,
    news: Option<&'static str>,
}

impl AddressForm {
    /// The form for whoever has signed in; nothing where this server sends no mail.
    pub(crate) async fn of(visit: &Visit, needs_old: bool, fault: Option<String>) -> Result<Option<Self>, NotShown> {
        if visit.courses.post.is_none() {
            return Ok(None);
        }
        let address = visit.store().mail_address(visit.person()?.key).await?.map(|address| address.to_string());
        let typed = match &fault {
            Some(_) => visit.fields.text("address").to_owned(),
            None => address.clone().unwrap_or_default(),
        };
        let word = visit.fields.get("mail");
        let news = NEWS.iter().find(|(listed, _)| word == Some(listed)).map(|(_, news)| *news);
        Ok(Some(Self { address, typed, needs_old, fault, news }))
    }
}
