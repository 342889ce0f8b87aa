//! A new address of whoever has signed in.

use momentous_course::MailAddress;

use super::super::cookie::Cookie;
use super::super::courses;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::tries;
use super::super::visit::Visit;
use super::letter::{NotSent, Writer};
use super::sign_in::{browser, post, send};

/// Sends a link to a new address, which is saved once the link is opened; an empty field removes the address.
pub(crate) async fn change(visit: &Visit) -> Result<Reply, NotShown> {
    let post = post(visit)?;
    let person = visit.person()?;
    courses::owner(visit).await?;
    let typed = visit.fields.text("address").trim();
    let address = match (typed, MailAddress::read(typed)) {
        ("", _) => None,
        (_, Ok(address)) => Some(address),
        (_, Err(fault)) => return courses::with_address_fault(visit, fault.to_string()).await,
    };
    if !courses::knows_password(visit).await? {
        return courses::with_address_fault(visit, "the password is not right".to_owned()).await;
    }
    let Some(address) = address else {
        let entries = visit.entries(person.key, "e-mail address removed").await?;
        visit.store().set_mail_address(person.key, None, &entries).await?;
        return Ok(Reply::To(visit.address("/courses?mail=removed")));
    };
    tries::letter(visit, &address).await?;
    let browser = browser(visit);
    let linked = Writer::new(visit, &browser, None).write((person.key, person.shown()), &address);
    match send(&visit.courses, post, linked, visit.now).await {
        Ok(()) => {
            let to = visit.address("/courses?mail=sent");
            Ok(Reply::ToWith { to, cookie: Cookie::Browser, token: Some(browser) })
        }
        Err(NotSent::Store(fault)) => Err(fault.into()),
        Err(NotSent::Refused(reason)) => {
            eprintln!("momentous serve: a letter could not be sent: {reason}");
            let fault = "the letter could not be sent; tell whoever runs this server";
            courses::with_address_fault(visit, fault.to_owned()).await
        }
    }
}
