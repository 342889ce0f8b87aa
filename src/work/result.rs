//! Results without their units: a bare number at the end of a line counts in a unit of the sheet.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::AskedUnit;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;

use super::judge::Judge;
use super::written::Written;

/// A number fits a unit where it is the value within this share.
const FITS: f64 = 0.03;

impl Judge<'_> {
    /// A bare number that is the value of one quantity counts in a unit in which the sheet has that quantity: the one in which it is
    /// asked, the usual one, or one in which others of its kind are given, where the number fits.
    pub(crate) fn measure_results(&self, line: &mut Written) {
        let mut results: Vec<(Symbol, Symbol)> = Vec::new();
        for chain in line.stated.iter().flatten() {
            let sides = || chain.iter().flat_map(|statement| [&statement.left, &statement.right]);
            let letter = sides().find_map(|side| line.letter_alone(side));
            let Some(letter) = letter else { continue };
            let bare = sides().filter_map(|side| line.number_alone(side)).filter(|number| number.unit.is_none());
            results.extend(bare.map(|number| (number.symbol, letter)));
        }
        let place = self.ground.place(&self.base);
        for (number, symbol) in results {
            let dimension = line.symbols.entry(symbol).dimension;
            let Some(result) = line.numbers.iter_mut().find(|written| written.symbol == number) else { continue };
            let value = place.value(symbol).map_or(f64::NAN, |value| value.value.abs());
            let fits = |unit: &&Unit| {
                let written = result.value.to_f64().value() * unit.factor().to_f64();
                (written - value).abs() <= FITS * value
            };
            let units = self.units_of(symbol, dimension);
            let Some(unit) = units.iter().find(fits).or(units.first()).filter(|unit| !unit.is_none()) else { continue };
            result.unit = Some(unit.clone());
            line.symbols.measure(number, dimension);
        }
    }

    /// A line whose sides of bare numbers count in the unit of the result behind them: `T_1 = 96 + 1.6 = 97.6 kJ`.
    pub(crate) fn in_unit_of_result(&self, line: &Written) -> Option<Written> {
        let mut scaled = line.clone();
        let mut is_changed = false;
        for chain in scaled.stated.iter_mut().flatten() {
            let unit = chain.last().and_then(|statement| match &statement.right {
                Expr::Symbol(number) => line.number(*number)?.unit.clone(),
                _ => None,
            });
            let Some(unit) = unit.filter(|unit| unit.dimension() != Dimension::NONE) else { continue };
            let coherent = coherent_unit(unit.dimension(), self.worked.problem.units());
            let factor = Expr::Number(unit.in_terms_of(&coherent).rational);
            let is_bare = |side: &Expr| {
                let symbols = side.symbols();
                !symbols.is_empty()
                    && symbols.iter().all(|symbol| line.number(*symbol).is_some_and(|number| number.unit.is_none()))
            };
            for statement in chain {
                for side in [&mut statement.left, &mut statement.right] {
                    if is_bare(side) {
                        *side = factor.clone() * side.clone();
                        is_changed = true;
                    }
                }
            }
        }
        is_changed.then_some(scaled)
    }

    /// The units in which a result may be written without saying so, the likeliest first.
    fn units_of(&self, symbol: Symbol, dimension: Dimension) -> Vec<Unit> {
        let parts = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        let asked = parts.into_iter().find(|number| number.symbol == symbol).and_then(|number| match &number.unit {
            AskedUnit::Unit(unit) => Some(unit.clone()),
            AskedUnit::InTermsOf(..) => None,
        });
        let given = self.worked.variant.all_given().iter().map(|(_, _, unit)| unit.clone());
        let usual = self.worked.variant.unit(self.worked.problem, symbol);
        let coherent = coherent_unit(dimension, self.worked.problem.units());
        asked
            .into_iter()
            .chain([usual])
            .chain(given)
            .chain([coherent])
            .filter(|unit| unit.dimension() == dimension)
            .collect()
    }
}
