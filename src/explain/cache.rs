//! A cache of what the worked solutions of a form have in common: worked out for the first variant, and used for the others.
//! Without it, a worked solution takes about three times as long (`docs/performance.md`).

use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::OnceLock;

use crate::expr::Math;
use crate::expr::Symbol;
use crate::problem::PlannedForm;
use crate::problem::Worked;
use crate::scene::Senses;

use super::Block;
use super::checks::Checks;
use super::letters::Letters;
use super::pictures::Compass;
use super::pictures::Plan;
use super::script::Script;
use super::term::Measured;

/// What is kept of a form: one place for each way in which the scene can go.
pub(super) struct SolutionCache {
    ways: Vec<WayCache>,
    /// Where the directions of the scene point on drawings.
    compass: OnceLock<Compass>,
}

/// One way. Nothing here depends on the numbers of a variant.
#[derive(Default)]
pub(super) struct WayCache {
    /// What is shown in letters that the sheet leaves open.
    pub letters: OnceLock<Letters>,
    /// How each quantity is shown.
    pub manners: Vec<OnceLock<Manner>>,
    /// The section on the system.
    pub system: OnceLock<Vec<Block>>,
    /// The diagram of momenta and impulses of each stage.
    pub diagrams: Vec<OnceLock<Plan>>,
    /// The sentences beneath the diagrams.
    pub acting: OnceLock<Vec<Block>>,
    /// The quantities that the answer needs.
    pub used: OnceLock<BTreeSet<Symbol>>,
    /// The steps of the answer plan.
    pub laws: OnceLock<Vec<Script>>,
    /// The checks.
    pub checks: OnceLock<Checks>,
}

impl WayCache {
    fn new(worked: Worked<'_>) -> Self {
        let symbols = worked.problem.model().symbols.len();
        let stages = worked.problem.loaded().draft.scene.stages.len();
        Self {
            manners: (0..symbols).map(|_| OnceLock::new()).collect(),
            diagrams: (0..stages).map(|_| OnceLock::new()).collect(),
            ..Self::default()
        }
    }
}

/// How a quantity is shown, whatever its value.
pub(super) struct Manner {
    /// The unit in which explanations compute with it.
    pub measured: Measured,
    /// Its name; nothing for a number that the author wrote into a term.
    pub name: Option<Math>,
    /// The words for the two directions between which its sign decides.
    pub senses: Option<Senses>,
    /// The quantity that it always equals, and whether with the other sign.
    pub equals: Option<(Symbol, bool)>,
    /// The plain fraction that it always is.
    pub constant: Option<Math>,
    /// Whether it is found by counting.
    pub is_whole: bool,
}

impl SolutionCache {
    /// What is kept of a form.
    pub(super) fn of(worked: Worked<'_>) -> Arc<Self> {
        let PlannedForm { cache, solver, .. } = worked.form;
        cache.get(|| Self {
            ways: solver.leaves().iter().map(|_| WayCache::new(worked)).collect(),
            compass: OnceLock::new(),
        })
    }

    /// Where the directions of the scene point on drawings.
    pub(super) fn compass(&self, worked: Worked<'_>) -> &Compass {
        self.compass.get_or_init(|| Compass::of(&worked.problem.loaded().draft.scene))
    }

    /// What is kept of the way that a variant goes.
    pub(super) fn way(&self, worked: Worked<'_>) -> &WayCache {
        // There is always one, as there is of the ways themselves.
        self.ways.get(worked.variant.leaf()).unwrap_or(&self.ways[0])
    }
}
