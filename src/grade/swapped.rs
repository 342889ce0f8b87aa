//! Values of two bodies, or of two components, exchanged: each answer is right, for the other.

use super::expected::Expected;
use super::judge::judge;
use super::messages::Message;
use super::read::Answer;
use super::verdict::Verdict;

/// The parts of an impact, whose impulses are told apart as those of bodies are.
const PHASES: [&str; 2] = ["def", "rest"];

/// An answer that was read and is not right, with the position of its part.
pub(super) type NotRight<'a> = (usize, &'a Answer);

/// The parts that were exchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Exchanged {
    /// The values of two bodies.
    Bodies,
    /// Two components of one vector.
    Components,
}

impl Exchanged {
    pub(super) fn verdict(self) -> Verdict {
        match self {
            Self::Bodies => Verdict::BodiesSwapped,
            Self::Components => Verdict::ComponentsExchanged,
        }
    }

    pub(super) fn message(self) -> Message {
        match self {
            Self::Bodies => Message::BodiesSwapped,
            Self::Components => Message::ComponentsExchanged { of_contact: false },
        }
    }
}

/// The body in the name of a quantity, without its instant: `A` of `v_A2`. Of two instants or two phases there is none, and the mistake
/// has a diagnosis of its own.
fn body(id: &str) -> Option<&str> {
    let index = id.split_once('_')?.1;
    let index = index.split(['@', '[']).next().unwrap_or(index);
    let body = index.trim_end_matches(|last: char| last.is_ascii_digit() || last == '\'');
    (!body.is_empty() && !PHASES.contains(&body)).then_some(body)
}

/// The positions of answers that are right for each other's parts, and what was exchanged.
pub(super) fn find(expected: &[Expected], not_right: &[NotRight<'_>]) -> Vec<(usize, Exchanged)> {
    let is_right_for =
        |part: usize, answer: &Answer| expected.get(part).is_some_and(|part| judge(part, answer).verdict.is_right());
    let same_quantity = |one: usize, other: usize| {
        let stem = |part: usize| expected.get(part).and_then(|part| part.id.split_once('_')).map(|(stem, _)| stem);
        stem(one).is_some() && stem(one) == stem(other)
    };
    let vector = |part: usize| expected.get(part).and_then(|part| part.id.rsplit_once('.')).map(|(vector, _)| vector);
    let body = |part: usize| expected.get(part).and_then(|part| body(&part.id));
    let of = |one: usize, other: usize| {
        let is_one_vector = vector(one).is_some() && vector(one) == vector(other);
        let are_bodies = || body(one).is_some() && body(other).is_some() && body(one) != body(other);
        if is_one_vector { Some(Exchanged::Components) } else { are_bodies().then_some(Exchanged::Bodies) }
    };
    let mut exchanges = Vec::new();
    for (position, (one, answer)) in not_right.iter().enumerate() {
        for (other, theirs) in not_right.iter().skip(position + 1) {
            let exchanged = of(*one, *other).filter(|_| same_quantity(*one, *other));
            if let Some(exchanged) = exchanged.filter(|_| is_right_for(*other, answer) && is_right_for(*one, theirs)) {
                exchanges.extend([*one, *other].map(|place| (place, exchanged)));
            }
        }
    }
    exchanges
}
