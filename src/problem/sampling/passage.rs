//! Whether bodies get to the end of their ways, where forces on them depend on the place: energy alone does not tell.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Passage;
use momentous_model::Reason;

use super::sampler::Sampler;

/// The equal parts of a way, at whose ends its kinetic energy is looked at.
const PARTS: u32 = 64;

/// The equal parts at whose ends it is looked at first: where none of it would be left, most ways show it there.
const FIRST: u32 = 8;

/// The share of a way just behind its start and before its end, where the energy may have turned already.
const EDGE: f64 = 1e-6;

/// The share of the largest energy on the way below which there is none.
const NONE: f64 = 1e-9;

/// The share of the largest energy above which a body moves for certain.
const MOVES: f64 = 1e-3;

/// The number of times that the place of a least energy is narrowed down.
const NARROWED: usize = 40;

impl Sampler<'_> {
    /// Why a body does not get to the end of its way with the numbers solved last.
    pub(super) fn turned_back(&self) -> Option<&Reason> {
        self.problem.model().passages.get(self.way_back(0)?).map(|passage| &passage.reason)
    }

    /// Of several solutions, rules out those in which a body does not get to the end of its way, unless it does in none.
    pub(super) fn rule_out_ways_back(&mut self) {
        let solutions = self.scratch.survivors(&self.form.solver);
        if solutions > 1 {
            let reasons: Vec<Option<usize>> = (0..solutions).map(|solution| self.way_back(solution)).collect();
            self.scratch.rule_out(&self.form.solver, &reasons);
        }
    }

    /// The position of the first way to whose end a body does not get in a solution.
    pub(super) fn way_back(&self, solution: usize) -> Option<usize> {
        let words = &self.form.solver.leaf(self.scratch.leaf()).words;
        let is_allowed = |reason: &Reason| reason.warning().is_some_and(|warning| self.form.allowed.contains(&warning));
        let is_taken =
            |passage: &&Passage| passage.way.as_ref().is_none_or(|(choice, what)| words.get(*choice) == Some(what));
        let turns_back = |passage: &Passage| {
            is_taken(&passage) && !is_allowed(&passage.reason) && self.turns_back(passage, solution)
        };
        self.problem.model().passages.iter().position(turns_back)
    }

    /// Whether there is none of the kinetic energy left before the end; not where what it follows from is not solved.
    fn turns_back(&self, passage: &Passage, solution: usize) -> bool {
        let mut symbols = passage.kinetic.symbols();
        symbols.extend(passage.ends.iter().flat_map(Expr::symbols));
        symbols.remove(&passage.place);
        let solved =
            symbols.into_iter().map(|symbol| self.answer_in(solution, symbol).map(|answer| (symbol, answer.value)));
        let Some(solved) = solved.collect::<Option<BTreeMap<Symbol, f64>>>() else { return false };
        let value = |symbol: Symbol| solved.get(&symbol).copied().unwrap_or(f64::NAN);
        let [start, end] = passage.ends.each_ref().map(|end| end.evaluate(&value));
        let energy = |share: f64| {
            let place = start + share * (end - start);
            passage.kinetic.evaluate(&|symbol| if symbol == passage.place { place } else { value(symbol) })
        };
        let within = |parts: u32| (1..parts).map(move |part| f64::from(part) / f64::from(parts));
        let ends = [energy(0.0), energy(1.0)];
        let first: Vec<f64> = within(FIRST).map(energy).chain(ends).collect();
        let clear = MOVES * first.iter().map(|energy| energy.abs()).fold(0.0, f64::max);
        if ends.iter().all(|energy| *energy > -NONE * clear) && first.iter().any(|energy| *energy < -clear) {
            return true;
        }
        let inner = within(PARTS);
        let shares: Vec<f64> = [0.0, EDGE].into_iter().chain(inner).chain([1.0 - EDGE, 1.0]).collect();
        let energies: Vec<(f64, f64)> = shares.into_iter().map(|share| (share, energy(share))).collect();
        let largest = energies.iter().map(|(_, energy)| energy.abs()).fold(0.0, f64::max);
        let mut highest = 0.0_f64;
        energies.windows(3).any(|three| {
            let [(low, before), (_, middle), (high, after)] = three else { return false };
            highest = highest.max(*before);
            if !middle.is_finite() {
                return true;
            }
            if middle > before || middle > after {
                return false;
            }
            let least = least(&energy, [*low, *high]).min(*middle);
            least < -NONE * largest || (least <= NONE * largest && highest > MOVES * largest)
        })
    }
}

/// The least value of a function that has one least value between two places.
fn least(function: &dyn Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..NARROWED {
        let third = (high - low) / 3.0;
        if function(low + third) < function(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    function(f64::midpoint(low, high))
}
