//! How the unknowns are found: equations, reasons and moves of algebra, with the numbers of a variant.

mod bracket;
pub(super) mod counting;
pub(super) mod derivation;
pub(super) mod divisors;
mod isolate;
pub(super) mod naming;
pub(super) mod needed;
pub(super) mod on_paper;
pub(super) mod quadratic;
pub(super) mod script;
pub(super) mod sentence;
pub(super) mod short;
pub(super) mod steps;
