//! Reading units as people write them.

use momentous_fault::Span;

use super::unit::Symbol;
use super::unit_lookup::{find_spelling, find_symbol, in_other_case, near};
use super::unit_token::{Token, tokens};
use super::units_table::SECOND;
use super::{Unit, UnitFault, UnitFaultKind};

/// How deeply brackets, and words that stand for products, may be nested.
const MAX_DEPTH: usize = 4;

/// Symbols with their exponents, as far as they have been read.
type Powers = Vec<(Symbol, i32)>;

impl Unit {
    /// Reads a unit: `m/s`, `m s^-1`, `m·s⁻¹`, `N-s`, `Ns`, `kg*m/s^2`, `m/(s kg)`, `ft lb`, `km/h`, `%`; `1` or nothing for none.
    ///
    /// ```
    /// use momentous_quantity::Unit;
    /// assert_eq!(Unit::parse("kg*m*s⁻²")?.to_string(), "kg m/s^2");
    /// let fault = Unit::parse("kg m/sek").unwrap_err();
    /// assert_eq!((fault.span.start, fault.help().as_str()), (5, "did you mean `sec`?"));
    /// # Ok::<(), momentous_quantity::UnitFault>(())
    /// ```
    ///
    /// # Errors
    /// Where a name is not known, the text can be read in two ways (`m/s kg`), or is no product of powers.
    pub fn parse(text: &str) -> Result<Self, UnitFault> {
        if text.trim().is_empty() {
            return Ok(Self::none());
        }
        let powers = read(text, 0)?;
        Self::from_powers(powers).ok_or_else(|| UnitFault::new(UnitFaultKind::TooLong, 0, text.len()))
    }
}

fn read(text: &str, depth: usize) -> Result<Powers, UnitFault> {
    let mut reader = Reader { text, tokens: tokens(text)?, next: 0 };
    let powers = reader.product(depth)?;
    match reader.peek() {
        None => Ok(powers),
        Some((_, span)) => Err(reader.unexpected(span)),
    }
}

/// The powers that a word stands for.
fn word_powers(word: &str, span: Span, depth: usize) -> Result<Powers, UnitFault> {
    if let Some(symbol) = find_symbol(word) {
        return Ok(vec![(symbol, 1)]);
    }
    if depth >= MAX_DEPTH {
        return Err(UnitFault { kind: UnitFaultKind::TooLong, span });
    }
    if let Some(meaning) = find_spelling(word) {
        return read(meaning, depth + 1);
    }
    match in_other_case(word).as_slice() {
        [only] => word_powers(only, span, depth + 1),
        [] => Err(UnitFault { kind: UnitFaultKind::Unknown { name: word.to_owned(), near: near(word) }, span }),
        several => Err(UnitFault {
            kind: UnitFaultKind::Ambiguous { written: word.to_owned(), readings: several.to_vec() },
            span,
        }),
    }
}

/// A word with a power behind it.
enum Raised {
    /// One reading.
    Plain(Powers),
    /// Either of these.
    Either([Powers; 2]),
}

/// A power behind a word applies to its last unit. `Nm^-1` is one newton per metre: letters that are written together
/// are units of their own. The SI reads `ms^-1` as one per millisecond; whoever types it nearly always means metres per
/// second.
fn raised_word(word: &str, span: Span, powers: Powers, exponent: i32, depth: usize) -> Raised {
    if find_symbol(word).is_none() && powers.len() > 1 {
        let mut last = powers.clone();
        let Some((_, power)) = last.last_mut() else { return Raised::Plain(powers) };
        match (power.signum(), exponent.signum()) {
            // `kmh^-1`: km/h, and so is `kmh`.
            (-1, -1) => *power = exponent,
            (-1, _) if word.contains('p') => *power = -exponent,
            (-1, _) => {
                *power = exponent;
                return Raised::Either([last, raise(powers, exponent)]);
            }
            _ => *power *= exponent,
        }
        return Raised::Plain(last);
    }
    let head = word.strip_suffix('s').filter(|_| exponent < 0).map(|head| word_powers(head, span, depth));
    match head {
        Some(Ok(mut apart)) => {
            apart.push((Symbol::plain(&SECOND), exponent));
            Raised::Either([apart, raise(powers, exponent)])
        }
        _ => Raised::Plain(raise(powers, exponent)),
    }
}

fn raise(powers: Powers, exponent: i32) -> Powers {
    powers.into_iter().map(|(symbol, power)| (symbol, power * exponent)).collect()
}

fn print(powers: Powers) -> String {
    Unit::from_powers(powers).map_or_else(String::new, |unit| unit.to_string())
}

struct Reader<'text> {
    text: &'text str,
    tokens: Vec<(Token<'text>, Span)>,
    next: usize,
}

impl<'text> Reader<'text> {
    fn peek(&self) -> Option<(Token<'text>, Span)> {
        self.tokens.get(self.next).copied()
    }

    fn take_if(&mut self, token: Token) -> bool {
        let is_next = self.peek().is_some_and(|(next, _)| next == token);
        self.next += usize::from(is_next);
        is_next
    }

    /// Factors up to a closing bracket or the end. Once divided, only a further division may follow: `m/s kg` has two readings.
    fn product(&mut self, depth: usize) -> Result<Powers, UnitFault> {
        let start = self.peek().map_or(self.text.len(), |(_, span)| span.start);
        let mut product = self.first_factor(depth)?;
        let mut divided = false;
        loop {
            let divide = self.take_if(Token::Divide);
            let times = !divide && self.take_if(Token::Times);
            if !divide && !times && self.peek().is_none_or(|(token, _)| token == Token::Close) {
                return Ok(product);
            }
            let factor = self.factor(depth)?;
            if divided && !divide {
                return Err(self.two_readings(
                    start,
                    [
                        product.iter().chain(&factor).copied().collect(),
                        product.iter().copied().chain(raise(factor, -1)).collect(),
                    ],
                ));
            }
            divided |= divide;
            product.extend(if divide { raise(factor, -1) } else { factor });
        }
    }

    /// Reads like [`Reader::factor`]; here alone the number one may stand, of which something is said per something:
    /// `1/s`.
    fn first_factor(&mut self, depth: usize) -> Result<Powers, UnitFault> {
        if !self.take_if(Token::One) {
            return self.factor(depth);
        }
        match self.peek() {
            None | Some((Token::Divide | Token::Close, _)) => Ok(Powers::new()),
            Some((_, span)) => Err(self.unexpected(span)),
        }
    }

    /// A word or a bracket, with its exponent.
    fn factor(&mut self, depth: usize) -> Result<Powers, UnitFault> {
        let end = Span { start: self.text.len(), end: self.text.len() };
        let (token, span) = self.peek().ok_or(UnitFault { kind: UnitFaultKind::Missing, span: end })?;
        self.next += 1;
        let base = match token {
            Token::Word(word) => word_powers(word, span, depth)?,
            Token::Power(power) => match self.peek() {
                Some((Token::Word(word), span)) => {
                    self.next += 1;
                    return Ok(raise(word_powers(word, span, depth)?, power));
                }
                _ => return Err(self.unexpected(span)),
            },
            Token::Open if depth >= MAX_DEPTH => return Err(UnitFault { kind: UnitFaultKind::TooLong, span }),
            Token::Open => {
                let inner = self.product(depth + 1)?;
                if self.take_if(Token::Close) { inner } else { return Err(self.unexpected(span)) }
            }
            Token::Exponent(_) | Token::One => return Err(self.unexpected(span)),
            Token::Times | Token::Divide | Token::Close => {
                return Err(UnitFault { kind: UnitFaultKind::Missing, span });
            }
        };
        let Some((Token::Exponent(exponent), _)) = self.peek() else { return Ok(base) };
        self.next += 1;
        let Token::Word(word) = token else { return Ok(raise(base, exponent)) };
        match raised_word(word, span, base, exponent, depth) {
            Raised::Plain(powers) => Ok(powers),
            Raised::Either(readings) => Err(self.two_readings(span.start, readings)),
        }
    }

    /// The fault that what is written there has no place there.
    fn unexpected(&self, span: Span) -> UnitFault {
        UnitFault { kind: UnitFaultKind::Unexpected(self.text[span.start..span.end].to_owned()), span }
    }

    /// The fault that everything from `start` to what was read last has these two readings.
    fn two_readings(&self, start: usize, readings: [Powers; 2]) -> UnitFault {
        let end = self.next.checked_sub(1).and_then(|last| self.tokens.get(last)).map_or(start, |(_, span)| span.end);
        let written = self.text[start..end].to_owned();
        let kind = UnitFaultKind::Ambiguous { written, readings: readings.map(print).to_vec() };
        UnitFault { kind, span: Span { start, end } }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;
    use crate::prefix::PREFIXES;
    use crate::units_table::UNITS;
    use proptest::prelude::*;

    #[test]
    fn reads_units_as_people_write_them() {
        let table: &[(&str, &[&str])] = &[
            (
                "m/s",
                &[
                    "m s^-1",
                    "m·s⁻¹",
                    "m s⁻¹",
                    "m*s^-1",
                    "m s-1",
                    "m s^{-1}",
                    "m s**-1",
                    "m s−1",
                    "metres per second",
                    " m / s ",
                ],
            ),
            ("m/s^2", &["m/s/s", "m/s2", "m/s²", "m s^(-2)", "m/s per second", "m/(s s)", "meters/sec^2"]),
            (
                "N s",
                &[
                    "N·s",
                    "N*s",
                    "N-s",
                    "Ns",
                    "N.s",
                    "N x s",
                    "N‧s",
                    "Nsec",
                    "Newton Seconds",
                    "N S",
                    "newton seconds",
                    "N\u{a0}s",
                    "N s",
                ],
            ),
            ("N m s", &["N m s", "Nms", "N-m-s", "N·m·s"]),
            (
                "kg m/s",
                &["kg*m/s", "kg·m/s", "kg.m/s", "kg-m/s", "kgm/s", "kg m s^-1", "(kg m)/s", "kg m s^0/s", "Kg m/s"],
            ),
            ("km/h", &["kph", "kmh", "km/hr", "kilometres per hour", "km h^-1", "kmh^-1", "KM/H", "Km/h"]),
            ("kg m^2/s", &["kgm²/s", "kgm^2/s", "kgm2/s", "kg m ^ 2/s"]),
            ("kg m^2/s^2", &["kgm^2s^-2"]),
            ("N/m", &["Nm^-1"]),
            ("N/s", &["Ns^-1"]),
            ("ft/s^2", &["fps^2"]),
            ("J", &["Joules", "JOULES"]),
            ("cm^3", &["cc"]),
            ("t", &["metric tons"]),
            ("lb s", &["lb-s", "lbf s", "lb·s", "lbf·sec", "pound-seconds"]),
            ("ft lb", &["ft-lb", "ftlb", "ft·lbf", "foot-pounds", "ft lbs"]),
            ("slug ft/s", &["slug-ft/s", "slug*ft/s", "slugs feet per second"]),
            ("m/(s kg)", &["m s^-1 kg^-1", "m/s/kg", "m s⁻¹/kg"]),
            ("m^2/s^2", &["(m/s)^2", "(m/s)²", "m^2 s^-2"]),
            ("1/s", &["s^-1", "s⁻¹", "1/sec"]),
            ("", &["1", " ", "m/m"]),
            ("°", &["deg", "degrees", "º"]),
            ("°/s", &["deg/s", "degrees per second"]),
            ("rev/min", &["rev min^-1", "rev per minute"]),
            ("µs", &["us", "μs", "microseconds"]),
            ("Mg", &["megagrams"]),
            ("kW h", &["kWh", "kW-h"]),
            ("mi/h", &["miles per hour"]),
            ("kt", &["knot", "knots"]),
            ("%", &["percent"]),
            ("kg^2", &["kg kg", "kg²", "kgs^2"]),
        ];
        for (printed, spellings) in table {
            for text in spellings.iter().chain([printed]) {
                assert_eq!(Unit::parse(text).map(|unit| unit.to_string()), Ok((*printed).to_owned()), "{text}");
            }
        }
    }

    #[test]
    fn says_what_is_wrong_and_where() {
        let cases = [
            ("kg m/sek", 5, 8, "the unit `sek` is not known", "did you mean `sec`?"),
            ("foo", 0, 3, "the unit `foo` is not known", "did you mean `foot`?"),
            ("MM", 0, 2, "`MM` can be read in two ways", "write `mm` or `Mm`"),
            ("3h00", 0, 1, "`3` is not allowed here in a unit", ""),
            ("h00", 1, 2, "`0` is not allowed here in a unit", ""),
            ("rads^-1", 0, 7, "`rads^-1` can be read in two ways", "write `rad/s` or `1/rad`"),
            ("m/s kg", 0, 6, "`m/s kg` can be read in two ways", "write `m kg/s` or `m/(s kg)`"),
            ("kg ms^-1", 3, 8, "`ms^-1` can be read in two ways", "write `m/s` or `1/ms`"),
            ("m/", 2, 2, "a unit is missing here", ""),
            ("/s", 0, 1, "a unit is missing here", ""),
            ("m//s", 2, 3, "a unit is missing here", ""),
            ("()", 1, 2, "a unit is missing here", ""),
            ("(m", 0, 1, "`(` is not allowed here in a unit", ""),
            ("m)", 1, 2, "`)` is not allowed here in a unit", ""),
            ("m^2^2", 3, 5, "`^2` is not allowed here in a unit", ""),
            ("m s -1", 4, 5, "`-` is not allowed here in a unit", ""),
            ("m s - 1", 6, 7, "`1` is not allowed here in a unit", ""),
            ("1 m", 2, 3, "`m` is not allowed here in a unit", ""),
            ("m 1", 2, 3, "`1` is not allowed here in a unit", ""),
            ("3 m", 0, 1, "`3` is not allowed here in a unit", ""),
            ("m + s", 2, 3, "`+` is not allowed here in a unit", ""),
            ("m^", 1, 2, "the exponent of a unit is an integer from -9 to 9", ""),
            ("m^x", 1, 2, "the exponent of a unit is an integer from -9 to 9", ""),
            ("m^{2", 1, 4, "the exponent of a unit is an integer from -9 to 9", ""),
            ("m^10", 1, 4, "the exponent of a unit is an integer from -9 to 9", ""),
            ("m^99999999999", 1, 13, "the exponent of a unit is an integer from -9 to 9", ""),
            ("(((((m)))))", 4, 5, "this is too long for a unit", ""),
            ("((((m^9)^9)^9)^9)", 0, 17, "this is too long for a unit", ""),
        ];
        for (text, start, end, message, help) in cases {
            let fault = Unit::parse(text).unwrap_err();
            assert_eq!((fault.span, fault.to_string().as_str()), (Span { start, end }, message), "{text}");
            assert!(
                help.is_empty() || fault.help().starts_with(help.trim_end_matches('?')),
                "{text}: {}",
                fault.help()
            );
        }
        assert_eq!(Unit::parse(&"m ".repeat(61)).unwrap_err().kind, UnitFaultKind::TooLong);
    }

    fn any_power() -> impl Strategy<Value = (Symbol, i32)> {
        let symbol = (0..UNITS.len(), 0..=PREFIXES.len()).prop_map(|(row, prefix)| {
            let row = &UNITS[row];
            Symbol { row, prefix: PREFIXES.get(prefix).filter(|_| row.prefixes) }
        });
        (symbol, -3..=3_i32)
    }

    proptest! {
        #[test]
        fn reads_what_it_prints(powers in prop::collection::vec(any_power(), 0..5)) {
            let unit = Unit::from_powers(powers).unwrap();
            prop_assert_eq!(Unit::parse(&unit.to_string()), Ok(unit.clone()));
            prop_assert_eq!(Unit::parse(&unit.unicode()), Ok(unit));
        }

        #[test]
        fn products_multiply(left in prop::collection::vec(any_power(), 0..4), right in prop::collection::vec(any_power(), 0..4)) {
            let (left, right) = (Unit::from_powers(left).unwrap(), Unit::from_powers(right).unwrap());
            let product = left.times(&right).unwrap();
            prop_assert_eq!(product.dimension(), left.dimension() * right.dimension());
            prop_assert_eq!(product.factor(), left.factor() * right.factor());
            prop_assert_eq!(product.per(&right).unwrap().factor(), left.factor());
            prop_assert_eq!(left.power(2), left.times(&left));
        }

        #[test]
        fn never_panics(text in "[a-zA-Z0-9µ°%²⁻^*/(){}· .-]{0,30}|\\PC{0,20}") {
            if let Err(fault) = Unit::parse(&text) {
                prop_assert!(text.get(fault.span.start..fault.span.end).is_some());
            }
        }
    }
}
