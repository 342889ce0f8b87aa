//! The subject of a simulation: a variant, and what is put in place of its values.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_scene::Scene;

/// The variant of a problem, and the values that are put in place of its own.
pub(super) struct Case<'a> {
    pub problem: &'a Problem,
    pub scene: &'a Scene,
    pub variant: &'a Variant,
    /// Values that take the place of the variant's.
    pub replaced: Vec<(Symbol, f64)>,
    /// The only quantities of which the variant's own values are used; every one, where none are named.
    pub known: Option<&'a BTreeSet<Symbol>>,
}
