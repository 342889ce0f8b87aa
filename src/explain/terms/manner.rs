//! How each quantity is shown, whatever its value: worked out once for all variants that go the same way.

use std::sync::OnceLock;

use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_problem::Worked;
use momentous_scene::Senses;

use super::letters::Letters;
use super::term::Measured;

/// How the quantities of one way are shown.
#[derive(Default)]
pub(crate) struct MannerCache {
    letters: OnceLock<Letters>,
    /// One for each symbol of the model.
    each: Vec<OnceLock<Manner>>,
}

/// How a quantity is shown, whatever its value.
pub(crate) struct Manner {
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

impl MannerCache {
    pub(crate) fn new(worked: Worked<'_>) -> Self {
        let symbols = worked.problem.model().symbols.len();
        Self { letters: OnceLock::new(), each: (0..symbols).map(|_| OnceLock::new()).collect() }
    }

    /// The quantities that are shown in letters that the sheet leaves open.
    pub(super) fn letters(&self, worked: Worked<'_>) -> &Letters {
        self.letters.get_or_init(|| Letters::of(worked))
    }

    /// How a quantity is shown.
    pub(crate) fn of(&self, symbol: Symbol, find: impl FnOnce() -> Manner) -> &Manner {
        self.each[symbol.index()].get_or_init(find)
    }
}
