//! How quantities, numbers and terms are shown, and to how many figures.

pub(super) mod algebra;
pub(super) mod display;
pub(super) mod entry;
pub(super) mod ledger;
pub(super) mod letters;
pub(super) mod manner;
pub(super) mod numbers;
pub(super) mod printed;
pub(super) mod substitution;
pub(super) mod term;
