//! A system cut down to some of its equations: those that a solution uses.

use std::collections::BTreeSet;

use momentous_solve::System;

/// Some equations of a system, with all its conditions.
#[derive(Clone, Debug)]
pub(super) struct Restricted {
    /// The smaller system.
    pub system: System,
    /// The positions of its equations in the larger one.
    pub places: Vec<usize>,
}

impl Restricted {
    pub(crate) fn new(system: &System, kept: impl IntoIterator<Item = usize>) -> Self {
        let places: Vec<usize> = kept.into_iter().collect::<BTreeSet<_>>().into_iter().collect();
        let equations = places.iter().filter_map(|place| system.equations.get(*place).cloned()).collect();
        Self { system: system.with(equations), places }
    }
}
