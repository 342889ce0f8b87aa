//! Consequences of the common mistakes with the numbers of one variant.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::wrong::data::MASS_LEFT_OUT;
use momentous_laws::wrong::reading::DEGREES;
use momentous_laws::wrong::reading::SlipOf;
use momentous_model::QuantityKind;
use momentous_quantity::MOST_TOLERANCES;
use momentous_quantity::half_unit;
use momentous_solve::BatchValues;
use momentous_solve::Bounded;

use super::super::questions::part::AskedUnit;
use super::super::questions::part::NumberPart;
use super::super::questions::part::PartKind;
use super::super::questions::part::VectorPart;
use super::super::sampling::variant::Worked;
use super::mistake::Made;
use super::mistake::Misread;
use super::mistake::Mistake;
use super::mistake::Planned;

/// A formula and a program give the same within this share.
const SAME: f64 = 1e-9;
/// An angle that is misread is turned on by so much, in radians, to see whether anything hangs on it.
const TURNED: f64 = 0.05;
/// The share of a change below which a value does not hang on it.
const UNMOVED: f64 = 0.01;

/// The consequences of every common mistake with the numbers of a variant.
#[derive(Debug)]
pub struct Simulated<'a> {
    worked: Worked<'a>,
    planned: Option<&'a Planned>,
    batch: Option<BatchValues<'a>>,
}

impl<'a> Simulated<'a> {
    pub(super) fn new(worked: Worked<'a>, planned: Option<&'a Planned>) -> Self {
        let batch = planned.and_then(|planned| {
            let given = |symbol: &Symbol| worked.variant.value(*symbol).map(|given| given.value);
            let inputs: Option<Vec<f64>> = planned.inputs.iter().map(given).collect();
            Some(planned.batch.run(&inputs?))
        });
        Self { worked, planned, batch }
    }

    /// The mistakes.
    #[must_use]
    pub fn mistakes(&self) -> &'a [Mistake] {
        self.planned.map_or(&[], |planned| planned.list.as_slice())
    }

    /// The answers to a part by a mistake, in the unit of the question; none where it cannot be made there.
    #[must_use]
    pub fn answers(&self, mistake: &Mistake, number: &NumberPart) -> Vec<f64> {
        let mut values = Vec::new();
        self.each(mistake, number, &|_| true, &mut |value| values.push(value));
        values
    }

    /// Gives `add` each of them that `is_wanted`.
    pub fn each(
        &self,
        mistake: &Mistake,
        number: &NumberPart,
        is_wanted: &dyn Fn(f64) -> bool,
        add: &mut dyn FnMut(f64),
    ) {
        let unit = self.worked.unit_of(number);
        let told = |symbol: Symbol| self.worked.variant.value(symbol);
        // A body without mass has no momentum: nobody who writes nothing has got there in that way.
        let is_empty = |value: f64| value == 0.0 && *mistake.of == MASS_LEFT_OUT;
        let mut keep = |value: f64| {
            let value = value / unit;
            if value.is_finite() && !is_empty(value) && is_wanted(value) {
                add(value);
            }
        };
        let batched = |place: usize| self.batch.as_ref()?.value(place, number.symbol, &|value| is_wanted(value / unit));
        match &mistake.made {
            Made::Solved(ways) => {
                for way in ways {
                    match way.batched {
                        Some(place) => batched(place).into_iter().for_each(&mut keep),
                        None => way.solver.values(number.symbol, &told, &mut keep),
                    }
                }
            }
            Made::OtherRoot(right) => {
                right.roots(number.symbol, &told, &mut keep);
            }
            Made::Misread(misread) => self.each_misread(mistake, misread, number, is_wanted, add),
            Made::Taken(pairs) => {
                let others = pairs.iter().filter(|(asked, _)| *asked == number.symbol);
                let values = others.filter_map(|(asked, other)| Some((told(*asked)?.value, told(*other)?.value)));
                // A component for a magnitude is written without its sign, and a magnitude for a component with the one it needs.
                values.flat_map(|(right, other)| [other, other.copysign(right)]).for_each(&mut keep);
            }
            Made::Written(to, written) => {
                let fits = match to {
                    SlipOf::Signed => self.planned.is_some_and(|planned| planned.directed.contains(&number.symbol)),
                    SlipOf::Angle => is_in_degrees(number) && !self.is_between(number),
                    SlipOf::Between => is_in_degrees(number) && self.is_between(number),
                    SlipOf::Count => number.whole,
                    SlipOf::Size => !number.whole && !is_in_degrees(number),
                };
                told(number.symbol).filter(|_| fits).map(|value| written(value.value)).into_iter().for_each(&mut keep);
            }
        }
    }

    /// The same of a unit that is misread.
    fn each_misread(
        &self,
        mistake: &Mistake,
        misread: &Misread,
        number: &NumberPart,
        is_wanted: &dyn Fn(f64) -> bool,
        add: &mut dyn FnMut(f64),
    ) {
        let unit = self.worked.unit_of(number);
        // An answer in the unit that is overlooked is not converted to it either; one with the sines of a wrong calculator never is.
        let overlooked = &misread.unit;
        let is_overlooked = matches!(&number.unit, AskedUnit::Unit(own) if *own == overlooked.0);
        let units = match (is_overlooked, *mistake.of == DEGREES && is_in_degrees(number)) {
            (_, true) => vec![1.0],
            (true, false) => vec![unit, unit * overlooked.1],
            (false, false) => vec![unit],
        };
        let is_near = |value: f64| units.iter().any(|unit| is_wanted(value / unit));
        let mut values = Vec::new();
        match misread.batched {
            Some(place) => {
                let batch = self.batch.as_ref();
                values.extend(batch.and_then(|batch| batch.value(place, number.symbol, &is_near)));
            }
            None => misread.right.values(number.symbol, &self.misread(&misread.read, 1.0, 0.0), &mut |value| {
                values.extend(Some(value).filter(|value| is_near(*value)));
            }),
        }
        values.retain(|value| self.hangs_on(mistake, number.symbol, *value));
        let written = values.iter().flat_map(|value| units.iter().map(move |unit| value / unit));
        written.filter(|value| value.is_finite() && is_wanted(*value)).for_each(add);
    }

    /// Whether a number is the angle between two arrows.
    fn is_between(&self, number: &NumberPart) -> bool {
        matches!(self.worked.problem.model().name(number.symbol).kind, QuantityKind::AngleBetween(_))
    }

    /// The givens with some of them misread, by a somewhat other factor and something added.
    fn misread<'m>(
        &'m self,
        read: &'m [(Symbol, f64)],
        times: f64,
        plus: f64,
    ) -> impl Fn(Symbol) -> Option<Bounded> + 'm {
        move |symbol| {
            let right = self.worked.variant.value(symbol)?;
            let factor = read.iter().find(|(misread, _)| *misread == symbol).map(|(_, factor)| *factor * times);
            let Some(factor) = factor else { return Some(right) };
            Some(Bounded { value: right.value * factor + plus, error: right.error * factor })
        }
    }

    /// Whether what comes of a misreading hangs on by how much the given is misread. Where it does not, it is what comes of
    /// leaving the given out, or of making it as large as can be, and nothing says that a unit was misread.
    fn hangs_on(&self, mistake: &Mistake, symbol: Symbol, value: f64) -> bool {
        let Made::Misread(Misread { right, read, .. }) = &mistake.made else { return true };
        let others = if *mistake.of == DEGREES { [(1.0, -TURNED), (1.0, TURNED)] } else { [(0.5, 0.0), (2.0, 0.0)] };
        others.into_iter().all(|(times, plus)| {
            let mut is_other = true;
            right.values(symbol, &self.misread(read, times, plus), &mut |other| {
                is_other &= (other - value).abs() > UNMOVED * value.abs();
            });
            is_other
        })
    }

    /// The vectors by a mistake: their components in the unit of the question. One that the mistake leaves alone is right.
    #[must_use]
    pub fn vectors(&self, mistake: &Mistake, vector: &VectorPart) -> Vec<Vec<f64>> {
        let each: Vec<Vec<f64>> = vector.components.iter().map(|number| self.answers(mistake, number)).collect();
        let count = each.iter().map(Vec::len).filter(|count| *count > 0).min().unwrap_or(0);
        let right =
            |number: &NumberPart| Some(self.worked.variant.value(number.symbol)?.value / self.worked.unit_of(number));
        let one = |place: usize| {
            let components = vector.components.iter().zip(&each);
            components.filter_map(move |(number, values)| match &values[..] {
                [] => right(number),
                some => some.get(place).copied(),
            })
        };
        (0..count).map(|place| one(place).collect()).collect()
    }
}

/// Whether a number is an angle in degrees, or in turns.
fn is_in_degrees(number: &NumberPart) -> bool {
    matches!(&number.unit, AskedUnit::Unit(unit) if unit.is_plain_angle() && unit.has_pi())
}

impl<'a> Worked<'a> {
    /// The formulas of a quantity by a mistake, in what is given; none where nothing but numbers is got wrong.
    #[must_use]
    pub fn mistaken_formulas(&self, mistake: &Mistake, symbol: Symbol) -> Vec<Expr> {
        let Made::Solved(ways) = &mistake.made else { return Vec::new() };
        let told = |symbol: Symbol| self.variant.value(symbol);
        let right = self.every_formula(&self.leaf().audit.plan, symbol);
        let mut formulas: Vec<Expr> = Vec::new();
        for solver in ways.iter().map(|way| &way.solver).filter(|solver| solver.wanted.contains(&symbol)) {
            let mut values = Vec::new();
            solver.values(symbol, &told, &mut |value| values.push(value));
            for formula in self.every_formula(&solver.plan, symbol) {
                // Of several roots the one that is possible for these numbers.
                let value = formula.evaluate(&|symbol| told(symbol).map_or(f64::NAN, |value| value.value));
                let taken = values.iter().any(|other| (other - value).abs() <= SAME * value.abs());
                if taken && !formulas.contains(&formula) && !right.contains(&formula) {
                    formulas.push(formula);
                }
            }
        }
        formulas
    }

    /// Makes every mistake with the numbers of this variant.
    #[must_use]
    pub fn simulated(&self) -> Simulated<'a> {
        Simulated::new(*self, self.planned())
    }

    /// Whether a mistake changes some answer by more than its tolerance; true where it cannot be made.
    #[must_use]
    pub fn tells_apart(&self, mistake: &str) -> bool {
        let mut possible = false;
        let simulated = self.simulated();
        let numbers = || {
            self.form.parts.iter().filter_map(|part| match &part.kind {
                PartKind::Number(number) => Some(number),
                PartKind::Vector(_) | PartKind::Formula(_) | PartKind::Range(_) | PartKind::Choice(_) => None,
            })
        };
        for mistake in self.mistakes().iter().filter(|other| other.of.id == mistake) {
            for number in numbers() {
                let right = self.answer(number).value;
                let tolerance = number.tolerance.reach(right).unwrap_or_else(|| half_unit(right, number.figures));
                let allowed = tolerance.max(self.judged(number).allowance.min(MOST_TOLERANCES * tolerance));
                for value in simulated.answers(mistake, number) {
                    possible = true;
                    if (value - right).abs() > allowed {
                        return true;
                    }
                }
            }
        }
        !possible
    }
}
