//! How often somebody may try.

use std::hash::Hash;
use std::num::NonZeroU32;

use governor::{DefaultKeyedRateLimiter, Quota, RateLimiter};

use crate::course::{Key, Person};

use super::outcome::NotShown;

/// Passwords that may be tried for one name in a minute, and at once.
const PASSWORDS: NonZeroU32 = NonZeroU32::new(10).expect("ten");
/// Answers that one person may hand in or save in a minute, and at once.
const ANSWERS: NonZeroU32 = NonZeroU32::new(60).expect("sixty");

/// Answers that one person may have read in a minute, and at once: every pause while typing is one.
const READINGS: NonZeroU32 = NonZeroU32::new(240).expect("two hundred and forty");

/// How often somebody may try. Each process counts for itself.
pub(super) struct Limits {
    passwords: DefaultKeyedRateLimiter<String>,
    answers: DefaultKeyedRateLimiter<Key<Person>>,
    readings: DefaultKeyedRateLimiter<Key<Person>>,
}

impl Limits {
    pub(super) fn new() -> Self {
        Self {
            passwords: RateLimiter::keyed(Quota::per_minute(PASSWORDS)),
            answers: RateLimiter::keyed(Quota::per_minute(ANSWERS)),
            readings: RateLimiter::keyed(Quota::per_minute(READINGS)),
        }
    }

    /// Whether another password may be tried for a name.
    pub(super) fn password(&self, login: &str) -> Result<(), NotShown> {
        allowed(&self.passwords, &login.to_lowercase())
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
    // Those who have been quiet long enough are forgotten, so that the table stays as small as the crowd of the last minutes.
    if limiter.len() > 10_000 {
        limiter.retain_recent();
    }
    limiter.check_key(key).map_err(|_| NotShown::TooMany)
}
