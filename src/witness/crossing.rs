//! Ends of a simulated stage that could end several times: the problem's own conditions say at which crossing.

use std::cell::Cell;

use momentous_problem::split_relation;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::Observed;
use momentous_simulate::scene::observe_at;
use momentous_simulate::scene::value_of;
use momentous_solve::Relation;

use super::simulation::Measurement;
use super::simulation::Witness;

/// The crossings that are tried after the first.
const MOST_LATER: usize = 3;

/// Whether two values compare as is said; none where they differ by no more than they may be off.
pub(super) fn holds(relation: Relation, left: Measurement, right: Measurement) -> Option<bool> {
    let apart = left.value - right.value;
    let is_decided = apart.abs() > left.error + right.error;
    is_decided.then_some(match relation {
        Relation::Less | Relation::AtMost => apart < 0.0,
        Relation::Greater | Relation::AtLeast => apart > 0.0,
        Relation::Differs => true,
        Relation::Equals => false,
    })
}

impl Witness<'_> {
    /// Simulates a stage up to the first crossing of its end at which it breaks no condition of the problem.
    pub(super) fn observed(&self, stage: usize) -> Result<Observed, NothingToSimulate> {
        let at = |crossing| observe_at(self.scene(), stage, &|name| self.value(name), self.tolerance(), crossing);
        let first = at(0)?;
        if !self.breaks(&first) {
            return Ok(first);
        }
        let later = (1..=MOST_LATER).map_while(|crossing| at(crossing).ok()).find(|later| !self.breaks(later));
        Ok(later.unwrap_or(first))
    }

    /// Whether what a stage came to breaks a condition by which the author picks among solutions.
    fn breaks(&self, observed: &Observed) -> bool {
        self.conditions().any(|text| {
            let Some((left, relation, right)) = split_relation(text) else { return false };
            let (reached, error) = (Cell::new(false), Cell::new(0.0));
            let value = |name: &str| {
                let name = self.since(name);
                let Some(reached_here) = observed.found.iter().find(|reached| reached.name == name) else {
                    return self.value(&name);
                };
                reached.set(true);
                error.set(error.get() + reached_here.error);
                Some(reached_here.value)
            };
            let [left, right] = [left, right].map(|side| value_of(self.scene(), side, &value));
            let (Some(left), Some(right)) = (left, right) else { return false };
            let [left, right] = [(left, error.get()), (right, 0.0)].map(|(value, error)| Measurement { value, error });
            reached.get() && holds(relation, left, right) == Some(false)
        })
    }
}
