//! How far honest rounding can move an answer, whether an answer is nothing, and the size against which that is judged.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_quantity::MOST_TOLERANCES;
use momentous_quantity::first_place;
use momentous_quantity::half_unit;
use momentous_quantity::unit_of_place;
use momentous_solve::Sensitivity;

use super::super::questions::part::AskedUnit;
use super::super::questions::part::NumberPart;
use super::super::questions::part::Part;
use super::variant::Worked;

/// A value just below a power of ten may be computed just above it, where its last figure counts ten times as much.
const NEXT_DECADE: f64 = 1.02;

/// At most by this share slopes are taken to change.
const MOST_BEND: f64 = 0.05;

/// The numbers that marking needs besides the answer itself, in the unit of the question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// How far rounding every intermediate value, and the answer, to the figures that are asked can move the answer.
    pub allowance: f64,
    /// The size of the terms that cancel in an answer that is exactly nothing; zero for any other.
    pub scale: f64,
}

/// The share of what cancels in a value of 77 digits below which it is nothing.
const NOTHING: f64 = 1e-40;

impl Worked<'_> {
    /// Allowance and scale of an answer.
    #[must_use]
    pub fn judged(&self, number: &NumberPart) -> Judged {
        let unit = match &number.unit {
            AskedUnit::Unit(_) => number.size,
            AskedUnit::InTermsOf(symbol, _) => self.value(*symbol).abs() * number.size,
        };
        let figures = number.figures;
        let allowance = self.allowance(number.symbol, figures) / unit;
        // Whoever converts the result rounds it once more; a decimal multiple leaves its figures as they are.
        let is_decimal = (unit - unit_of_place(first_place(unit))).abs() < 1e-9 * unit;
        let written = half_unit(NEXT_DECADE * self.value(number.symbol) / unit, figures);
        let scale = if self.is_nothing(number.symbol) { self.cancelling(number.symbol) / unit } else { 0.0 };
        Judged { allowance: if is_decimal { allowance } else { allowance + written }, scale }
    }

    /// Whether honest rounding may move the answer to a part by more than a few tolerances, or by half of it: with such numbers
    /// nobody can tell a right answer from a wrong one.
    ///
    /// Of a vector, the sizes are those of the whole vector.
    #[must_use]
    pub fn is_ill_chosen(&self, part: &Part) -> bool {
        let numbers = part.kind.numbers();
        let Some(first) = numbers.first().filter(|first| !first.whole) else { return false };
        let judged: Vec<Judged> = numbers.iter().map(|number| self.judged(number)).collect();
        let size = |values: &mut dyn Iterator<Item = f64>| libm::sqrt(values.map(|value| value * value).sum());
        let answer = size(&mut numbers.iter().map(|number| self.answer(number).value));
        let is_nothing = numbers.iter().all(|number| self.is_nothing(number.symbol));
        let scale = size(&mut judged.iter().map(|judged| judged.scale));
        let shift = size(&mut judged.iter().map(|judged| judged.allowance));
        let Some(tolerance) = first.tolerance.reach(if is_nothing { scale } else { answer }) else { return false };
        // A direction has no size.
        let has_size = !is_nothing && !matches!(&first.unit, AskedUnit::Unit(unit) if unit.is_plain_angle());
        shift > MOST_TOLERANCES * tolerance || (has_size && shift > answer / 2.0)
    }

    /// Whether a quantity is exactly nothing: known to be, or around nothing in as many digits as there are.
    #[must_use]
    pub fn is_nothing(&self, symbol: Symbol) -> bool {
        let Some(value) = self.variant.value(symbol) else { return false };
        let spread = value.value.abs() + value.error;
        value.value.abs() <= value.error && (spread == 0.0 || spread <= NOTHING * self.cancelling(symbol))
    }

    /// The size of what cancels in a quantity that is nothing, `sum |x_i dt/dx_i|` over what is given; where nothing cancels, the
    /// problem's own scale.
    fn cancelling(&self, asked: Symbol) -> f64 {
        let mut total = 0.0;
        if let Some(leaf) = self.sensitivity() {
            let value = |symbol| self.value(symbol);
            leaf.each_input(asked, value, self.variant.roots(), |symbol, slope| {
                total += (slope * self.value(symbol)).abs();
            });
        }
        if total > 0.0 && total.is_finite() { total } else { self.scale(asked) }
    }

    fn sensitivity(&self) -> Option<&Sensitivity> {
        let leaves = || self.form.solver.leaves().iter().map(|leaf| Sensitivity::of(leaf.answer_steps())).collect();
        self.form.sensitivities.0.get_or_init(leaves).get(self.variant.leaf())
    }

    fn value(&self, symbol: Symbol) -> f64 {
        self.variant.value(symbol).map_or(0.0, |value| value.value)
    }

    /// `sum |dt/dx_i| (half a unit of x_i's last figure) + half a unit of t's`, over the values `x_i` on the way to t.
    fn allowance(&self, asked: Symbol, figures: usize) -> f64 {
        let Some(leaf) = self.sensitivity() else { return 0.0 };
        let mut total = 0.0;
        leaf.each(
            asked,
            |symbol| self.value(symbol),
            self.variant.roots(),
            |symbol, slope| {
                total += slope.abs() * half_unit(NEXT_DECADE * self.value(symbol), figures);
            },
        );
        // Slopes change on the way, by about the share of the value that the rounding has.
        let share = (total / self.value(asked).abs()).min(MOST_BEND);
        total * (1.0 + share)
    }

    /// The largest given or solved quantity of the same dimension; of a momentum or an energy also what the speeds and
    /// masses of the scene make of it.
    fn scale(&self, asked: Symbol) -> f64 {
        let symbols = &self.problem.model().symbols;
        let dimension = symbols.entry(asked).dimension;
        let largest = |wanted: Dimension| {
            let sizes = symbols.iter().filter(|(symbol, entry)| entry.dimension == wanted && *symbol != asked);
            sizes.map(|(symbol, _)| self.value(symbol).abs()).fold(0.0, f64::max)
        };
        let terms = match dimension {
            Dimension::MOMENTUM => largest(Dimension::MASS) * largest(Dimension::VELOCITY),
            Dimension::ENERGY => largest(Dimension::MASS) * largest(Dimension::VELOCITY).powi(2) / 2.0,
            _ => 0.0,
        };
        let approach = if dimension == Dimension::VELOCITY { self.approach() } else { 0.0 };
        if approach > 0.0 { approach } else { largest(dimension).max(terms) }
    }

    /// The speed of approach of the first impact, where velocities along one line tell it.
    fn approach(&self) -> f64 {
        let condition = self.leaf().system.conditions.iter().find(|condition| {
            let reason = self.problem.model().reasons.get(condition.tag);
            reason.is_some_and(|reason| reason.warning() == Some(momentous_model::Warning::NoImpact))
        });
        condition.map_or(0.0, |condition| {
            let side = |side: &Expr| side.evaluate(&|symbol| self.value(symbol));
            (side(&condition.left) - side(&condition.right)).abs()
        })
    }
}
