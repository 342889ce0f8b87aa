//! How the quantities of a system are tied to each other, whatever their values: by the derivatives of all equations where all hold.

use std::collections::BTreeSet;

use momentous_expr::Symbol;

use super::super::System;
use super::super::structure::freedom::Freedom;
use super::super::structure::incidence::Structure;
use super::super::structure::sample::Samples;

/// At how many places equations are looked at: at one, some may say the same that say different things elsewhere.
const PLACES: u32 = 2;

/// The freedom that equations leave where no quantity is given.
#[derive(Clone, Debug)]
pub struct Ties {
    structure: Structure,
    places: Vec<Freedom>,
}

impl Ties {
    /// The ties of a system; without any where no place is found at which its equations hold.
    #[must_use]
    pub fn new(system: &System) -> Self {
        let structure = Structure::new(system, &BTreeSet::new());
        let places = (0..PLACES).filter_map(|starts| {
            let mut samples = Samples::from(starts);
            samples.hold(system, &structure).then(|| Freedom::new(system, &structure, &mut samples))
        });
        Self { places: places.collect(), structure }
    }

    /// Whether no place was found at which the equations hold, so that nothing is known of them.
    #[must_use]
    pub fn are_unknown(&self) -> bool {
        self.places.is_empty()
    }

    /// Whether a quantity has no freedom left where others are given, itself not counted.
    #[must_use]
    pub fn fix(&self, symbol: Symbol, given: &BTreeSet<Symbol>) -> bool {
        self.everywhere(symbol, given, true)
    }

    /// Whether it has some left.
    #[must_use]
    pub fn leave_open(&self, symbol: Symbol, given: &BTreeSet<Symbol>) -> bool {
        self.everywhere(symbol, given, false)
    }

    fn everywhere(&self, symbol: Symbol, given: &BTreeSet<Symbol>, is_fixed: bool) -> bool {
        let Some(column) = self.structure.column(symbol) else { return false };
        let others = given.iter().filter(|other| **other != symbol);
        let others: Vec<usize> = others.filter_map(|other| self.structure.column(*other)).collect();
        !self.places.is_empty() && self.places.iter().all(|freedom| freedom.fixes(column, &others) == is_fixed)
    }
}
