//! The units in which bare numbers count: the coherent ones, or those in which the sheet prints masses, lengths and times.

use momentous_problem::Worked;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;

/// Units agree within this share.
const SAME: f64 = 1e-12;
/// The dimensions of which other units are made.
const BASE: [Dimension; 3] = [Dimension::MASS, Dimension::LENGTH, Dimension::TIME];

/// The units of bare numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BareUnits {
    system: UnitSystem,
    /// The sizes of the units of mass, length and time, in coherent ones; those themselves where there are none.
    base: Option<[f64; 3]>,
}

impl BareUnits {
    /// The coherent units of a system.
    pub(crate) fn coherent(system: UnitSystem) -> Self {
        Self { system, base: None }
    }

    /// Those of the sheet, where it prints masses, lengths and times in one unit each, and some in others than the coherent ones.
    pub(crate) fn of_sheet(worked: Worked<'_>) -> Option<Self> {
        let coherent = Self::coherent(worked.problem.units());
        let mut base = [1.0; 3];
        for (size, dimension) in base.iter_mut().zip(BASE) {
            let printed = worked.variant.all_given().iter().map(|(_, _, unit)| unit);
            let mut sizes = printed.filter(|unit| unit.dimension() == dimension).map(|unit| coherent.ratio(unit));
            let Some(first) = sizes.next() else { continue };
            if sizes.any(|other| !is_same(other, first)) {
                return None;
            }
            *size = first;
        }
        let is_other = base.iter().any(|size| !is_same(*size, 1.0));
        is_other.then_some(Self { base: Some(base), ..coherent })
    }

    /// The size of the unit of a dimension in SI units.
    pub(crate) fn size(self, dimension: Dimension) -> f64 {
        let coherent = match self.system {
            UnitSystem::Si => 1.0,
            UnitSystem::Us => coherent_unit(dimension, self.system).factor().to_f64(),
        };
        let powers = [dimension.mass, dimension.length, dimension.time];
        let base = self.base.unwrap_or([1.0; 3]);
        base.iter().zip(powers).fold(coherent, |size, (base, power)| size * libm::pow(*base, f64::from(power)))
    }

    /// Whether values in them are those in SI units.
    pub(crate) fn is_si(self) -> bool {
        self.system == UnitSystem::Si && self.base.is_none()
    }

    /// Whether a unit is that of its dimension.
    pub(crate) fn has(self, unit: &Unit) -> bool {
        is_same(self.ratio(unit), 1.0)
    }

    fn ratio(self, unit: &Unit) -> f64 {
        unit.factor().to_f64() / self.size(unit.dimension())
    }
}

fn is_same(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME * other.abs()
}
