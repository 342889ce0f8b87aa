//! The values that a drawn given can take, exact as decimals.

use momentous_fault::{Code, Fault};
use momentous_quantity::Decimal;
use momentous_quantity::unit_of_place;

/// The most values that a given may have.
const MOST_VALUES: u64 = 1 << 40;
/// The most decimals behind the point.
const MOST_DECIMALS: u32 = 18;

/// The values that a given can take, numbered from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Values at equal steps.
    Grid(Grid),
    /// Listed values.
    Choice(Vec<Decimal>),
}

/// Values at equal steps: the lowest, and whole multiples of the step above it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    low: i64,
    step: i64,
    scale: u32,
    count: u64,
}

impl Domain {
    /// How many values there are; never nought.
    #[must_use]
    pub fn count(&self) -> u64 {
        match self {
            Self::Grid(grid) => grid.count,
            Self::Choice(values) => values.len() as u64,
        }
    }

    /// The number of the value that a random word picks. The word is read as a fraction of 2^64, so that the map is the
    /// same on every machine; no value is preferred by more than one part in 2^24, and for a hundred values in 2^57.
    ///
    /// ```
    /// use momentous_problem::Domain;
    /// use momentous_quantity::Decimal;
    /// let coin = Domain::Choice(vec![Decimal::from(0), Decimal::from(1)]);
    /// assert_eq!((coin.pick(u64::MAX / 2), coin.pick(u64::MAX / 2 + 1)), (0, 1));
    /// ```
    #[must_use]
    pub fn pick(&self, word: u64) -> u64 {
        let (_, whole) = word.carrying_mul(self.count(), 0);
        whole
    }

    /// The value of that number; the last one where the number is too large.
    #[must_use]
    pub fn value(&self, index: u64) -> Decimal {
        match self {
            Self::Grid(grid) => Decimal::from_scaled(i128::from(grid.scaled(index)), grid.scale),
            Self::Choice(values) => choose(values, index).cloned().unwrap_or_else(|| Decimal::from(0)),
        }
    }

    /// The double nearest to the value of that number, without making the decimal.
    #[must_use]
    pub fn value_f64(&self, index: u64) -> f64 {
        match self {
            Self::Grid(grid) => grid.value_f64(index),
            Self::Choice(values) => choose(values, index).map_or(0.0, Decimal::to_f64),
        }
    }
}

fn choose(values: &[Decimal], index: u64) -> Option<&Decimal> {
    usize::try_from(index).ok().and_then(|index| values.get(index)).or(values.last())
}

impl Grid {
    /// The grid from the least to the greatest value.
    ///
    /// # Errors
    /// A step that is not above zero or does not lead from the least to the greatest value, a range without values, or
    /// more than 2^40 of them.
    pub fn new(min: &Decimal, max: &Decimal, step: &Decimal) -> Result<Self, Fault> {
        let range = |message: String, help: String| Fault::new(Code::Range, message).help(help);
        let decimals = [min, max, step].into_iter().map(|decimal| u32::try_from(decimal.scale()).unwrap_or(0)).max();
        let scale = decimals.unwrap_or(0);
        let scaled = |decimal: &Decimal| {
            let scaled = decimal.to_scaled(scale).filter(|_| scale <= MOST_DECIMALS);
            scaled.and_then(|scaled| i64::try_from(scaled).ok()).ok_or_else(|| {
                range(
                    format!("{decimal} has too many digits to be drawn together with the others"),
                    "choose a larger unit, or a coarser step".to_owned(),
                )
            })
        };
        let (low, high, step_scaled) = (scaled(min)?, scaled(max)?, scaled(step)?);
        if step_scaled <= 0 {
            return Err(range(
                format!("the step {step} is not positive"),
                "write a positive step, such as `0.5`".to_owned(),
            ));
        }
        if high < low {
            let help = format!("swap them: `min: {max}, max: {min}`");
            return Err(range(format!("no value lies between min {min} and max {max}"), help));
        }
        let (width, step_wide) = (i128::from(high) - i128::from(low), i128::from(step_scaled));
        let (steps, rest) = (width / step_wide, width % step_wide);
        if rest != 0 {
            let at = |steps: i128| Decimal::from_scaled(i128::from(low) + steps * step_wide, scale);
            let message = format!("the step {step} does not lead from {min} to {max}");
            return Err(range(
                message,
                format!("write `max: {}` or `max: {}`, or another step", at(steps), at(steps + 1)),
            ));
        }
        let count = u64::try_from(steps + 1).ok().filter(|count| *count <= MOST_VALUES).ok_or_else(|| {
            let message = format!("these are {} values; a given has at most 2^40", steps + 1);
            range(message, "choose a coarser step".to_owned())
        })?;
        Ok(Self { low, step: step_scaled, scale, count })
    }

    /// The least value.
    #[must_use]
    pub fn low(&self) -> Decimal {
        Decimal::from_scaled(i128::from(self.low), self.scale)
    }

    /// The greatest value.
    #[must_use]
    pub fn high(&self) -> Decimal {
        Decimal::from_scaled(i128::from(self.scaled(self.count)), self.scale)
    }

    fn scaled(self, index: u64) -> i64 {
        // The last value fits, so every value before it does.
        let steps = self.step.unsigned_abs().saturating_mul(index.min(self.count - 1));
        self.low.saturating_add_unsigned(steps)
    }

    fn value_f64(self, index: u64) -> f64 {
        /// Up to here whole numbers are doubles, and so are the powers of ten up to the 22nd.
        const EXACT: i64 = 1 << 53;
        let scaled = self.scaled(index);
        match i32::try_from(self.scale) {
            #[allow(clippy::cast_precision_loss, reason = "whole numbers up to 2^53 are doubles")]
            Ok(place) if scaled.abs() <= EXACT => scaled as f64 / unit_of_place(place),
            _ => Decimal::from_scaled(i128::from(scaled), self.scale).to_f64(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decimal(text: &str) -> Decimal {
        Decimal::parse(text).unwrap()
    }

    fn grid(min: &str, max: &str, step: &str) -> Result<Domain, String> {
        let fault = |fault: Fault| format!("{}: {}", fault.message, fault.help.unwrap_or_default());
        Grid::new(&decimal(min), &decimal(max), &decimal(step)).map(Domain::Grid).map_err(fault)
    }

    #[test]
    fn a_grid_has_exactly_the_decimals_of_its_steps() {
        let e = grid("0.3", "0.9", "0.05").unwrap();
        assert_eq!(e.count(), 13);
        let printed: Vec<_> = (0..4).map(|index| e.value(index).to_string()).collect();
        assert_eq!(printed, ["0.30", "0.35", "0.40", "0.45"]);
        for index in 0..13 {
            assert_eq!(e.value_f64(index).to_bits(), e.value(index).to_f64().to_bits());
        }
        let wide = grid("-4e3", "1.5", "0.5").unwrap();
        assert_eq!((wide.value(0).to_string(), wide.value(u64::MAX).to_string()), ("-4000.0".into(), "1.5".into()));
    }

    #[test]
    fn the_first_and_the_last_word_pick_the_first_and_the_last_value() {
        let domain = grid("1", "6", "0.5").unwrap();
        assert_eq!((domain.pick(0), domain.pick(u64::MAX)), (0, 10));
        assert_eq!(grid("5", "5", "1").unwrap().pick(u64::MAX), 0);
        let mut counts = std::collections::BTreeMap::new();
        for word in 0..11_000_u64 {
            *counts.entry(domain.pick(word * (u64::MAX / 11_000))).or_insert(0) += 1;
        }
        assert!(counts.len() == 11 && counts.values().all(|times| (999..=1001).contains(times)), "{counts:?}");
    }

    #[test]
    fn grids_without_meaning_are_faults_with_the_way_out() {
        let faults = [
            (
                ("1", "6", "0.7"),
                "the step 0.7 does not lead from 1 to 6: write `max: 5.9` or `max: 6.6`, or another step",
            ),
            (("6", "1", "1"), "no value lies between min 6 and max 1: swap them: `min: 1, max: 6`"),
            (("1", "6", "0"), "the step 0 is not positive: write a positive step, such as `0.5`"),
            (("1", "6", "-1"), "the step -1 is not positive: write a positive step, such as `0.5`"),
            (("0", "1", "1e-13"), "these are 10000000000001 values; a given has at most 2^40: choose a coarser step"),
            (
                ("0", "1e30", "1"),
                "1000000000000000000000000000000 has too many digits to be drawn together with the others: choose a larger unit, or a coarser step",
            ),
        ];
        for ((min, max, step), message) in faults {
            assert_eq!(grid(min, max, step).unwrap_err(), message);
        }
    }
}
