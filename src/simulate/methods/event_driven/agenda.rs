//! What will happen next: one prediction for each contact, in a tournament whose winner is the earliest. A new prediction
//! replaces the old one, so that nothing stale is ever met.

use std::cmp::Ordering;

use crate::simulate::contact::Contact;
use crate::simulate::exact::Clock;

use super::prediction::Predicted;

/// A contact that will be struck at a time, unless a party has another event first.
#[derive(Clone, Copy)]
pub(super) struct Event<const D: usize> {
    pub at: Clock,
    pub contact: Contact,
    pub predicted: Predicted<D>,
}

pub(super) struct Agenda<const D: usize> {
    contacts: Vec<Contact>,
    predicted: Vec<Option<Predicted<D>>>,
    /// When each contact is due, infinity for never; filled up to a power of two.
    due: Vec<Clock>,
    /// The earliest contact below each node: node 1 is the root, and `2 n` and `2 n + 1` are below `n`.
    winners: Vec<usize>,
}

impl<const D: usize> Agenda<D> {
    pub fn new(contacts: Vec<Contact>) -> Self {
        let leaves = contacts.len().next_power_of_two().max(2);
        let due = vec![Clock::at(f64::INFINITY); leaves];
        let mut winners = vec![0; leaves];
        for node in (1..leaves).rev() {
            let below = 2 * node;
            winners[node] = if below >= leaves { below - leaves } else { winners[below] };
        }
        Self { predicted: vec![None; contacts.len()], contacts, due, winners }
    }

    /// The contacts, by whose places the agenda is kept.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The next event.
    pub fn next(&self) -> Option<Event<D>> {
        let place = self.winners[1];
        let predicted = (*self.predicted.get(place)?)?;
        Some(Event { at: self.due[place], contact: self.contacts[place], predicted })
    }

    /// Sets the prediction of a contact, or that there is none.
    pub fn set(&mut self, place: usize, at: Clock, predicted: Option<Predicted<D>>) {
        self.predicted[place] = predicted;
        self.due[place] = if predicted.is_some() { at } else { Clock::at(f64::INFINITY) };
        let leaves = self.due.len();
        let mut node = usize::midpoint(leaves, place);
        while node >= 1 {
            let below = 2 * node;
            let (left, right) = if below >= leaves {
                (below - leaves, below + 1 - leaves)
            } else {
                (self.winners[below], self.winners[below + 1])
            };
            let winner = if self.due[right].order(self.due[left]) == Ordering::Less { right } else { left };
            if winner == self.winners[node] && winner != place {
                return;
            }
            self.winners[node] = winner;
            node /= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a search through all: 2000 changes of 13 contacts.
    #[test]
    fn the_winner_is_the_earliest() {
        let mut agenda = Agenda::<1>::new((0..13).map(Contact::Cord).collect());
        let mut due = [f64::INFINITY; 13];
        let mut word = 1_u64;
        for _ in 0..2000 {
            word = word.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let place = usize::try_from((word >> 33) % 13).unwrap();
            let time = f64::from(u32::try_from(word >> 40).unwrap());
            let none = word.is_multiple_of(5);
            due[place] = if none { f64::INFINITY } else { time };
            let predicted = (!none).then_some(Predicted { after: time, rate: None, normal: None });
            agenda.set(place, Clock::at(time), predicted);
            let earliest = due.iter().copied().fold(f64::INFINITY, f64::min);
            let found = agenda.next().map_or(f64::INFINITY, |event| event.at.seconds());
            assert!((found - earliest).abs() < 0.5 || found.is_infinite() && earliest.is_infinite());
        }
    }
}
