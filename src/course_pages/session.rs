//! Who is asking: a random token in a cookie, of which the database keeps a hash.

use std::fmt::Write;

use axum::http::{HeaderMap, HeaderValue, header};
use sha2::{Digest, Sha256};

use momentous_course::{Key, Moment, Person};
use momentous_store::{Reach, Ticket, TicketKind};

/// How long somebody stays signed in.
const SESSION: i64 = 14 * DAY;
/// How long a link to sign in is good.
const LINK: i64 = 14 * DAY;
const DAY: i64 = 24 * 3_600_000;
/// The name of the cookie.
const COOKIE: &str = "momentous-session";

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

/// A new secret of a course: as many random bits as `momentous secret` writes.
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

/// What the database knows of a token.
pub(super) fn hash(token: &str) -> String {
    hex(&Sha256::digest(token.as_bytes()))
}

/// A new token for a person, and what is kept of it.
pub(crate) fn token(person: Key<Person>, (kind, reach): (TicketKind, Reach), now: Moment) -> (String, Ticket) {
    let token = hex(&random::<BYTES>());
    let lasts = match kind {
        TicketKind::Session => SESSION,
        TicketKind::Link => LINK,
    };
    let ticket = Ticket { hash: hash(&token), person, kind, reach, expires: now.after(lasts) };
    (token, ticket)
}

/// The token that a browser sends.
pub(super) fn of(headers: &HeaderMap) -> Option<&str> {
    let cookies = headers.get_all(header::COOKIE).iter().filter_map(|value| value.to_str().ok());
    let mut pairs = cookies.flat_map(|text| text.split(';')).filter_map(|pair| pair.trim().split_once('='));
    pairs.find(|(name, _)| *name == COOKIE).map(|(_, value)| value)
}

/// The cookie that holds a token; without one, a browser forgets the one it has. Scripts cannot read it, and other sites cannot send it.
pub(super) fn cookie(token: Option<&str>, base: &str, secure: bool) -> Option<HeaderValue> {
    let path = if base.is_empty() { "/" } else { base };
    let age = if token.is_some() { SESSION / 1000 } else { 0 };
    let secure = if secure { "; Secure" } else { "" };
    let text =
        format!("{COOKIE}={}; Path={path}; Max-Age={age}; HttpOnly; SameSite=Lax{secure}", token.unwrap_or_default());
    HeaderValue::from_str(&text).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cookie_is_read_as_it_is_written() {
        let cookie = cookie(Some("t0k3n"), "/momentous", true).unwrap();
        let text = cookie.to_str().unwrap();
        assert_eq!(text, "momentous-session=t0k3n; Path=/momentous; Max-Age=1209600; HttpOnly; SameSite=Lax; Secure");
        let mut headers = HeaderMap::new();
        headers.insert(header::COOKIE, HeaderValue::from_static("a=b; momentous-session=t0k3n; c=d"));
        assert_eq!(of(&headers), Some("t0k3n"));
    }

    #[test]
    fn the_database_never_sees_a_token() {
        let (token, ticket) = token(Key::new([1; 16]), (TicketKind::Link, Reach::All), Moment::from_millis(0));
        assert_eq!((token.len(), ticket.hash.len()), (64, 64));
        assert_ne!(token, ticket.hash);
        assert_eq!(hash(&token), ticket.hash);
    }
}
