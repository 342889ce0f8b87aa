//! Values of two bodies, or of two components, exchanged: each answer is right, for the other.

use super::expected::Expected;
use super::judge::judge;
use super::messages::Message;
use super::read::Answer;
use super::verdict::Verdict;

/// An answer that was read and is not right, with the position of its part.
pub(super) type NotRight<'a> = (usize, &'a Answer);

/// What was exchanged.
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

/// The positions of answers that are right for each other's parts, and what was exchanged.
pub(super) fn find(expected: &[Expected], not_right: &[NotRight<'_>]) -> Vec<(usize, Exchanged)> {
    let is_right_for =
        |part: usize, answer: &Answer| expected.get(part).is_some_and(|part| judge(part, answer).verdict.is_right());
    let same_quantity = |one: usize, other: usize| {
        let stem = |part: usize| expected.get(part).and_then(|part| part.id.split_once('_')).map(|(stem, _)| stem);
        stem(one).is_some() && stem(one) == stem(other)
    };
    let vector = |part: usize| expected.get(part).and_then(|part| part.id.rsplit_once('.')).map(|(vector, _)| vector);
    let of = |one: usize, other: usize| {
        let is_one_vector = vector(one).is_some() && vector(one) == vector(other);
        if is_one_vector { Exchanged::Components } else { Exchanged::Bodies }
    };
    let mut found = Vec::new();
    for (position, (one, answer)) in not_right.iter().enumerate() {
        for (other, theirs) in not_right.iter().skip(position + 1) {
            if same_quantity(*one, *other) && is_right_for(*other, answer) && is_right_for(*one, theirs) {
                found.extend([*one, *other].map(|place| (place, of(*one, *other))));
            }
        }
    }
    found
}
