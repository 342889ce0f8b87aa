//! A time with twice the digits, so that the difference of two late times still tells near events apart.

/// A time in s as an unevaluated sum; `low` is below the last digit of `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clock {
    high: f64,
    low: f64,
}

impl Clock {
    /// A time as it stands.
    #[must_use]
    #[inline]
    pub fn at(time: f64) -> Self {
        Self { high: time, low: 0.0 }
    }

    /// The time that is this much later.
    ///
    /// ```
    /// use momentous_simulate::Clock;
    /// let late = Clock::at(1e6);
    /// assert_eq!(late.after(1e-20).since(late), 1e-20);
    /// ```
    #[must_use]
    #[inline]
    pub fn after(self, elapsed: f64) -> Self {
        let (high, rest) = two_sum(self.high, elapsed);
        let (high, low) = two_sum(high, rest + self.low);
        Self { high, low }
    }

    /// The time that has gone by since another, in s.
    #[must_use]
    #[inline]
    pub fn since(self, other: Self) -> f64 {
        let (difference, rest) = two_sum(self.high, -other.high);
        difference + (rest + (self.low - other.low))
    }

    /// The nearest number.
    #[must_use]
    #[inline]
    pub fn seconds(self) -> f64 {
        self.high
    }

    /// Whether it is earlier than another.
    #[must_use]
    #[inline]
    #[allow(clippy::needless_bitwise_bool, clippy::float_cmp, reason = "a branch that nobody can foretell costs more")]
    pub fn is_before(self, other: Self) -> bool {
        (self.high < other.high) | ((self.high == other.high) & (self.low < other.low))
    }
}

/// The rounded sum and what rounding took away (Knuth).
#[inline]
fn two_sum(one: f64, other: f64) -> (f64, f64) {
    let sum = one + other;
    if !sum.is_finite() {
        return (sum, 0.0);
    }
    let part = sum - one;
    (sum, (one - (sum - part)) + (other - part))
}
