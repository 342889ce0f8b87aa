//! An agenda of the next impacts: one prediction for each contact, in a tournament whose winner is the earliest. A new prediction
//! replaces the old one, so that nothing stale is ever met.

use crate::contact::Contact;
use crate::exact::Clock;

use super::prediction::Predicted;

/// A contact that will be struck at a time, unless a party has another event first.
#[derive(Clone, Copy)]
pub(super) struct Event<const D: usize> {
    pub at: Clock,
    pub contact: Contact,
    pub predicted: Predicted<D>,
}

/// A contact by its place, and when it is due: infinity for never.
#[derive(Clone, Copy)]
struct Due {
    at: Clock,
    place: usize,
}

impl Due {
    /// The earlier of two; of two at one time the one that is asked.
    #[inline]
    fn unless_after(self, other: Self) -> Self {
        if other.at.is_before(self.at) { other } else { self }
    }
}

pub(super) struct Agenda<const D: usize> {
    contacts: Vec<Contact>,
    predicted: Vec<Option<Predicted<D>>>,
    /// The earliest contact below each node: node 1 is the root, `2 n` and `2 n + 1` are below `n`, and the last half, filled up to
    /// a power of two, are the contacts themselves.
    earliest: Vec<Due>,
    /// The nodes whose contacts changed since the last game.
    changed: Vec<usize>,
}

impl<const D: usize> Agenda<D> {
    pub fn new(contacts: Vec<Contact>) -> Self {
        let leaves = contacts.len().next_power_of_two().max(2);
        let never = Clock::at(f64::INFINITY);
        let mut earliest = vec![Due { at: never, place: 0 }; 2 * leaves];
        for (place, leaf) in earliest[leaves..].iter_mut().enumerate() {
            leaf.place = place;
        }
        for node in (1..leaves).rev() {
            earliest[node] = earliest[2 * node];
        }
        Self { predicted: vec![None; contacts.len()], contacts, earliest, changed: Vec::new() }
    }

    /// The contacts, by whose places the agenda is kept.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The next event.
    pub fn next(&mut self) -> Option<Event<D>> {
        self.play();
        let Due { at, place } = self.earliest[1];
        let predicted = (*self.predicted.get(place)?)?;
        Some(Event { at, contact: self.contacts[place], predicted })
    }

    /// Sets the prediction of a contact, or that there is none.
    pub fn set(&mut self, place: usize, at: Clock, predicted: Option<Predicted<D>>) {
        let at = if predicted.is_some() { at } else { Clock::at(f64::INFINITY) };
        self.predicted[place] = predicted;
        let leaf = self.earliest.len() / 2 + place;
        self.earliest[leaf].at = at;
        self.changed.push(leaf);
    }

    /// Plays what the changes decide anew, round by round: what an impact changes stands close together, and soon shares its games.
    fn play(&mut self) {
        self.changed.sort_unstable();
        while self.changed.first().is_some_and(|node| *node > 1) {
            let mut played = 0;
            for place in 0..self.changed.len() {
                let node = self.changed[place] / 2;
                if played == 0 || self.changed[played - 1] != node {
                    self.earliest[node] = self.earliest[2 * node].unless_after(self.earliest[2 * node + 1]);
                    self.changed[played] = node;
                    played += 1;
                }
            }
            self.changed.truncate(played);
        }
        self.changed.clear();
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
