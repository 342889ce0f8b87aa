//! Dimensions in words, and the units in which a dimension is usually given.

use std::fmt;
use std::sync::OnceLock;

use super::prefix::KILO;
use super::unit::Symbol;
use super::units_table::{FOOT_UNIT, GRAM, METRE, SECOND, SLUG};
use super::{Dimension, Unit};

/// A coherent system of units: one in which no equation needs a factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum UnitSystem {
    /// Kilogram, metre, second.
    #[default]
    Si,
    /// Slug, foot, second; the pound is the unit of force.
    Us,
}

/// Exponents of mass, length and time; what has them; its usual coherent unit, SI and US, where that is not a product of base units.
type Row = ([i8; 3], &'static str, &'static str, &'static str);

#[rustfmt::skip] // a table is read by its columns
const NAMES: &[Row] = &[
    ([0, 0,  0], "a pure number",                      "",     ""),
    ([1, 0,  0], "a mass",                             "",     ""),
    ([0, 1,  0], "a length",                           "",     ""),
    ([0, 0,  1], "a time",                             "",     ""),
    ([0, 2,  0], "an area",                            "",     ""),
    ([0, 3,  0], "a volume",                           "",     ""),
    ([0, 1, -1], "a velocity",                         "",     ""),
    ([0, 1, -2], "an acceleration",                    "",     ""),
    ([0, 0, -1], "an angular velocity or a frequency", "",     ""),
    ([0, 0, -2], "an angular acceleration",            "",     ""),
    ([0, 2, -1], "an areal rate",                      "",     ""),
    ([0, 2, -2], "an energy per unit mass",            "",     ""),
    ([0, 3, -1], "a volume flow rate",                 "",     ""),
    ([0, 3, -2], "a gravitational parameter",          "",     ""),
    ([1, 1, -1], "an impulse or momentum",             "",     "lb s"),
    ([1, 1, -2], "a force",                            "N",    "lb"),
    ([1, 1, -3], "a rate of change of force",          "N/s",  "lb/s"),
    ([1, 2, -2], "an energy",                          "J",    "ft lb"),
    ([1, 2, -3], "a power",                            "W",    "ft lb/s"),
    ([1, 2, -1], "an angular momentum",                "",     "ft lb s"),
    ([1, 2,  0], "a moment of inertia",                "",     ""),
    ([1, 1,  0], "a first moment of mass",             "",     ""),
    ([1, 0, -1], "a mass flow rate",                   "",     ""),
    ([1, 0, -2], "a stiffness",                        "N/m",  "lb/ft"),
    ([1, -1, 0], "a mass per unit length",             "",     ""),
    ([1, -3, 0], "a density",                          "",     ""),
    ([1, -1, -2], "a pressure",                        "Pa",   "lb/ft^2"),
];

/// The usual units, SI and US, of the dimensions in the table, each read when it is first wanted.
static UNITS: [[OnceLock<Unit>; 2]; NAMES.len()] = [const { [const { OnceLock::new() }; 2] }; NAMES.len()];

fn find(dimension: Dimension) -> Option<(&'static Row, &'static [OnceLock<Unit>; 2])> {
    NAMES.iter().zip(&UNITS).find(|(([mass, length, time], ..), _)| Dimension::new(*mass, *length, *time) == dimension)
}

/// The name of a quantity of this dimension, with its article: "an impulse or momentum".
///
/// ```
/// use momentous_quantity::{Dimension, dimension_name};
/// assert_eq!(dimension_name(Dimension::ENERGY), "an energy");
/// ```
#[must_use]
pub fn dimension_name(dimension: Dimension) -> &'static str {
    find(dimension).map_or("a quantity without a common name", |((_, name, ..), _)| name)
}

/// The unit of a system in which quantities of this dimension are usually given.
///
/// ```
/// use momentous_quantity::{Dimension, UnitSystem, coherent_unit};
/// assert_eq!(coherent_unit(Dimension::MOMENTUM, UnitSystem::Si).to_string(), "kg m/s");
/// assert_eq!(coherent_unit(Dimension::MOMENTUM, UnitSystem::Us).to_string(), "lb s");
/// ```
#[must_use]
pub fn coherent_unit(dimension: Dimension, system: UnitSystem) -> Unit {
    let base = || base_unit(dimension, system);
    let Some(((.., si, us), [in_si, in_us])) = find(dimension) else { return base() };
    let (usual, unit) = match system {
        UnitSystem::Si => (si, in_si),
        UnitSystem::Us => (us, in_us),
    };
    let read = || if usual.is_empty() { base() } else { Unit::parse(usual).unwrap_or_else(|_| base()) };
    unit.get_or_init(read).clone()
}

/// The product of base units that has this dimension.
fn base_unit(dimension: Dimension, system: UnitSystem) -> Unit {
    let [mass, length] = match system {
        UnitSystem::Si => [Symbol { prefix: Some(&KILO), row: &GRAM }, Symbol::plain(&METRE)],
        UnitSystem::Us => [Symbol::plain(&SLUG), Symbol::plain(&FOOT_UNIT)],
    };
    let bases = [(mass, dimension.mass), (length, dimension.length), (Symbol::plain(&SECOND), dimension.time)];
    // Exponents that fit a dimension fit the unit: nothing is lost here.
    Unit::from_powers(bases.map(|(symbol, exponent)| (symbol, i32::from(exponent)))).unwrap_or_default()
}

/// A product of SI base units: `kg m/s`; a pure number is `1`.
impl fmt::Display for Dimension {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = base_unit(*self, UnitSystem::Si);
        if unit.is_none() { out.write_str("1") } else { write!(out, "{unit}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Factor;

    #[test]
    fn every_usual_unit_is_coherent_and_of_its_dimension() {
        for ([mass, length, time], name, si, us) in NAMES {
            let dimension = Dimension::new(*mass, *length, *time);
            assert_eq!(dimension_name(dimension), *name, "named twice");
            for (system, text) in [(UnitSystem::Si, si), (UnitSystem::Us, us)] {
                let unit = coherent_unit(dimension, system);
                assert_eq!(unit.dimension(), dimension, "{name}");
                assert_eq!(unit.factor(), base_unit(dimension, system).factor(), "{name}");
                assert!(text.is_empty() || unit.to_string() == *text, "{name}");
            }
            assert_eq!(coherent_unit(dimension, UnitSystem::Si).factor(), Factor::ONE, "{name}");
        }
    }

    #[test]
    fn prints_dimensions() {
        assert_eq!(Dimension::MOMENTUM.to_string(), "kg m/s");
        assert_eq!(Dimension::NONE.to_string(), "1");
        assert_eq!(Dimension::new(0, 0, -1).to_string(), "1/s");
        assert_eq!(Dimension::new(127, -127, 127).to_string(), "kg^127 s^127/m^127");
        assert_eq!(Dimension::new(0, -128, 0).to_string(), "1/m^128");
        assert_eq!(dimension_name(Dimension::new(3, 0, 0)), "a quantity without a common name");
    }
}
