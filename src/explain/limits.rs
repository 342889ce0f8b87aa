//! The extremes of restitution: what the answers would be with e = 0 and with e = 1.

use crate::expr::Math;
use crate::expr::Operator;
use crate::expr::Symbol;
use crate::problem::NumberPart;
use crate::problem::Worked;
use crate::quantity::Decimal;
use crate::quantity::Dimension;
use crate::quantity::Printed;
use crate::quantity::Unit;
use crate::scene::Stage;

use super::Block;
use super::Inline;
use super::display::Display;
use super::display::number_math;
use super::wording::join;

/// The two extremes, and what happens there: in one dimension, and in two.
const EXTREMES: [(i64, [&str; 2]); 2] = [
    (0, ["they would move on together", "they would keep the same velocity along the line of impact"]),
    (1, ["no energy would be lost"; 2]),
];

/// A sentence on each extreme, where the coefficient of restitution is told and the answers exist there.
pub(super) fn limits(display: Display<'_>) -> Vec<Block> {
    let worked = display.worked;
    let Some(e) = coefficient(worked) else { return Vec::new() };
    let numbers: Vec<&NumberPart> = worked
        .form
        .parts
        .iter()
        .flat_map(|part| part.kind.numbers())
        .filter(|number| !number.whole && !display.is_free(number.symbol))
        .collect();
    let oblique = worked.problem.loaded().draft.scene.axes.rectangular().len() > 1;
    let sentences = EXTREMES.iter().filter_map(|(value, words)| {
        let there = worked.at_limit(e, &Decimal::from(*value), &Unit::none())?;
        let there = Worked::new(worked.problem, &there)?;
        let results: Vec<Vec<Inline>> =
            numbers.iter().map(|number| vec![Inline::Math(result(display, there, number))]).collect();
        let mut sentence = vec![
            Inline::Text("With ".into()),
            Inline::Math(Math::relation(display.name(e), Operator::Equals, Math::Number(value.to_string()))),
        ];
        let words = words[usize::from(oblique)];
        sentence.push(Inline::Text(format!(" {words}: ")));
        sentence.extend(join(results));
        sentence.push(Inline::Text(".".into()));
        Some(Block::Paragraph(sentence))
    });
    if numbers.is_empty() { Vec::new() } else { sentences.collect() }
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

fn result(display: Display<'_>, there: Worked<'_>, number: &NumberPart) -> Math {
    let answer = there.answer(number);
    let shown = Printed::new(answer.for_print(), number.figures)
        .map_or(Math::Text("?".into()), |printed| number_math(printed.plain()));
    Math::relation(display.name(number.symbol), Operator::Equals, display.in_unit_of(number, shown))
}
