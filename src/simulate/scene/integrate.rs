//! Motions that no world describes, integrated as they are written: a slope, a start, and what ends it.
//!
//! The step adapts to a tolerance; the event that ends a run is found by shortening the last step until the event's own
//! function is zero there. The error of a run is what a second run with a finer tolerance changes.

use crate::methods::dormand_prince::{ERROR, NODES, STAGES};

use super::nothing::NothingToSimulate;

/// Steps after which a run is given up.
pub(super) const MOST_STEPS: usize = 20_000;

/// The share of the largest component below which a component is rounding.
const NOISE: f64 = 1e-14;

/// Trials after which an event is located as well as rounding lets it.
const MOST_TRIALS: usize = 80;

/// The slope of a state at a time.
pub(super) type Slope<'a, const N: usize> = &'a dyn Fn(f64, &[f64; N]) -> [f64; N];

/// A function that is positive until the run has to end.
pub(super) type Stop<'a, const N: usize> = &'a dyn Fn(f64, &[f64; N]) -> f64;

/// How finely a motion is integrated.
#[derive(Clone, Copy, Debug)]
pub(super) struct Integrator {
    /// The error that a step may have, relative to the largest value that the component has had.
    pub tolerance: f64,
    /// The longest step, so that none passes over an event.
    pub longest: f64,
}

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End<const N: usize> {
    pub time: f64,
    pub state: [f64; N],
    /// Whether the event ended it, and not the time.
    pub stopped: bool,
    /// The largest size that each component of the state has had.
    pub largest: [f64; N],
}

impl Integrator {
    /// Until a time.
    pub(super) fn until<const N: usize>(
        self,
        start: f64,
        state: [f64; N],
        end: f64,
        slope: Slope<'_, N>,
    ) -> Result<[f64; N], NothingToSimulate> {
        Ok(self.run(start, state, end, slope, &|_, _| 1.0)?.state)
    }

    /// Until an event, which has to happen.
    pub(super) fn event<const N: usize>(
        self,
        start: f64,
        state: [f64; N],
        slope: Slope<'_, N>,
        stop: Stop<'_, N>,
    ) -> Result<(f64, [f64; N]), NothingToSimulate> {
        let end = self.run(start, state, f64::INFINITY, slope, stop)?;
        Ok((end.time, end.state))
    }

    /// Until an event, or a time if that comes first. An event that is zero at the start counts once it has been positive.
    pub(super) fn run<const N: usize>(
        self,
        start: f64,
        state: [f64; N],
        end: f64,
        slope: Slope<'_, N>,
        stop: Stop<'_, N>,
    ) -> Result<End<N>, NothingToSimulate> {
        let (mut time, mut state) = (start, state);
        let mut size = state.map(f64::abs);
        let mut length = self.longest / 8.0;
        let mut before = stop(time, &state);
        let mut first = slope(time, &state);
        for _ in 0..MOST_STEPS {
            if time >= end {
                return Ok(End { time, state, stopped: false, largest: size });
            }
            let last = length.min(self.longest) >= end - time;
            let tried = if last { end - time } else { length.min(self.longest) };
            let Step { next, error, last: last_slope } = step(slope, time, (&state, &first), tried, &size);
            let wrong = error / self.tolerance;
            let factor = 0.9 * libm::pow(wrong, -0.2);
            length = tried * factor.clamp(0.2, 5.0);
            if wrong.is_nan() || wrong > 1.0 {
                length = if wrong.is_nan() { tried * 0.2 } else { length };
                continue;
            }
            let after = stop(time + tried, &next);
            if before > 0.0 && after <= 0.0 {
                let part = located(
                    &|part| stop(time + part, &step(slope, time, (&state, &first), part, &size).next),
                    tried,
                    [before, after],
                );
                let state = step(slope, time, (&state, &first), part, &size).next;
                return Ok(End { time: time + part, state, stopped: true, largest: size });
            }
            for (size, value) in size.iter_mut().zip(&next) {
                *size = size.max(value.abs());
            }
            (time, state, before, first) = (if last { end } else { time + tried }, next, after, last_slope);
        }
        Err(NothingToSimulate::NoMethod)
    }
}

/// A step that may be taken.
struct Step<const N: usize> {
    /// The state at its end.
    next: [f64; N],
    /// The largest error relative to the sizes.
    error: f64,
    /// The slope at its end, with which the next one begins.
    last: [f64; N],
}

/// One step of the pair of Dormand and Prince from a state with its slope.
fn step<const N: usize>(
    slope: Slope<'_, N>,
    time: f64,
    (state, first): (&[f64; N], &[f64; N]),
    length: f64,
    size: &[f64; N],
) -> Step<N> {
    let mut slopes = [[0.0; N]; 7];
    slopes[0] = *first;
    let mut next = *state;
    for (stage, (node, weights)) in NODES.iter().zip(STAGES).enumerate().skip(1) {
        for (place, value) in next.iter_mut().enumerate() {
            let change: f64 = weights.iter().zip(&slopes).map(|(weight, slope)| weight * slope[place]).sum();
            *value = state[place] + length * change;
        }
        slopes[stage] = slope(time + node * length, &next);
    }
    let (mut worst, largest) = (0.0_f64, size.iter().copied().fold(0.0, f64::max));
    for (place, value) in next.iter().enumerate() {
        let error: f64 = ERROR.iter().zip(&slopes).map(|(weight, slope)| weight * slope[place]).sum();
        // A component that is nothing but rounding must not set the step.
        let scale = size[place].max(value.abs()).max(NOISE * largest);
        if error != 0.0 {
            let part = (length * error).abs() / scale;
            worst = if part.is_nan() { f64::NAN } else { worst.max(part) };
        }
    }
    Step { next, error: worst, last: slopes[6] }
}

/// Finds where a function of a part of the step crosses zero: false position with halved ends (the Illinois method).
pub(super) fn located(function: &dyn Fn(f64) -> f64, whole: f64, ends: [f64; 2]) -> f64 {
    let ([mut low, mut high], [mut before, mut after]) = ([0.0, whole], ends);
    for _ in 0..MOST_TRIALS {
        let mut part = low + (high - low) * before / (before - after);
        if !(part > low && part < high) {
            part = low + (high - low) / 2.0;
        }
        let value = function(part);
        if value == 0.0 || part <= low || part >= high {
            return part;
        }
        if value > 0.0 {
            (low, before, after) = (part, value, after / 2.0);
        } else {
            (high, after, before) = (part, value, before / 2.0);
        }
        if high - low <= 4.0 * f64::EPSILON * whole {
            break;
        }
    }
    high
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    const FINE: Integrator = Integrator { tolerance: 1e-12, longest: 0.1 };

    #[test]
    fn a_quarter_of_an_oscillation_ends_where_it_must() {
        let (time, [place, speed]) =
            FINE.event(0.0, [1.0, 0.0], &|_, &[place, speed]| [speed, -place], &|_, &[place, _]| place).unwrap();
        assert!((time - core::f64::consts::FRAC_PI_2).abs() < 1e-10, "{time}");
        assert!(place.abs() < 1e-14 && (speed + 1.0).abs() < 1e-10, "{place} {speed}");
    }

    #[test]
    fn an_event_at_the_start_counts_when_it_comes_back() {
        let thrown = |_: f64, state: &[f64; 2]| [state[1], -10.0];
        let (time, _) = FINE.event(0.0, [0.0, 5.0], &thrown, &|_, state| state[0]).unwrap();
        assert!((time - 1.0).abs() < 1e-12, "{time}");
    }

    #[test]
    fn a_time_that_comes_before_the_event_ends_the_run() {
        let end = FINE.run(0.0, [1.0], 2.0, &|_, &[value]| [-value], &|_, &[value]| value).unwrap();
        assert!(
            !end.stopped && (end.time - 2.0).abs() < 1e-15 && (end.state[0] - libm::exp(-2.0)).abs() < 1e-11,
            "{end:?}"
        );
    }

    #[test]
    fn a_slope_that_blows_up_is_refused() {
        let run = FINE.until(0.0, [1.0], 2.0, &|_, &[value]| [value * value]);
        assert_eq!(run, Err(NothingToSimulate::NoMethod));
    }
}
