//! Numbers and values with units, as an author writes them.

use momentous_fault::{Code, Fault, Span};
use momentous_quantity::{Decimal, DecimalFault, Unit, UnitFault};

/// One or more components in one unit: `3 kg`, `0.7`, `(2, -3) m`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Literal {
    /// One number; of a vector, its components along the axes in order.
    pub components: Vec<Decimal>,
    /// Their unit.
    pub unit: Unit,
}

impl Literal {
    /// Reads a value; `None` where the text is not a value but may be an expression (`2*m_A`).
    ///
    /// # Errors
    /// A value that is written wrongly (`1_000`, `3,5 m`, `3 kgg`), with its place within the text.
    ///
    /// ```
    /// use momentous_problem::Literal;
    /// let place = Literal::read("(2, -3.0) m").unwrap().unwrap();
    /// assert_eq!((place.components[1].to_string(), place.unit.to_string()), ("-3.0".into(), "m".into()));
    /// assert_eq!(Literal::read("2*m_A"), Ok(None));
    /// ```
    pub fn read(text: &str) -> Result<Option<Self>, Fault> {
        let start = text.len() - text.trim_start().len();
        if text[start..].starts_with('(') {
            return vector(text, start);
        }
        let length = number_length(&text[start..]);
        let end = start + length;
        let rest = &text[end..];
        if length == 0 || rest.trim_start().starts_with(['*', '/', '+', '-', '^', '(']) {
            return Ok(None);
        }
        // A number that goes on has too many digits, or too great a power of ten.
        let end = end + rest.bytes().take_while(u8::is_ascii_digit).count();
        let rest = &text[end..];
        let number = number(&text[start..end]).map_err(|fault| fault.within(Span { start, end }))?;
        if rest.starts_with(['_', ',']) && rest[1..].starts_with(|next: char| next.is_ascii_digit()) {
            let fault = Fault::new(Code::Value, format!("`{}` is not a number", text.trim()));
            let help = "write digits without separators, and a decimal point: `1000`, `3.5`";
            return Err(fault.help(help).within(Span { start, end: text.trim_end().len() }));
        }
        Ok(unit(text, end)?.map(|unit| Self { components: vec![number], unit }))
    }
}

/// Reads a bare decimal number, and says what is wrong with anything else.
///
/// # Errors
/// A text that is not a number, has too many digits, or leading zeros, which some tools read as octal.
pub fn number(text: &str) -> Result<Decimal, Fault> {
    let fault = |message: String, help: String| Fault::new(Code::Value, message).help(help);
    let digits = text.trim_start_matches(['+', '-']);
    let significant = digits.trim_start_matches('0');
    if digits.len() > significant.len() + 1
        || (digits.len() > significant.len() && significant.starts_with(|next: char| next.is_ascii_digit()))
    {
        let sign = if text.starts_with('-') { "-" } else { "" };
        let zero = if significant.starts_with(|next: char| next.is_ascii_digit()) { "" } else { "0" };
        return Err(fault(
            format!("`{text}` has leading zeros, which some tools read as octal"),
            format!("write `{sign}{zero}{significant}`"),
        ));
    }
    Decimal::parse(text).map_err(|error| match error {
        DecimalFault::NotANumber { .. } => {
            fault(format!("`{text}` is not a number"), "write a decimal such as `2`, `-0.5` or `1e3`".to_owned())
        }
        other => fault(other.to_string(), "choose a unit in which the number is shorter".to_owned()),
    })
}

fn vector(text: &str, start: usize) -> Result<Option<Literal>, Fault> {
    let Some(close) = text.find(')') else { return Ok(None) };
    let inside = &text[start + 1..close];
    if !inside.contains(',') || inside.contains('(') {
        return Ok(None);
    }
    let mut components = Vec::new();
    let mut at = start + 1;
    for part in inside.split(',') {
        let begin = at + part.len() - part.trim_start().len();
        let span = Span { start: begin, end: begin + part.trim().len() };
        components.push(number(part.trim()).map_err(|fault| fault.within(span))?);
        at += part.len() + 1;
    }
    if components.len() > 3 {
        let fault = Fault::new(Code::Value, format!("a vector has two or three components, not {}", components.len()));
        return Err(fault.help("write one component for each axis").within(Span { start, end: close + 1 }));
    }
    Ok(unit(text, close + 1)?.map(|unit| Literal { components, unit }))
}

/// Reads the unit that follows a number; `None` where what follows is part of an expression.
fn unit(text: &str, end: usize) -> Result<Option<Unit>, Fault> {
    let rest = &text[end..];
    let start = end + rest.len() - rest.trim_start().len();
    match Unit::parse(rest.trim()) {
        Ok(unit) => Ok(Some(unit)),
        Err(_) if rest.contains(['+', '*', '_', '(', ')', '=']) || rest.contains(" - ") => Ok(None),
        Err(fault) => Err(unit_fault(fault, start)),
    }
}

/// The fault of a unit that begins at that byte of a value of the file.
pub(crate) fn unit_fault(fault: UnitFault, start: usize) -> Fault {
    let within = Span { start: start + fault.span.start, end: start + fault.span.end };
    let mut fault = Fault::from(fault);
    fault.span = None;
    fault.within(within)
}

/// How many bytes at the start of a text are a number: sign, digits with a point, power of ten.
fn number_length(text: &str) -> usize {
    let candidates = text.char_indices().map(|(at, _)| at).chain([text.len()]).take(64);
    candidates.filter(|end| Decimal::parse(&text[..*end]).is_ok()).last().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> String {
        match Literal::read(text) {
            Ok(None) => "expression".to_owned(),
            Ok(Some(literal)) => {
                let numbers: Vec<String> = literal.components.iter().map(ToString::to_string).collect();
                format!("{} [{}]", numbers.join(" "), literal.unit)
            }
            Err(fault) => {
                let within = fault.within.map(|at| &text[at.start..at.end]).unwrap_or_default();
                format!("{} at {within}", fault.message)
            }
        }
    }

    #[test]
    fn values_keep_their_figures() {
        let cases = [
            ("0.7", "0.7 []"),
            ("0.70", "0.70 []"),
            ("1e3", "1000 []"),
            (".5", "0.5 []"),
            ("-0.05 m/s", "-0.05 [m/s]"),
            ("3kg", "3 [kg]"),
            ("2 kg*m/s", "2 [kg m/s]"),
            ("(2, -3.50) m", "2 -3.50 [m]"),
            ("(1,2,3)", "1 2 3 []"),
        ];
        for (text, expected) in cases {
            assert_eq!(read(text), expected, "{text}");
        }
    }

    #[test]
    fn expressions_are_left_to_their_reader() {
        for text in ["m_A", "2*m_A", "2 m + x", "(m_A + m_B)/2", "1 - e", "-m_A", "2 m*x_1", ""] {
            assert_eq!(read(text), "expression", "{text}");
        }
    }

    #[test]
    fn traps_are_faults_in_their_place() {
        let cases = [
            ("007", "`007` has leading zeros, which some tools read as octal at 007"),
            ("00.5 m", "`00.5` has leading zeros, which some tools read as octal at 00.5"),
            ("1_000 kg", "`1_000 kg` is not a number at 1_000 kg"),
            ("3,5 m", "`3,5 m` is not a number at 3,5 m"),
            ("(2, x) m", "`x` is not a number at x"),
            ("(1, 2, 3, 4)", "a vector has two or three components, not 4 at (1, 2, 3, 4)"),
            ("1e999 kg", "a power of ten lies between -400 and 400 at 1e999"),
            ("3 kgg", "the unit `kgg` is not known at kgg"),
        ];
        for (text, expected) in cases {
            assert_eq!(read(text), expected, "{text}");
        }
    }
}
