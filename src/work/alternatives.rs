//! Lines with alternatives, `v = 3 or v = 5`, `v = ± 3`: each of them has to be a solution.

use momentous_expr::Symbol;
use momentous_solve::Bounded;
use momentous_solve::System;

use super::found::LineFinding;
use super::ground::Place;
use super::holds::{At, Holds, RESULT};
use super::judge::Judge;
use super::meaning::Meanings;
use super::verdict::Verdict;
use super::way::{Values, Way};
use super::written::{Statement, Written};

/// What is said of alternatives of which one is no solution.
const NOT_ALL: &str = "Does not follow: one of the alternatives is no solution. Which one is meant?";

impl Judge<'_> {
    /// The finding on a line of whose alternatives one holds, and another neither holds nor is a root of the scene's equations. The two signs
    /// before a root in letters are those of an equation that was squared.
    pub(crate) fn with_false_alternative(
        &self,
        line: &Written,
        place: Place<'_>,
        sets: &[Meanings],
    ) -> Option<LineFinding> {
        if line.is_of_root && line.is_in_letters() || line.stated.iter().all(|alternatives| alternatives.len() < 2) {
            return None;
        }
        let roots = self.roots(line, place);
        let mut each = line.stated.iter().filter(|alternatives| alternatives.len() > 1).flatten();
        let is_solution = |chain: &Vec<Statement>| {
            sets.iter().any(|set| {
                let holds = |value: &dyn Fn(Symbol) -> Option<Bounded>| {
                    let at = At { value, units: self.units, turned: &self.turned, share: RESULT };
                    at.chain(line, chain, set) != Holds::No
                };
                holds(&|symbol| place.value(symbol))
                    || roots
                        .iter()
                        .any(|root| holds(&|symbol| root.get(&symbol).copied().or_else(|| place.value(symbol))))
            })
        };
        let are_all = each.all(is_solution);
        (!are_all).then(|| LineFinding::of(Verdict::DoesNotFollow).because(NOT_ALL.to_owned()))
    }

    /// The roots of the scene's equations for the quantities of a line, those that are impossible included.
    fn roots(&self, line: &Written, place: Place<'_>) -> Vec<Values> {
        let system = System { conditions: Vec::new(), ..self.ground.system.clone() };
        let told = &self.ground.told;
        let wanted: Vec<Symbol> = line.quantities().difference(told).copied().collect();
        let way = Way::new(&system, told, &wanted);
        way.map_or_else(Vec::new, |way| way.solve(&|symbol| place.value(symbol)))
    }
}
