//! Whether what a sheet tells is enough to find a quantity: several worlds that print the same sheet are simulated, and either the
//! quantity is the same in all of them or it is not.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_problem::Given;
use momentous_quantity::Dimension;

use super::case::Case;
use super::simulation::Witness;

/// The number of worlds that are enough to say something.
const ENOUGH: usize = 3;

/// The most parts of a scene that may be open.
const MOST_OPEN: usize = 4;

/// Steps by which a world is brought to print the same sheet.
const STEPS: usize = 30;

/// Two values that differ by less than this share are the same, and by more than that share are not.
const SAME: f64 = 1e-7;
const DIFFERENT: f64 = 1e-3;

/// The share by which an open quantity is changed to see what that does.
const NUDGE: f64 = 1e-6;

/// The share of the largest slope that keeps a step small in directions in which the sheet fixes nothing.
const RIDGE: f64 = 1e-9;

/// Values that an open quantity is tried with, in SI units: a coefficient with the first, other quantities with multiples as well.
const TRIALS: [f64; 6] = [0.31, 0.47, 0.59, 0.73, 0.83, 0.97];
const MULTIPLES: [f64; 2] = [1.0, 5.0];

/// A scene of which only what the sheet prints is known.
struct Sheet<'a> {
    case: &'a Case<'a>,
    told: &'a BTreeSet<Symbol>,
    tolerance: f64,
}

/// Whether the quantity is settled; none where the simulation does not say.
pub(super) fn settle(case: &Case<'_>, sought: &str, tolerance: f64) -> Option<bool> {
    let told = &case.problem.forms().get(case.variant.form())?.on_sheet;
    let sheet = Sheet { case, told, tolerance };
    let open = sheet.open()?;
    let sought_value = |witness: &Witness<'_>| witness.seen(sought).map(|measured| measured.value);
    let turns = 0..TRIALS.len() * MULTIPLES.len();
    let worlds = turns.filter_map(|turn| sheet.same_sheet(&open, sheet.trial(turn, &open)));
    let values: Vec<f64> = worlds.filter_map(|world| sheet.simulated(&open, &world, sought_value)).collect();
    if values.len() < ENOUGH && !open.is_empty() {
        return None;
    }
    let size = values.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    let (first, rest) = values.split_first()?;
    let apart = rest.iter().fold(0.0, |apart: f64, value| apart.max((value - first).abs()));
    if apart <= SAME * size { Some(true) } else { (apart > DIFFERENT * size).then_some(false) }
}

impl Sheet<'_> {
    /// The quantities without which the scene cannot be simulated and of which the sheet does not tell the value.
    fn open(&self) -> Option<Vec<Symbol>> {
        let mut open: Vec<Symbol> = Vec::new();
        loop {
            let case = self.with(&open, &self.trial(0, &open));
            let witness = Witness::new(&case, self.tolerance);
            let missing = witness.missing().into_iter().find(|symbol| !open.contains(symbol));
            if witness.nothing.is_none() {
                return Some(open);
            }
            let missing = missing?;
            let name = &self.case.problem.model().symbols.entry(missing).name;
            // What is worked out from other quantities has no value of its own.
            let is_derived = self.case.problem.loaded().given.get(name).is_some_and(Given::is_derived);
            if is_derived || open.len() >= MOST_OPEN {
                return None;
            }
            open.push(missing);
        }
    }

    /// Values for what is open, others in each turn.
    fn trial(&self, turn: usize, open: &[Symbol]) -> Vec<f64> {
        let symbols = &self.case.problem.model().symbols;
        let multiple = MULTIPLES[turn / TRIALS.len() % MULTIPLES.len()];
        let values = TRIALS.iter().cycle().skip(turn).step_by(2).zip(open);
        let is_pure = |symbol: &Symbol| symbols.entry(*symbol).dimension == Dimension::NONE;
        values.map(|(value, symbol)| if is_pure(symbol) { *value } else { multiple * value }).collect()
    }

    fn with(&self, open: &[Symbol], world: &[f64]) -> Case<'_> {
        let replaced = open.iter().copied().zip(world.iter().copied()).collect();
        Case { replaced, known: Some(self.told), ..*self.case }
    }

    /// The result of simulating a world; `None` where it cannot be simulated.
    fn simulated<T>(&self, open: &[Symbol], world: &[f64], read: impl Fn(&Witness<'_>) -> Option<T>) -> Option<T> {
        let case = self.with(open, world);
        let witness = Witness::new(&case, self.tolerance);
        if witness.nothing.is_some() { None } else { read(&witness) }
    }

    /// How far what the sheet tells of the end of a stage lies from what is found there.
    fn off(&self, open: &[Symbol], world: &[f64]) -> Option<Vec<f64>> {
        self.simulated(open, world, |witness| {
            let compared = self.told.iter().filter_map(|symbol| witness.comparison(*symbol));
            Some(compared.map(|comparison| comparison.apart() / comparison.stated.abs().max(1.0)).collect())
        })
    }

    /// A world near a trial that prints the same sheet.
    fn same_sheet(&self, open: &[Symbol], mut world: Vec<f64>) -> Option<Vec<f64>> {
        for _ in 0..STEPS {
            let off = self.off(open, &world)?;
            if off.iter().all(|difference| difference.abs() < SAME * DIFFERENT) {
                return Some(world);
            }
            let mut slopes = Vec::new();
            for place in 0..world.len() {
                let mut moved = world.clone();
                moved[place] += NUDGE;
                let there = self.off(open, &moved)?;
                slopes.push(there.iter().zip(&off).map(|(there, here)| (there - here) / NUDGE).collect::<Vec<f64>>());
            }
            for (value, step) in world.iter_mut().zip(least_step(&slopes, &off)?) {
                *value -= step;
            }
        }
        None
    }
}

/// The least change of a world by which what is off comes right to first order; none where the slopes are no numbers.
fn least_step(slopes: &[Vec<f64>], off: &[f64]) -> Option<Vec<f64>> {
    let product = |left: &[f64], right: &[f64]| left.iter().zip(right).map(|(left, right)| left * right).sum::<f64>();
    let largest = slopes.iter().map(|slope| product(slope, slope)).fold(0.0, f64::max);
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for (place, slope) in slopes.iter().enumerate() {
        let mut row: Vec<f64> = slopes.iter().map(|other| product(slope, other)).collect();
        // Where more is open than the sheet fixes, the smallest of all possible steps is taken.
        row[place] += RIDGE * largest;
        row.push(product(slope, off));
        rows.push(row);
    }
    eliminated(rows).filter(|step| step.iter().all(|part| part.is_finite()))
}

/// The solution of linear equations, each row with its right side last.
fn eliminated(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for pivot in 0..count {
        let best = (pivot..count).max_by(|one, other| rows[*one][pivot].abs().total_cmp(&rows[*other][pivot].abs()))?;
        rows.swap(pivot, best);
        let pivot_row = rows[pivot].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(place, _)| *place != pivot) {
            let share = row[pivot] / pivot_row[pivot];
            row.iter_mut().zip(&pivot_row).for_each(|(part, pivot_part)| *part -= share * pivot_part);
        }
    }
    Some(rows.iter().enumerate().map(|(place, row)| row[count] / row[place]).collect())
}
