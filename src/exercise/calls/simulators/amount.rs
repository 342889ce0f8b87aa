//! A number with the text that pages show.

use serde::Serialize;

use momentous_quantity::Printed;
use momentous_quantity::with_minus_signs;

/// The figures that pages show, as worked solutions do.
const FIGURES: usize = 3;

/// The share of a scale below which a value is rounding, and nothing.
const ROUNDING: f64 = 1e-11;

/// A number in SI units, and how it is shown.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Amount {
    /// The number.
    pub value: f64,
    /// The number with its unit, as it is shown.
    pub text: String,
}

impl Amount {
    /// A number among others as large as `scale`: what is left of it by rounding alone is 0.
    pub(super) fn new(value: f64, scale: f64, unit: &str) -> Self {
        let value = if value.abs() <= ROUNDING * scale.abs() { 0.0 } else { value };
        let number = Printed::new(value, FIGURES).map_or_else(|| "for ever".to_owned(), |printed| printed.plain());
        let space = if unit.is_empty() { "" } else { "\u{a0}" };
        Self { value, text: prose(&format!("{number}{space}{unit}")) }
    }

    /// A number whose text is known, such as an answer.
    pub(super) fn with_text(value: f64, text: &str) -> Self {
        Self { value, text: prose(text) }
    }

    /// A share, in percent.
    pub(super) fn share(part: f64, whole: f64) -> Self {
        let share = if whole == 0.0 { 0.0 } else { part / whole };
        Self { value: share, ..Self::new(100.0 * share, 100.0, "%") }
    }
}

/// The text of a terminal as prose: `2 × 10^-7` with its power raised, and with a minus instead of a hyphen.
fn prose(text: &str) -> String {
    let (number, power) = text.split_once("10^").map_or((text, ""), |(number, power)| (number, power));
    if power.is_empty() {
        return with_minus_signs(text);
    }
    let end = power.find(|letter: char| !letter.is_ascii_digit() && letter != '-').unwrap_or(power.len());
    let (power, unit) = power.split_at(end);
    let raised = power.chars().filter_map(|letter| RAISED.chars().nth("0123456789-".find(letter)?));
    format!("{}10{}{unit}", with_minus_signs(number), raised.collect::<String>())
}

const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_leaves_is_nothing() {
        assert_eq!(Amount::new(1e-16, 10.0, "m/s").text, "0\u{a0}m/s");
        assert_eq!(Amount::new(-0.4, 10.0, "m/s").text, "\u{2212}0.400\u{a0}m/s");
        assert_eq!(Amount::new(-4.268e-6, 1.0, "m").text, "\u{2212}4.27 × 10⁻⁶\u{a0}m");
        assert_eq!(Amount::share(7.65, 17.5).text, "43.7\u{a0}%");
        assert_eq!(Amount::share(0.0, 0.0).text, "0\u{a0}%");
    }
}
