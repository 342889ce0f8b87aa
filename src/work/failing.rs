//! Lines whose sides do not agree, or cannot be tried: why.

use momentous_quantity::Dimension;
use momentous_quantity::coherent_unit;

use super::clash::clash_in_symbols;
use super::elsewhere::{Elsewhere, elsewhere};
use super::found::Found;
use super::ground::Place;
use super::holds::At;
use super::judge::Judge;
use super::meaning::Meanings;
use super::verdict::Verdict;
use super::written::Written;
use super::wrong::WrongSystems;

impl Judge<'_> {
    /// What is said of a line that cannot be tried.
    pub(crate) fn open(&self, line: &Written, place: Place<'_>) -> Found {
        let missing = line.quantities().into_iter().find(|symbol| place.value(*symbol).is_none());
        let detail = missing.map_or_else(
            || "its numbers are too close to tell".to_owned(),
            |symbol| format!("{} does not follow from what is given", self.worked.problem.name_of(symbol)),
        );
        Found::of(Verdict::Undecided).because(detail)
    }

    /// Whether a bare number is that of a given in a unit in which bare numbers do not count.
    fn has_printed_number(&self, line: &Written) -> bool {
        let system = self.worked.problem.units();
        self.worked.variant.all_given().iter().any(|(_, value, unit)| {
            let coherent = coherent_unit(unit.dimension(), system);
            let is_other = unit.dimension() != Dimension::NONE && unit.factor() != coherent.factor();
            let printed = value.to_rational();
            is_other && line.numbers.iter().any(|own| own.unit.is_none() && own.value == printed)
        })
    }

    /// Why a line does not hold.
    pub(crate) fn failing(&self, line: &Written, place: Place<'_>, sets: &[Meanings], at: &At<'_>) -> Found {
        if let Some(clash) = clash_in_symbols(line, sets) {
            return Found::of(Verdict::Dimensions).because(clash);
        }
        let follows = WrongSystems::of(&self.ground, self.worked, place, (line, sets), at);
        if !follows.is_empty() {
            return Found { mistakes: follows, ..Found::of(Verdict::Mistake) };
        }
        // Bare numbers in the units of the sheet: their results may be in any.
        if self.has_printed_number(line) && !line.is_in_symbols() {
            return Found::of(Verdict::Undecided).because("write the units of its numbers".to_owned());
        }
        match elsewhere(self.worked, place, (line, sets), at) {
            Some((Elsewhere::Instant, symbol)) => {
                Found::of(Verdict::OtherInstant).because(self.worked.problem.name_of(symbol))
            }
            Some((Elsewhere::Body, symbol)) => {
                Found::of(Verdict::OtherBody).because(self.worked.problem.name_of(symbol))
            }
            None => Found::of(Verdict::DoesNotFollow),
        }
    }
}
