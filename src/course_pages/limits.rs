//! The number of times that somebody may ask for work, which each server counts for itself.

use std::hash::Hash;
use std::net::IpAddr;
use std::num::NonZeroU32;

use governor::{DefaultKeyedRateLimiter, Quota, RateLimiter};

use momentous_course::{Key, Person};
use momentous_web::sender::network;

use super::outcome::NotShown;

/// Passwords that may be tried from one address in a minute: to compare one takes a processor's time.
const TRIED: NonZeroU32 = NonZeroU32::new(120).expect("one hundred and twenty");
/// The same at once: a year's classes sign in behind one address, and mistype.
const TRIED_AT_ONCE: NonZeroU32 = NonZeroU32::new(900).expect("nine hundred");
/// Answers that one person may hand in or save in a minute, and at once.
const ANSWERS: NonZeroU32 = NonZeroU32::new(60).expect("sixty");
/// Answers that one person may have read in a minute, and at once: every pause while typing is one.
const READINGS: NonZeroU32 = NonZeroU32::new(240).expect("two hundred and forty");
/// Letters that are asked for from one address of the network in a minute; at once, those of a year's classes.
const ASKED: NonZeroU32 = NonZeroU32::new(60).expect("sixty");
const ASKED_AT_ONCE: NonZeroU32 = NonZeroU32::new(300).expect("three hundred");
/// Keys of a table, above which those who have been quiet long enough are forgotten.
const MANY: usize = 10_000;

/// The number of times that somebody may ask for work, by keys that are no longer than a hash.
pub(super) struct Limits {
    tried: DefaultKeyedRateLimiter<[u8; 16]>,
    asked: DefaultKeyedRateLimiter<[u8; 16]>,
    answers: DefaultKeyedRateLimiter<Key<Person>>,
    readings: DefaultKeyedRateLimiter<Key<Person>>,
}

impl Limits {
    pub(super) fn new() -> Self {
        Self {
            tried: RateLimiter::keyed(Quota::per_minute(TRIED).allow_burst(TRIED_AT_ONCE)),
            asked: RateLimiter::keyed(Quota::per_minute(ASKED).allow_burst(ASKED_AT_ONCE)),
            answers: RateLimiter::keyed(Quota::per_minute(ANSWERS)),
            readings: RateLimiter::keyed(Quota::per_minute(READINGS)),
        }
    }

    /// Whether something that takes a processor's time may be tried once more from an address.
    pub(super) fn tried(&self, from: IpAddr) -> Result<(), NotShown> {
        allowed(&self.tried, &network(from))
    }

    /// Whether another letter may be asked for from an address of the network.
    pub(super) fn asked(&self, from: IpAddr) -> Result<(), NotShown> {
        allowed(&self.asked, &network(from))
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
    fn a_year_signs_in_behind_one_address() {
        let limits = Limits::new();
        let from = "192.0.2.7".parse().unwrap();
        assert!((0..900).all(|_| limits.tried(from).is_ok()), "each of three hundred may mistype twice");
        assert!((0..300).any(|_| limits.tried(from).is_err()));
    }
}
