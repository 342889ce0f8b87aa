//! A number with its unit, as it was written.

use std::fmt;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Span;

use super::decimal::number_length;
use super::{Decimal, DecimalFault, Rational, Unit, UnitFault};

/// A decimal with its unit: `9.81 m/s^2`, `30°`, `0.5`.
///
/// ```
/// use momentous_quantity::{Quantity, Rational};
/// let angle = Quantity::parse("30 deg")?;
/// assert_eq!(angle.to_string(), "30°");
/// assert_eq!(angle.si(), (Rational::ONE / Rational::from(6), 1)); // pi/6
/// # Ok::<(), momentous_quantity::QuantityFault>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Quantity {
    /// The number.
    pub value: Decimal,
    /// The unit behind it.
    pub unit: Unit,
}

/// Why a text is not a number with a unit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum QuantityFault {
    /// It does not begin with a number, or with none that can be read.
    #[error("{0}")]
    Number(DecimalFault),
    /// The text behind the number is not a unit; places are those of the whole text.
    #[error("{0}")]
    Unit(UnitFault),
}

impl From<QuantityFault> for Fault {
    fn from(fault: QuantityFault) -> Self {
        let message = fault.to_string();
        match fault {
            QuantityFault::Unit(fault) => fault.into(),
            QuantityFault::Number(DecimalFault::NotANumber { at }) => {
                let help = "a quantity is a number and a unit, such as `3 kg`, `9.81 m/s^2` or `0.7`";
                Fault::new(Code::Value, message).at(Span { start: at, end: at }).help(help)
            }
            QuantityFault::Number(_) => Fault::new(Code::Value, message),
        }
    }
}

impl Quantity {
    /// Reads a number and the unit behind it, with or without a space between them.
    ///
    /// # Errors
    /// Where the number or the unit cannot be read.
    pub fn parse(text: &str) -> Result<Self, QuantityFault> {
        let start = text.len() - text.trim_start().len();
        let end = start + number_length(&text[start..]);
        let value = Decimal::parse(&text[start..end]).map_err(|fault| {
            QuantityFault::Number(match fault {
                DecimalFault::NotANumber { at } => DecimalFault::NotANumber { at: at + start },
                other => other,
            })
        })?;
        // As a unit alone `1` means none; behind a number it is a second number.
        if text[end..].trim() == "1" {
            return Err(QuantityFault::Number(DecimalFault::NotANumber { at: end }));
        }
        let unit = Unit::parse(&text[end..]).map_err(|fault| QuantityFault::Unit(fault.shifted(end)))?;
        Ok(Self { value, unit })
    }

    /// The exact value in the coherent SI unit: a rational number, and the power of pi that it is multiplied by.
    #[must_use]
    pub fn si(&self) -> (Rational, i8) {
        let factor = self.unit.factor();
        (self.value.to_rational() * factor.rational, factor.pi)
    }

    /// In words: `3.1 metres per second`.
    #[must_use]
    pub fn spoken(&self) -> String {
        let number = self.value.to_string();
        let unit = self.unit.spoken(number.trim_start_matches('-') != "1");
        if unit.is_empty() { number } else { format!("{number} {unit}") }
    }
}

/// Plain text that [`Quantity::parse`] reads back.
impl fmt::Display for Quantity {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let space = if self.unit.is_none() || self.unit.is_attached() { "" } else { " " };
        write!(out, "{}{space}{}", self.value, self.unit)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;

    #[test]
    fn reads_and_prints() {
        let cases = [
            ("3 kg", "3 kg", "3 kilograms"),
            ("9.81 m/s^2", "9.81 m/s^2", "9.81 metres per second squared"),
            ("30deg", "30°", "30 degrees"),
            ("0.50", "0.50", "0.50"),
            ("5%", "5%", "5 per cent"),
            ("  -2 m/s ", "-2 m/s", "-2 metres per second"),
            ("1 ft/s", "1 ft/s", "1 foot per second"),
            ("3eV", "3 eV", "3 electronvolts"),
            ("3e2 V", "", ""),
            ("1 1", "", ""),
            ("1,200 m", "", ""),
            ("5-3 m", "", ""),
            ("2 1/s", "2 1/s", "2 per second"),
            ("1.2e3 N", "1200 N", "1200 newtons"),
        ];
        for (text, printed, spoken) in cases {
            let found = Quantity::parse(text).map(|found| (found.to_string(), found.spoken()));
            assert_eq!(found.unwrap_or_default(), (printed.to_owned(), spoken.to_owned()), "{text}");
        }
    }

    #[test]
    fn converts_exactly() {
        let si = |text: &str| Quantity::parse(text).unwrap().si();
        assert_eq!(si("36 km/h"), (Rational::from(10), 0));
        assert_eq!(si("180 deg"), (Rational::ONE, 1));
        assert_eq!(si("30 rpm"), (Rational::ONE, 1));
        assert_eq!(si("1 slug ft/s^2"), si("1 lb"));
        assert_eq!(si("1 lb").0, Rational::from(44_482_216_152_605_u64) / Rational::from(10_000_000_000_000_u64));
        assert_eq!(si("60 mph"), si("88 ft/s"));
        assert_eq!(si("1 hp"), si("550 ft lb/s"));
        assert_eq!(si("1 AU").0, Rational::from(149_597_870_700_u64));
        assert_eq!(si("16 ozm"), si("1 lbm"));
        assert_eq!(si("1 N s"), si("1 kg m/s"));
    }

    #[test]
    fn places_faults_in_the_whole_text() {
        let Err(QuantityFault::Unit(fault)) = Quantity::parse(" 3 kg m/sek") else { panic!("no fault of the unit") };
        assert_eq!((fault.span.start, fault.span.end), (8, 11));
        assert_eq!(Quantity::parse("  x"), Err(QuantityFault::Number(DecimalFault::NotANumber { at: 2 })));
        assert!(matches!(Quantity::parse("3..2 m/s"), Err(QuantityFault::Unit(_))));
    }
}
