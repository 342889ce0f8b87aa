//! A cache of what the worked solutions of a form have in common: worked out for the first variant, and used for the others.
//! Without it, a worked solution takes about three times as long (`docs/performance.md`).

use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::OnceLock;

use momentous_expr::Symbol;
use momentous_problem::PlannedForm;
use momentous_problem::Worked;

use super::Block;
use super::Detail;
use super::checking::checks::Checks;
use super::pictures::PictureCache;
use super::terms::display::Display;
use super::terms::manner::MannerCache;
use super::working::script;
use super::working::script::Script;

/// The kept parts of a form's solutions: one place for each way in which the scene can go.
pub(super) struct SolutionCache {
    ways: Vec<WayCache>,
}

/// One way. Nothing here depends on the numbers of a variant.
#[derive(Default)]
pub(super) struct WayCache {
    /// How each quantity is shown.
    pub manners: MannerCache,
    /// The section on the system.
    pub system: OnceLock<Vec<Block>>,
    /// The parts that its figures share.
    pub pictures: PictureCache,
    /// The sentences beneath the diagrams.
    pub acting: OnceLock<Vec<Block>>,
    /// The quantities that the answer needs.
    pub used: OnceLock<BTreeSet<Symbol>>,
    short_scripts: OnceLock<Vec<Script>>,
    full_scripts: OnceLock<Vec<Script>>,
    checks: OnceLock<Checks>,
}

impl WayCache {
    fn new(worked: Worked<'_>) -> Self {
        Self {
            manners: MannerCache::new(worked),
            pictures: PictureCache::new(&worked.problem.loaded().draft.scene),
            ..Self::default()
        }
    }
}

impl WayCache {
    /// The steps of the answer plan.
    pub(super) fn scripts(&self, display: Display<'_>, detail: Detail) -> &[Script] {
        let scripts = match detail {
            Detail::Short => &self.short_scripts,
            Detail::Full => &self.full_scripts,
        };
        scripts.get_or_init(|| script::scripts(display, detail))
    }

    /// The checks.
    pub(super) fn checks(&self, display: Display<'_>) -> &Checks {
        self.checks.get_or_init(|| Checks::new(display))
    }
}

impl SolutionCache {
    /// The kept parts of a form.
    pub(super) fn of(worked: Worked<'_>) -> Arc<Self> {
        let PlannedForm { cache, solver, .. } = worked.form;
        cache.get(|| Self { ways: solver.leaves().iter().map(|_| WayCache::new(worked)).collect() })
    }

    /// The kept parts of the way that a variant goes.
    pub(super) fn way(&self, worked: Worked<'_>) -> &WayCache {
        // There is always one, as there is of the ways themselves.
        self.ways.get(worked.variant.leaf()).unwrap_or(&self.ways[0])
    }
}
