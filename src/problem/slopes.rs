//! How the answers of a form depend on the values on the way to them: derived once for a form, evaluated for each variant.

use std::sync::Arc;
use std::sync::OnceLock;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::solve::Closed;

use super::planned::Form;
use super::regimes::Leaf;

/// The slopes of one way in which a scene can go, by step and root.
type OfLeaf = Vec<Vec<Vec<Slope>>>;

/// The slopes of every value in every way in which a form's scene can go; empty until they are asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Slopes(Arc<OnceLock<Vec<OfLeaf>>>);

/// A value of a step, with its derivative with respect to each value that it is made from.
#[derive(Clone, Debug)]
pub(super) struct Slope {
    pub(super) unknown: Symbol,
    pub(super) partials: Vec<(Symbol, Expr)>,
}

impl Slopes {
    /// Those of one way, by step and root.
    pub(super) fn of_leaf(&self, form: &Form, leaf: usize) -> &[Vec<Vec<Slope>>] {
        let all = self.0.get_or_init(|| form.solver.leaves().iter().map(derived).collect());
        all.get(leaf).map_or(&[], Vec::as_slice)
    }
}

fn derived(leaf: &Leaf) -> OfLeaf {
    let steps = leaf.answer_steps().iter();
    steps.map(|step| step.roots.iter().map(|root| root.values.iter().map(slope).collect()).collect()).collect()
}

fn slope((unknown, closed): &(Symbol, Closed)) -> Slope {
    let partials = match closed {
        Closed::Formula(formula) => {
            formula.symbols().into_iter().map(|symbol| (symbol, formula.differentiate(symbol))).collect()
        }
        Closed::FirstInteger { .. } | Closed::BracketedRoot { .. } => Vec::new(),
    };
    Slope { unknown: *unknown, partials }
}
