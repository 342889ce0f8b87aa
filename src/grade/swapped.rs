//! Values of two bodies exchanged: each answer is right, for the other.

use super::expected::Expected;
use super::judge::judge;
use super::read::Answer;

/// An answer that was read and is not right, with the position of its part.
pub(super) type NotRight<'a> = (usize, &'a Answer);

/// The positions of answers that are right for each other's parts.
pub(super) fn find(expected: &[Expected], not_right: &[NotRight<'_>]) -> Vec<usize> {
    let is_right_for =
        |part: usize, answer: &Answer| expected.get(part).is_some_and(|part| judge(part, answer).verdict.is_right());
    let same_quantity = |one: usize, other: usize| {
        let stem = |part: usize| expected.get(part).and_then(|part| part.id.split_once('_')).map(|(stem, _)| stem);
        stem(one).is_some() && stem(one) == stem(other)
    };
    let mut found = Vec::new();
    for (position, (one, answer)) in not_right.iter().enumerate() {
        for (other, theirs) in not_right.iter().skip(position + 1) {
            if same_quantity(*one, *other) && is_right_for(*other, answer) && is_right_for(*one, theirs) {
                found.extend([*one, *other]);
            }
        }
    }
    found
}
