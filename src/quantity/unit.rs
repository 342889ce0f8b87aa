//! A unit: a product of named units with integer powers.

use std::fmt;
use std::hash::Hash;
use std::hash::Hasher;

use smallvec::SmallVec;
use smallvec::smallvec;

use super::factor::StaticFactor;
use super::prefix::Prefix;
use super::units_table::{DEGREE, RADIAN, REVOLUTION_UNIT, UnitRow};
use super::{Dimension, Factor};

/// A unit with a symbol of its own, perhaps prefixed: `km`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Symbol {
    pub(super) prefix: Option<&'static Prefix>,
    pub(super) row: &'static UnitRow,
}

impl Symbol {
    /// The key that tells it from every other: each row of the tables has its own symbol.
    fn key(&self) -> (Option<&'static str>, &'static str) {
        (self.prefix.map(|prefix| prefix.symbol), self.row.symbol)
    }
}

impl PartialEq for Symbol {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Symbol {}

impl Hash for Symbol {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

/// A symbol to a power other than zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Power {
    pub(super) symbol: Symbol,
    pub(super) exponent: i8,
}

/// The powers kept in place: few units have more, and units are copied often.
const USUAL: usize = 3;

/// A product of units, as it is printed: `kg m/s` and `N s` are different units of the same dimension and size.
///
/// Symbols stay in the order in which they were written, those with positive powers first; equal ones are joined.
///
/// ```
/// use momentous_quantity::{Dimension, Unit};
/// let momentum = Unit::parse("N-s")?;
/// assert_eq!(momentum.to_string(), "N s");
/// assert_eq!(momentum.dimension(), Dimension::MOMENTUM);
/// assert_eq!(Unit::parse("km/h")?.factor().to_f64(), 1.0 / 3.6);
/// # Ok::<(), momentous_quantity::UnitFault>(())
/// ```
#[derive(PartialEq, Eq, Hash, Default)]
pub struct Unit {
    powers: SmallVec<[Power; USUAL]>,
    dimension: Dimension,
}

impl Clone for Unit {
    fn clone(&self) -> Self {
        // In one piece: a derived copy would go power by power.
        Self { powers: SmallVec::from_slice(&self.powers), dimension: self.dimension }
    }
}

impl Unit {
    /// The unit of pure numbers, which prints as nothing.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// The radian.
    ///
    /// ```
    /// use momentous_quantity::Unit;
    /// assert_eq!(Unit::parse("rad"), Ok(Unit::radian()));
    /// assert_eq!(Unit::parse("deg"), Ok(Unit::degree()));
    /// assert_eq!(Unit::parse("rev"), Ok(Unit::revolution()));
    /// ```
    #[must_use]
    pub fn radian() -> Self {
        Self::of_angle(&RADIAN)
    }

    /// The degree.
    #[must_use]
    pub fn degree() -> Self {
        Self::of_angle(&DEGREE)
    }

    /// The revolution.
    #[must_use]
    pub fn revolution() -> Self {
        Self::of_angle(&REVOLUTION_UNIT)
    }

    fn of_angle(row: &'static UnitRow) -> Self {
        Self { powers: smallvec![Power { symbol: Symbol::plain(row), exponent: 1 }], dimension: Dimension::NONE }
    }

    /// The product of these powers; `None` where an exponent, of a symbol, of the dimension or of pi, does not fit.
    pub(super) fn from_powers(written: impl IntoIterator<Item = (Symbol, i32)>) -> Option<Self> {
        let mut joined: SmallVec<[(Symbol, i32); USUAL]> = SmallVec::new();
        for (symbol, exponent) in written {
            match joined.iter_mut().find(|(known, _)| *known == symbol) {
                Some((_, sum)) => *sum = sum.checked_add(exponent)?,
                None => joined.push((symbol, exponent)),
            }
        }
        let fit = |(symbol, exponent): (Symbol, i32)| Some(Power { symbol, exponent: i8::try_from(exponent).ok()? });
        let mut powers: SmallVec<[Power; USUAL]> =
            joined.into_iter().filter(|(_, exponent)| *exponent != 0).map(fit).collect::<Option<_>>()?;
        powers.sort_by_key(|power| power.exponent < 0);
        let total = |exponent_of: fn(&UnitRow) -> i8| {
            let each = powers.iter().map(|power| i32::from(exponent_of(power.symbol.row)) * i32::from(power.exponent));
            i8::try_from(each.sum::<i32>()).ok()
        };
        let mass = total(|row| row.dimension.mass)?;
        let length = total(|row| row.dimension.length)?;
        let time = total(|row| row.dimension.time)?;
        total(|row| row.factor.pi())?;
        Some(Self { powers, dimension: Dimension::new(mass, length, time) })
    }

    /// The powers of which it is the product, those above the fraction bar first.
    pub(super) fn powers(&self) -> &[Power] {
        &self.powers
    }

    /// The powers again, as [`Unit::from_powers`] takes them.
    pub(super) fn written(&self, times: i8) -> impl Iterator<Item = (Symbol, i32)> {
        self.powers.iter().map(move |power| (power.symbol, i32::from(power.exponent) * i32::from(times)))
    }

    /// The same without prefixes: `kN m` becomes `N m`, and `kg` becomes `g`.
    #[must_use]
    pub fn without_prefixes(&self) -> Self {
        let bare = |power: &Power| Power { symbol: Symbol::plain(power.symbol.row), exponent: power.exponent };
        Self { powers: self.powers.iter().map(bare).collect(), dimension: self.dimension }
    }

    /// The product with another unit; `None` where an exponent does not fit.
    #[must_use]
    pub fn times(&self, other: &Self) -> Option<Self> {
        Self::from_powers(self.written(1).chain(other.written(1)))
    }

    /// The quotient by another unit; `None` where an exponent does not fit.
    #[must_use]
    pub fn per(&self, other: &Self) -> Option<Self> {
        Self::from_powers(self.written(1).chain(other.written(-1)))
    }

    /// An integer power; `None` where an exponent does not fit.
    #[must_use]
    pub fn power(&self, exponent: i8) -> Option<Self> {
        Self::from_powers(self.written(exponent))
    }

    /// Whether it is the unit of pure numbers.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.powers.is_empty()
    }

    /// The dimension that it measures.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Whether its size has a power of pi in it, as that of a degree has.
    #[must_use]
    pub fn has_pi(&self) -> bool {
        let each = self.powers.iter().map(|power| i32::from(power.symbol.row.factor.pi()) * i32::from(power.exponent));
        each.sum::<i32>() != 0
    }

    /// Its size in the coherent SI unit of its dimension (kilogram, metre, second, radian).
    #[must_use]
    pub fn factor(&self) -> Factor {
        let sized = self.powers.iter().filter(|power| !power.symbol.is_coherent());
        sized.fold(Factor::ONE, |product, power| product * power.symbol.factor().power(power.exponent))
    }

    /// The number of the other unit that it is; both measure the same.
    ///
    /// ```
    /// use momentous_quantity::Unit;
    /// assert_eq!(Unit::parse("km/h")?.in_terms_of(&Unit::parse("m/s")?).to_f64(), 1.0 / 3.6);
    /// # Ok::<(), momentous_quantity::UnitFault>(())
    /// ```
    #[must_use]
    pub fn in_terms_of(&self, other: &Self) -> Factor {
        let other = other.factor();
        // Most units that are asked are coherent.
        if other.is_one() { self.factor() } else { self.factor() * other.power(-1) }
    }

    /// Whether it stands directly behind its number, without a space: `30°`, `5%`.
    #[must_use]
    pub fn is_attached(&self) -> bool {
        self.powers.first().is_some_and(|power| power.exponent == 1 && power.symbol.row.attached)
    }
}

impl Symbol {
    /// The symbol without a prefix.
    pub(super) fn plain(row: &'static UnitRow) -> Self {
        Self { prefix: None, row }
    }

    /// Whether its factor is one, seen without exact arithmetic: most symbols in use are such.
    fn is_coherent(self) -> bool {
        let prefix = self.prefix.map_or(StaticFactor::integer(1), |prefix| prefix.factor);
        self.row.factor.cancels(prefix)
    }

    fn factor(self) -> Factor {
        let size = Factor::from(self.row.factor);
        match self.prefix {
            None => size,
            Some(prefix) => size * Factor::from(prefix.factor),
        }
    }
}

impl fmt::Debug for Unit {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "Unit({self})")
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;

    #[test]
    fn prefixes_can_be_left_out() {
        for (with, without) in [("kN m", "N m"), ("kg m/s", "g m/s"), ("ft/s", "ft/s"), ("", "")] {
            assert_eq!(Unit::parse(with).unwrap().without_prefixes(), Unit::parse(without).unwrap());
        }
    }

    #[test]
    fn exponents_that_do_not_fit_are_refused() {
        let metre = Unit::parse("m^9").unwrap().power(14).unwrap();
        assert_eq!((metre.dimension().length, metre.power(2)), (126, None));
        assert_eq!(Unit::parse("J^9").unwrap().power(9), None);
        assert_eq!(Unit::parse("rev^9").unwrap().power(127), None);
    }
}
