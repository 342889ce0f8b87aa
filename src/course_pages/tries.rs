//! Limits that protect a person: a password from being guessed, and a letter box from being filled. They are counted in the database, so
//! that they are the same however many servers work on it.

use momentous_course::MailAddress;
use momentous_store::Rate;
use momentous_web::sender::network;

use super::outcome::NotShown;
use super::session;
use super::visit::Visit;

/// Passwords that may be tried for one name from one address.
const PASSWORDS: Rate = Rate { at_once: 10, interval: 6_000 };
/// Letters that are sent to one address.
const LETTERS: Rate = Rate { at_once: 3, interval: 5 * 60_000 };

/// Whether another password may be tried for a name from where the request comes. Others who try the name from elsewhere keep nobody out.
/// A name that nobody has is counted likewise.
pub(super) async fn password(visit: &Visit, login: &str) -> Result<(), NotShown> {
    visit.courses.limits.tried(visit.from)?;
    let name = login.to_lowercase();
    shared(visit, &format!("password {:x?} {name}", network(visit.from)), PASSWORDS).await
}

/// Whether another letter may be sent to an address, asked for from where the request comes.
pub(super) async fn letter(visit: &Visit, to: &MailAddress) -> Result<(), NotShown> {
    visit.courses.limits.asked(visit.from)?;
    shared(visit, &format!("letter {to}"), LETTERS).await
}

async fn shared(visit: &Visit, counted: &str, rate: Rate) -> Result<(), NotShown> {
    let is_allowed = visit.store().allow(&session::hash(counted), rate, visit.now).await?;
    if is_allowed { Ok(()) } else { Err(NotShown::TooMany) }
}
