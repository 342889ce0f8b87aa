//! The values for which a claim holds: the boundary is solved, the side is found by trial.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Model;
use momentous_quantity::Decimal;
use momentous_quantity::Unit;
use momentous_quantity::round_to_figures;
use momentous_solve::Bounded;
use momentous_solve::Relation;
use momentous_solve::Step;

use super::super::compiling::input::Input;
use super::super::compiling::inputs::inputs;
use super::super::compiling::regimes::Regimes;
use super::super::compiling::regimes::Scratch;
use super::super::questions::part::AskedUnit;
use super::super::questions::part::PartKind;
use super::super::questions::part::RangePart;
use super::super::sampling::variant::Worked;

/// The values for which the claim of a [`RangePart`] holds: those on one side of the boundary.
#[derive(Clone, Debug)]
pub struct Interval {
    /// The lower end; none where there is no least value.
    pub low: Option<End>,
    /// The upper end; none where there is no greatest value.
    pub high: Option<End>,
    /// The value on one side with which the model was tried.
    pub trial: Trial,
}

/// An end of an interval, in the unit of the question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Its place.
    pub value: Bounded,
    /// Whether it belongs to the interval.
    pub closed: bool,
    /// Whether it is a limit of the quantity itself, whatever the claim: `e <= 1`.
    pub is_limit: bool,
}

/// The values that the model gives on the side on which the claim holds.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The value that was tried, in the unit of the question.
    pub at: Decimal,
    /// The left side of the claim there, in SI units.
    pub left: f64,
    /// The way that the scene goes there.
    leaf: usize,
}

/// How far from a limit towards the boundary the model is tried where there is no motion at the limit itself.
const BESIDE_A_LIMIT: f64 = 0.01;

/// The least and the greatest value of a quantity, in SI units, each with whether it is reached.
type Limits = [Option<(f64, bool)>; 2];

/// The limits of a quantity: what the model requires of it whatever the other values.
fn limits(model: &Model, symbol: Symbol) -> Limits {
    let positive = model.system.positive.contains(&symbol).then_some((0.0, false));
    let mut limits = [positive, None];
    for condition in &model.system.conditions {
        let (Expr::Symbol(compared), Some(bound)) = (&condition.left, condition.right.as_number()) else { continue };
        let bound = bound.to_f64().value();
        match condition.relation {
            _ if *compared != symbol => {}
            Relation::AtLeast => limits[0] = Some((bound, true)),
            Relation::Greater => limits[0] = Some((bound, false)),
            Relation::AtMost => limits[1] = Some((bound, true)),
            Relation::Less => limits[1] = Some((bound, false)),
            Relation::Differs | Relation::Equals => {}
        }
    }
    limits
}

/// A value between a limit of a quantity and the boundary.
fn between(limit: Option<(f64, bool)>, boundary: f64, away: f64) -> f64 {
    match limit {
        Some((limit, true)) => limit,
        Some((limit, false)) => f64::midpoint(limit, boundary),
        None => boundary + away * boundary.abs().max(1.0),
    }
}

impl Worked<'_> {
    /// Whether every range that is asked has one boundary, with a side on which it holds.
    pub(crate) fn has_intervals(&self) -> bool {
        let mut ranges = self.form.parts.iter().filter_map(|part| match &part.kind {
            PartKind::Range(range) => Some(range),
            _ => None,
        });
        ranges.all(|range| self.interval(range).is_some())
    }

    /// The values for which the claim holds; `None` where it holds on both sides of the boundary, or on neither.
    #[must_use]
    pub fn interval(&self, range: &RangePart) -> Option<Interval> {
        let symbol = range.number.symbol;
        let regimes = self.form.trials.iter().find(|(trial, _)| *trial == symbol).map(|(_, regimes)| regimes)?;
        let AskedUnit::Unit(unit) = &range.number.unit else { return None };
        let boundary = self.variant.value(symbol)?;
        let limits = limits(self.problem.model(), symbol);
        let inside = |(limit, sign): (Option<(f64, bool)>, f64)| {
            limit.is_none_or(|(limit, _)| sign * (limit - boundary.value) > boundary.error)
        };
        if !limits.into_iter().zip([-1.0, 1.0]).all(inside) {
            return None;
        }
        let tried = |at: f64| self.tried(regimes, range, at / unit.factor().to_f64(), unit);
        let side = |limit: Option<(f64, bool)>, away: f64| {
            let beside = |limit: f64| {
                // Just there the motion may be none, as a bounce with e = 0: then what is next to it counts.
                tried(limit + BESIDE_A_LIMIT * (boundary.value - limit))?;
                tried(f64::midpoint(limit, boundary.value))
            };
            tried(between(limit, boundary.value, away)).or_else(|| beside(limit.filter(|(_, closed)| *closed)?.0))
        };
        let (below, above) = (side(limits[0], -0.5)?, side(limits[1], 1.0)?);
        let reached = matches!(range.claim.relation, Relation::AtMost | Relation::AtLeast);
        let at_boundary = End { value: self.answer(&range.number), closed: reached, is_limit: false };
        let end = |limit: Option<(f64, bool)>| {
            limit.map(|(value, closed)| {
                let value = Bounded { value: value / unit.factor().to_f64(), error: 0.0 };
                End { value, closed, is_limit: true }
            })
        };
        match (below, above) {
            ((true, trial), (false, _)) => Some(Interval { low: end(limits[0]), high: Some(at_boundary), trial }),
            ((false, _), (true, trial)) => Some(Interval { low: Some(at_boundary), high: end(limits[1]), trial }),
            _ => None,
        }
    }

    /// The steps that give the sides of the claim from a value that was tried.
    #[must_use]
    pub fn steps_tried(&self, range: &RangePart, trial: &Trial) -> &[Step] {
        let mut trials = self.form.trials.iter();
        let regimes_of_range = trials.find(|(trial, _)| *trial == range.number.symbol);
        regimes_of_range.map_or(&[], |(_, regimes)| regimes.leaf(trial.leaf).answer_steps())
    }

    /// Whether the claim holds with that value of the quantity, in the unit of the question.
    fn tried(&self, regimes: &Regimes, range: &RangePart, at: f64, unit: &Unit) -> Option<(bool, Trial)> {
        let at = round_to_figures(at, range.number.figures)?;
        let mut inputs = inputs(self.problem, self.form);
        let told = self.variant.all_given().iter().map(|(symbol, value, unit)| (*symbol, value, unit));
        for (symbol, value, unit) in told.chain([(range.number.symbol, &at, unit)]) {
            if let Some(input) = inputs.get_mut(symbol.index()) {
                *input = Input::of(value, unit);
            }
        }
        let mut scratch = Scratch::default();
        if scratch.run(regimes, &inputs, &[]) != 1 {
            return None;
        }
        let value = |symbol: Symbol| {
            let solved = scratch.value(regimes, symbol);
            solved
                .or_else(|| inputs.get(symbol.index()).and_then(Input::bounded))
                .map_or(f64::NAN, |number| number.value)
        };
        let [left, right] = [&range.claim.left, &range.claim.right].map(|side| side.evaluate(&value));
        Some((range.claim.holds_between(left, right)?, Trial { at, left, leaf: scratch.leaf() }))
    }
}
