//! Local times that somebody typed, as moments.

use jiff::civil::DateTime;
use jiff::tz::{AmbiguousOffset, TimeZone};

use super::moment::Moment;

/// The notation of a local time.
const FORMAT: &str = "%Y-%m-%dT%H:%M";

/// The years in which a course may take place.
const YEARS: std::ops::RangeInclusive<i16> = 2000..=2999;

/// Why a text is no moment.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoMoment {
    /// It is not written as a local time.
    #[error("`{0}` is no date with a time\nhelp: write it as 2026-11-30T18:00")]
    Unreadable(String),
    /// The zone is not known.
    #[error("`{0}` is no time zone\nhelp: write its IANA name, such as Europe/Berlin or UTC")]
    Zone(String),
    /// The clocks jump over it.
    #[error(
        "this time does not exist: the clocks go forward from {0} to {1}\nhelp: choose a time before {0}, or from {1} on"
    )]
    Skipped(String, String),
    /// The clocks show it twice.
    #[error(
        "this time exists twice: the clocks go back from {1} to {0}\nhelp: choose a time before {0}, or from {1} on"
    )]
    Twice(String, String),
}

/// The names of all time zones, in alphabetical order.
#[must_use]
pub fn zones() -> Vec<String> {
    jiff::tz::db().available().map(|name| name.to_string()).collect()
}

/// The time zone of that IANA name.
///
/// # Errors
/// [`NoMoment::Zone`] where there is none.
pub fn zone(name: &str) -> Result<TimeZone, NoMoment> {
    TimeZone::get(name).map_err(|_| NoMoment::Zone(name.chars().take(60).collect()))
}

impl Moment {
    /// The moment of a local time in a zone, as fields send it.
    ///
    /// ```
    /// use momentous_course::Moment;
    /// let due = Moment::local("2026-11-30T18:00", "Europe/Berlin")?;
    /// assert_eq!(due.to_string(), "2026-11-30T17:00:00Z");
    /// let skipped = Moment::local("2026-03-29T02:30", "Europe/Berlin").unwrap_err();
    /// assert!(skipped.to_string().starts_with("this time does not exist: the clocks go forward from 02:00 to 03:00"));
    /// # Ok::<(), momentous_course::NoMoment>(())
    /// ```
    ///
    /// # Errors
    /// Where the text is no local time, or one that does not exist or exists twice in the zone.
    pub fn local(text: &str, zone: &str) -> Result<Self, NoMoment> {
        let tz = self::zone(zone)?;
        let text = text.trim();
        // Some browsers add the seconds.
        let minutes = text.strip_suffix(":00").filter(|rest| rest.len() == "2026-11-30T18:00".len()).unwrap_or(text);
        let local = DateTime::strptime(FORMAT, minutes).ok().filter(|local| YEARS.contains(&local.year()));
        let local = local.ok_or_else(|| NoMoment::Unreadable(text.chars().take(60).collect()))?;
        let ambiguous = tz.to_ambiguous_timestamp(local);
        let unreadable = |_| NoMoment::Unreadable(minutes.to_owned());
        let (before, after) = match ambiguous.offset() {
            AmbiguousOffset::Unambiguous { .. } => return Ok(ambiguous.compatible().map_err(unreadable)?.into()),
            AmbiguousOffset::Gap { before, after } | AmbiguousOffset::Fold { before, after } => (before, after),
        };
        let earlier = ambiguous.earlier().map_err(unreadable)?;
        let turn = tz.following(earlier).next().map_or(earlier, |transition| transition.timestamp());
        let shown = |local: DateTime| local.strftime("%H:%M").to_string();
        let (then, now) = (shown(before.to_datetime(turn)), shown(after.to_datetime(turn)));
        Err(if after > before { NoMoment::Skipped(then, now) } else { NoMoment::Twice(now, then) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Zone, local time, and the moment in UTC or what is said; changes of clocks from the IANA database's own comments.
    const CASES: &str = include_str!("../../tests/fixtures/course/local_times.txt");

    #[test]
    fn local_times_are_moments_or_are_refused_with_the_way_out() {
        let mut count = 0;
        for case in CASES.lines().filter(|line| !line.starts_with('#')) {
            let cells: Vec<&str> = case.split('|').map(str::trim).collect();
            let [zone, local, expected] = cells[..] else { panic!("{case}") };
            let named = Moment::local(local, zone);
            let said = named.as_ref().map_or_else(|why| why.to_string().replace('\n', " "), ToString::to_string);
            assert!(said.starts_with(expected), "{case}: {said}");
            if let Ok(moment) = named {
                assert_eq!(Moment::local(&moment.typed(zone), zone), Ok(moment), "{case}");
            }
            count += 1;
        }
        assert!(count > 10, "the cases were read");
    }
}
