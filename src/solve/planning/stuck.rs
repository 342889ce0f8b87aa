//! Why a plan cannot be made, as a value.

use std::collections::BTreeSet;

use momentous_expr::Symbol;

use super::super::structure::bits::Bits;
use super::super::structure::freedom::Freedom;
use super::super::structure::incidence::Structure;

/// A plan that got stuck: the known symbols, those that remain, and the obstacle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stuck {
    /// Everything that was known at the start.
    pub known: BTreeSet<Symbol>,
    /// The symbols wanted and not found, in the order in which they were asked for.
    pub remaining: Vec<Symbol>,
    /// The obstacle.
    pub reason: Reason,
}

/// An obstacle to a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The equations do not determine everything that is wanted.
    Underdetermined {
        /// The symbols that do not follow.
        wanted: Vec<Symbol>,
        /// Sets of further symbols, the smallest that would do, any one of which would be enough; empty where none is small.
        enough: Vec<Vec<Symbol>>,
    },
    /// There are as many equations as unknowns, and no tactic closes them.
    NoTactic {
        /// Positions of the equations in the system.
        equations: Vec<usize>,
        /// Their unknowns.
        unknowns: Vec<Symbol>,
    },
    /// An equation that can never hold: its unknowns drop out, and its sides differ.
    Contradiction {
        /// Positions of the equations that it follows from.
        equations: Vec<usize>,
    },
}

/// At most this many unknowns are tried in pairs.
const PAIRS: usize = 40;

/// The smallest sets of further symbols, of one or two, each of which would determine all `wanted` columns.
/// The wanted symbols themselves are left out: to be told to give the answer helps nobody.
pub(super) fn enough(structure: &Structure, freedom: &Freedom, wanted: &Bits) -> Vec<Vec<Symbol>> {
    let columns: Vec<usize> = (0..structure.unknowns.len()).filter(|column| !wanted.contains(*column)).collect();
    let serves = |given: &[usize]| {
        let known = Bits::of(structure.unknowns.len(), given.iter().copied());
        // Of equations that say the same twice, counting believes that they give what they leave open.
        let is_open = |rows: Vec<usize>| structure.columns(&rows).iter().any(|column| !freedom.fixes(column, given));
        wanted.iter().all(|column| freedom.fixes(column, given))
            && structure.determined(&known).covers(wanted)
            && !structure.sufficient(wanted, &known, &Bits::empty(structure.rows.len())).is_some_and(is_open)
    };
    let names = |given: &[usize]| given.iter().map(|column| structure.unknowns[*column]).collect::<Vec<_>>();
    let singles: Vec<_> = columns.iter().filter(|column| serves(&[**column])).map(|column| names(&[*column])).collect();
    if !singles.is_empty() || columns.len() > PAIRS {
        return singles;
    }
    let pairs = columns
        .iter()
        .enumerate()
        .flat_map(|(place, first)| columns.iter().skip(place + 1).map(move |second| [*first, *second]));
    pairs.filter(|pair| serves(pair)).map(|pair| names(&pair)).collect()
}
