//! Usual mistakes as graphs.

use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::concept;
use momentous_laws::wrong::momentum;
use momentous_laws::wrong::reading;

use super::curve::Curve;

/// A part of a stage in which a state neither jumps nor changes its sign.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    /// To which stage of the graph it belongs.
    pub stretch: usize,
    pub points: Vec<Point>,
}

/// A state and its rate at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub time: f64,
    pub state: f64,
    pub rate: f64,
}

/// The heights of a curve, run by run.
type Heights = Vec<Vec<f64>>;

/// A mistake, and what it makes of the right curve; none where it cannot be made.
type Wrong = (&'static Misconception, fn(&[Run]) -> Option<Heights>);

/// Mistakes about a velocity or a momentum, those that teach most first.
const OF_STATES: [Wrong; 9] = [
    (&momentum::SIGN_LOST, |runs| Some(mapped(runs, |point| point.state.abs()))),
    (&concept::STATE_AS_FORCE, |runs| {
        scaled(mapped(runs, |point| point.rate), largest(&mapped(runs, |point| point.state)))
    }),
    (&concept::FORCE_AS_CONSTANT, |runs| {
        Some(by_stretch(runs, |[from, to], point| from.state_towards(to, point.time)))
    }),
    (&concept::REBOUND_OVERLOOKED, rebound_overlooked),
    (&momentum::IMPULSE_REVERSED, reversed),
    (&concept::MOMENTUM_KEPT, |runs| {
        let first = start(runs)?;
        is_level(runs).then(|| mapped(runs, |_| first))
    }),
    (&concept::PLACE_DRAWN, |runs| scaled(added_up(runs), largest(&mapped(runs, |point| point.state)))),
    (&momentum::START_FORGOTTEN, |runs| {
        let first = start(runs)?;
        Some(mapped(runs, |point| point.state - first))
    }),
    (&reading::DIRECTION, |runs| Some(mapped(runs, |point| -point.state))),
];

/// Mistakes about a force.
const OF_RATES: [Wrong; 4] = [
    (&concept::FORCE_AS_STATE, |runs| {
        scaled(mapped(runs, |point| point.state), largest(&mapped(runs, |point| point.rate)))
    }),
    (&concept::FORCE_AS_CONSTANT, |runs| Some(by_stretch(runs, |[from, to], _| from.mean_rate_to(to)))),
    (&concept::FORCE_FADES, |runs| {
        let is_even = |run: &Run| run.points.windows(2).all(|pair| pair[0].rate.total_cmp(&pair[1].rate).is_eq());
        let fades = |[from, to]: [Point; 2], point: Point| point.rate * (to.time - point.time) / (to.time - from.time);
        runs.iter().all(is_even).then(|| by_stretch(runs, fades))
    }),
    (&momentum::IMPULSE_REVERSED, |runs| Some(mapped(runs, |point| -point.rate))),
];

/// How many times as high as the right curve a wrong one may go: where it needs more, the others are hard to tell apart.
const HIGHEST: f64 = 2.2;

/// The right curve and those of the mistakes: of the states, or of their rates.
pub(crate) fn curves(runs: &[Run], of_rates: bool) -> Vec<(Option<&'static Misconception>, Curve)> {
    let wrong = if of_rates { &OF_RATES[..] } else { &OF_STATES[..] };
    let right = curve(runs, &mapped(runs, |point| if of_rates { point.rate } else { point.state }));
    let highest = HIGHEST * right.largest();
    let mistaken = wrong.iter().filter_map(|(mistake, heights)| Some((Some(*mistake), curve(runs, &heights(runs)?))));
    let mistaken: Vec<_> = mistaken.filter(|(_, curve)| curve.largest() <= highest).collect();
    std::iter::once((None, right)).chain(mistaken).collect()
}

impl Run {
    /// Nothing happens.
    pub fn idle(stretch: usize, times: [f64; 2], state: f64) -> Self {
        Self { stretch, points: times.map(|time| Point { time, state, rate: 0.0 }).to_vec() }
    }

    /// The same in parts that meet where the state is zero.
    pub fn at_zeros(self) -> Vec<Self> {
        let piece_of = |points| Self { stretch: self.stretch, points };
        let (mut parts, mut piece): (_, Vec<Point>) = (Vec::new(), Vec::new());
        for point in self.points {
            let zero = match piece.last() {
                Some(before) if before.state * point.state < 0.0 => Some(before.at_zero_towards(point)),
                Some(before) if before.state == 0.0 && piece.len() > 1 => Some(*before),
                _ => None,
            };
            if let Some(zero) = zero {
                piece.extend((piece.last().is_some_and(|last| last.time < zero.time)).then_some(zero));
                parts.push(piece_of(std::mem::replace(&mut piece, vec![zero])));
            }
            piece.push(point);
        }
        parts.push(piece_of(piece));
        parts
    }
}

impl Point {
    fn at_zero_towards(self, to: Self) -> Self {
        let share = self.state / (self.state - to.state);
        let between = |from: f64, to: f64| from + share * (to - from);
        Self { time: between(self.time, to.time), state: 0.0, rate: between(self.rate, to.rate) }
    }

    fn mean_rate_to(self, to: Self) -> f64 {
        (to.state - self.state) / (to.time - self.time)
    }

    /// The state at a time on the straight line to another point.
    fn state_towards(self, to: Self, time: f64) -> f64 {
        self.state + self.mean_rate_to(to) * (time - self.time)
    }
}

fn points(runs: &[Run]) -> impl Iterator<Item = &Point> {
    runs.iter().flat_map(|run| &run.points)
}

/// The state at the start.
fn start(runs: &[Run]) -> Option<f64> {
    points(runs).next().map(|point| point.state)
}

/// Whether nothing changes but in jumps.
fn is_level(runs: &[Run]) -> bool {
    points(runs).all(|point| point.rate == 0.0)
}

fn mapped(runs: &[Run], height: impl Fn(Point) -> f64) -> Heights {
    runs.iter().map(|run| run.points.iter().map(|point| height(*point)).collect()).collect()
}

/// Heights by the ends of the stage to which a point belongs.
fn by_stretch(runs: &[Run], height: impl Fn([Point; 2], Point) -> f64) -> Heights {
    let heights = |run: &Run| {
        let in_stretch = || runs.iter().filter(|other| other.stretch == run.stretch).flat_map(|other| &other.points);
        let ends = in_stretch().next().zip(in_stretch().next_back());
        let height = |point: &Point| ends.map_or(f64::NAN, |(first, last)| height([*first, *last], *point));
        run.points.iter().map(height).collect()
    };
    runs.iter().map(heights).collect()
}

/// Every force has the opposite direction: each stage changes the state by as much the other way, and a jump by the same factor.
fn reversed(runs: &[Run]) -> Option<Heights> {
    if is_level(runs) {
        return None;
    }
    let mut heights: Heights = Vec::new();
    // A state of the right curve, and what is drawn in its place.
    let mut drawn: Option<[f64; 2]> = None;
    for run in runs {
        let (first, last) = (run.points.first()?.state, run.points.last()?.state);
        let from = drawn.map_or(first, |[state, drawn_first]| match first - state {
            0.0 => drawn_first,
            _ if state == 0.0 => first,
            _ => drawn_first * first / state,
        });
        let turned = |state: f64| from - (state - first);
        heights.push(run.points.iter().map(|point| turned(point.state)).collect());
        drawn = Some([last, turned(last)]);
    }
    Some(heights)
}

/// After each jump that turns the state round, it keeps its sign.
fn rebound_overlooked(runs: &[Run]) -> Option<Heights> {
    let mut shift = 0.0;
    let mut before: Option<f64> = None;
    let mut is_overlooked = false;
    let mut heights: Heights = Vec::new();
    for run in runs {
        let (first, last) = (run.points.first()?.state, run.points.last()?.state);
        if let Some(state) = before.filter(|state| state * first < 0.0) {
            shift = f64::copysign(first, state + shift) - first;
            is_overlooked = true;
        }
        heights.push(run.points.iter().map(|point| point.state + shift).collect());
        before = Some(last);
    }
    is_overlooked.then_some(heights)
}

/// The areas under the states so far.
fn added_up(runs: &[Run]) -> Heights {
    let mut area = 0.0;
    let mut before: Option<Point> = None;
    let mut add = |point: &Point| {
        area += before.map_or(0.0, |before| (point.time - before.time) * f64::midpoint(point.state, before.state));
        before = Some(*point);
        area
    };
    runs.iter().map(|run| run.points.iter().map(&mut add).collect()).collect()
}

fn largest(heights: &[Vec<f64>]) -> f64 {
    heights.iter().flatten().fold(0.0, |largest, height| height.abs().max(largest))
}

/// The heights to another scale; none where all are zero.
fn scaled(heights: Heights, to: f64) -> Option<Heights> {
    let size = largest(&heights);
    (size > 0.0)
        .then(|| heights.into_iter().map(|run| run.into_iter().map(|height| height * to / size).collect()).collect())
}

fn curve(runs: &[Run], heights: &[Vec<f64>]) -> Curve {
    let piece = |(run, heights): (&Run, &Vec<f64>)| {
        run.points.iter().zip(heights).map(|(point, height)| [point.time, *height]).collect()
    };
    Curve { pieces: runs.iter().zip(heights).map(piece).collect() }
}
