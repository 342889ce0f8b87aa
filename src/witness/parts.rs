//! The parts asked, each beside what the simulation finds of it.

use std::collections::BTreeMap;

use momentous_expr::Symbol;
use momentous_problem::Ask;
use momentous_problem::ChoicePart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Turn;
use momentous_problem::Worked;

use super::case::Case;
use super::choices::chosen;
use super::choices::is_first;
use super::choices::taken_root;
use super::simulation::Comparison;
use super::simulation::Witness;

/// The share by which an answer is put wrong, to see that the simulation finds it out.
const WRONG: f64 = 1e-3;

/// An answer that can be put wrong.
pub(super) enum Answer<'a> {
    /// A number: the quantity, whether it is a whole number.
    Number { id: String, symbol: Symbol, whole: bool, ask: &'a Ask },
    /// A phrase.
    Choice { id: String, part: &'a Part, ask: &'a Ask },
}

impl<'a> Answer<'a> {
    /// Every answer of a form.
    pub(super) fn all(worked: &Worked<'a>) -> Vec<Self> {
        let mut all = Vec::new();
        for (part, ask) in worked.form.parts.iter().zip(&worked.form.question.ask) {
            match &part.kind {
                PartKind::Choice(_) => all.push(Self::Choice { id: part.id.clone(), part, ask }),
                PartKind::Formula(formula) => {
                    all.push(Self::Number { id: part.id.clone(), symbol: formula.symbol, whole: false, ask });
                }
                PartKind::Number(_) | PartKind::Vector(_) | PartKind::Range(_) => {}
            }
            for (id, number) in part.numbers() {
                all.push(Self::Number { id, symbol: number.symbol, whole: number.whole, ask });
            }
        }
        all
    }

    /// The name of the answer.
    pub(super) fn id(&self) -> &str {
        match self {
            Self::Number { id, .. } | Self::Choice { id, .. } => id,
        }
    }

    /// A value near the right one that is wrong: by a thousandth, or by one where it is a whole number.
    pub(super) fn wrong(&self, worked: &Worked<'_>) -> Option<(Symbol, f64)> {
        let Self::Number { symbol, whole, .. } = self else { return None };
        let right = worked.variant.value(*symbol)?.value;
        Some((*symbol, if *whole { right + 1.0 } else { off(worked, *symbol)? }))
    }
}

/// A value that is wrong by a thousandth.
pub(super) fn off(worked: &Worked<'_>, symbol: Symbol) -> Option<f64> {
    let right = worked.variant.value(symbol)?.value;
    Some(right + if right == 0.0 { WRONG } else { right * WRONG })
}

/// Comparisons that belong to what is asked rather than to a quantity: directions counted from somewhere, and boundaries.
pub(super) fn comparisons(worked: &Worked<'_>, witness: &Witness<'_>) -> BTreeMap<String, Comparison> {
    let mut all = BTreeMap::new();
    for (part, ask) in worked.form.parts.iter().zip(&worked.form.question.ask) {
        match (ask, &part.kind) {
            (Ask::Find(find), PartKind::Number(number)) => {
                if let (Some(from), Some(sense)) = (&find.from, find.sense) {
                    let compared = witness.direction(number.symbol, from, sense == Turn::Clockwise);
                    all.extend(compared.map(|comparison| (part.id.clone(), comparison)));
                }
            }
            (_, PartKind::Range(range)) => {
                let sides = [&range.claim.left, &range.claim.right].map(|side| (side, witness.evaluated(side)));
                let at = |(side, measurement): &(&momentous_expr::Expr, Option<super::simulation::Measurement>)| {
                    let said = || {
                        side.evaluate(&|symbol| worked.variant.value(symbol).map_or(f64::NAN, |number| number.value))
                    };
                    measurement.map_or_else(|| (said(), 0.0), |measurement| (measurement.value, measurement.error))
                };
                if sides.iter().any(|(_, measurement)| measurement.is_some()) {
                    let [(left, one), (right, other)] = [at(&sides[0]), at(&sides[1])];
                    let boundary = Comparison { stated: 0.0, found: left - right, error: one + other, turns: false };
                    all.insert(format!("the boundary of {}", part.id), boundary);
                }
            }
            _ => {}
        }
    }
    all
}

/// The values of the formulas that are asked, with the numbers of the variant, each with the quantity that it is to be.
pub(super) fn formulas(worked: &Worked<'_>) -> Vec<(String, Symbol, f64)> {
    let value = |symbol| worked.variant.value(symbol).map_or(f64::NAN, |number| number.value);
    let said = |part: &Part| {
        let PartKind::Formula(formula) = &part.kind else { return None };
        Some((format!("the formula of {}", part.id), formula.symbol, worked.formula(formula)?.evaluate(&value)))
    };
    worked.form.parts.iter().filter_map(said).collect()
}

/// Whether the simulation finds the same as an answer that is not compared as a number; `None` where it finds nothing
/// of it.
pub(super) fn agrees(
    worked: &Worked<'_>,
    case: &Case<'_>,
    witness: &Witness<'_>,
    answer: &Answer<'_>,
    tolerance: f64,
) -> Option<bool> {
    match answer {
        Answer::Choice { part, ask, .. } => {
            let PartKind::Choice(choice) = &part.kind else { return None };
            let right = choice.decided(worked).right;
            // What is equal only within the precision of the data differs in a simulation.
            if choice.is_within_data(worked) {
                return None;
            }
            let option = match choice {
                ChoicePart::Physical(symbol) => taken_root(worked, witness, *symbol),
                _ => chosen(case, witness, ask, choice, tolerance),
            };
            Some(option? == right)
        }
        Answer::Number { symbol, ask: Ask::Count(count), .. } => {
            let put = case.replaced.iter().find(|(known, _)| known == symbol).map(|(_, value)| *value);
            let number = put.or_else(|| Some(worked.variant.value(*symbol)?.value))?;
            is_first(worked, case.scene, count, number, tolerance)
        }
        Answer::Number { .. } => None,
    }
}
