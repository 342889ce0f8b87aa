//! Points in time.

use std::fmt;
use std::str::FromStr;

use jiff::Timestamp;
use jiff::tz::TimeZone;
use serde::{Deserialize, Serialize};

/// A point in time: milliseconds since the beginning of 1970, UTC. It is always the server's; no rule trusts the clock of a browser.
///
/// ```
/// use momentous_course::Moment;
/// let moment = Moment::from_millis(1_764_576_000_000);
/// assert_eq!(moment.to_string(), "2025-12-01T08:00:00Z");
/// assert_eq!(moment.shown("Europe/Berlin"), "Mon, 1 Dec 2025, 09:00");
/// ```
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, Hash, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(transparent)]
pub struct Moment(i64);

impl Moment {
    /// Milliseconds after the beginning of 1970.
    #[must_use]
    pub const fn from_millis(millis: i64) -> Self {
        Self(millis)
    }

    /// The milliseconds since the beginning of 1970.
    #[must_use]
    pub const fn millis(self) -> i64 {
        self.0
    }

    /// The moment so many milliseconds later.
    #[must_use]
    pub const fn after(self, millis: i64) -> Self {
        Self(self.0.saturating_add(millis))
    }

    /// In the local time of a zone, by its IANA name, as pages show it: to the minute. UTC where there is no such zone, and it says so.
    #[must_use]
    pub fn shown(self, zone: &str) -> String {
        self.local_to(zone, "%a, %-d %b %Y, %H:%M")
    }

    /// The same to the second, as receipts show it.
    #[must_use]
    pub fn shown_exactly(self, zone: &str) -> String {
        self.local_to(zone, "%a, %-d %b %Y, %H:%M:%S")
    }

    /// In the local time of a zone as fields take it: `2026-11-30T18:00`.
    #[must_use]
    pub fn typed(self, zone: &str) -> String {
        let zone = TimeZone::get(zone).unwrap_or(TimeZone::UTC);
        self.timestamp().to_zoned(zone).strftime("%Y-%m-%dT%H:%M").to_string()
    }

    fn local_to(self, zone: &str, written: &str) -> String {
        match TimeZone::get(zone) {
            Ok(zone) => self.timestamp().to_zoned(zone).strftime(written).to_string(),
            Err(_) => format!("{} UTC", self.timestamp().to_zoned(TimeZone::UTC).strftime(written)),
        }
    }

    /// The nearest moment that a calendar knows.
    pub(super) fn timestamp(self) -> Timestamp {
        Timestamp::from_millisecond(self.0).unwrap_or(if self.0 < 0 { Timestamp::MIN } else { Timestamp::MAX })
    }
}

/// ISO 8601, in UTC.
impl fmt::Display for Moment {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.timestamp().fmt(out)
    }
}

impl FromStr for Moment {
    type Err = jiff::Error;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        text.parse::<Timestamp>().map(Self::from)
    }
}

impl From<Timestamp> for Moment {
    fn from(timestamp: Timestamp) -> Self {
        Self(timestamp.as_millisecond())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_in_a_zone_that_is_not_known_says_that_it_is_utc() {
        let noon = Moment::from_millis(1_795_780_800_000);
        assert_eq!(noon.shown("UTC"), "Fri, 27 Nov 2026, 12:00");
        assert_eq!(noon.shown("Europe/Atlantis"), "Fri, 27 Nov 2026, 12:00 UTC");
    }
}
