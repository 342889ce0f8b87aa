//! The figures with which a right number is written. The value is judged elsewhere.

use super::super::expected::{ExpectedNumber, Writing};
use super::super::messages::Message;
use super::super::number::Number;
use super::super::read::Written;
use super::super::verdict::Verdict;
use super::closeness::{Target, half_unit};
use super::judgement::Judgement;

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
