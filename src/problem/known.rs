//! A quantity whose value is known before anything is solved.

use crate::expr::Symbol;
use crate::quantity::Decimal;
use crate::quantity::Unit;

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
    /// Where its value comes from.
    pub origin: Origin,
}

/// Where a given's value comes from.
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

    /// Whether each seed draws it.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        matches!(self, Self::Drawn(_))
    }
}
