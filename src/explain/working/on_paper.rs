//! The formula that a student would find on paper, where the plan has another one.

use momentous_expr::Expr;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::Shown;
use momentous_solve::Move;
use momentous_solve::Step;

use super::super::terms::algebra::positive_first;
use super::super::terms::display::Display;
use super::super::terms::term::Term;
use super::derivation::is_definition;
use super::isolate;
use super::quadratic;
use super::quadratic::Short;
use super::script::Formula;
use super::script::Script;

/// By how much, relative to its size, the value of a formula may differ from that of another one that is equal to it.
const SAME: f64 = 1e-9;

/// The formula that a student would find, where the plan has another: a plain square root, or the law with its terms moved and nothing
/// multiplied out.
pub(crate) fn as_on_paper(
    display: Display<'_>,
    step: &Step,
    script: &Script,
    unknown: Symbol,
    formula: &Formula,
) -> Option<Term> {
    if let Some((solved, way)) = quadratic_of(display, step) {
        return match way {
            Short::Root(root) if solved == unknown => Some(display.term(root)),
            _ => None,
        };
    }
    let ([law], Formula::Fixed(Some(formula))) = (&script.derivation.lines[..], formula) else { return None };
    if let Some(Shown::Areas(areas)) = &law.shown
        && law.left == Expr::from(unknown)
    {
        return Some(display.term(Expr::sum(areas.iter().cloned())));
    }
    if matches!(law.shown, Some(Shown::Integral { .. })) && law.left == Expr::from(unknown) {
        return multiplied_out(&display.without_zeros(&formula.expr)).map(|terms| display.term(terms));
    }
    let sides = [&law.left, &law.right];
    if matches!(law.shown, Some(Shown::Integral { .. }))
        || law.relation != Operator::Equals
        || only_evaluates(step, sides)
    {
        return None;
    }
    let value = display.value_of(&unknown.into());
    let isolated = positive_first(&isolate::isolated(sides, unknown, value < 0.0)?);
    let terms = [&isolated, &formula.expr].map(|term| display.without_zeros(term));
    let [mentions, fewest] = terms.each_ref().map(|term| isolate::occurrences(term, None));
    let [nested, least] = terms.each_ref().map(isolate::nested_fractions);
    let splits = isolate::is_bare(sides, unknown) && isolate::is_quotient_of_sum(&terms[1]);
    let reads_better = nested <= least && (mentions < fewest || splits && mentions <= fewest + 1);
    // Not so where the plan took another branch of a root.
    let is_same = (display.value_of(&isolated) - value).abs() <= SAME * value.abs();
    (reads_better && is_same).then(|| display.term(isolated))
}

/// The value of an integral of powers, one term for each: `F_0 d - k d^2/2`.
fn multiplied_out(value: &Expr) -> Option<Expr> {
    let Expr::Product(factors) = value else { return None };
    let place = factors.iter().position(|factor| matches!(factor, Expr::Sum(_))).filter(|_| !has_function(value))?;
    let rest = || factors.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, factor)| factor.clone());
    let terms = factors[place].children().map(|term| Expr::product(rest().chain([term.clone()])).simplify());
    Some(Expr::sum(terms))
}

fn has_function(term: &Expr) -> bool {
    matches!(term, Expr::Apply(..)) || term.children().any(has_function)
}

/// The unknown that a step finds from a quadratic equation, and how.
pub(crate) fn quadratic_of(display: Display<'_>, step: &Step) -> Option<(Symbol, Short)> {
    step.moves.iter().find_map(|step_move| match step_move {
        Move::Quadratic { unknown, a, b, c, .. } => Some((*unknown, quadratic::short(display, *unknown, [a, b, c])?)),
        _ => None,
    })
}

/// Whether a step only evaluates its one law, which is then stated together with its numbers.
pub(super) fn only_evaluates(step: &Step, [left, right]: [&Expr; 2]) -> bool {
    step.equations.len() == 1 && is_definition(step, left, right)
}
