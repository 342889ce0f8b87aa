//! Choices between phrases: what settles each kind of choice, and what it depends on.

use std::collections::BTreeSet;

use momentous_expr::Symbol;

use super::super::pictures::pictured::Pictured;
use super::claim::Claim;
use super::decision::Decision;
use super::judgement::Judgement;
use super::offered::Offer;

/// A choice between phrases.
#[derive(Clone, Debug)]
pub enum ChoicePart {
    /// The scene settles it, whatever the numbers.
    Settled(Decision),
    /// Whether quantities are equal settles it: what is conserved, and of which kind an impact is.
    Judged(Box<Judgement>),
    /// Whether something holds of the numbers: yes or no.
    Holds(Claim),
    /// In which order some quantities are, the least first.
    Order(Vec<Symbol>),
    /// Which of the roots for a quantity is possible.
    Physical(Symbol),
    /// Which of the author's own options is right.
    Offered(Box<Offer>),
    /// Which of several pictures is right.
    Pictured(Box<Pictured>),
}

/// The most quantities that can be put in order: they have 24 orders.
pub(crate) const MOST_ORDERED: usize = 4;

impl ChoicePart {
    /// Everything on which the choice depends, what is given included.
    #[must_use]
    pub fn depends_on(&self) -> BTreeSet<Symbol> {
        match self {
            Self::Settled(_) => BTreeSet::new(),
            Self::Judged(choice) => choice.symbols(),
            Self::Holds(claim) => claim.symbols(),
            Self::Order(symbols) => symbols.iter().copied().collect(),
            Self::Physical(symbol) => BTreeSet::from([*symbol]),
            Self::Offered(offer) => offer.symbols(),
            Self::Pictured(pictured) => pictured.subject.symbols(),
        }
    }

    /// Everything to which the choice refers.
    #[must_use]
    pub fn mentioned(&self) -> BTreeSet<Symbol> {
        if let Self::Offered(offer) = self { offer.mentioned() } else { self.depends_on() }
    }

    /// The quantities that have to be solved for the choice.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        match self {
            Self::Settled(_) => Vec::new(),
            Self::Judged(choice) => choice.quantities(),
            Self::Holds(claim) => claim.quantities.clone(),
            Self::Order(symbols) => symbols.clone(),
            Self::Physical(symbol) => vec![*symbol],
            Self::Offered(offer) => offer.quantities(),
            Self::Pictured(pictured) => pictured.quantities.clone(),
        }
    }
}

/// Every order of some quantities.
#[must_use]
pub fn orders(symbols: &[Symbol]) -> Vec<Vec<Symbol>> {
    let mut orders = Vec::new();
    permute(symbols.to_vec(), 0, &mut orders);
    orders
}

fn permute(symbols: Vec<Symbol>, from: usize, all: &mut Vec<Vec<Symbol>>) {
    if from + 1 >= symbols.len() {
        all.push(symbols);
        return;
    }
    for other in from..symbols.len() {
        let mut next = symbols.clone();
        // Turned rather than swapped, so that the orders come as in a dictionary.
        next[from..=other].rotate_right(1);
        permute(next, from + 1, all);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentous_expr::{SymbolEntry, SymbolTable};
    use momentous_quantity::Dimension;

    #[test]
    fn every_order_comes_once_as_in_a_dictionary() {
        let mut table = SymbolTable::default();
        let entry = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
        let symbols = ["a", "b", "c"].map(|name| table.intern(entry(name)));
        let places = |order: Vec<Symbol>| order.iter().map(|symbol| symbol.index()).collect::<Vec<_>>();
        let all: Vec<Vec<usize>> = orders(&symbols).into_iter().map(places).collect();
        assert_eq!(all, [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]]);
    }
}
