//! A decimal number as it was written.

use std::cmp::Ordering;
use std::fmt;
use std::ops::Neg;

use dashu::base::{Abs, Sign, UnsignedAbs};

use super::{Integer, Rational, nearest_double};

/// The most digits that a written number may have.
const MAX_DIGITS: usize = 40;
/// The largest power of ten, either way, that a written number may carry.
const MAX_EXPONENT: i32 = 400;

/// A decimal number that remembers how it was written: `0.70` and `0.7` have the same value but not the same figures.
///
/// Two decimals are equal (`==`) when they are written alike; [`Decimal::compare`] compares values.
///
/// ```
/// use momentous_quantity::{Decimal, Rational};
/// let e = Decimal::parse("0.70")?;
/// assert_eq!((e.to_string().as_str(), e.figures()), ("0.70", 2));
/// assert_eq!(e.to_rational(), Rational::from(7) / Rational::from(10));
/// # Ok::<(), momentous_quantity::DecimalFault>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Decimal {
    unscaled: Integer,
    scale: i32,
}

/// Why a text is not a decimal number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DecimalFault {
    /// A character that no number has there, or the end where a digit must stand.
    #[error("this is not a decimal number")]
    NotANumber {
        /// The byte of the text at which reading stopped.
        at: usize,
    },
    /// More than 40 digits.
    #[error("a number has at most {MAX_DIGITS} digits")]
    TooManyDigits,
    /// A power of ten beyond 400.
    #[error("a power of ten lies between -{MAX_EXPONENT} and {MAX_EXPONENT}")]
    ExponentTooLarge,
}

/// The powers of ten that doubles hold exactly.
#[rustfmt::skip]
pub(super) const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

impl Decimal {
    /// Reads `0.7`, `-3`, `+3`, `.5`, `3.`, `1.2e3`, with no space around it.
    ///
    /// # Errors
    /// Where the text is anything else, or beyond 40 digits or a power of ten of 400.
    pub fn parse(text: &str) -> Result<Self, DecimalFault> {
        if let Some(short) = short(text) {
            return Ok(short);
        }
        let end = number_length(text);
        if end != text.len() || end == 0 {
            return Err(DecimalFault::NotANumber { at: end });
        }
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = whole.trim_start_matches(['+', '-']).len() + fraction.len();
        if digits > MAX_DIGITS {
            return Err(DecimalFault::TooManyDigits);
        }
        let exponent: i32 = exponent.parse().map_err(|_| DecimalFault::ExponentTooLarge)?;
        if exponent.abs() > MAX_EXPONENT {
            return Err(DecimalFault::ExponentTooLarge);
        }
        let unscaled = Integer::from_str_radix(&format!("{whole}{fraction}"), 10)
            .map_err(|_| DecimalFault::NotANumber { at: 0 })?;
        let scale = i32::try_from(fraction.len()).map_err(|_| DecimalFault::TooManyDigits)? - exponent;
        Ok(Self { unscaled, scale })
    }

    /// `unscaled / 10^scale`: a point of a grid whose step has `scale` decimals.
    ///
    /// ```
    /// use momentous_quantity::Decimal;
    /// assert_eq!(Decimal::from_scaled(-250, 2).to_string(), "-2.50");
    /// ```
    #[must_use]
    pub fn from_scaled(unscaled: impl Into<Integer>, scale: u32) -> Self {
        Self::new(unscaled.into(), i32::try_from(scale).unwrap_or(i32::MAX))
    }

    /// `unscaled / 10^scale`; a negative scale stands for zeros that are not figures.
    pub(super) fn new(unscaled: Integer, scale: i32) -> Self {
        Self { unscaled, scale }
    }

    /// The digits as an integer, with the sign.
    #[must_use]
    pub fn unscaled(&self) -> &Integer {
        &self.unscaled
    }

    /// The number of the digits that stand behind the point; negative for `1.2e3`.
    #[must_use]
    pub fn scale(&self) -> i32 {
        self.scale
    }

    /// The value times `10^scale`, where that is an integer and fits.
    #[must_use]
    pub fn to_scaled(&self, scale: u32) -> Option<i128> {
        let shift = i64::from(scale) - i64::from(self.scale);
        let power = power_of_ten(usize::try_from(shift.unsigned_abs()).ok().filter(|places| *places <= 1000)?);
        if shift >= 0 {
            return i128::try_from(&self.unscaled * power).ok();
        }
        let quotient = &self.unscaled / &power;
        if &quotient * power == self.unscaled { i128::try_from(quotient).ok() } else { None }
    }

    /// The number of figures that are written: leading zeros do not count, trailing zeros do; at least one.
    #[must_use]
    pub fn figures(&self) -> usize {
        match i64::try_from(&self.unscaled) {
            Ok(digits) => digits.unsigned_abs().checked_ilog10().map_or(1, |places| places as usize + 1),
            Err(_) => digits_of(&self.unscaled).len(),
        }
    }

    /// The fewest figures that the writing can mean: in an integer such as `1200` trailing zeros may only hold the place.
    #[must_use]
    pub fn least_figures(&self) -> usize {
        if self.scale != 0 {
            return self.figures();
        }
        match i64::try_from(&self.unscaled) {
            Ok(0) => 1,
            Ok(digits) => self.figures() - (1..19).take_while(|places| digits % 10_i64.pow(*places) == 0).count(),
            Err(_) => digits_of(&self.unscaled).trim_end_matches('0').len().max(1),
        }
    }

    /// The exact value.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        if let (Ok(digits), Ok(scale @ 0..=18)) = (i64::try_from(&self.unscaled), u32::try_from(self.scale)) {
            // Reducing machine words is quicker; two of them hold 64 bits on every machine.
            let sign = if digits < 0 { Sign::Negative } else { Sign::Positive };
            return Rational::from_parts_const(sign, digits.unsigned_abs().into(), 10_u64.pow(scale).into());
        }
        let power = power_of_ten(self.scale.unsigned_abs() as usize);
        if self.scale > 0 {
            return Rational::from_parts(self.unscaled.clone(), power.unsigned_abs());
        }
        Rational::from(&self.unscaled * power)
    }

    /// The nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        // Digits and powers of ten that doubles hold exactly need one rounding only.
        match self.few_digits() {
            #[allow(clippy::cast_precision_loss, reason = "below 2^53")]
            Some((digits, scale)) => digits as f64 / POWERS_OF_TEN[scale as usize],
            None => nearest_double(&self.to_rational()),
        }
    }

    /// The digits, and how many of them stand behind the point, where doubles hold the digits and that power of ten exactly.
    #[must_use]
    pub fn few_digits(&self) -> Option<(i64, u32)> {
        let digits = i64::try_from(&self.unscaled).ok().filter(|digits| digits.unsigned_abs() < 1 << 53)?;
        let scale = u32::try_from(self.scale).ok().filter(|scale| (*scale as usize) < POWERS_OF_TEN.len())?;
        Some((digits, scale))
    }

    /// Whether the value is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.unscaled.is_zero()
    }

    /// Whether the value is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.unscaled.sign() == Sign::Negative
    }

    /// The absolute value, written with the same figures.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self::new(self.unscaled.clone().abs(), self.scale)
    }

    /// Compares values: `0.70` with `0.7` is `Equal`.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        self.to_rational().cmp(&other.to_rational())
    }
}

impl Neg for Decimal {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.unscaled, self.scale)
    }
}

impl From<i64> for Decimal {
    fn from(value: i64) -> Self {
        Self::new(Integer::from(value), 0)
    }
}

/// Without a power of ten: `.5` prints as `0.5`, `1.2e3` as `1200`, and zero never has a sign.
impl fmt::Display for Decimal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_negative() {
            out.write_str("-")?;
        }
        let (mut room, long);
        let digits = match u64::try_from(&self.unscaled.clone().abs()) {
            Ok(few) => {
                room = [0; MOST_DIGITS];
                few_digits(few, &mut room)
            }
            Err(_) => {
                long = digits_of(&self.unscaled);
                &long
            }
        };
        let places = self.scale.unsigned_abs() as usize;
        let zeros = |out: &mut fmt::Formatter<'_>, count: usize| (0..count).try_for_each(|_| out.write_str("0"));
        if self.scale <= 0 {
            out.write_str(digits)?;
            return zeros(out, if self.is_zero() { 0 } else { places });
        }
        let (whole, fraction) = digits.split_at(digits.len().saturating_sub(places));
        out.write_str(if whole.is_empty() { "0" } else { whole })?;
        out.write_str(".")?;
        zeros(out, places.saturating_sub(fraction.len()))?;
        out.write_str(fraction)
    }
}

/// A number of few digits without a power of ten, in one pass; `None` of any other text.
fn short(text: &str) -> Option<Decimal> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.len() > 18 {
        return None;
    }
    let (mut size, mut scale): (i64, Option<i32>) = (0, None);
    for byte in digits.bytes() {
        match (byte, scale) {
            (b'.', None) => scale = Some(0),
            (b'0'..=b'9', _) => {
                size = 10 * size + i64::from(byte - b'0');
                scale = scale.map(|places| places + 1);
            }
            _ => return None,
        }
    }
    let is_number = digits.len() > usize::from(scale.is_some());
    let size = if text.starts_with('-') { -size } else { size };
    is_number.then(|| Decimal { unscaled: Integer::from(size), scale: scale.unwrap_or(0) })
}

/// How many bytes at the start of the text are a number; 0 where none is.
pub(super) fn number_length(text: &str) -> usize {
    let digits = |from: usize| text.bytes().skip(from).take_while(u8::is_ascii_digit).count();
    let byte = |at: usize| text.as_bytes().get(at).copied();
    let start = usize::from(matches!(byte(0), Some(b'+' | b'-')));
    let whole = digits(start);
    let mut end = start + whole;
    if byte(end) == Some(b'.') {
        let fraction = digits(end + 1);
        if whole + fraction == 0 {
            return 0;
        }
        end += 1 + fraction;
    } else if whole == 0 {
        return 0;
    }
    if matches!(byte(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(byte(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    end
}

/// `10^places`.
pub(super) fn power_of_ten(places: usize) -> Integer {
    /// The largest power that fits.
    const SHORT: usize = 38;
    match u32::try_from(places) {
        Ok(few) if places <= SHORT => Integer::from(10_u128.pow(few)),
        _ => Integer::from(10).pow(places),
    }
}

/// The number of digits that a machine word has at most.
const MOST_DIGITS: usize = 20;

/// The digits of a machine word, at the end of the room for them.
fn few_digits(mut number: u64, room: &mut [u8; MOST_DIGITS]) -> &str {
    let mut written = 0;
    for place in room.iter_mut().rev() {
        *place = b'0' + (number % 10) as u8;
        number /= 10;
        written += 1;
        if number == 0 {
            break;
        }
    }
    std::str::from_utf8(room.split_at(MOST_DIGITS - written).1).unwrap_or_default()
}

/// The digits without the sign.
fn digits_of(value: &Integer) -> String {
    match i64::try_from(value) {
        Ok(few) => few.unsigned_abs().to_string(),
        Err(_) => value.clone().abs().to_string(),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;

    #[test]
    fn prints_what_was_written() {
        let cases = [
            ("0.7", "0.7", 1),
            ("0.70", "0.70", 2),
            ("-3", "-3", 1),
            ("+3", "3", 1),
            (".5", "0.5", 1),
            ("3.", "3", 1),
            ("1.2e3", "1200", 2),
            ("1.2E+3", "1200", 2),
            ("-1.25e-3", "-0.00125", 3),
            ("007", "7", 1),
            ("-0.0", "0.0", 1),
            ("0e5", "0", 1),
            ("100", "100", 3),
            ("10.0", "10.0", 3),
        ];
        for (text, printed, figures) in cases {
            let decimal = Decimal::parse(text).unwrap();
            assert_eq!((decimal.to_string().as_str(), decimal.figures()), (printed, figures), "{text}");
        }
    }

    #[test]
    fn refuses_what_is_not_a_number() {
        let faults = [("", 0), ("-", 0), (".", 0), ("e3", 0), ("3..2", 2), ("3,14", 1), ("1_200", 1), ("1.2e", 3)];
        for (text, at) in faults {
            assert_eq!(Decimal::parse(text), Err(DecimalFault::NotANumber { at }), "{text}");
        }
        assert_eq!(Decimal::parse(&"1".repeat(41)), Err(DecimalFault::TooManyDigits));
        for text in ["1e401", "1e-401", "1e99999999999999999999"] {
            assert_eq!(Decimal::parse(text), Err(DecimalFault::ExponentTooLarge), "{text}");
        }
    }

    #[test]
    fn knows_its_value() {
        let value = |text| Decimal::parse(text).unwrap();
        assert_eq!(value("0.70").compare(&value("0.7")), Ordering::Equal);
        assert_eq!(value("-1.5").compare(&value("-1.25")), Ordering::Less);
        assert_eq!(value("0.1").to_f64().to_bits(), 0.1_f64.to_bits());
        assert_eq!(
            (value("0.5").to_scaled(2), value("2").to_scaled(0), value("1e3").to_scaled(1)),
            (Some(50), Some(2), Some(10000))
        );
        assert_eq!((value("0.05").to_scaled(1), value("1e400").to_scaled(0)), (None, None));
        assert_eq!(
            (value("1200").least_figures(), value("1200.").least_figures(), value("0.70").least_figures()),
            (2, 2, 2)
        );
    }
}
