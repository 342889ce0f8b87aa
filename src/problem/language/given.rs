//! Givens: the entry as it is written, and as it is read.

use schemars::JsonSchema;
use serde::Deserialize;

use momentous_fault::{Code, Fault, Path};
use momentous_quantity::{Decimal, Rational, Unit};
use momentous_scene::Term;

use super::domain::{Domain, Grid};
use super::literal::{Literal, number, unit_fault};

/// A given as it is written: a value, a mapping that draws it, or `any`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum GivenEntry {
    /// Values at equal steps: `{ min: 1, max: 6, step: 0.5, unit: kg }`.
    Range(RangeEntry),
    /// One of several values: `{ one_of: [2, 3, 5], unit: kg }`.
    Choice(ChoiceEntry),
    /// A value with its unit apart: `{ value: 3, unit: kg }`.
    Value(ValueEntry),
    /// A value (`3 kg`, `0.7`, `(2, -3) m`), an expression of other givens (`2*m_A`), or `any` (`any kg`) for what must not matter.
    Term(Term),
}

/// A range of values at equal steps, both ends included.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RangeEntry {
    /// The least value.
    pub min: Term,
    /// The greatest value.
    pub max: Term,
    /// The distance of neighbouring values, which divides the range.
    pub step: Term,
    /// The unit of the three. None: a pure number.
    #[serde(default)]
    pub unit: Option<String>,
}

/// Several values, each as likely as the others.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChoiceEntry {
    /// The values.
    pub one_of: Vec<Term>,
    /// Their unit. None: a pure number.
    #[serde(default)]
    pub unit: Option<String>,
}

/// A value with its unit apart.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ValueEntry {
    /// The value.
    pub value: Term,
    /// Its unit. None: a pure number.
    #[serde(default)]
    pub unit: Option<String>,
}

/// What is known of a quantity, read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Given {
    /// It must not matter; its unit where it is said.
    Any(Option<Unit>),
    /// A value, or the components of a vector.
    Literal(Literal),
    /// A value that each seed draws.
    Drawn {
        /// The values that it can take.
        domain: Domain,
        /// Their unit.
        unit: Unit,
    },
    /// An expression of other givens, as it is written.
    Expression(String),
}

impl Given {
    /// The text of a plain number that is written as a calculation, `1/3`, or of a fraction with its unit, `10/3 kg`.
    #[must_use]
    pub fn constant(&self) -> Option<&str> {
        let Self::Expression(text) = self else { return None };
        let is_number = |letter: char| letter.is_ascii_digit() || " .+-*/()".contains(letter);
        let text = text.trim();
        (text.chars().all(is_number) || Fraction::read(text).is_some()).then_some(text)
    }

    /// Whether its value follows from other quantities; that of a fraction which a decimal gives exactly does not.
    #[must_use]
    pub fn is_derived(&self) -> bool {
        let Self::Expression(text) = self else { return false };
        Fraction::read(text.trim()).and_then(|fraction| fraction.decimal()).is_none()
    }

    /// Reads an entry that stands at a path.
    ///
    /// # Errors
    /// Every number and unit that cannot be read, and ranges and choices that draw nothing.
    pub fn read(entry: &GivenEntry, path: &Path) -> Result<Self, Vec<Fault>> {
        let mut reader = Reader { faults: Vec::new() };
        let given = match entry {
            GivenEntry::Term(Term(text)) => reader.term(text, path),
            GivenEntry::Value(entry) => {
                let value = reader.number(&entry.value, &path.key("value"));
                let unit = reader.unit_key(entry.unit.as_deref(), path);
                value.zip(unit).map(|(value, unit)| Self::Literal(Literal { components: vec![value], unit }))
            }
            GivenEntry::Range(entry) => {
                let min = reader.number(&entry.min, &path.key("min"));
                let max = reader.number(&entry.max, &path.key("max"));
                let step = reader.number(&entry.step, &path.key("step"));
                let unit = reader.unit_key(entry.unit.as_deref(), path);
                let grid = min.zip(max).zip(step);
                let grid = grid.and_then(|((min, max), step)| reader.take(Grid::new(&min, &max, &step), path));
                grid.zip(unit).map(|(grid, unit)| Self::Drawn { domain: Domain::Grid(grid), unit })
            }
            GivenEntry::Choice(entry) => {
                let values = reader.choice(&entry.one_of, &path.key("one_of"));
                let unit = reader.unit_key(entry.unit.as_deref(), path);
                values.zip(unit).map(|(values, unit)| Self::Drawn { domain: Domain::Choice(values), unit })
            }
        };
        given.ok_or(reader.faults)
    }
}

/// A fraction of two decimals as it is written, with the unit of the whole: `1/2`, `10/3 kg`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fraction {
    above: Decimal,
    below: Decimal,
    /// Its unit.
    pub(crate) unit: Unit,
}

impl Fraction {
    pub(crate) fn read(text: &str) -> Option<Self> {
        Self::with_unit(text, |unit| Unit::parse(unit).ok())
    }

    /// The same, or a fraction of pure numbers: `1/5`.
    pub(crate) fn read_any(text: &str) -> Option<Self> {
        Self::with_unit(text, |unit| if unit.is_empty() { Some(Unit::none()) } else { Unit::parse(unit).ok() })
    }

    fn with_unit(text: &str, read: impl Fn(&str) -> Option<Unit>) -> Option<Self> {
        let (above, rest) = text.split_once('/')?;
        let end = rest.find(|letter: char| !letter.is_ascii_digit() && letter != '.').unwrap_or(rest.len());
        let (below, unit) = rest.split_at(end);
        let [above, below] = [above, below].map(|text| Decimal::parse(text.trim()).ok());
        Some(Self { above: above?, below: below.filter(|decimal| !decimal.is_zero())?, unit: read(unit.trim())? })
    }

    /// Its value, where a decimal gives it exactly.
    pub(crate) fn decimal(&self) -> Option<Decimal> {
        let value = self.above.to_rational() / self.below.to_rational();
        let digits = value.to_f64().value().to_string();
        Decimal::parse(&digits).ok().filter(|decimal| decimal.to_rational() == value)
    }

    /// The fault of a fraction where only a decimal serves.
    fn endless(&self) -> Fault {
        let Self { above, below, .. } = self;
        let fault =
            Fault::new(Code::Value, format!("no decimal is exactly {above}/{below}, and only decimals can be drawn"));
        fault.help(format!(
            "draw the number above the line: `n: {{ one_of: [1, 2] }}`, and give `n/{below}` as the value"
        ))
    }

    /// The same as an expression, in which a unit belongs to the number before it alone.
    pub(crate) fn expression(&self) -> String {
        let Self { above, below, unit } = self;
        if unit.is_none() { format!("{above}/{below}") } else { format!("{above}/{below}*(1 {unit})") }
    }
}

/// The values that stand before already, with their places, in their order.
fn repeated(values: &[(usize, Decimal)]) -> Vec<(usize, &Decimal)> {
    let mut sorted: Vec<(Rational, usize, &Decimal)> =
        values.iter().map(|(index, value)| (value.to_rational(), *index, value)).collect();
    sorted.sort_by(|one, other| (&one.0, one.1).cmp(&(&other.0, other.1)));
    let later = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| (pair[1].1, pair[1].2));
    let mut later: Vec<_> = later.collect();
    later.sort_by_key(|(index, _)| *index);
    later
}

/// Reads the parts of an entry and keeps their faults.
struct Reader {
    faults: Vec<Fault>,
}

impl Reader {
    fn take<T>(&mut self, read: Result<T, Fault>, path: &Path) -> Option<T> {
        read.map_err(|fault| self.faults.push(fault.at_path(path.clone()))).ok()
    }

    fn term(&mut self, text: &str, path: &Path) -> Option<Given> {
        if let Some(unit) = text.trim().strip_prefix("any").filter(|unit| unit.is_empty() || unit.starts_with(' ')) {
            let unit = unit.trim();
            return self.unit(Some(unit), path).map(|read| Given::Any((!unit.is_empty()).then_some(read)));
        }
        let literal = self.take(Literal::read(text), path)?;
        Some(literal.map_or_else(|| Given::Expression(text.to_owned()), Given::Literal))
    }

    /// A bare number; its unit stands under `unit`.
    fn number(&mut self, Term(text): &Term, path: &Path) -> Option<Decimal> {
        let read = match Literal::read(text) {
            Ok(Some(Literal { unit, .. })) if !unit.is_none() => {
                let fault = Fault::new(Code::Value, format!("`{text}` has a unit of its own"));
                Err(fault.help(format!("write the number alone, and beside it `unit: {unit}`")))
            }
            Err(fault) => Err(fault),
            Ok(_) => match Fraction::read(text.trim()).filter(|fraction| fraction.unit.is_none()) {
                Some(fraction) => fraction.decimal().ok_or_else(|| fraction.endless()),
                None => number(text),
            },
        };
        self.take(read, path)
    }

    /// The unit that stands under `unit`.
    fn unit_key(&mut self, text: Option<&str>, path: &Path) -> Option<Unit> {
        self.unit(text, &path.key("unit"))
    }

    fn unit(&mut self, text: Option<&str>, path: &Path) -> Option<Unit> {
        let read = Unit::parse(text.unwrap_or_default()).map_err(|fault| unit_fault(fault, 0));
        self.take(read, path)
    }

    fn choice(&mut self, terms: &[Term], path: &Path) -> Option<Vec<Decimal>> {
        if terms.is_empty() {
            let fault = Fault::new(Code::Range, "there is nothing to choose from");
            return self.take(Err(fault.help("write the values: `one_of: [2, 3, 5]`")), path);
        }
        let before = self.faults.len();
        let mut values = Vec::new();
        for (index, term) in terms.iter().enumerate() {
            let place = path.index(index);
            values.extend(self.number(term, &place).map(|value| (index, value)));
        }
        for (index, value) in repeated(&values) {
            let fault = Fault::new(Code::Duplicate, format!("{value} is already among the choices"));
            let fault = fault.help("remove it: each choice is as likely as the others");
            self.take::<()>(Err(fault), &path.index(index));
        }
        let values: Vec<Decimal> = values.into_iter().map(|(_, value)| value).collect();
        (self.faults.len() == before).then_some(values)
    }
}
