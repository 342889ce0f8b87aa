//! Follow-through: an answer that is wrong only because an earlier one was.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade as grade;
use momentous_grade::Follows;
use momentous_grade::Verdict;
use momentous_grade::diagnose;
use momentous_laws::Law;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_quantity::Dimension;
use momentous_quantity::Printed;
use momentous_quantity::Rational;

use super::marking::Marking;

/// The number of wrong earlier answers that are looked at in every combination, the latest ones.
const MOST_EARLIER: usize = 4;
/// A given and an answer are the same within this share of it.
const SAME: f64 = 1e-6;

/// A wrong earlier answer that later ones may build upon; of a vector, one of its components.
pub(super) struct Earlier {
    pub(super) id: String,
    pub(super) symbol: Symbol,
    /// In SI units; of a formula, with the numbers of the variant.
    pub(super) value: f64,
    /// Whether nothing but its sign is wrong.
    pub(super) reversed: bool,
    /// In what is given. Of numbers only a pure one can stand in a formula.
    pub(super) formula: Option<Expr>,
}

/// Earlier answers and what follows from them.
pub(super) struct FollowedAnswer {
    pub(super) from: Vec<String>,
    pub(super) by: Vec<&'static Law>,
    pub(super) unphysical: Option<String>,
    /// The fraction that the answer is worth otherwise: less than all where its unit is missing.
    pub(super) fraction: Rational,
}

impl Marking<'_> {
    /// Accepts every wrong answer that follows from earlier wrong ones. Where a part is closed, what would have followed is shown
    /// for it; before that it could be typed in.
    pub(super) fn follow_through(&self, report: &mut grade::Report) {
        let mut earlier: Vec<Earlier> = Vec::new();
        for (place, report) in report.parts.iter_mut().enumerate() {
            if !diagnose::is_open(report.verdict) {
                continue;
            }
            let relevant = earlier.split_at(earlier.len().saturating_sub(MOST_EARLIER)).1;
            if let Some(followed) = self.followed(place, relevant) {
                let flagged = followed.unphysical.is_some();
                report.verdict = if flagged { Verdict::FollowThroughUnphysical } else { Verdict::FollowThrough };
                report.points = grade::Points(
                    self.rubric.fraction(report.verdict) * followed.fraction * Rational::from(report.out_of),
                );
                let by = followed.by.iter().map(|law| law.name).collect();
                let follows = Follows { from: followed.from, by, unphysical: followed.unphysical };
                report.message = follows.to_string().into();
                report.follows = Some(follows);
            } else if self.sitting(place).closed
                && !relevant.is_empty()
                && let Some((PartKind::Number(number), ..)) = self.answered(place)
            {
                report.own_values = self.own_values(number, relevant);
            }
            let reversed = matches!(report.verdict, Verdict::Sense | Verdict::SenseReversed);
            let fresh = self.given_as(place).into_iter();
            earlier.extend(fresh.filter_map(|(symbol, value, formula)| {
                self.can_be_built_upon(symbol, value).then(|| Earlier {
                    id: report.id.clone(),
                    symbol,
                    value,
                    reversed,
                    formula,
                })
            }));
        }
        report.recount();
    }

    /// The values of an answer for the quantities that are asked: in SI units, and as formulas in what is given. None where it
    /// measures something else.
    fn given_as(&self, place: usize) -> Vec<(Symbol, f64, Option<Expr>)> {
        match self.answered(place) {
            Some((PartKind::Number(number), grade::ExpectedKind::Number(right), answer)) => {
                let value = diagnose::number(right, answer).map(|value| value * self.worked.unit_of(number));
                let pure = self.worked.problem.model().symbols.entry(number.symbol).dimension == Dimension::NONE;
                let is_formula = |part: &Part| matches!(part.kind, PartKind::Formula(_));
                let stands = pure && self.worked.form.parts.iter().any(is_formula);
                let formula = if stands { exactly(answer) } else { None };
                value.map(|value| (number.symbol, value, formula)).into_iter().collect()
            }
            Some((PartKind::Vector(vector), grade::ExpectedKind::Vector(right), answer)) => {
                let values = diagnose::components(right, answer).unwrap_or_default();
                let pairs = vector.components.iter().zip(values);
                pairs.map(|(number, value)| (number.symbol, value * self.worked.unit_of(number), None)).collect()
            }
            Some((PartKind::Formula(formula), grade::ExpectedKind::Formula(right), grade::Answer::Formula(answer))) => {
                let written = right.in_letters(&answer.formula);
                let fits = written.dimension(&right.symbols) == Ok(right.dimension);
                let value = written
                    .evaluate(&|symbol| self.worked.variant.value(symbol).map_or(f64::NAN, |number| number.value));
                fits.then_some((formula.symbol, value, Some(written))).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    /// Whether a value can be built upon: none that makes the rest trivial or impossible, as zero and what is given anyway.
    pub(super) fn can_be_built_upon(&self, symbol: Symbol, value: f64) -> bool {
        let dimension = self.worked.problem.model().symbols.entry(symbol).dimension;
        let given = self.worked.variant.all_given().iter().any(|(given_symbol, _, unit)| {
            let given = self.worked.variant.value(*given_symbol).map(|given| given.value);
            unit.dimension() == dimension && given.is_some_and(|given| (given - value).abs() <= SAME * given.abs())
        });
        value != 0.0 && value.is_finite() && !given
    }

    /// The values that would have followed from the student's own answers, and the laws by which they follow.
    fn own_values(&self, number: &NumberPart, earlier: &[Earlier]) -> Option<String> {
        let all: Vec<&Earlier> = earlier.iter().collect();
        let last: Vec<&Earlier> = earlier.iter().rev().take(1).collect();
        let (chosen, consequences) = [all, last]
            .into_iter()
            .map(|chosen| (names(&chosen), self.consequences(number.symbol, &chosen, &mut |_| true)))
            .find(|(_, consequences)| !consequences.is_empty())?;
        let unit = self.worked.unit_of(number);
        let said: Vec<String> = consequences
            .iter()
            .filter_map(|consequence| {
                let value = Printed::new(consequence.value / unit, number.figures)?.plain();
                let laws: Vec<&str> = consequence.by.iter().map(|law| law.name).collect();
                Some(format!(
                    "{} by {}",
                    format!("{value} {}", self.worked.problem.unit_name(number)).trim_end(),
                    laws.join(" and ")
                ))
            })
            .collect();
        Some(format!("With your own {}, the result would be {}.", chosen.join(" and "), said.join(", or ")))
    }
}

/// A pure number as it was written.
fn exactly(answer: &grade::Answer) -> Option<Expr> {
    let grade::Answer::Number(answer) = answer else { return None };
    let factor = answer.unit.clone().unwrap_or_default().factor();
    Some(Expr::Number(answer.directed().scaled(&factor)?.value().into_owned()))
}

/// The parts of earlier answers, each once.
pub(super) fn names(chosen: &[&Earlier]) -> Vec<String> {
    let mut listed = BTreeSet::new();
    chosen.iter().filter(|answer| listed.insert(&answer.id)).map(|answer| answer.id.clone()).collect()
}
