//! The ways in which a form's answers follow from earlier ones.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::RwLock;

use momentous_expr::Symbol;
use momentous_laws::Law;
use momentous_model::Reason;
use momentous_solve::Program;

use super::solver::Solver;

/// The ways in which a form's answers follow from each other, as far as somebody has asked: by the way the scene goes, the
/// quantity that is asked, and the earlier quantities that are known.
#[derive(Clone, Debug, Default)]
pub(crate) struct Followings(pub(super) Arc<RwLock<BTreeMap<Key, Arc<[Following]>>>>);

type Key = (usize, Symbol, BTreeSet<Symbol>);

/// One way in which an answer follows from earlier ones.
#[derive(Clone, Debug)]
pub struct Following {
    /// The laws that the answer then satisfies together with the earlier ones.
    pub by: Vec<&'static Law>,
    /// Whether what comes before an earlier answer is found from it, so that it need not be wrong in itself.
    pub(super) backwards: bool,
    pub(super) solver: Solver,
    /// Judges whether the values can be, with what each condition that it judges by says where it is broken.
    pub(super) judge: Option<(Program, Vec<Reason>)>,
}
