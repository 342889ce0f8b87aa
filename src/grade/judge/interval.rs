//! An interval: each end is judged as a number, then whether it belongs.

use super::super::expected::{ExpectedEnd, ExpectedInterval};
use super::super::messages::Message;
use super::super::read::{EndAnswer, IntervalAnswer, NumberAnswer};
use super::super::verdict::Verdict;
use super::judgement::Judgement;
use super::number;

/// The judgement of an end: none where neither the question nor the answer has one.
type EndJudgement = Option<Judgement>;

/// Judges an interval.
pub(super) fn judge(expected: &ExpectedInterval, answer: &IntervalAnswer) -> Judgement {
    let ends = [(&expected.low, &answer.low), (&expected.high, &answer.high)];
    let judgements: Vec<EndJudgement> =
        ends.iter().map(|(asked, given)| end(asked.as_ref(), given.as_ref(), answer)).collect();
    let judged: Vec<&Judgement> = judgements.iter().flatten().collect();
    let right = judged.iter().filter(|judgement| judgement.verdict.is_right()).count();
    if right == judged.len() && right > 0 {
        let differs = |(asked, given): &(&Option<ExpectedEnd>, &Option<EndAnswer>)| {
            let closed = given.as_ref().map(|end| end.closed);
            // A limit of the quantity's own need not be repeated, so nothing hangs on how it is.
            asked.as_ref().zip(closed).is_some_and(|(asked, closed)| !asked.is_limit && asked.closed != closed)
        };
        return if ends.iter().any(differs) {
            Judgement::of(Verdict::IntervalEnds, Message::Slip(Verdict::IntervalEnds))
        } else {
            Judgement::of(Verdict::Right, Message::Right)
        };
    }
    if is_other_side(expected, answer) {
        return Judgement::of(Verdict::IntervalHalf, Message::OtherSide);
    }
    let wrong: Vec<&&Judgement> = judged.iter().filter(|judgement| !judgement.verdict.is_right()).collect();
    match wrong.as_slice() {
        // The same slip at every end, such as a missing unit, is that slip.
        [first, others @ ..]
            if first.verdict != Verdict::Wrong && others.iter().all(|end| end.verdict == first.verdict) =>
        {
            (**first).clone()
        }
        _ if right > 0 => Judgement::of(Verdict::IntervalHalf, Message::Slip(Verdict::IntervalHalf)),
        _ => Judgement::of(Verdict::Wrong, Message::Wrong),
    }
}

/// Whether the answer begins where the right interval ends, or ends where that begins: what lies on the other side of the boundary.
fn is_other_side(expected: &ExpectedInterval, answer: &IntervalAnswer) -> bool {
    let crossed = [(&expected.low, &answer.high), (&expected.high, &answer.low)];
    let meets = |asked: &Option<ExpectedEnd>, given: &Option<EndAnswer>| {
        let boundary = asked.as_ref().filter(|asked| !asked.is_limit);
        boundary.is_some()
            && end(boundary, given.as_ref(), answer).is_some_and(|judgement| judgement.verdict.is_right())
    };
    crossed.into_iter().any(|(asked, given)| meets(asked, given))
}

fn end(asked: Option<&ExpectedEnd>, given: Option<&EndAnswer>, answer: &IntervalAnswer) -> EndJudgement {
    match (asked, given) {
        (None, None) => None,
        (Some(asked), None) if asked.is_limit => None,
        (Some(asked), Some(given)) => {
            let number = NumberAnswer {
                number: given.number.clone(),
                written: given.written,
                signed: given.number.is_negative(),
                // A zero needs no unit beside an end that has one.
                unit: answer.unit.clone(),
                pounds_as_mass: false,
                sense: None,
                heading: None,
                unjudged: None,
            };
            Some(number::judge(&asked.number, &number))
        }
        _ => Some(Judgement::of(Verdict::Wrong, Message::Wrong)),
    }
}
