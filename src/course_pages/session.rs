//! Sessions of visitors: random tokens, of which the database keeps a hash.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use momentous_course::{Key, Moment, Person};
use momentous_store::{Reach, Ticket, TicketKind};

/// The time for which somebody stays signed in.
pub(super) const SESSION: i64 = 14 * DAY;
/// How long a link to sign in is good.
const LINK: i64 = 14 * DAY;
/// How long a link that was sent by mail is good.
pub(super) const MAILED: i64 = 15 * 60_000;
const DAY: i64 = 24 * 3_600_000;

/// The random bytes of a token, and of a secret.
const BYTES: usize = 32;

/// Random bytes of the system.
pub(super) fn random<const N: usize>() -> [u8; N] {
    let mut bytes = [0; N];
    // A system without random numbers cannot serve people safely; it does not start (`Courses::new` tries once).
    let _ = getrandom::fill(&mut bytes);
    bytes
}

/// A new random key.
pub(crate) fn key<Of>() -> Key<Of> {
    Key::new(random())
}

/// A new secret of a course, or of a browser: as many random bits as `momentous secret` writes.
pub(super) fn secret() -> String {
    hex(&random::<BYTES>())
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut digits, byte| {
        // Writing to a string cannot fail.
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}

/// The hash by which the database knows a token.
pub(super) fn hash(token: &str) -> String {
    hex(&Sha256::digest(token.as_bytes()))
}

/// A new token for a person, and what is kept of it.
pub(crate) fn token(person: Key<Person>, (kind, reach): (TicketKind, Reach), now: Moment) -> (String, Ticket) {
    let token = secret();
    let lasts = match kind {
        TicketKind::Session => SESSION,
        TicketKind::Link => LINK,
    };
    let ticket = Ticket { hash: hash(&token), person, kind, reach, expires: now.after(lasts) };
    (token, ticket)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_database_never_sees_a_token() {
        let (token, ticket) = token(Key::new([1; 16]), (TicketKind::Link, Reach::All), Moment::from_millis(0));
        assert_eq!((token.len(), ticket.hash.len()), (64, 64));
        assert_ne!(token, ticket.hash);
        assert_eq!(hash(&token), ticket.hash);
    }
}
