//! Units in print: plain, Unicode and LaTeX; and in words.

use std::fmt;

use super::Unit;
use super::unit::{Power, Symbol};

/// How a form of print writes the parts of a unit.
struct Style {
    between: &'static str,
    symbol: fn(&mut String, &str),
    exponent: fn(u8) -> String,
}

const PLAIN: Style = Style { between: " ", symbol: String::push_str, exponent: |exponent| format!("^{exponent}") };
const UNICODE: Style =
    Style { between: "·", symbol: String::push_str, exponent: |exponent| superscript(u32::from(exponent)) };
const LATEX: Style = Style { between: "\\,", symbol: latex_symbol, exponent: latex_exponent };

impl Unit {
    /// With raised exponents and dots: `kg·m/s²`.
    #[must_use]
    pub fn unicode(&self) -> String {
        self.print(&UNICODE)
    }

    /// For LaTeX's mathematics: `\mathrm{kg\,m/s^2}`; alone `^\circ` and `\%`, which follow their number at once.
    #[must_use]
    pub fn latex(&self) -> String {
        let unit = self.print(&LATEX);
        match self.powers() {
            [] => unit,
            [_] if self.is_attached() => unit.trim_start_matches("{}").to_owned(),
            _ => format!("\\mathrm{{{unit}}}"),
        }
    }

    /// In words, for one or for several: `metres per second`, `newton seconds`, `kilogram metres per second`.
    #[must_use]
    pub fn spoken(&self, plural: bool) -> String {
        let (above, below) = self.fraction();
        let last = above.len().saturating_sub(1);
        let mut words = String::new();
        for (position, power) in above.iter().enumerate() {
            words.push_str(if position == 0 { "" } else { " " });
            speak_power(&mut words, power, plural && position == last, above.len() == 1);
        }
        for power in below {
            words.push_str(if words.is_empty() { "per " } else { " per " });
            speak_power(&mut words, power, false, true);
        }
        words
    }

    /// The powers above and below the fraction bar.
    fn fraction(&self) -> (&[Power], &[Power]) {
        let powers = self.powers();
        powers.split_at(powers.partition_point(|power| power.exponent > 0))
    }

    fn print(&self, style: &Style) -> String {
        let (above, below) = self.fraction();
        let mut out = String::new();
        if above.is_empty() && !below.is_empty() {
            out.push('1');
        }
        style.put_product(&mut out, above);
        match below {
            [] => {}
            [single] => {
                out.push('/');
                style.put_power(&mut out, single);
            }
            several => {
                out.push_str("/(");
                style.put_product(&mut out, several);
                out.push(')');
            }
        }
        out
    }
}

impl Style {
    fn put_product(&self, out: &mut String, powers: &[Power]) {
        for (index, power) in powers.iter().enumerate() {
            out.push_str(if index > 0 { self.between } else { "" });
            self.put_power(out, power);
        }
    }

    /// A power without its sign, which the fraction bar already shows.
    fn put_power(&self, out: &mut String, power: &Power) {
        if let Some(prefix) = power.symbol.prefix {
            (self.symbol)(out, prefix.symbol);
        }
        (self.symbol)(out, power.symbol.row.symbol);
        let exponent = power.exponent.unsigned_abs();
        if exponent != 1 {
            out.push_str(&(self.exponent)(exponent));
        }
    }
}

/// Plain text that [`Unit::parse`] reads back: `kg m/s^2`, `m/(s kg)`, `1/s`.
impl fmt::Display for Unit {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.print(&PLAIN))
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}{}", self.prefix.map_or("", |prefix| prefix.symbol), self.row.symbol)
    }
}

/// A whole number, raised: `¹²`.
pub(super) fn superscript(exponent: u32) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    exponent.to_string().chars().filter_map(|digit| digits.get(digit.to_digit(10)? as usize)).collect()
}

fn latex_symbol(out: &mut String, symbol: &str) {
    for character in symbol.chars() {
        match character {
            '%' => out.push_str("\\%"),
            '°' => out.push_str("{}^\\circ"),
            'µ' => out.push_str("\\mu "),
            other => out.push(other),
        }
    }
}

fn latex_exponent(exponent: u8) -> String {
    if exponent < 10 { format!("^{exponent}") } else { format!("^{{{exponent}}}") }
}

/// `alone`: nothing is multiplied with it, so that an area may be `square metres`.
fn speak_power(words: &mut String, power: &Power, plural: bool, alone: bool) {
    let row = power.symbol.row;
    let before = row.dimension == super::Dimension::LENGTH && alone;
    let exponent = power.exponent.unsigned_abs();
    words.push_str(match exponent {
        2 if before => "square ",
        3 if before => "cubic ",
        _ => "",
    });
    words.push_str(power.symbol.prefix.map_or("", |prefix| prefix.name));
    words.push_str(if plural { row.plural } else { row.singular });
    match exponent {
        1 => {}
        2 | 3 if before => {}
        2 => words.push_str(" squared"),
        3 => words.push_str(" cubed"),
        exponent => words.extend([" to the power of ", &exponent.to_string()]),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;

    #[test]
    fn prints_in_every_form() {
        let cases = [
            ("kg m/s", "kg·m/s", r"\mathrm{kg\,m/s}", "kilogram metres per second"),
            ("N s", "N·s", r"\mathrm{N\,s}", "newton seconds"),
            ("m/s^2", "m/s²", r"\mathrm{m/s^2}", "metres per second squared"),
            ("°", "°", r"^\circ", "degrees"),
            ("°/s", "°/s", r"\mathrm{{}^\circ/s}", "degrees per second"),
            ("%", "%", r"\%", "per cent"),
            ("µs", "µs", r"\mathrm{\mu s}", "microseconds"),
            ("ft lb", "ft·lb", r"\mathrm{ft\,lb}", "foot pounds"),
            ("1/s", "1/s", r"\mathrm{1/s}", "per second"),
            ("m^2", "m²", r"\mathrm{m^2}", "square metres"),
            ("kg m^2/s", "kg·m²/s", r"\mathrm{kg\,m^2/s}", "kilogram metres squared per second"),
            ("N/m^2", "N/m²", r"\mathrm{N/m^2}", "newtons per square metre"),
            ("m/(s kg)", "m/(s·kg)", r"\mathrm{m/(s\,kg)}", "metres per second per kilogram"),
            ("lb s", "lb·s", r"\mathrm{lb\,s}", "pound seconds"),
            ("mph", "mph", r"\mathrm{mph}", "miles per hour"),
            ("", "", "", ""),
        ];
        for (plain, unicode, latex, spoken) in cases {
            let unit = Unit::parse(plain).unwrap();
            let printed = (unit.to_string(), unit.unicode(), unit.latex(), unit.spoken(true));
            assert_eq!(printed, (plain.into(), unicode.into(), latex.into(), spoken.into()));
        }
        assert_eq!(Unit::parse("ft/s").unwrap().spoken(false), "foot per second");
        assert_eq!(Unit::parse("m^12").ok(), None);
        let tall = Unit::parse("m^6").unwrap().power(2).unwrap();
        assert_eq!((tall.unicode(), tall.latex()), ("m¹²".into(), r"\mathrm{m^{12}}".into()));
    }
}
