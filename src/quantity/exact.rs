//! Exact fractions in records, as text: `3/2`. For `#[serde(with = "exact")]`.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

use super::Rational;

/// The characters that a fraction may have.
const LONGEST: usize = 1000;

/// Writes a fraction.
///
/// # Errors
/// Those of the serializer.
pub fn serialize<S: Serializer>(value: &Rational, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}

/// Reads a fraction.
///
/// # Errors
/// Where the text is none.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Rational, D::Error> {
    let text = String::deserialize(deserializer)?;
    // Nothing is divided by zero, however many zeros it has.
    let has_value =
        text.split_once('/').is_none_or(|(_, below)| below.bytes().any(|digit| matches!(digit, b'1'..=b'9')));
    let value = if text.len() <= LONGEST && has_value { text.parse().ok() } else { None };
    value.ok_or_else(|| D::Error::custom("expected a fraction such as 3/2"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, PartialEq, serde::Serialize, Deserialize)]
    struct Kept(#[serde(with = "super")] Rational);

    #[test]
    fn fractions_come_back_as_they_were() {
        for text in ["0", "-7", "3/2", "1/3000000000000000000000000"] {
            let json = format!("\"{text}\"");
            let kept: Kept = serde_json::from_str(&json).unwrap();
            assert_eq!(serde_json::to_string(&kept).unwrap(), json);
        }
        for text in ["", "1/0", "1.5", "x", "1/2/3"] {
            assert!(serde_json::from_str::<Kept>(&format!("\"{text}\"")).is_err(), "{text}");
        }
        assert!(serde_json::from_str::<Kept>(&format!("\"{}\"", "1".repeat(2000))).is_err());
    }
}
