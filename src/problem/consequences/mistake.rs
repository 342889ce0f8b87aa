//! The common mistakes in one form of a problem, each as the program that makes it.

use std::sync::Arc;
use std::sync::OnceLock;

use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::reading::SlipOf;
use momentous_quantity::Unit;
use momentous_solve::Batch;

use super::solver::Solver;

/// The mistakes of a form, for each way in which its scene can go; empty until they are asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mistakes(pub(super) Arc<OnceLock<Vec<Planned>>>);

/// The mistakes of one way in which a scene can go, with the tape of all that are made straight on.
#[derive(Clone, Debug)]
pub(crate) struct Planned {
    pub(super) list: Vec<Mistake>,
    pub(crate) inputs: Vec<Symbol>,
    pub(super) batch: Batch,
    /// The quantities that are asked and whose sign is a direction.
    pub(super) directed: Vec<Symbol>,
}

/// One way of making one common mistake.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// The mistake.
    pub of: &'static Misconception,
    /// The law that is got wrong, as it is used: a position in [`momentous_model::Model::instances`]; none where nothing is
    /// wrong with the laws.
    pub instance: Option<usize>,
    /// In how many places the same is got wrong: one mistake is likelier than several.
    pub places: usize,
    pub(super) made: Made,
}

impl Mistake {
    /// Whether the laws are right and the data wrong: an answer tells such a mistake only if it agrees in every figure.
    #[must_use]
    pub fn is_of_data(&self) -> bool {
        match self.made {
            Made::Solved(_) => self.instance.is_none(),
            Made::OtherRoot(_) | Made::Misread(..) | Made::Taken(_) => true,
            Made::Written(..) => false,
        }
    }

    /// Whether it is no more than a guess where a verdict explains the answer: a given or the question is mistaken.
    #[must_use]
    pub fn yields(&self) -> bool {
        match self.made {
            Made::Solved(_) => self.instance.is_none(),
            Made::OtherRoot(_) | Made::Taken(_) => true,
            Made::Misread(..) | Made::Written(..) => false,
        }
    }

    /// Whether the right value is written down wrongly.
    #[must_use]
    pub fn is_written(&self) -> bool {
        matches!(self.made, Made::Written(..))
    }

    /// Whether the mistake is made in one answer, and leaves the others as they are.
    #[must_use]
    pub fn is_of_one_answer(&self) -> bool {
        match self.made {
            Made::Written(..) | Made::Taken(_) => true,
            Made::Solved(_) | Made::OtherRoot(_) | Made::Misread(..) => false,
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) enum Made {
    /// The system has a wrong equation.
    Solved(Vec<WrongSystem>),
    /// The laws and the data are right, and a root is taken that is not possible.
    OtherRoot(Arc<Solver>),
    /// A unit of some givens is misread.
    Misread(Misread),
    /// The value of another quantity is written down: what is asked, and what is taken for it.
    Taken(Vec<(Symbol, Symbol)>),
    /// The right value is written down wrongly.
    Written(SlipOf, fn(f64) -> f64),
}

/// Givens that are taken too large or too small, since one unit is read for another.
#[derive(Clone, Debug)]
pub(crate) struct Misread {
    /// The right program.
    pub(super) right: Arc<Solver>,
    /// By which factor each is too large.
    pub(super) read: Vec<(Symbol, f64)>,
    /// The unit in which they are given, and how many of it the other one is: whoever overlooks it in a given does not convert an
    /// answer to it.
    pub(super) unit: (Unit, f64),
    /// The place in the batch, where it is in there.
    pub(super) batched: Option<usize>,
}

/// How the values that come of a mistake are found.
#[derive(Clone, Debug)]
pub(crate) struct WrongSystem {
    pub(crate) solver: Solver,
    /// The place in the batch, where there is nothing to choose and nothing to judge.
    pub(super) batched: Option<usize>,
}
