//! A time with twice the digits, so that the difference of two late times still tells near events apart.

use std::cmp::Ordering;

/// A time in s as an unevaluated sum; `low` is below the last digit of `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clock {
    high: f64,
    low: f64,
}

impl Clock {
    /// A time as it stands.
    #[must_use]
    pub fn at(time: f64) -> Self {
        Self { high: time, low: 0.0 }
    }

    /// The time that is this much later.
    ///
    /// ```
    /// use momentous::simulate::Clock;
    /// let late = Clock::at(1e6);
    /// assert_eq!(late.after(1e-20).since(late), 1e-20);
    /// ```
    #[must_use]
    pub fn after(self, elapsed: f64) -> Self {
        let (high, rest) = two_sum(self.high, elapsed);
        let (high, low) = two_sum(high, rest + self.low);
        Self { high, low }
    }

    /// The time that has gone by since another, in s.
    #[must_use]
    pub fn since(self, other: Self) -> f64 {
        let (difference, rest) = two_sum(self.high, -other.high);
        difference + (rest + (self.low - other.low))
    }

    /// The nearest number.
    #[must_use]
    pub fn seconds(self) -> f64 {
        self.high
    }

    /// Which of two times is earlier.
    #[must_use]
    pub fn order(self, other: Self) -> Ordering {
        self.high.total_cmp(&other.high).then(self.low.total_cmp(&other.low))
    }
}

/// The rounded sum and what rounding took away (Knuth).
fn two_sum(one: f64, other: f64) -> (f64, f64) {
    let sum = one + other;
    if !sum.is_finite() {
        return (sum, 0.0);
    }
    let part = sum - one;
    (sum, (one - (sum - part)) + (other - part))
}
