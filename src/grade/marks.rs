//! Points: what an answer is worth.

use std::fmt;

use serde::{Serialize, Serializer};

use momentous_quantity::Decimal;
use momentous_quantity::Rational;

/// The decimals with which points are printed.
const DECIMALS: u32 = 2;

/// Points, exactly: fractions of marks add up without rounding. As JSON the nearest number.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Points(pub Rational);

/// With at most two decimals: `1.5`, `2`.
impl fmt::Display for Points {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_int() {
            return match i64::try_from(self.0.numerator()) {
                Ok(few) => few.fmt(out),
                Err(_) => self.0.numerator().fmt(out),
            };
        }
        let scaled = (&self.0 * Rational::from(10_u32.pow(DECIMALS))).round();
        let printed = Decimal::from_scaled(scaled, DECIMALS).to_string();
        out.write_str(printed.trim_end_matches('0').trim_end_matches('.'))
    }
}

impl Serialize for Points {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match i64::try_from(self.0.numerator()) {
            // A whole number of points is written as one.
            Ok(whole) if self.0.is_int() => serializer.serialize_i64(whole),
            _ => serializer.serialize_f64(self.0.to_f64().value()),
        }
    }
}
