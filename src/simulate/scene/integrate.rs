//! Motions that no world describes, integrated as they are written: a slope, a start, and what ends it.
//!
//! The step adapts to a tolerance; the event that ends a run is found by shortening the last step until the event's own
//! function is zero there. The error of a run is what a second run with a finer tolerance changes.

use crate::ode::{EIGHTH, FIFTH, Pair, Quartic, Step};

use super::nothing::NothingToSimulate;

/// Steps after which a run is given up.
pub(super) const MOST_STEPS: usize = 20_000;

/// The tolerance below which a run of more than a step that looks for no event takes the pair of higher order.
const FINE: f64 = 1e-8;

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
        let start = (start, state);
        let high = self.tolerance < FINE && end - start.0 > self.longest;
        let end = if high {
            self.steps(&EIGHTH, start, end, slope, None)
        } else {
            self.steps(&FIFTH, start, end, slope, None)
        };
        Ok(end?.state)
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
        self.steps(&FIFTH, (start, state), end, slope, Some(stop))
    }

    /// The steps of a pair until an event, if any is looked for, or a time.
    fn steps<const N: usize, const S: usize>(
        self,
        pair: &'static Pair<S>,
        (start, state): (f64, [f64; N]),
        end: f64,
        slope: Slope<'_, N>,
        stop: Option<Stop<'_, N>>,
    ) -> Result<End<N>, NothingToSimulate> {
        let (mut time, mut state, mut size) = (start, state, state.map(f64::abs));
        let mut length = self.longest / 8.0;
        let mut before = stop.map(|stop| stop(time, &state));
        let mut step = Step::new(pair, N);
        let take = |step: &mut Step<S>, from: (f64, &[f64; N]), length: f64| {
            step.take((from.0, from.1), length, |at, numbers, out| out.copy_from_slice(&slope(at, &whole(numbers))));
        };
        for _ in 0..MOST_STEPS {
            if time >= end {
                return Ok(End { time, state, stopped: false, largest: size });
            }
            let last = length.min(self.longest) >= end - time;
            let tried = if last { end - time } else { length.min(self.longest) };
            take(&mut step, (time, &state), tried);
            let next = whole(&step.state);
            let largest = size.iter().copied().fold(0.0, f64::max);
            // A component that is nothing but rounding must not set the step.
            let tolerated = |place: usize| self.tolerance * size[place].max(next[place].abs()).max(NOISE * largest);
            let error = step.error(tried, tolerated);
            length = pair.next(tried, error);
            if error.is_nan() || error > 1.0 {
                continue;
            }
            if let (Some(stop), Some(positive)) = (stop, before.filter(|before| *before > 0.0)) {
                let after = stop(time + tried, &next);
                let ends = if after <= 0.0 {
                    Some((tried, after))
                } else {
                    passed(&step, (time, &state), tried, positive.min(after), stop)
                };
                if let Some((part, after)) = ends {
                    let mut at = |part: f64| {
                        take(&mut step, (time, &state), part);
                        whole(&step.state)
                    };
                    let part = located(&mut |part| stop(time + part, &at(part)), part, [positive, after]);
                    return Ok(End { time: time + part, state: at(part), stopped: true, largest: size });
                }
            }
            for (size, value) in size.iter_mut().zip(&next) {
                *size = size.max(value.abs());
            }
            step.accepted();
            (time, state) = (if last { end } else { time + tried }, next);
            before = stop.map(|stop| stop(time, &state));
        }
        Err(NothingToSimulate::NoMethod)
    }
}

fn whole<const N: usize>(numbers: &[f64]) -> [f64; N] {
    core::array::from_fn(|place| numbers[place])
}

/// Where between the ends of a step, at both of which it is positive, an event has happened, and its function there: looked for
/// where the interpolant brings it lower than at both ends.
fn passed<const N: usize, const S: usize>(
    step: &Step<S>,
    (time, state): (f64, &[f64; N]),
    length: f64,
    ends: f64,
    stop: Stop<'_, N>,
) -> Option<(f64, f64)> {
    let quartics: [Quartic; N] = core::array::from_fn(|place| step.within(state, length, place));
    let value = |share: f64| {
        let between = quartics.map(|quartic| quartic.iter().rev().fold(0.0, |sum, part| sum * share + part));
        stop(time + share * length, &between)
    };
    let lowest = [0.25, 0.5, 0.75].into_iter().min_by(|one, other| value(*one).total_cmp(&value(*other)))?;
    if value(lowest) >= ends {
        return None;
    }
    let (mut low, mut high) = (lowest - 0.25, lowest + 0.25);
    for _ in 0..MOST_TRIALS {
        let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        if value(one).min(value(other)) <= 0.0 || high <= low + f64::EPSILON {
            break;
        }
        if value(one) < value(other) { high = other } else { low = one }
    }
    let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
    [one, other].into_iter().map(|share| (share * length, value(share))).find(|(_, value)| *value <= 0.0)
}

/// Finds where a function of a part of the step crosses zero: false position with halved ends (the Illinois method).
pub(super) fn located(function: &mut dyn FnMut(f64) -> f64, whole: f64, ends: [f64; 2]) -> f64 {
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
