//! The figures with which a right number is written. The value is judged elsewhere.

use super::super::expected::{ExpectedKind, ExpectedNumber, Writing};
use super::super::messages::Message;
use super::super::number::Number;
use super::super::read::{Answer, Written};
use super::super::verdict::Verdict;
use super::closeness::{Target, half_unit};
use super::judgement::Judgement;

/// The fewest figures that are asked for.
const LEAST_ASKED: usize = 2;

/// The judgement on a right number, with what is to be said of its figures; `number` is in the unit that is asked.
pub(super) fn judged(
    judgement: Judgement,
    target: &Target,
    written: Written,
    number: &Number,
    converted: bool,
) -> Judgement {
    let expected = target.expected;
    if expected.writing == Writing::Ignore || expected.whole || number.is_zero() {
        return judgement;
    }
    let Some((verdict, message)) = finding(target, written, number, converted) else { return judgement };
    match expected.writing {
        Writing::Require => Judgement::of(verdict, message),
        Writing::Ignore | Writing::Advise => judgement.with(message),
    }
}

fn finding(target: &Target, written: Written, number: &Number, converted: bool) -> Option<(Verdict, Message)> {
    let expected: &ExpectedNumber = target.expected;
    let asked = expected.figures;
    let Written::Figures { least, most } = written else { return None };
    // Trailing zeros of integers are read in the student's favour; one figure more than asked is no false precision yet.
    if most < asked {
        return Some((Verdict::FiguresFew, Message::TooFewFigures(asked)));
    }
    if least > asked + 1 {
        return Some((Verdict::FiguresMany, Message::TooManyFigures(asked)));
    }
    let off = (number.to_f64() - target.value()).abs();
    // Of a value that is nothing no figure counts, and an angle has decimals, not figures.
    let counts = !converted && target.turn().is_none() && target.value() != 0.0;
    let reach = half_unit(target.value(), expected).max(expected.allowance) + expected.error;
    (counts && off > reach * (1.0 + 1e-9)).then_some((Verdict::FiguresWrong, Message::LastFigure))
}

/// How many figures are asked for, where an answer is written with fewer. Neither the right value nor how near the answer is to it
/// is looked at.
#[must_use]
pub fn too_few_figures(asked: &ExpectedKind, answer: &Answer) -> Option<usize> {
    let lacks = |expected: &ExpectedNumber, number: &Number, written: Written| {
        let is_written = matches!(written, Written::Figures { most, .. } if most < expected.figures);
        let counts = expected.writing != Writing::Ignore
            && !expected.whole
            && expected.figures >= LEAST_ASKED
            && !number.is_zero();
        (is_written && counts).then_some(expected.figures)
    };
    match (asked, answer) {
        (ExpectedKind::Number(number), Answer::Number(answer)) => lacks(number, &answer.number, answer.written),
        (ExpectedKind::Vector(vector), Answer::Vector(answer)) => {
            let component = vector.components.first()?;
            let size = answer.heading.as_ref().map(|(size, _)| std::slice::from_ref(size));
            let numbers = size.unwrap_or(&answer.components).iter().zip(&answer.written);
            numbers.into_iter().find_map(|(number, written)| lacks(component, number, *written))
        }
        (ExpectedKind::Interval(interval), Answer::Interval(answer)) => {
            // The limits of a quantity itself are whole numbers, which need no figures.
            let boundary = [&interval.low, &interval.high].into_iter().flatten().find(|end| !end.is_limit)?;
            let ends = [&answer.low, &answer.high].into_iter().flatten().filter(|end| !end.number.value().is_int());
            ends.into_iter().find_map(|end| lacks(&boundary.number, &end.number, end.written))
        }
        _ => None,
    }
}
