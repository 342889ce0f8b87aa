//! The value of a known quantity on its way into a program: exact as a decimal, and as the nearest double.

use momentous_quantity::Decimal;
use momentous_quantity::Factor;
use momentous_quantity::Unit;
use momentous_solve::Bounded;
use momentous_solve::Exact;

use super::super::language::domain::Domain;

/// The value of one symbol; most symbols have none before they are solved.
#[derive(Clone, Debug, Default)]
pub(crate) struct Input {
    value: Option<Bounded>,
    source: Source,
    factor: Factor,
    /// The factor as a double.
    size: f64,
}

/// From which decimal the value was made.
#[derive(Clone, Debug, Default)]
enum Source {
    #[default]
    None,
    Decimal(Decimal),
    Drawn(u64),
}

impl Input {
    pub(crate) fn blank(unit: &Unit) -> Self {
        let factor = unit.factor();
        Self { value: None, source: Source::None, size: factor.to_f64(), factor }
    }

    /// A decimal in a unit.
    pub(crate) fn of(value: &Decimal, unit: &Unit) -> Self {
        let mut input = Self::blank(unit);
        input.value = Some(scaled(value.to_f64(), input.size));
        input.source = Source::Decimal(value.clone());
        input
    }

    /// Takes the value of that number of a domain.
    pub(crate) fn draw(&mut self, domain: &Domain, index: u64) {
        self.value = Some(scaled(domain.value_f64(index), self.size));
        self.source = Source::Drawn(index);
    }

    pub(crate) fn bounded(&self) -> Option<Bounded> {
        self.value
    }

    /// The decimal that it was made from, where it was made from one.
    pub(crate) fn decimal(&self) -> Option<Decimal> {
        match &self.source {
            Source::Decimal(value) => Some(value.clone()),
            Source::None | Source::Drawn(_) => None,
        }
    }

    /// The exact value in SI units.
    pub(crate) fn exact(&self, domain: Option<&Domain>) -> Option<Exact> {
        let decimal = match &self.source {
            Source::Decimal(value) => value.clone(),
            Source::Drawn(index) => domain?.value(*index),
            Source::None => return None,
        };
        let Factor { rational: factor, pi } = &self.factor;
        let value = decimal.to_rational();
        Some(Exact { rational: if factor.is_one() { value } else { value * factor }, pi_power: *pi })
    }
}

/// A decimal's nearest double times a unit's factor: exact for whole numbers in base units, else within three roundings.
fn scaled(value: f64, factor: f64) -> Bounded {
    let product = value * factor;
    let coherent = factor.to_bits() == 1.0_f64.to_bits();
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        clippy::float_cmp,
        reason = "it asks for loss"
    )]
    let is_whole = value.abs() < 9e15 && value as i64 as f64 == value;
    let exact = coherent && is_whole;
    let half_ulp = f64::EPSILON / 2.0;
    let roundings = if coherent { 1.0 } else { 3.1 };
    Bounded { value: product, error: if exact { 0.0 } else { product.abs() * half_ulp * roundings } }
}
