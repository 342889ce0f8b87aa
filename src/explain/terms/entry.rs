//! A number in a worked solution, and with how many figures it is printed.

use momentous_expr::Symbol;
use momentous_quantity::first_place;
use momentous_quantity::round_to_figures;
use momentous_quantity::unit_of_place;

/// The fewest figures of a value in a solution.
pub(super) const FEWEST: usize = 4;

/// The figures of a last result that four figures before it do not give: as many as answers have.
pub(super) const LAST: usize = 3;

/// The share of itself by which a last result may be rounded.
const CLOSE: f64 = 0.002;

/// By how much, relative to their size, two numbers may differ that are the same but for how they were computed.
const EQUAL: f64 = 1e-12;

/// Whether two numbers have the same size, but for how they were computed.
pub(super) fn is_same_size(one: f64, other: f64) -> bool {
    (one.abs() - other.abs()).abs() <= EQUAL * other.abs()
}

/// A number in a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Item {
    /// A quantity.
    Quantity(Symbol),
    /// The coefficient of that place in the quadratic equation of an unknown.
    Coefficient(Symbol, usize),
    /// The other root of that equation.
    OtherRoot(Symbol),
    /// Both sides of a balance, by its place among those that are checked.
    Balance(usize),
    /// A side of a condition, by its place among those that are checked.
    Side(usize, usize),
    /// An answer, in the unit of the question.
    Answer(Symbol),
    /// A side of the condition by which a number is counted, with that number tried.
    Trial(Symbol, i64, usize),
    /// An answer in the extreme case of that place.
    Extreme(Symbol, usize),
}

/// A number: its value and its size as it is printed, in SI units.
pub(super) struct Entry {
    pub item: Item,
    pub value: f64,
    /// The size of the unit in which it is printed.
    pub unit: f64,
    pub figures: usize,
    /// The most figures that it may get; as many as it has where it is printed exactly.
    pub most: usize,
    pub printed: f64,
    pub half: f64,
}

impl Entry {
    /// A number that is printed exactly as it is, to within that half a unit of its last place.
    pub(super) fn exact(item: Item, value: f64, unit: f64, half: f64) -> Self {
        Self { item, value, unit, figures: 0, most: 0, printed: value, half }
    }

    pub(super) fn rounded(item: Item, value: f64, unit: f64, figures: usize, most: usize) -> Self {
        if value == 0.0 {
            return Self::exact(item, value, unit, 0.5 * unit);
        }
        let mut entry = Self { item, value, unit, figures, most, printed: value, half: 0.0 };
        entry.round();
        entry
    }

    fn round(&mut self) {
        let shown = self.value / self.unit;
        let place = unit_of_place((first_place(shown) + 1 - i32::try_from(self.figures).unwrap_or(0)).abs());
        let fine = first_place(shown) + 1 < i32::try_from(self.figures).unwrap_or(0);
        let places = if fine { shown * place } else { shown / place };
        // Close to half-way only the exact digits tell which way to round.
        let near_tie = ((places - places.floor()) - 0.5).abs() < 1e-6;
        let rounded = match round_to_figures(shown, self.figures).filter(|_| near_tie) {
            Some(decimal) => decimal.to_f64(),
            None if fine => places.round() / place,
            None => places.round() * place,
        };
        self.printed = rounded * self.unit;
        self.half = 0.5 * self.unit * if fine { 1.0 / place } else { place };
    }

    /// Prints the number with the figures of an answer, where that is close enough.
    pub(super) fn lower(&mut self) {
        if self.figures != FEWEST || self.most == 0 || first_place(self.value / self.unit) >= 3 {
            return;
        }
        self.figures = LAST;
        self.round();
        if self.half > CLOSE * self.value.abs() {
            self.figures = FEWEST;
            self.round();
        }
    }

    /// Whether it is a quantity of the same size and unit as another one, rounded like it.
    pub(super) fn is_printed_like(&self, other: &Self) -> bool {
        let are_quantities = matches!((self.item, other.item), (Item::Quantity(_), Item::Quantity(_)));
        let are_rounded = self.most > 0 && other.most > 0;
        are_quantities && are_rounded && is_same_size(other.unit, self.unit) && is_same_size(other.value, self.value)
    }

    pub(super) fn raise(&mut self) -> bool {
        let can = self.figures < self.most;
        if can {
            self.figures += 1;
            self.round();
        }
        can
    }
}
