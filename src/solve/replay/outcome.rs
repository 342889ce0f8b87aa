//! The outcome of a replay.

use momentous_expr::Symbol;

use super::super::Program;
use super::workspace::{Death, Workspace};

/// The solutions of one variant, and why other branches are none. It reads the workspace of its replay.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<'a, R> {
    pub(crate) program: &'a Program,
    pub(crate) workspace: &'a Workspace<R>,
    pub(crate) exact: bool,
}

impl<'a, R> Outcome<'a, R> {
    /// The number of distinct solutions: none, one, or too many.
    #[must_use]
    pub fn survivors(&self) -> usize {
        self.workspace.survivors
    }

    /// Whether every condition was decided, rather than taken as satisfied since its two sides agree within their error.
    #[must_use]
    pub fn is_decided(&self) -> bool {
        self.workspace.decided
    }

    /// Whether the values come from exact or long arithmetic.
    #[must_use]
    pub fn is_exact_replay(&self) -> bool {
        self.exact
    }

    /// The value of a symbol in the (first) solution, in base units.
    #[must_use]
    pub fn value(&self, symbol: Symbol) -> Option<&'a R> {
        let register = self.program.register(symbol)?;
        if self.workspace.survivors == 0 { None } else { self.workspace.chosen.get(register as usize) }
    }

    /// The value of a symbol in the solution at that position, the first being 0.
    #[must_use]
    pub fn value_in(&self, position: usize, symbol: Symbol) -> Option<&'a R> {
        let Some(other) = position.checked_sub(1) else { return self.value(symbol) };
        self.workspace.others.get(other)?.get(self.program.register(symbol)? as usize)
    }

    /// The values of all symbols in the (first) solution.
    pub fn values(&self) -> impl Iterator<Item = (Symbol, &'a R)> {
        let chosen = self.workspace.chosen.as_slice();
        let values = self.program.symbols.iter().filter(|_| self.workspace.survivors > 0);
        values.filter_map(|(symbol, register)| Some((*symbol, chosen.get(*register as usize)?)))
    }

    /// The value of a symbol in each further solution.
    pub fn other_values(&self, symbol: Symbol) -> impl Iterator<Item = &'a R> {
        let register = self.program.register(symbol);
        self.workspace.others.iter().filter_map(move |values| values.get(register? as usize))
    }

    /// The root taken at each step of the plan in the (first) solution.
    #[must_use]
    pub fn choices(&self) -> &'a [usize] {
        self.workspace.choices.get(1..).unwrap_or_default()
    }

    /// The branches that died, in the order in which they were followed.
    #[must_use]
    pub fn dead(&self) -> &'a [Death] {
        &self.workspace.deaths
    }

    /// The values of the unknowns of the step at which the branch died, in the step's order.
    #[must_use]
    pub fn values_at_death(&self, death: &Death) -> &'a [R] {
        self.workspace.death_values.get(death.values.0..death.values.1).unwrap_or_default()
    }

    /// The root taken at each step up to the one at which the branch died, that one included.
    #[must_use]
    pub fn choices_at_death(&self, death: &Death) -> &'a [usize] {
        let path = self.workspace.death_paths.get(death.path.0..death.path.1).unwrap_or_default();
        path.get(1..).unwrap_or_default()
    }
}
