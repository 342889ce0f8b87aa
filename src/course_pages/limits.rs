//! The number of times that somebody may try.

use std::hash::Hash;
use std::net::IpAddr;
use std::num::NonZeroU32;

use governor::{DefaultKeyedRateLimiter, Quota, RateLimiter};
use sha2::{Digest, Sha256};

use momentous_course::{Key, MailAddress, Person};

use super::outcome::NotShown;
use momentous_web::sender::network;

/// Passwords that may be tried for one name from one address in a minute, and at once.
const PASSWORDS: NonZeroU32 = NonZeroU32::new(10).expect("ten");
/// Passwords that are compared for one address in a minute: each takes a processor's time.
const COMPARED: NonZeroU32 = NonZeroU32::new(120).expect("one hundred and twenty");
/// The same at once: a year's classes sign in behind one address, and mistype.
const COMPARED_AT_ONCE: NonZeroU32 = NonZeroU32::new(900).expect("nine hundred");
/// Answers that one person may hand in or save in a minute, and at once.
const ANSWERS: NonZeroU32 = NonZeroU32::new(60).expect("sixty");
/// Answers that one person may have read in a minute, and at once: every pause while typing is one.
const READINGS: NonZeroU32 = NonZeroU32::new(240).expect("two hundred and forty");
/// Letters that are sent to one address in an hour, and at once.
const LETTERS: NonZeroU32 = NonZeroU32::new(12).expect("twelve");
const LETTERS_AT_ONCE: NonZeroU32 = NonZeroU32::new(3).expect("three");
/// Letters that are asked for from one address of the network in a minute; at once, those of a year's classes.
const ASKED: NonZeroU32 = NonZeroU32::new(60).expect("sixty");
const ASKED_AT_ONCE: NonZeroU32 = NonZeroU32::new(300).expect("three hundred");
/// Keys of a table, above which those who have been quiet long enough are forgotten.
const MANY: usize = 10_000;

/// The number of times that somebody may try. Each process counts for itself, by keys that are no longer than a hash.
pub(super) struct Limits {
    passwords: DefaultKeyedRateLimiter<[u8; 32]>,
    compared: DefaultKeyedRateLimiter<[u8; 16]>,
    letters: DefaultKeyedRateLimiter<MailAddress>,
    asked: DefaultKeyedRateLimiter<[u8; 16]>,
    answers: DefaultKeyedRateLimiter<Key<Person>>,
    readings: DefaultKeyedRateLimiter<Key<Person>>,
}

impl Limits {
    pub(super) fn new() -> Self {
        Self {
            passwords: RateLimiter::keyed(Quota::per_minute(PASSWORDS)),
            compared: RateLimiter::keyed(Quota::per_minute(COMPARED).allow_burst(COMPARED_AT_ONCE)),
            letters: RateLimiter::keyed(Quota::per_hour(LETTERS).allow_burst(LETTERS_AT_ONCE)),
            asked: RateLimiter::keyed(Quota::per_minute(ASKED).allow_burst(ASKED_AT_ONCE)),
            answers: RateLimiter::keyed(Quota::per_minute(ANSWERS)),
            readings: RateLimiter::keyed(Quota::per_minute(READINGS)),
        }
    }

    /// Whether another password may be tried for a name from an address. Others who try the name from elsewhere keep nobody out.
    pub(super) fn password(&self, from: IpAddr, login: &str) -> Result<(), NotShown> {
        let key = Sha256::new().chain_update(network(from)).chain_update(login.to_lowercase());
        allowed(&self.passwords, &key.finalize().into())
    }

    /// Whether another password may be compared for an address.
    pub(super) fn compared(&self, from: IpAddr) -> Result<(), NotShown> {
        allowed(&self.compared, &network(from))
    }

    /// Whether another letter may be sent to an address, asked for from an address of the network.
    pub(super) fn letter(&self, from: IpAddr, to: &MailAddress) -> Result<(), NotShown> {
        allowed(&self.asked, &network(from))?;
        allowed(&self.letters, to)
    }

    /// Whether a person may hand in again.
    pub(super) fn answer(&self, person: Key<Person>) -> Result<(), NotShown> {
        allowed(&self.answers, &person)
    }

    /// Whether a person may have another answer read.
    pub(super) fn reading(&self, person: Key<Person>) -> Result<(), NotShown> {
        allowed(&self.readings, &person)
    }
}

fn allowed<K: Clone + Hash + Eq>(limiter: &DefaultKeyedRateLimiter<K>, key: &K) -> Result<(), NotShown> {
    // The table stays as small as the crowd of the last minutes.
    if limiter.len() > MANY {
        limiter.retain_recent();
        limiter.shrink_to_fit();
    }
    limiter.check_key(key).map_err(|_| NotShown::TooMany)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_tried_ten_times_from_each_address() {
        let limits = Limits::new();
        let [one, other] = ["192.0.2.7", "192.0.2.8"].map(|text| text.parse().unwrap());
        let tried = |from, login: &str| (0..20).filter(|_| limits.password(from, login).is_ok()).count();
        assert_eq!((tried(one, "ada"), tried(one, "ADA"), tried(one, "bob"), tried(other, "ada")), (10, 0, 10, 10));
    }

    #[test]
    fn a_year_signs_in_behind_one_address() {
        let limits = Limits::new();
        let from = "192.0.2.7".parse().unwrap();
        let let_in = |student: u32| limits.password(from, &student.to_string()).and_then(|()| limits.compared(from));
        assert!((0..300).all(|student| (0..3).all(|_| let_in(student).is_ok())), "each may mistype twice");
        assert!((0..300).any(|student| let_in(student).is_err()));
    }
}
