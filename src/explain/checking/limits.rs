//! The extremes of restitution: what the answers would be with e = 0 and with e = 1.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_problem::AskedUnit;
use momentous_problem::NumberPart;
use momentous_problem::Variant;
use momentous_problem::Worked;
use momentous_quantity::Decimal;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_scene::Stage;

use super::super::Block;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::entry::Item;
use super::super::terms::ledger::Ledger;
use super::super::terms::printed;
use super::super::wording::join;

/// The two extremes, and what happens there: in one dimension, and in two.
const EXTREMES: [(i64, [&str; 2]); 2] = [
    (0, ["they would move on together", "they would have the same velocity along the line of impact"]),
    (1, ["no energy would be lost"; 2]),
];

/// A sentence on each extreme, where the coefficient of restitution is told and the answers exist there.
pub(crate) fn limits(display: Display<'_>) -> Vec<Block> {
    let oblique = display.worked.problem.loaded().draft.scene.axes.rectangular().len() > 1;
    let numbers: Vec<&NumberPart> = numbers(display).collect();
    let sentences = extremes(display).map(|Extreme { e, place, there }| {
        let (value, words) = EXTREMES[place];
        let there = Worked { variant: &there, ..display.worked };
        let results: Vec<Vec<Inline>> =
            numbers.iter().map(|number| vec![Inline::Math(result(display, there, place, number))]).collect();
        let mut sentence = vec![
            Inline::Text("With ".into()),
            Inline::Math(Math::relation(display.name(e), Operator::Equals, Math::Number(value.to_string()))),
        ];
        let words = words[usize::from(oblique)];
        sentence.push(Inline::Text(format!(" {words}: ")));
        sentence.extend(join(results));
        sentence.push(Inline::Text(".".into()));
        Block::Paragraph(sentence)
    });
    if numbers.is_empty() { Vec::new() } else { sentences.collect() }
}

/// Enters the answers in the extremes into the ledger of a solution, where they have formulas in what is told.
pub(crate) fn enter(display: Display<'_>, ledger: &mut Ledger) {
    for Extreme { e, place, there } in extremes(display) {
        let there = Worked { variant: &there, ..display.worked };
        let values = BTreeMap::from([(e, Expr::integer(EXTREMES[place].0))]);
        for number in numbers(display) {
            let unit = match number.unit {
                AskedUnit::Unit(_) => Some(Expr::one()),
                AskedUnit::InTermsOf(unit, _) => there.in_givens(unit, &values),
            };
            let Some((whole, unit)) = there.in_givens(number.symbol, &values).zip(unit) else { continue };
            let ratio = whole / unit;
            let mentions: Vec<Symbol> = ratio.symbols().into_iter().collect();
            for symbol in &mentions {
                display.enter(ledger, *symbol);
            }
            let (item, size) = (Item::Extreme(number.symbol, place), number.size);
            ledger.asked(item, there.answer(number).for_print() * size, size, number.figures);
            ledger.term(&ratio, &mentions, item);
        }
    }
}

/// One extreme: the coefficient, the place in the table, and the numbers there.
struct Extreme {
    e: Symbol,
    place: usize,
    there: Variant,
}

fn extremes(display: Display<'_>) -> impl Iterator<Item = Extreme> {
    let there = move |(e, place): (Symbol, usize)| {
        let there = display.worked.at_limit(e, &Decimal::from(EXTREMES[place].0), &Unit::none())?;
        Some(Extreme { e, place, there })
    };
    let e = coefficient(display.worked).into_iter();
    e.flat_map(|e| (0..EXTREMES.len()).map(move |place| (e, place))).filter_map(there)
}

/// The answers that are told of an extreme.
fn numbers(display: Display<'_>) -> impl Iterator<Item = &NumberPart> {
    let numbers = display.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
    numbers.filter(move |number| !number.whole && display.has_number(number.symbol))
}

/// The told coefficient of restitution of the one impact of two bodies, where it is neither 0 nor 1.
fn coefficient(worked: Worked<'_>) -> Option<Symbol> {
    let [Stage::Impact(impact)] = &worked.problem.loaded().draft.scene.stages[..] else { return None };
    impact.between.as_ref()?;
    let symbol = worked.problem.model().symbols.find(impact.restitution.as_ref()?.0.trim())?;
    let (value, _) = worked.variant.given(symbol)?;
    let inner = !value.is_zero() && value.compare(&Decimal::from(1)).is_lt();
    let plain = worked.problem.model().symbols.entry(symbol).dimension == Dimension::NONE;
    (inner && plain && worked.form.reveal.is_empty()).then_some(symbol)
}

fn result(display: Display<'_>, there: Worked<'_>, place: usize, number: &NumberPart) -> Math {
    let settled = display.shown.figures.get();
    let figures = settled.and_then(|figures| figures.of(Item::Extreme(number.symbol, place))).unwrap_or(number.figures);
    let answer = printed::answer(display, &NumberPart { figures, ..number.clone() }, there.answer(number));
    Math::relation(display.name(number.symbol), Operator::Equals, answer)
}
