//! One step of a pair: its slopes, its error, and what lies between its ends.

use super::fifth::DENSE;
use super::pair::Pair;

/// How much the rougher of two estimates counts beside the finer.
const ROUGH: f64 = 0.01;

/// The coefficients of 1, s, ..., s^4 of a value within a step, where s goes from 0 to 1.
pub(crate) type Quartic = [f64; 5];

/// A step that is tried. Its slopes, and the state at its end, have their room once for all steps.
#[derive(Clone)]
pub(crate) struct Step<const S: usize> {
    /// The state at its end.
    pub state: Vec<f64>,
    /// The number of times that the slope was worked out.
    pub evaluations: usize,
    pair: &'static Pair<S>,
    /// The slopes of each number at all stages.
    slopes: Vec<[f64; S]>,
    slope: Vec<f64>,
    /// Whether the first slope is that of the start.
    begun: bool,
}

impl<const S: usize> Step<S> {
    /// Room for the steps of a state of so many numbers.
    pub(crate) fn new(pair: &'static Pair<S>, size: usize) -> Self {
        let (state, slope) = (vec![0.0; size], vec![0.0; size]);
        Self { state, evaluations: 0, pair, slopes: vec![[0.0; S]; size], slope, begun: false }
    }

    /// Forgets the slope of the start: it is another one, or another law holds there.
    pub(crate) fn begin_anew(&mut self) {
        self.begun = false;
    }

    /// Goes on from the end of the step: its last slope is the first of the next one.
    pub(crate) fn accepted(&mut self) {
        for slopes in &mut self.slopes {
            slopes[0] = slopes[S - 1];
        }
        self.begun = true;
    }

    /// Tries a step of a length; the slope at a time and a state is written to a list.
    #[inline]
    pub(crate) fn take(
        &mut self,
        (time, start): (f64, &[f64]),
        length: f64,
        mut slope: impl FnMut(f64, &[f64], &mut [f64]),
    ) {
        for stage in usize::from(self.begun)..S {
            let weights = &self.pair.stages[stage];
            for ((value, start), slopes) in self.state.iter_mut().zip(start).zip(&mut self.slopes) {
                // What is left of an earlier step must not count, were it no number.
                slopes[stage] = 0.0;
                let mut change = 0.0;
                for before in 0..stage {
                    change += weights[before] * slopes[before];
                }
                *value = start + length * change;
            }
            slope(time + self.pair.nodes[stage] * length, &self.state, &mut self.slope);
            for (slopes, slope) in self.slopes.iter_mut().zip(&self.slope) {
                slopes[stage] = *slope;
            }
            self.evaluations += 1;
        }
        self.begun = true;
    }

    /// The greatest error of the step of a length, each relative to what is tolerated at its place; not a number where a slope is none.
    pub(crate) fn error(&self, length: f64, tolerated: impl Fn(usize) -> f64) -> f64 {
        let mut worst = 0.0_f64;
        for place in 0..self.state.len() {
            let mut error = self.pair.errors.iter().map(|weights| self.weighted(weights, place));
            let (fine, rough) = (error.next(), error.next());
            let error = match (fine, rough) {
                (Some(fine), Some(rough)) if fine != 0.0 => {
                    fine * (fine / libm::sqrt(fine * fine + ROUGH * rough * rough))
                }
                (fine, _) => fine.map_or(f64::NAN, |fine| fine),
            };
            if error != 0.0 {
                let part = (length * error).abs() / tolerated(place);
                worst = if part.is_nan() || worst.is_nan() { f64::NAN } else { worst.max(part) };
            }
        }
        worst
    }

    /// A value within a step of order 5 that began there.
    pub(crate) fn within(&self, start: &[f64], length: f64, place: usize) -> Quartic {
        let from = start[place];
        let [first, last] = [0, S - 1].map(|stage| self.slopes[place][stage] * length);
        let change = self.state[place] - from;
        let bend = first - change;
        let third = change - last - bend;
        let fourth = length * self.weighted(&DENSE, place);
        // c1 + s (c2 + (1 - s)(c3 + s (c4 + (1 - s) c5)))
        [from, change + bend, -bend + third + fourth, -third - fourth * 2.0, fourth]
    }

    fn weighted(&self, weights: &[f64], place: usize) -> f64 {
        weights.iter().zip(&self.slopes[place]).map(|(weight, slope)| weight * slope).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{EIGHTH, FIFTH};
    use super::*;

    /// Once round an orbit of eccentricity 1/2 at a tolerance: how far the end is from the start, and how often the slope was worked out.
    fn once_round<const S: usize>(pair: &'static Pair<S>, tolerance: f64) -> (f64, usize) {
        let orbit = |_: f64, state: &[f64], slope: &mut [f64]| {
            let distance = libm::hypot(state[0], state[1]);
            let pull = -1.0 / (distance * distance * distance);
            slope.copy_from_slice(&[state[2], state[3], pull * state[0], pull * state[1]]);
        };
        let start = [1.0, 0.0, 0.0, libm::sqrt(1.5)];
        let (mut state, mut time, mut length, mut step) = (start, 0.0, 0.01, Step::new(pair, 4));
        let period = core::f64::consts::TAU * 8.0_f64.sqrt();
        while time < period {
            let tried = if length < period - time { length } else { period - time };
            step.take((time, &state), tried, orbit);
            let error = step.error(tried, |_| tolerance);
            length = pair.next(tried, error);
            if error <= 1.0 {
                state.copy_from_slice(&step.state);
                time = if tried < period - time { time + tried } else { period };
                step.accepted();
            }
        }
        (state.iter().zip(start).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max), step.evaluations)
    }

    #[test]
    fn the_higher_pair_takes_a_third_of_the_evaluations_at_twelve_digits() {
        let ((rough, many), (fine, few)) = (once_round(&FIFTH, 1e-13), once_round(&EIGHTH, 1e-13));
        assert!(rough < 1e-10 && fine < 1e-10, "{rough:e} {fine:e}");
        assert!(5 * few < 2 * many, "{few} of {many}");
    }

    /// Half the step leaves so small a part of the error as the order of the pair says.
    #[test]
    fn errors_go_with_the_order_of_a_pair() {
        fn check<const S: usize>(pair: &'static Pair<S>, long: f64) {
            let growth = |_: f64, state: &[f64], slope: &mut [f64]| slope[0] = state[0];
            let off = |length: f64| {
                let mut step = Step::new(pair, 1);
                step.take((0.0, &[1.0]), length, growth);
                (step.state[0] - libm::exp(length)).abs()
            };
            let order = libm::log2(off(long) / off(long / 2.0));
            assert!((order - pair.order - 1.0).abs() < 0.7, "{order}");
        }
        check(&FIFTH, 0.5);
        check(&EIGHTH, 1.0);
    }

    #[test]
    fn the_interpolant_is_right_within_a_step() {
        let mut step = Step::new(&FIFTH, 2);
        step.take((0.0, &[0.0, 1.0]), 0.2, |_, state, slope| slope.copy_from_slice(&[state[1], -state[0]]));
        for share in [0.0, 0.3, 0.5, 0.9, 1.0] {
            let value = step.within(&[0.0, 1.0], 0.2, 0).iter().rev().fold(0.0, |sum, part| sum * share + part);
            assert!((value - libm::sin(0.2 * share)).abs() < 1e-7, "{share}: {value}");
        }
    }
}
