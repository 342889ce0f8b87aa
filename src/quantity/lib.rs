//! Numbers with units: dimensions, units, prefixes, decimals as they were written.

mod decimal;
mod dimension;
mod dimension_name;
mod double;
pub mod exact;
mod factor;
mod figures;
mod place;
mod pounds;
mod prefix;
mod tolerance;
mod unit;
mod unit_asked;
mod unit_fault;
mod unit_lookup;
mod unit_parse;
mod unit_print;
mod unit_token;
mod units_table;
mod value;

pub use decimal::{Decimal, DecimalFault};
pub use dimension::Dimension;
pub use dimension_name::{UnitSystem, coherent_unit, dimension_name};
pub use double::nearest_double;
pub use factor::Factor;
pub use figures::{Printed, round_rational, round_to_figures, with_minus_signs};
pub use place::{first_place, half_unit, unit_of_place};
pub use tolerance::MOST_TOLERANCES;
pub use tolerance::Tolerance;
pub use unit::Unit;
pub use unit_fault::{UnitFault, UnitFaultKind};
pub use value::{Quantity, QuantityFault};

/// An exact rational number. `0.7` in a problem file is `7/10` until the numeric kernel.
pub type Rational = dashu::Rational;

/// An integer of any size.
pub type Integer = dashu::Integer;
