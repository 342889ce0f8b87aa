//! Numbers with which the scene could go in another way as well: the conditions of the ways do not tell them apart.

use momentous_expr::Symbol;
use momentous_solve::Bounded;

use super::other_way::Rival;
use super::sampler::Sampler;

/// The share of a value within which another is the same: a time found by search has no better bound.
const SAME: f64 = 1e-9;

impl Sampler<'_> {
    /// A way that rivals the one that was taken last.
    pub(super) fn find_rival(&mut self) -> Option<Rival> {
        let others = self.scratch.others(&self.form.solver, &self.inputs, &self.domains);
        let taken = self.scratch.leaf();
        let found = self.asked_in_all();
        let rival = others.into_iter().find_map(|other| {
            self.scratch.turn_to(other);
            let solutions =
                (0..self.scratch.survivors(&self.form.solver)).filter(|place| self.way_back(*place).is_none());
            let values = solutions.map(|place| self.asked_in(place)).find(|values| !is_among(values, &found))?;
            let [here, there] = [taken, other].map(|leaf| &self.form.solver.leaf(leaf).words);
            let unlike = |one: &[String], other: &[String]| {
                let words = one.iter().zip(other).filter(|(word, other)| word != other).map(|(word, _)| word.as_str());
                words.collect::<Vec<_>>().join(", and ")
            };
            let words = [unlike(here, there), unlike(there, here)];
            Some(Rival { words, values })
        });
        self.scratch.turn_to(taken);
        rival
    }

    fn asked_in_all(&self) -> Vec<Vec<(Symbol, Bounded)>> {
        (0..self.scratch.survivors(&self.form.solver)).map(|place| self.asked_in(place)).collect()
    }

    /// What is asked, as far as it is found, in the solution at that position.
    fn asked_in(&self, solution: usize) -> Vec<(Symbol, Bounded)> {
        let value = |symbol| Some((symbol, self.scratch.value_in(&self.form.solver, solution, symbol)?));
        self.form.wanted().filter_map(value).collect()
    }
}

/// Whether values are those of one of the solutions, as far as both find them.
fn is_among(values: &[(Symbol, Bounded)], solutions: &[Vec<(Symbol, Bounded)>]) -> bool {
    let agree = |one: &Bounded, other: &Bounded| {
        let size = one.value.abs().max(other.value.abs());
        (one.value - other.value).abs() <= one.error + other.error + SAME * size
    };
    solutions.iter().any(|solution| {
        values.iter().all(|(symbol, value)| {
            let other = solution.iter().find(|(listed, _)| listed == symbol);
            other.is_none_or(|(_, other)| agree(value, other))
        })
    })
}
