//! Which lines a solution computes, and so how many figures its numbers have.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::AskedUnit;
use momentous_problem::NumberPart;
use momentous_problem::PartKind;
use momentous_solve::Closed;
use momentous_solve::Move;
use momentous_solve::Step;

use super::Detail;
use super::cache::WayCache;
use super::terms::display::Display;
use super::terms::entry::Item;
use super::terms::ledger::Figures;
use super::terms::ledger::Ledger;
use super::working::counting;
use super::working::derivation::Solving;
use super::working::naming;
use super::working::on_paper;
use super::working::quadratic;
use super::working::quadratic::Short;
use super::working::script::Formula;
use super::working::script::Script;
use super::working::script::SolvedUnknown;
use super::working::steps::Steps;
use super::working::steps::taken;

/// The number of figures that the numbers of a variant's solution have. What does not come out with the most figures is computed
/// from the givens, which are exact.
pub(super) fn figures(display: Display<'_>, way: &WayCache, detail: Detail) -> Figures {
    if detail == Detail::Short {
        display.shown.names.get_or_init(|| naming::names(display));
    }
    let figures = ledger(display, way, detail, &[]).settle();
    let from_givens = figures.stubborn.iter().filter_map(|item| match item {
        Item::Quantity(symbol) => Some(*symbol).filter(|symbol| display.in_what_is_told(*symbol).is_some()),
        _ => None,
    });
    let from_givens: Vec<Symbol> = from_givens.collect();
    if from_givens.is_empty() {
        return figures;
    }
    let settled = ledger(display, way, detail, &from_givens).settle();
    Figures { from_givens, ..settled }
}

/// The lines of a solution but those of some results.
fn ledger(display: Display<'_>, way: &WayCache, detail: Detail, without: &[Symbol]) -> Ledger {
    let mut ledger = Ledger::default();
    let scripts = way.scripts(display, detail);
    for (position, (step, script)) in display.worked.leaf().answer_steps().iter().zip(scripts).enumerate() {
        enter_step(display, &mut ledger, (position, step, script), without);
    }
    enter_answers(display, &mut ledger);
    if detail == Detail::Full {
        way.checks(display).enter(display, &mut ledger);
    }
    ledger
}

fn enter_step(
    display: Display<'_>,
    ledger: &mut Ledger,
    (position, step, script): (usize, &Step, &Script),
    without: &[Symbol],
) {
    let steps = Steps::new(display);
    let Some(root) = taken(display, position, step) else { return };
    for (unknown, closed, SolvedUnknown { formula, .. }) in script.printed(root) {
        if without.contains(&unknown) {
            display.enter(ledger, unknown);
            continue;
        }
        let is_in_numbers = script.solving == Solving::InNumbers;
        if is_in_numbers && enter_in_numbers(display, ledger, (step, script), (unknown, formula)) {
            continue;
        }
        let solved = step.moves.iter().find_map(|step_move| match step_move {
            Move::Quadratic { unknown: squared, a, b, c, .. } if *squared == unknown => Some([a, b, c]),
            _ => None,
        });
        match (solved, closed, formula) {
            (Some(coefficients), ..) => quadratic::enter(display, ledger, unknown, coefficients),
            (None, Closed::FirstInteger { .. }, _) => counting::enter(display, ledger, unknown, closed),
            (None, _, Formula::Fixed(formula)) => {
                if let Some(formula) = formula {
                    display.enter_term(ledger, formula, Item::Quantity(unknown));
                }
            }
            (None, _, Formula::Varies) => {
                if let Some(formula) = steps.formula(step, unknown, closed) {
                    display.enter_term(ledger, &formula, Item::Quantity(unknown));
                }
            }
        }
    }
}

/// Enters a result as a short solution finds it; whether that differs from the plan.
fn enter_in_numbers(
    display: Display<'_>,
    ledger: &mut Ledger,
    (step, script): (&Step, &Script),
    (unknown, formula): (Symbol, &Formula),
) -> bool {
    if let Some((solved, Short::Equation(terms))) = on_paper::quadratic_of(display, step)
        && solved == unknown
    {
        quadratic::enter(display, ledger, unknown, terms.each_ref());
        return true;
    }
    let Some(term) = on_paper::as_on_paper(display, step, script, unknown, formula) else { return false };
    display.enter_term(ledger, &term, Item::Quantity(unknown));
    true
}

/// The answers that are converted to the unit of the question.
fn enter_answers(display: Display<'_>, ledger: &mut Ledger) {
    for part in &display.worked.form.parts {
        let PartKind::Number(number @ NumberPart { whole: false, .. }) = &part.kind else { continue };
        let item = Item::Quantity(number.symbol);
        let value = display.worked.variant.value(number.symbol).filter(|_| ledger.knows(item));
        let (of_component, Some(value)) = (Item::Answer(number.symbol), value) else { continue };
        match number.unit {
            AskedUnit::Unit(_) => {
                ledger.rounded(of_component, value.for_print(), number.size, number.figures);
                ledger.same(item, of_component);
            }
            AskedUnit::InTermsOf(unit, _) => {
                let ratio = Expr::from(number.symbol) / Expr::from(unit);
                display.enter(ledger, unit);
                let multiple = display.worked.answer(number).for_print() * number.size;
                ledger.rounded(of_component, multiple, number.size, number.figures);
                ledger.term(&ratio, &[number.symbol, unit], of_component);
            }
        }
    }
}
