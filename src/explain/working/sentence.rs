//! How a line of algebra follows from those before it, as a sentence.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::Shown;
use momentous_solve::Statement;

use super::super::Block;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::wording::join;
use super::derivation::Derivation;
use super::derivation::Line;
use super::derivation::Origin;
use super::divisors;

/// The sentence that leads to a line, and the line. Of a law its own reason is said.
pub(super) fn blocks(
    display: Display<'_>,
    derivation: &Derivation,
    line: &Line,
    simplified: &dyn Fn(&Expr) -> Expr,
) -> Vec<Block> {
    let mut words = words(display, derivation, line);
    words.push(Inline::Text(":".into()));
    let [left, right] = [&line.left, &line.right].map(|side| display.symbolic(&simplified(side)));
    let equation = Math::relation(left, line.relation, right);
    vec![Block::Paragraph(words), Block::Equation { lines: vec![equation], number: line.number }]
}

fn words(display: Display<'_>, derivation: &Derivation, line: &Line) -> Vec<Inline> {
    let said = |text: String| vec![Inline::Text(text)];
    let named = |place: usize| name(derivation, place);
    match &line.origin {
        Origin::Law(_) => Vec::new(),
        Origin::Add { to, times, factor, drops } => {
            let (to, times) = (named(*to), named(*times));
            let is_minus = factor.begins_with_minus();
            let size = if is_minus { (-factor.clone()).simplify() } else { factor.clone() };
            let mut words = match (size.is_one(), is_minus) {
                (true, false) => said(format!("Add {times} to {to}")),
                (true, true) => said(format!("Subtract {times} from {to}")),
                (false, _) => {
                    let mut words = said(format!("Multiply {times} by "));
                    words.push(Inline::Math(display.symbolic(&size)));
                    words.extend(where_not_zero(display, ", where ", divisors::of_term(factor)));
                    let then = if is_minus { "subtract it from" } else { "add it to" };
                    words.push(Inline::Text(format!(", and {then} {to}")));
                    words
                }
            };
            words.extend([
                Inline::Text(", so that ".into()),
                Inline::Math(display.name(*drops)),
                Inline::Text(" drops out".into()),
            ]);
            words
        }
        Origin::Vanish { of: line, zero, drops } => {
            let nothing = Math::relation(display.symbolic(zero), Operator::Equals, Math::Number("0".into()));
            vec![
                Inline::Text("Since ".into()),
                Inline::Math(nothing),
                Inline::Text(", ".into()),
                Inline::Math(display.name(*drops)),
                Inline::Text(format!(" drops out of {}", named(*line))),
            ]
        }
        Origin::Put { what, into } => said(format!("Put {} into {}", named(*what), named(*into))),
        Origin::Integrate { of, ends } => {
            let source = derivation.lines.get(*of);
            let number = source.and_then(|line| line.number);
            let mut words = said(format!(
                "Evaluating the integral{}",
                number.map_or_else(String::new, |equation| format!(" in ({equation})"))
            ));
            let shown = source.and_then(|source| source.shown.as_ref());
            if let (Some(Shown::Integral { of: quantity, .. }), Expr::Symbol(result)) = (shown, &line.left)
                && *quantity != line.left
            {
                words.extend([Inline::Text(" and solving for ".into()), Inline::Math(display.name(*result))]);
            }
            let ends: Vec<_> = ends.iter().filter_map(|(place, number)| end(display, *place, *number)).collect();
            if !ends.is_empty() {
                words.push(Inline::Text(", with ".into()));
                words.extend(join(ends));
            }
            words
        }
        Origin::Square(line) => said(format!("Square both sides of {}", named(*line))),
        Origin::Tangent(of) => {
            let mut words = said(format!("Divide {} by the cosine", named(*of)));
            words.extend(where_not_zero(display, ", where ", divisors::of_term(&line.right)));
            words
        }
        Origin::Component([first, second]) => said(format!("From {} and {}", named(*first), named(*second))),
        Origin::Solve { of, unknown } => {
            let source: Vec<&Line> = derivation.lines.get(*of).into_iter().collect();
            solved(display, &source, *unknown, &line.right)
        }
        Origin::Collect { of, factor, unknown, power } => {
            let is = derivation.lines.get(*of).and_then(|line| line.number).map_or("this", |_| "it");
            let mut words = if factor.is_one() {
                said(format!("With all terms on one side, {} is a quadratic equation in ", named(*of)))
            } else if *factor == Expr::integer(-1) {
                said(format!(
                    "With all signs changed and all terms on one side, {} is a quadratic equation in ",
                    named(*of)
                ))
            } else {
                vec![
                    Inline::Text(format!("Multiply {} by ", named(*of))),
                    Inline::Math(display.symbolic(factor)),
                    Inline::Text(format!("; with all terms on one side, {is} is a quadratic equation in ")),
                ]
            };
            words.push(Inline::Math(display.symbolic(&Expr::from(*unknown).powi(*power))));
            words
        }
    }
}

/// `(3)`; an equation without a number stands just above.
fn name(derivation: &Derivation, place: usize) -> String {
    let number = derivation.lines.get(place).and_then(|line| line.number);
    number.map_or_else(|| "this".to_owned(), |number| format!("({number})"))
}

/// An equation of an earlier step: by its number, or as it was stated.
fn end(display: Display<'_>, place: usize, number: Option<u32>) -> Option<Vec<Inline>> {
    if let Some(number) = number {
        return Some(vec![Inline::Text(format!("({number})"))]);
    }
    match &display.worked.leaf().system.equations.get(place)?.statement {
        Statement::Equal { left, right } => {
            let [left, right] = [left, right].map(|side| display.symbolic(side));
            Some(vec![Inline::Math(Math::relation(left, Operator::Equals, right))])
        }
        Statement::FirstInteger { .. } => None,
    }
}

/// From which equations a quantity is found, and what must not be zero for that.
fn solved(display: Display<'_>, sources: &[&Line], unknown: Symbol, value: &Expr) -> Vec<Inline> {
    let numbers: Vec<u32> = sources.iter().filter_map(|line| line.number).collect();
    let words = match (&numbers[..], value) {
        ([], _) => None,
        ([cosine, sine], Expr::Apply(Function::Atan2, _)) => Some(format!("Divide ({sine}) by ({cosine})")),
        ([cosine, sine], _) => Some(format!("Square ({cosine}) and ({sine}), and add them")),
        ([first, ..], _) => Some(format!("From ({first})")),
    };
    let mut words: Vec<Inline> = words.map(Inline::Text).into_iter().collect();
    let opening = if words.is_empty() { "Where " } else { ", where " };
    words.extend(where_not_zero(display, opening, divisors::of_solution(sources, unknown, value)));
    words
}

/// The text before the value of an unknown.
pub(super) fn before_result(
    display: Display<'_>,
    derivation: &Derivation,
    unknown: Symbol,
    value: &Expr,
) -> Option<Block> {
    let mut words = solved(display, &derivation.sources_of(unknown), unknown, value);
    words.push(Inline::Text(":".into()));
    (words.len() > 1).then_some(Block::Paragraph(words))
}

/// `, where cos(beta) is not zero`, for factors of which that is not plain.
fn where_not_zero(display: Display<'_>, opening: &str, factors: Vec<Expr>) -> Vec<Inline> {
    let doubtful = divisors::doubtful(factors, &display.worked.leaf().system.positive);
    if doubtful.is_empty() {
        return Vec::new();
    }
    let zero = || Math::Number("0".into());
    let differs = |factor: &Expr| {
        let condition = Math::relation(display.symbolic(factor), Operator::Differs, zero());
        vec![Inline::Math(condition)]
    };
    let mut words = vec![Inline::Text(opening.into())];
    words.extend(join(doubtful.iter().map(differs).collect()));
    words
}
