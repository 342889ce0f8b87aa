//! Whether a line holds at one place: with the values of one variant, right or mistaken.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade::WrittenNumber;
use momentous_grade::half_of_last_place;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_quantity::Unit;
use momentous_quantity::UnitSystem;
use momentous_solve::Bounded;
use momentous_solve::Real;
use momentous_solve::evaluate;

use super::bare_units::BareUnits;
use super::meaning::{Meaning, Meanings};
use super::sides::Compared;
use super::written::{Statement, Written};

/// Two sides agree where they differ by no more than this share of what stands in them.
const AGREE: f64 = 1e-10;
/// A bound on rounding beyond this share decides nothing.
const UNDECIDED: f64 = 1e-6;
/// Numbers that were rounded decide no more than this share of what stands in a line.
const ROUNDED: f64 = 0.02;
/// A value that is written as the last side may be off by this share as by the rounding of its figures.
pub(crate) const RESULT: f64 = 0.006;
/// A value that comes of a mistake has to be as close as this, beyond the rounding of its figures: with many mistakes one has some value near it.
pub(crate) const RESULT_OF_MISTAKE: f64 = 0.001;

/// The least number of three figures.
const LEAST_FIGURES: f64 = 100.0;

/// Whether a line holds, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Holds {
    /// Its sides are equal, or compare as it says.
    Yes,
    /// They are equal as far as the figures of its numbers show.
    AsFigures,
    /// It cannot be said.
    Open,
    /// They differ.
    No,
}

/// How far two sides are apart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Difference {
    /// The left side minus the right one.
    pub(crate) value: f64,
    /// The size of what stands in them.
    pub(crate) size: f64,
}

impl Difference {
    /// Whether the sides agree.
    pub(crate) fn is_nothing(self) -> bool {
        self.value.abs() <= 1e-9 * self.size
    }
}

/// The sources of the values of a line.
pub(crate) struct At<'a> {
    /// The value of a quantity in SI units.
    pub(crate) value: &'a dyn Fn(Symbol) -> Option<Bounded>,
    /// The units in which bare numbers count.
    pub(crate) units: BareUnits,
    /// Quantities that the student counts the other way round.
    pub(crate) turned: &'a [Symbol],
    /// The share by which a value may be off that is written as the last side.
    pub(crate) share: f64,
}

impl At<'_> {
    /// Whether all that a line states holds.
    pub(crate) fn line(&self, line: &Written, meanings: &Meanings) -> Holds {
        let alternatives = |alternatives: &Vec<Vec<Statement>>| {
            alternatives.iter().map(|chain| self.chain(line, chain, meanings)).min().unwrap_or(Holds::Yes)
        };
        line.stated.iter().map(alternatives).max().unwrap_or(Holds::Open)
    }

    /// Whether all statements of a chain hold.
    pub(crate) fn chain(&self, line: &Written, chain: &[Statement], meanings: &Meanings) -> Holds {
        chain.iter().map(|statement| self.statement(line, statement, meanings)).max().unwrap_or(Holds::Yes)
    }

    /// Whether one statement holds.
    pub(crate) fn statement(&self, line: &Written, statement: &Statement, meanings: &Meanings) -> Holds {
        let value = |symbol: Symbol| self.of(line, symbol, meanings);
        let residual = statement.residual();
        let difference: Bounded = evaluate(&residual, &value);
        if !difference.is_real() || !difference.value.is_finite() {
            return Holds::Open;
        }
        let rough = |symbol: Symbol| value(symbol).value;
        // A value that is zero as far as its bound shows is as large as what cancelled in it.
        let amount = |symbol: Symbol| {
            let known = value(symbol);
            if known.value.abs() <= known.error { known.error / f64::EPSILON } else { known.value.abs() }
        };
        let (mut size, mut reach, mut rounds) = (0.0_f64, 0.0_f64, false);
        residual.slopes(&rough, 1.0, &mut |symbol, slope| {
            let part = slope.abs() * amount(symbol);
            // A size of nothing has no slope.
            size += if part.is_nan() { 0.0 } else { part };
            if let Some(number) = line.number(symbol)
                && meanings.of(symbol) == Meaning::Computed
            {
                let half = number.half.to_f64().value() * self.unit_of(number.unit.as_ref());
                reach += (slope * half).abs();
                rounds = true;
            }
        });
        if !size.is_finite() || difference.error > UNDECIDED * size {
            return Holds::Open;
        }
        if rounds && is_result(line, statement) {
            reach = reach.max(self.share * evaluate(&statement.left, &value).value.abs());
        }
        let alone = [&statement.left, &statement.right].into_iter().find_map(|side| line.number_alone(side));
        if let Some(number) = alone {
            reach = reach.max(half_of_last_figure(&number.value) * self.unit_of(number.unit.as_ref()));
        }
        let is_nothing = difference.value.abs() <= difference.error + AGREE * size;
        let is_rounded = rounds && difference.value.abs() <= reach.min(ROUNDED * size);
        let (is_less, is_more) = (difference.value < 0.0, difference.value > 0.0);
        let holds = match statement.compared {
            Compared::Equal => is_nothing,
            Compared::Less => is_less && !is_nothing,
            Compared::Greater => is_more && !is_nothing,
            Compared::AtMost => is_less || is_nothing,
            Compared::AtLeast => is_more || is_nothing,
        };
        match (holds, is_rounded) {
            (true, _) => Holds::Yes,
            (false, true) => Holds::AsFigures,
            (false, false) => Holds::No,
        }
    }

    /// The difference of the sides of a statement, beside what stands in it; none where it has no value.
    pub(crate) fn difference(&self, line: &Written, statement: &Statement, meanings: &Meanings) -> Option<Difference> {
        let value = |symbol: Symbol| self.of(line, symbol, meanings);
        let [left, right]: [Bounded; 2] = [&statement.left, &statement.right].map(|side| evaluate(side, &value));
        let difference = left.value - right.value;
        difference.is_finite().then(|| Difference { value: difference, size: left.value.abs() + right.value.abs() })
    }

    fn of(&self, line: &Written, symbol: Symbol, meanings: &Meanings) -> Bounded {
        let measured = |symbol: Symbol| {
            let value = (self.value)(symbol).unwrap_or_else(Bounded::not_real);
            let value = if self.turned.contains(&symbol) { value.neg() } else { value };
            self.in_units(value, line.symbols.entry(symbol).dimension)
        };
        let Some(number) = line.number(symbol) else { return measured(symbol) };
        match meanings.of(symbol) {
            Meaning::Given { symbol, reversed } => {
                // The number of a given is written as the sheet prints it, whatever the student counts as positive.
                let value = (self.value)(symbol).unwrap_or_else(Bounded::not_real);
                let value = self.in_units(value, line.symbols.entry(symbol).dimension);
                if reversed { value.neg() } else { value }
            }
            Meaning::Constant | Meaning::Computed => {
                let size = number.value.to_f64().value() * self.unit_of(number.unit.as_ref());
                Bounded { value: size, error: size.abs() * 4.0 * f64::EPSILON }
            }
        }
    }

    fn unit_of(&self, unit: Option<&Unit>) -> f64 {
        unit.map_or(1.0, |unit| unit.factor().to_f64() / self.units.size(unit.dimension()))
    }

    fn in_units(&self, value: Bounded, dimension: Dimension) -> Bounded {
        if self.units.is_si() { value } else { value.div(&Bounded::exactly(self.units.size(dimension))) }
    }
}

/// Half a unit of the last figure of a result of two figures or more; zeros before no point may be no figures, where three are left.
fn half_of_last_figure(value: &Rational) -> f64 {
    if let Some(half) = half_of_last_place(value) {
        return half.to_f64().value();
    }
    let size = value.to_f64().value().abs();
    if size < LEAST_FIGURES / 10.0 {
        return 0.0;
    }
    let mut unit = 1.0;
    while size >= LEAST_FIGURES * unit * 10.0 && (size / (unit * 10.0)).fract() == 0.0 {
        unit *= 10.0;
    }
    unit / 2.0
}

/// The value of a number in coherent units.
pub(crate) fn coherent_value(number: &WrittenNumber, units: BareUnits) -> f64 {
    let unit = number.unit.as_ref();
    number.value.to_f64().value() * unit.map_or(1.0, |unit| unit.factor().to_f64() / units.size(unit.dimension()))
}

/// The quantities whose values a line gives.
pub(crate) fn results(line: &Written) -> Vec<Symbol> {
    let statements = line.statements().filter(|statement| is_result(line, statement));
    statements
        .flat_map(|statement| [&statement.left, &statement.right])
        .filter_map(|side| line.letter_alone(side))
        .collect()
}

/// Whether a statement gives the value of one quantity.
fn is_result(line: &Written, statement: &Statement) -> bool {
    let is_number = |side: &Expr| side.symbols().iter().all(|symbol| line.number(*symbol).is_some());
    let gives = |letter: &Expr, value: &Expr| line.letter_alone(letter).is_some() && is_number(value);
    gives(&statement.left, &statement.right) || gives(&statement.right, &statement.left)
}

/// Whether a line says the same of any values whatever: both sides are one.
pub(crate) fn is_identity(line: &Written, meanings: &Meanings) -> bool {
    (1..=3_u32).all(|round| {
        let anything = |symbol: Symbol| {
            let mixed = (u64::try_from(symbol.index()).unwrap_or(0) + 7) * 0x9E37_79B9 * u64::from(round);
            #[allow(clippy::cast_precision_loss, reason = "below 2^20")]
            let share = (mixed % 1_048_573) as f64 / 1_048_573.0;
            Some(Bounded::exactly(0.25 + share))
        };
        let at = At { value: &anything, units: BareUnits::coherent(UnitSystem::Si), turned: &[], share: RESULT };
        at.line(line, meanings) == Holds::Yes
    })
}
