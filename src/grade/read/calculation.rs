//! Calculations with units: `600 m + 600 m`, `2 kg*(-1.6 m/s)`; and values in several units: `1 km 200 m`, `36°52'`.

use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_quantity::Unit;

use super::super::number::Number;
use super::answer::{NumberAnswer, Written};
use super::arithmetic::{self, Form};
use super::numeral::DecimalMark;
use super::unit::unit;
use super::unreadable::At;
use super::value::check_size;

/// How deeply brackets may be nested.
const MAX_DEPTH: usize = 8;
/// The most values.
const MAX_PARTS: usize = 20;
/// The parts of a degree, as they are written.
const PARTS_OF_DEGREE: [(&str, u32); 6] =
    [("''", 3600), ("\"", 3600), ("″", 3600), ("'", 60), ("′", 60), ("arcmin", 60)];

/// The marks of feet and of inches, and the units.
const FEET: (&[&str], &str) = (&["'", "′"], "ft");
const INCHES: (&[&str], &str) = (&["''", "\"", "″"], "in");

/// The unit that a mark stands for behind a length.
fn mark_of_length(written: &str, asked: &Unit, (marks, unit): &(&[&str], &str)) -> Option<Unit> {
    let is_meant = asked.dimension() == Dimension::LENGTH && marks.contains(&written.trim());
    is_meant.then(|| Unit::parse(unit).ok())?
}

/// A value with its unit.
struct Quantity {
    number: Number,
    unit: Option<Unit>,
}

/// Reads a calculation; nothing where the text is none, or does not give what is asked.
pub(super) fn read(text: &str, asked: &Unit, mark: DecimalMark) -> Option<At<NumberAnswer>> {
    let answer = in_several_units(text, asked, mark).or_else(|| {
        let mut reader = Reader { text, at: 0, asked, mark, depth: 0, parts: 0 };
        let sum = reader.sum()?;
        (reader.rest().trim().is_empty() && reader.parts > 1).then_some(sum)
    })?;
    let unit = answer.unit.filter(|unit| unit.dimension() == asked.dimension())?;
    if let Err(kind) = check_size(&answer.number) {
        return Some(Err((0, kind)));
    }
    Some(Ok(NumberAnswer {
        signed: answer.number.is_negative(),
        number: answer.number,
        written: Written::Computed,
        unit: Some(unit),
        pounds_as_mass: false,
        sense: None,
        heading: None,
        unjudged: None,
    }))
}

/// `1 min 30 s`: one value in units that grow smaller.
fn in_several_units(text: &str, asked: &Unit, mark: DecimalMark) -> Option<Quantity> {
    let negative = text.starts_with('-');
    let mut rest = text.trim_start_matches(['-', '+', ' ']);
    let mut total: Option<(Quantity, Unit)> = None;
    let mut count = 0;
    while !rest.is_empty() {
        if !rest.starts_with(|first: char| first.is_ascii_digit()) || count >= MAX_PARTS {
            return None;
        }
        let (term, length) = arithmetic::read(rest, mark).ok()?;
        if !matches!(term.form, Form::Decimal { .. }) {
            return None;
        }
        let behind = &rest[length..];
        let end = behind.find(|next: char| next.is_ascii_digit()).unwrap_or(behind.len());
        let written = behind[..end].trim_end_matches([' ', ',']);
        let written = written.strip_suffix(" and").unwrap_or(written);
        total = Some(match total {
            None => {
                let unit = match mark_of_length(written, asked, &FEET) {
                    Some(unit) => unit,
                    None => unit(written, 0, written.len(), asked).ok()??,
                };
                (Quantity { number: term.number, unit: Some(unit.clone()) }, unit)
            }
            Some((sum, last)) => {
                let first = sum.unit.clone()?;
                let (size, smaller) = part(written, asked, &first, &last)?;
                let number = sum.number.plus(&term.number.times(&size)?)?;
                (Quantity { number, unit: Some(first) }, smaller)
            }
        });
        count += 1;
        rest = behind[end..].trim_start();
    }
    let (sum, _) = total.filter(|_| count > 1)?;
    Some(Quantity { number: if negative { sum.number.negated() } else { sum.number }, ..sum })
}

/// The size of a smaller unit in the first one, and the unit itself; it must be smaller than the last.
fn part(written: &str, asked: &Unit, first: &Unit, last: &Unit) -> Option<(Number, Unit)> {
    let by_mark = mark_of_length(written, asked, &INCHES);
    let degree = Unit::degree();
    let is_turn = by_mark.is_none();
    if let Some((_, share)) = PARTS_OF_DEGREE.iter().find(|(sign, _)| is_turn && written.trim() == *sign) {
        let size = Number::exact(Rational::ONE / Rational::from(*share));
        return (*first == degree).then_some((size, degree));
    }
    let unit = match by_mark {
        Some(unit) => unit,
        None => unit(written, 0, written.len(), asked).ok()??,
    };
    let smaller = unit.dimension() == first.dimension() && unit.factor().to_f64() < last.factor().to_f64();
    smaller.then(|| Number::exact(Rational::ONE).scaled(&unit.in_terms_of(first)).map(|size| (size, unit)))?
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    asked: &'t Unit,
    mark: DecimalMark,
    depth: usize,
    parts: usize,
}

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    /// A sign between values, taken where a value follows it.
    fn take(&mut self, signs: &[&str]) -> Option<&'t str> {
        let rest = self.rest().trim_start();
        let sign = signs.iter().find(|sign| rest.starts_with(**sign))?.len();
        let behind = &rest[sign..];
        if !arithmetic::begins_number(behind) {
            return None;
        }
        self.at = self.text.len() - behind.len();
        Some(&rest[..sign])
    }

    fn sum(&mut self) -> Option<Quantity> {
        let mut sum = self.product()?;
        while let Some(sign) = self.take(&["+", "-"]) {
            let term = self.product()?;
            let ratio = match (&term.unit, &sum.unit) {
                (Some(unit), Some(first)) if unit.dimension() == first.dimension() => unit.in_terms_of(first),
                _ => return None,
            };
            let term = term.number.scaled(&ratio)?;
            sum.number = if sign == "+" { sum.number.plus(&term)? } else { sum.number.minus(&term)? };
        }
        Some(sum)
    }

    fn product(&mut self) -> Option<Quantity> {
        let mut product = self.factor()?;
        while let Some(sign) = self.take(&["*", "·", "×", "x ", "/"]) {
            // Between bare numbers the letter may be anything.
            if sign == "x " && product.unit.is_none() {
                return None;
            }
            let factor = self.factor()?;
            let [left, right] = [&product.unit, &factor.unit].map(|unit| unit.clone().unwrap_or_default());
            let (number, unit) = if sign == "/" {
                (product.number.over(&factor.number)?, left.per(&right)?)
            } else {
                (product.number.times(&factor.number)?, left.times(&right)?)
            };
            product = Quantity { number, unit: (!unit.is_none()).then_some(unit) };
        }
        Some(product)
    }

    fn factor(&mut self) -> Option<Quantity> {
        self.parts += 1;
        if self.parts > MAX_PARTS || self.depth >= MAX_DEPTH {
            return None;
        }
        self.at = self.text.len() - self.rest().trim_start().len();
        let (number, form) = match arithmetic::read(self.rest(), self.mark) {
            Ok((term, length)) => {
                self.at += length;
                (term.number, term.form)
            }
            Err(_) => return self.bracket(),
        };
        let end = self.unit_end();
        let unit_here = unit(self.text, self.at, end, self.asked).ok()?;
        self.at = end;
        let unit_here = unit_here.or_else(|| if form == Form::Arc { Some(Unit::radian()) } else { None });
        Some(Quantity { number, unit: unit_here })
    }

    fn bracket(&mut self) -> Option<Quantity> {
        let minus = self.rest().starts_with('-');
        self.at += usize::from(minus);
        self.at = self.text.len() - self.rest().strip_prefix('(')?.len();
        self.depth += 1;
        let inner = self.sum()?;
        self.depth -= 1;
        self.at = self.text.len() - self.rest().trim_start().strip_prefix(')')?.len();
        Some(Quantity { number: if minus { inner.number.negated() } else { inner.number }, ..inner })
    }

    /// The end of the unit here: at a sign between values, or at a bracket that was opened before.
    fn unit_end(&self) -> usize {
        let rest = self.rest();
        let mut depth = 0;
        let mut before = ' ';
        for (at, next) in rest.char_indices() {
            let behind = &rest[at + next.len_utf8()..];
            let joins = match next {
                '+' => before != '^',
                // Directly before digits it is the sign of an exponent.
                // A power of a degree is no angle.
                '-' if before == '°' => true,
                '-' => before == ' ' && behind.starts_with(' ') || behind.trim_start().starts_with('('),
                '*' | '·' | '×' | '/' | 'x' => {
                    before != '^' && arithmetic::begins_number(behind) && (next != 'x' || before == ' ')
                }
                _ => false,
            };
            depth += i32::from(next == '(') - i32::from(next == ')');
            if depth < 0 || joins && depth == 0 {
                return self.at + at;
            }
            before = next;
        }
        self.text.len()
    }
}
