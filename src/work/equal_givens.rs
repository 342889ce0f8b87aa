//! Lines that are true because two quantities are given the same value on the sheet: `v_C2 = v_A1/2` of equal masses.

use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_solve::Bounded;

use super::found::LineFinding;
use super::ground::Place;
use super::holds::{At, Holds, RESULT};
use super::judge::Judge;
use super::meaning::Meanings;
use super::verdict::Verdict;
use super::way::Way;
use super::written::Written;

/// A line has to hold in so many other variants, with the values made equal there.
const ENOUGH: usize = 2;

impl Judge<'_> {
    /// The finding on a line that holds wherever two quantities have the same value that have it on this sheet.
    pub(crate) fn by_equal_givens(
        &self,
        line: &Written,
        place: Place<'_>,
        sets: &[Meanings],
        here: &[Holds],
    ) -> Option<LineFinding> {
        let pairs = self.equal_givens();
        if pairs.is_empty() {
            return None;
        }
        let wanted: Vec<Symbol> = line.quantities().difference(&self.ground.told).copied().collect();
        let way = Way::new(&self.ground.system, &self.ground.told, &wanted)?;
        let exactly = || sets.iter().zip(here).filter(|(set, holds)| **holds == Holds::Yes && set.is_general(line));
        pairs.into_iter().find_map(|pair| {
            let (set, _) = exactly().find(|(set, _)| self.holds_with_equal(line, set, &way, pair))?;
            let [one, other] = pair.map(|symbol| self.worked.problem.name_of(symbol));
            let detail = format!("True, as {one} and {other} are equal on this sheet.");
            let found = self.classed(line, place, set, true);
            Some(LineFinding { verdict: Verdict::Coincidence, ..found }.because(detail))
        })
    }

    /// The quantities of one kind that are given the same value.
    fn equal_givens(&self) -> Vec<[Symbol; 2]> {
        let model = self.worked.problem.model();
        let told: Vec<Symbol> = self.ground.told.iter().copied().collect();
        let is_same = |[one, other]: &[Symbol; 2]| {
            let [first, second] = [*one, *other].map(|symbol| self.worked.variant.given(symbol));
            model.symbols.entry(*one).dimension != Dimension::NONE
                && model.name(*one).kind == model.name(*other).kind
                && first.is_some()
                && first == second
        };
        let pairs = told.iter().enumerate().flat_map(|(at, one)| told[at + 1..].iter().map(|other| [*one, *other]));
        pairs.filter(is_same).collect()
    }

    /// Whether a line holds in other variants where the second quantity has the value of the first.
    fn holds_with_equal(&self, line: &Written, set: &Meanings, way: &Way, [one, other]: [Symbol; 2]) -> bool {
        let holds = |place: Place<'_>| {
            let told = |symbol: Symbol| place.value(if symbol == other { one } else { symbol });
            let solutions = way.solve(&told);
            let Some(solution) = solutions.first() else { return Holds::Open };
            let value = |symbol: Symbol| -> Option<Bounded> { solution.get(&symbol).copied().or_else(|| told(symbol)) };
            At { value: &value, units: self.units, turned: &self.turned, share: RESULT }.line(line, set)
        };
        let all: Vec<Holds> = self.ground.places().map(holds).collect();
        let count = |wanted: Holds| all.iter().filter(|holds| **holds == wanted).count();
        count(Holds::Yes) >= ENOUGH && count(Holds::Yes) + count(Holds::Open) == all.len()
    }
}
