//! Pounds and ounces, which are forces here, read as masses.

use super::Unit;
use super::unit::Symbol;
use super::unit_lookup::find_symbol;
use super::units_table::UNITS_OF_WEIGHT_AND_MASS;

impl Unit {
    /// The same with pounds and ounces read as units of mass: `lb ft/s` as `lbm ft/s`.
    ///
    /// Here a pound is a force; who is asked for a mass and answers in `lb` means this.
    #[must_use]
    pub fn with_pounds_as_mass(&self) -> Option<Self> {
        let as_mass = |(symbol, exponent): (Symbol, i32)| {
            let twin = UNITS_OF_WEIGHT_AND_MASS.iter().find(|(weight, _)| *weight == symbol.row.symbol);
            (twin.and_then(|(_, mass)| find_symbol(mass)).unwrap_or(symbol), exponent)
        };
        Self::from_powers(self.written(1).map(as_mass))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::super::Dimension;
    use super::*;

    #[test]
    fn pounds_can_be_read_as_mass() {
        let unit = Unit::parse("lb ft/s").unwrap();
        assert_eq!(unit.with_pounds_as_mass(), Unit::parse("lbm ft/s").ok());
        assert_eq!(unit.with_pounds_as_mass().unwrap().dimension(), Dimension::MOMENTUM);
        assert_eq!(Unit::parse("kg m").unwrap().with_pounds_as_mass(), Unit::parse("kg m").ok());
    }
}
