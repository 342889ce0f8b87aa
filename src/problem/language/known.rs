//! A quantity whose value is known before anything is solved.

use momentous_expr::Symbol;
use momentous_quantity::Decimal;
use momentous_quantity::Unit;

use super::domain::Domain;

/// A given of a compiled problem.
#[derive(Clone, Debug)]
pub struct Known {
    /// The name, as the author wrote it; a vector's components have names of their own.
    pub name: String,
    /// Its quantity.
    pub symbol: Symbol,
    /// The unit in which it is drawn and printed.
    pub unit: Unit,
    /// The origin of its value.
    pub origin: Origin,
    /// The position of its random stream, where some form draws it.
    pub stream: Option<usize>,
}

/// The origin of a given's value.
#[derive(Clone, Debug)]
pub enum Origin {
    /// Each seed draws it.
    Drawn(Domain),
    /// Always the same.
    Fixed(Decimal),
    /// Whatever it is, it must not matter; one in SI units stands for it.
    Any,
}

impl Origin {
    /// Whether every value that it can have is above zero.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        let positive = |value: &Decimal| !value.is_negative() && !value.is_zero();
        match self {
            Self::Drawn(Domain::Grid(grid)) => positive(&grid.low()),
            Self::Drawn(Domain::Choice(values)) => values.iter().all(positive),
            Self::Fixed(value) => positive(value),
            Self::Any => false,
        }
    }

    /// Whether every value that it can have is a whole number; what may be anything may be one.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let whole = |value: &Decimal| value.to_rational().denominator().is_one();
        match self {
            Self::Drawn(grid @ Domain::Grid(_)) => (0..grid.count().min(2)).all(|index| whole(&grid.value(index))),
            Self::Drawn(Domain::Choice(values)) => values.iter().all(whole),
            Self::Fixed(value) => whole(value),
            Self::Any => true,
        }
    }

    /// The least and the greatest value, in the unit of the given; some range for what may be anything.
    #[must_use]
    pub fn limits(&self) -> [f64; 2] {
        match self {
            Self::Drawn(Domain::Grid(grid)) => [grid.low(), grid.high()].map(|end| end.to_f64()),
            Self::Drawn(Domain::Choice(values)) => {
                let values = || values.iter().map(Decimal::to_f64);
                [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
            }
            Self::Fixed(value) => [value.to_f64(); 2],
            Self::Any => [1.0, 2.0],
        }
    }

    /// Whether each seed draws it.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        matches!(self, Self::Drawn(_))
    }
}
