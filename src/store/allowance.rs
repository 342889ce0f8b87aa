//! How often something may be done, counted in the database: every server that works on it counts the same.

use sqlx::query;

use momentous_course::Moment;

use super::fault::StoreFault;
use super::open::Store;

/// The number of times that something may be done: so many at once, and another one whenever an interval has passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rate {
    /// The most at once.
    pub at_once: u32,
    /// The interval in milliseconds.
    pub interval: i64,
}

impl Store {
    /// Counts one more time under a key, where the rate still allows it; whether it does. The key is a hash: whatever is counted may be
    /// private, and long.
    ///
    /// Each time adds an interval to the moment from which nothing counts any more, and so many intervals may lie ahead as may be
    /// used at once (the generic cell rate algorithm).
    ///
    /// # Errors
    /// Where the database refuses.
    pub async fn allow(&self, key: &str, rate: Rate, now: Moment) -> Result<bool, StoreFault> {
        let (now, ahead) = (now.millis(), rate.interval * (i64::from(rate.at_once) - 1));
        let count = query(
            "INSERT INTO allowance (key, free_at) VALUES ($1, $2) ON CONFLICT (key) DO UPDATE \
                SET free_at = $3 + CASE WHEN allowance.free_at > $4 THEN allowance.free_at ELSE $4 END \
                WHERE allowance.free_at <= $5",
        );
        let count =
            count.bind(key.to_owned()).bind(now + rate.interval).bind(rate.interval).bind(now).bind(now + ahead);
        let forget = query("DELETE FROM allowance WHERE free_at <= $1").bind(now);
        self.write_if(1, vec![count, forget]).await
    }
}
