//! Letters with a link.

use momentous_course::{Key, MailAddress, Moment, Person};
use momentous_store::{MailedLink, StoreFault};

use super::super::session;
use super::super::visit::Visit;
use super::post::Letter;

/// A letter with the link that is kept for it.
pub(super) struct Linked {
    pub(super) letter: Letter,
    pub(super) link: MailedLink,
}

/// The hash by which the database knows a link: it depends on the browser, so that nobody else can open it.
pub(super) fn hash(token: &str, browser: &str) -> String {
    session::hash(&format!("{token} {browser}"))
}

/// Addresses of this server and moments that letters speak of, as the visit knows them that asked.
pub(super) struct Writer {
    /// The address of links, without their token.
    links: String,
    /// The page to which the link leads, as a part of an address.
    onward: String,
    browser: String,
    expires: Moment,
}

impl Writer {
    /// Letters for a visit, whose links open in a browser, and lead on to a page.
    pub(super) fn new(visit: &Visit, browser: &str, onward: Option<&str>) -> Self {
        let onward = onward.and_then(|to| serde_urlencoded::to_string([("to", to)]).ok());
        Self {
            links: visit.public("/mail"),
            onward: onward.map_or_else(String::new, |to| format!("?{to}")),
            browser: browser.to_owned(),
            expires: visit.now.after(session::MAILED),
        }
    }

    /// A letter to a person at an address.
    pub(super) fn write(&self, (person, name): (Key<Person>, &str), to: &MailAddress) -> Linked {
        let token = session::secret();
        let Self { links, onward, .. } = self;
        let text = format!(
            "This link signs you in as {name}:\n\n{links}/{token}{onward}\n\nOpen it within 15 minutes, in the browser in which you asked \
             for it. It works once.\n\nDid you not ask for it? Then do nothing: nobody else can use it.\n"
        );
        let letter = Letter { to: to.clone(), subject: "Your link to sign in".to_owned(), text };
        let link = MailedLink { hash: hash(&token, &self.browser), person, address: to.clone(), expires: self.expires };
        Linked { letter, link }
    }
}

/// Why a letter was not sent.
#[derive(Debug)]
pub(super) enum NotSent {
    /// The link could not be kept.
    Store(StoreFault),
    /// The server of mail refused it: why.
    Refused(String),
}
