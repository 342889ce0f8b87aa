//! Shares of points.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use momentous_quantity::Rational;

/// A share between nothing and all, exactly.
///
/// ```
/// use momentous_course::Share;
/// let tenth: Share = "10 %".parse()?;
/// assert_eq!(Ok(&tenth), "1/10".parse().as_ref());
/// assert_eq!((tenth.to_string().as_str(), tenth.percent().as_str()), ("1/10", "10 %"));
/// assert!("110 %".parse::<Share>().is_err() && "1/0".parse::<Share>().is_err());
/// # Ok::<(), momentous_course::NoShare>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Share(Rational);

/// A text that is no share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a share is written `10 %`, `0.1` or `1/10`, and lies between 0 and 1")]
pub struct NoShare;

impl Share {
    /// The share as a fraction.
    #[must_use]
    pub fn fraction(&self) -> &Rational {
        &self.0
    }

    /// Whether it is no share at all.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.0 == Rational::ZERO
    }

    /// The share as it is typed: in per cent where that is exact with two decimals, else as a fraction.
    #[must_use]
    pub fn typed(&self) -> String {
        let percent = self.percent();
        if percent.parse().as_ref() == Ok(self) { percent } else { self.to_string() }
    }

    /// In per cent, with at most two decimals.
    #[must_use]
    pub fn percent(&self) -> String {
        format!("{} %", momentous_grade::Points(&self.0 * Rational::from(100)))
    }
}

/// A number of points: a decimal or a fraction.
pub(super) fn fraction(text: &str) -> Option<Rational> {
    match text.split_once('/') {
        Some((above, below)) => {
            let below = number(below.trim()).filter(|below| *below != Rational::ZERO)?;
            Some(number(above.trim())? / below)
        }
        None => number(text),
    }
}

/// A whole number or a decimal as a fraction; short, so that no power of ten grows large.
fn number(text: &str) -> Option<Rational> {
    let (whole, decimals) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let digits = format!("{whole}{decimals}");
    let is_short = (1..=15).contains(&digits.len()) && digits.bytes().all(|digit| digit.is_ascii_digit());
    let places = u32::try_from(decimals.len()).ok()?;
    is_short
        .then(|| digits.parse::<u64>().ok())
        .flatten()
        .map(|scaled| Rational::from(scaled) / Rational::from(10_u64.pow(places)))
}

impl FromStr for Share {
    type Err = NoShare;

    fn from_str(text: &str) -> Result<Self, NoShare> {
        let text = text.trim();
        let typed = match text.strip_suffix('%') {
            Some(percent) => number(percent.trim()).map(|number| number / Rational::from(100)),
            None => fraction(text),
        };
        typed.filter(|share| *share <= Rational::ONE).map(Self).ok_or(NoShare)
    }
}

impl fmt::Display for Share {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(out)
    }
}

impl Serialize for Share {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Share {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}
