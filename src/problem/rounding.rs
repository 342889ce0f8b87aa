//! How far honest rounding can move an answer, and the size against which a zero is judged.

use std::sync::Arc;
use std::sync::OnceLock;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::quantity::Dimension;
use crate::quantity::first_place;
use crate::quantity::half_unit;
use crate::quantity::unit_of_place;
use crate::solve::Sensitivity;

use super::part::AskedUnit;
use super::part::NumberPart;
use super::variant::Worked;

/// A value just below a power of ten may be computed just above it, where its last figure counts ten times as much.
const NEXT_DECADE: f64 = 1.02;

/// At most by this share slopes are taken to change.
const MOST_BEND: f64 = 0.05;

/// What marking needs besides the answer itself, in the unit of the question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// How far rounding every intermediate value, and the answer, to the problem's figures can move the answer.
    pub allowance: f64,
    /// The problem's own scale for such a quantity.
    pub scale: f64,
}

/// How the answers of a form move with the values on the way, for each way in which its scene can go; empty until it is asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Sensitivities(Arc<OnceLock<Vec<Sensitivity>>>);

impl Worked<'_> {
    /// Allowance and scale of an answer.
    #[must_use]
    pub fn judged(&self, number: &NumberPart) -> Judged {
        let unit = match &number.unit {
            AskedUnit::Unit(_) => number.size,
            AskedUnit::InTermsOf(symbol) => self.value(*symbol).abs(),
        };
        let figures = number.figures.min(usize::from(self.problem.loaded().draft.figures.unwrap_or(3)));
        let found = self.allowance(number.symbol, figures) / unit;
        // Whoever converts the result rounds it once more; a decimal multiple leaves its figures as they are.
        let is_decimal = (unit - unit_of_place(first_place(unit))).abs() < 1e-9 * unit;
        let written = half_unit(NEXT_DECADE * self.value(number.symbol) / unit, figures);
        Judged { allowance: if is_decimal { found } else { found + written }, scale: self.scale(number.symbol) / unit }
    }

    fn value(&self, symbol: Symbol) -> f64 {
        self.variant.value(symbol).map_or(0.0, |value| value.value)
    }

    /// `sum |dt/dx_i| (half a unit of x_i's last figure) + half a unit of t's`, over the values `x_i` on the way to t.
    fn allowance(&self, asked: Symbol, figures: usize) -> f64 {
        let leaves = || self.form.solver.leaves().iter().map(|leaf| Sensitivity::of(leaf.answer_steps())).collect();
        let Some(leaf) = self.form.sensitivities.0.get_or_init(leaves).get(self.variant.leaf()) else { return 0.0 };
        let mut total = 0.0;
        leaf.each(
            asked,
            |own| self.value(own),
            self.variant.roots(),
            |own, slope| {
                total += slope.abs() * half_unit(NEXT_DECADE * self.value(own), figures);
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
        let made = match dimension {
            Dimension::MOMENTUM => largest(Dimension::MASS) * largest(Dimension::VELOCITY),
            Dimension::ENERGY => largest(Dimension::MASS) * largest(Dimension::VELOCITY).powi(2) / 2.0,
            _ => 0.0,
        };
        let approach = if dimension == Dimension::VELOCITY { self.approach() } else { 0.0 };
        if approach > 0.0 { approach } else { largest(dimension).max(made) }
    }

    /// The speed of approach of the first impact, where velocities along one line tell it.
    fn approach(&self) -> f64 {
        let condition = self.leaf().system.conditions.iter().find(|condition| {
            let reason = self.problem.model().reasons.get(condition.tag);
            reason.is_some_and(|reason| reason.warning == Some(crate::model::Warning::NoImpact))
        });
        condition.map_or(0.0, |condition| {
            let side = |side: &Expr| side.evaluate(&|own| self.value(own));
            (side(&condition.left) - side(&condition.right)).abs()
        })
    }
}
