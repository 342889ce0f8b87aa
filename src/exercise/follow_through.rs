//! Follow-through: an answer that is wrong only because an earlier one was.

use crate::expr::Symbol;
use crate::grade;
use crate::grade::Follows;
use crate::grade::Verdict;
use crate::grade::diagnose;
use crate::problem::Consequence;
use crate::problem::NumberPart;
use crate::quantity::Dimension;
use crate::quantity::Printed;

use super::marking::Marking;

/// So many wrong earlier answers are looked at in every combination, the latest ones.
const MOST_EARLIER: usize = 4;
/// A given and an answer are the same within this share of it.
const SAME: f64 = 1e-6;
/// Values that a student rounds on the way move what follows from them by up to this share.
const ROUNDING: f64 = 0.006;

/// A wrong earlier answer that later ones may build upon.
struct Earlier {
    id: String,
    symbol: Symbol,
    /// In SI units.
    value: f64,
}

/// An earlier set of answers and what follows from it.
struct Found {
    from: Vec<String>,
    consequence: Consequence,
    fraction: crate::quantity::Rational,
}

impl Marking<'_> {
    /// Accepts every wrong answer that follows from earlier wrong ones. Where the question is closed, what would have followed
    /// is shown for the others; before that it could be typed in.
    pub(super) fn follow_through(&self, report: &mut grade::Report, closed: bool) {
        let mut earlier: Vec<Earlier> = Vec::new();
        for (place, own) in report.parts.iter_mut().enumerate() {
            if !diagnose::is_open(own.verdict) {
                continue;
            }
            let Some((number, right, answer)) = self.wrong(place) else { continue };
            let Some(value) = diagnose::number(right, answer) else { continue };
            let Some(expected) = self.expected.get(place) else { continue };
            let relevant = earlier.get(earlier.len().saturating_sub(MOST_EARLIER)..).unwrap_or_default();
            if let Some(found) = self.followed(number, expected, (answer, value), relevant) {
                let flagged = found.consequence.unphysical.is_some();
                own.verdict = if flagged { Verdict::FollowThroughUnphysical } else { Verdict::FollowThrough };
                let fraction = self.rubric.fraction(own.verdict) * found.fraction;
                own.points = grade::Points(fraction * crate::quantity::Rational::from(own.out_of));
                let follows = Follows {
                    from: found.from,
                    by: found.consequence.by.iter().map(|law| law.name).collect(),
                    unphysical: found.consequence.unphysical,
                };
                own.message = follows.to_string();
                own.follows = Some(follows);
            } else if closed && !relevant.is_empty() {
                own.own_values = self.own_values(number, relevant);
            }
            let value = value * self.worked.unit_of(number);
            if self.can_be_built_upon(number.symbol, value) {
                earlier.push(Earlier { id: own.id.clone(), symbol: number.symbol, value });
            }
        }
        report.recount();
    }

    /// What makes the rest trivial or impossible is not built upon: nothing, and what is given anyway.
    fn can_be_built_upon(&self, symbol: Symbol, value: f64) -> bool {
        let dimension = self.worked.problem.model().symbols.entry(symbol).dimension;
        let given = self.worked.variant.all_given().iter().any(|(own, _, unit)| {
            let given = self.worked.variant.value(*own).map(|given| given.value);
            unit.dimension() == dimension && given.is_some_and(|given| (given - value).abs() <= SAME * given.abs())
        });
        value != 0.0 && value.is_finite() && !given
    }

    /// The consequence that the answer is, of the fewest earlier answers; one that is possible rather than one that is not.
    fn followed(
        &self,
        number: &NumberPart,
        expected: &grade::Expected,
        (answer, written): (&grade::Answer, f64),
        earlier: &[Earlier],
    ) -> Option<Found> {
        let mut best: Option<Found> = None;
        let grade::ExpectedKind::Number(right) = &expected.kind else { return None };
        let mut target = expected.clone();
        for chosen in subsets(earlier) {
            let mut verdicts = Vec::new();
            let mut accept = |value: f64| {
                if is_far(right, value, written) {
                    return false;
                }
                aim(&mut target, expected, value);
                let judged = grade::judge(&target, answer).verdict;
                let accepted = judged.is_right() || judged == Verdict::UnitMissing;
                verdicts.extend(accepted.then_some(judged));
                accepted
            };
            let consequences = self.consequences(number, &chosen, &mut accept);
            for (consequence, judged) in consequences.into_iter().zip(verdicts) {
                let better = best
                    .as_ref()
                    .is_none_or(|best| best.consequence.unphysical.is_some() && consequence.unphysical.is_none());
                if better {
                    let from = chosen.iter().map(|own| own.id.clone()).collect();
                    best = Some(Found { from, consequence, fraction: self.rubric.fraction(judged) });
                }
            }
        }
        best
    }

    /// What follows from earlier answers and is wanted, without what makes the rest trivial.
    fn consequences(
        &self,
        number: &NumberPart,
        chosen: &[&Earlier],
        accept: &mut dyn FnMut(f64) -> bool,
    ) -> Vec<Consequence> {
        let values = chosen.iter().map(|own| (own.symbol, own.value)).collect();
        let unit = self.worked.unit_of(number);
        let mut accept = |value: f64| self.can_be_built_upon(number.symbol, value * unit) && accept(value);
        self.worked.following(number, &values, &mut accept)
    }

    /// What would have followed from the student's own answers: every value, and the laws by which it follows.
    fn own_values(&self, number: &NumberPart, earlier: &[Earlier]) -> Option<String> {
        let all: Vec<&Earlier> = earlier.iter().collect();
        let (chosen, found) = [all, earlier.iter().rev().take(1).collect()]
            .into_iter()
            .map(|chosen| {
                (
                    chosen.iter().map(|own| own.id.as_str()).collect::<Vec<_>>(),
                    self.consequences(number, &chosen, &mut |_| true),
                )
            })
            .find(|(_, found)| !found.is_empty())?;
        let said: Vec<String> = found
            .iter()
            .filter_map(|own| {
                let value = Printed::new(own.value, number.figures)?.plain();
                let laws: Vec<&str> = own.by.iter().map(|law| law.name).collect();
                Some(format!("{} by {}", format!("{value} {}", number.plain_unit()).trim_end(), laws.join(" and ")))
            })
            .collect();
        Some(format!("From your own {} it would follow: {}.", chosen.join(" and "), said.join(", or ")))
    }
}

/// Whether an answer is so far from a value, whatever its sign, that it cannot be taken for it. An angle is never far, nor is what
/// may be a fraction of something.
fn is_far(right: &grade::ExpectedNumber, value: f64, answer: f64) -> bool {
    let size = value.abs().max(right.scale);
    let tolerance = match &right.tolerance {
        grade::Tolerance::Relative(share) => share.to_f64().abs() * size,
        grade::Tolerance::Absolute(distance) => distance.to_f64().abs(),
        grade::Tolerance::ToFigures => size,
    };
    let reach = 2.0 * (tolerance + right.allowance + ROUNDING * size);
    !right.cyclic && right.unit.dimension() != Dimension::NONE && (answer.abs() - value.abs()).abs() > reach
}

/// Every choice of earlier answers, small ones first.
fn subsets(earlier: &[Earlier]) -> Vec<Vec<&Earlier>> {
    let mut all: Vec<Vec<&Earlier>> = vec![Vec::new()];
    for own in earlier {
        let with: Vec<Vec<&Earlier>> = all.iter().map(|chosen| [chosen.as_slice(), &[own]].concat()).collect();
        all.extend(with);
    }
    all.retain(|chosen| !chosen.is_empty());
    all.sort_by_key(Vec::len);
    all
}

/// Puts what follows from the student's own answers in place of the right value.
fn aim(target: &mut grade::Expected, expected: &grade::Expected, value: f64) {
    let grade::ExpectedKind::Number(right) = &expected.kind else { return };
    if let grade::ExpectedKind::Number(number) = &mut target.kind {
        number.value = value;
        number.error = SAME * SAME * value.abs();
        number.exact = None;
        number.allowance = right.allowance.max(ROUNDING * value.abs());
        number.magnitude = number.senses.is_none() && value >= 0.0;
    }
}
