//! One step of the pair of Dormand and Prince (1980), with the error and the interpolant of order 4 (Hairer, Nørsett, Wanner).

use nalgebra::Matrix;

use crate::state::{State, Vector};
use crate::world::World;

/// The times of the stages, as parts of the step.
pub(crate) const NODES: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

/// The weights of the slopes before each stage; the last stage is the step of order 5.
pub(crate) const STAGES: [&[f64]; 7] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// The difference of the weights of order 5 and 4.
pub(crate) const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];

/// The weights of the interpolant's last term.
const DENSE: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// The greatest sizes so far, by which errors are measured: a scene of micrometres is as accurate as one of kilometres.
#[derive(Clone, Debug)]
pub(super) struct Sizes<const D: usize> {
    from: Vec<Vector<D>>,
    /// How far a body went from where it started, in m.
    way: f64,
    /// How fast one was, in m/s.
    speed: f64,
}

impl<const D: usize> Sizes<D> {
    pub(super) fn of(start: &State<D>) -> Self {
        let mut sizes = Self { from: start.positions.clone(), way: 0.0, speed: 0.0 };
        sizes.see(start);
        sizes
    }

    /// Takes a state into account.
    pub(super) fn see(&mut self, state: &State<D>) {
        let ways = state.positions.iter().zip(&self.from).map(|(place, from)| (place - from).amax());
        self.way = ways.fold(self.way, f64::max);
        self.speed = state.velocities.iter().map(Matrix::amax).fold(self.speed, f64::max);
    }
}

/// A step that may be accepted.
pub(super) struct Trial<const D: usize> {
    /// The state at its end.
    pub state: State<D>,
    /// The estimated error over what is tolerated.
    pub error: f64,
    /// The positions on the way: coefficients of 1, s, ..., s^4, where s goes from 0 to 1.
    pub dense: Vec<[Vector<D>; 5]>,
}

/// Tries a step; `stop` is a time at which forces change, which no stage may reach.
#[allow(clippy::needless_range_loop, reason = "stages and bodies are numbered in the formulas")]
pub(super) fn trial<const D: usize>(
    world: &World<D>,
    start: &State<D>,
    length: f64,
    (tolerance, sizes): (f64, &Sizes<D>),
    stop: f64,
) -> Trial<D> {
    let bodies = world.bodies.len();
    let mut speeds: Vec<Vec<Vector<D>>> = Vec::with_capacity(7);
    let mut pulls: Vec<Vec<Vector<D>>> = Vec::with_capacity(7);
    let mut state = start.clone();
    for stage in 0..7 {
        state.time = (start.time + NODES[stage] * length).min(stop.next_down());
        for body in 0..bodies {
            let (mut position, mut velocity) = (Vector::zeros(), Vector::zeros());
            for (before, weight) in STAGES[stage].iter().enumerate() {
                position += speeds[before][body] * *weight;
                velocity += pulls[before][body] * *weight;
            }
            state.positions[body] = start.positions[body] + position * length;
            state.velocities[body] = start.velocities[body] + velocity * length;
        }
        pulls.push(world.accelerations(&state));
        speeds.push(state.velocities.clone());
    }
    state.time = start.time + length;
    let weighted = |slopes: &[Vec<Vector<D>>], weights: &[f64; 7], body: usize| {
        let terms = slopes.iter().zip(weights).map(|(slope, weight)| slope[body] * *weight);
        terms.sum::<Vector<D>>() * length
    };
    let mut worst = 0.0_f64;
    let mut dense = Vec::with_capacity(bodies);
    let mut sizes = sizes.clone();
    sizes.see(&state);
    for body in 0..bodies {
        for (slopes, size) in [(&speeds, sizes.way), (&pulls, sizes.speed)] {
            let error = weighted(slopes, &ERROR, body).amax();
            if error != 0.0 {
                let part = error / (tolerance * size);
                worst = if part.is_finite() { worst.max(part) } else { 1e10 };
            }
        }
        let change = state.positions[body] - start.positions[body];
        let bend = speeds[0][body] * length - change;
        let third = change - speeds[6][body] * length - bend;
        let fourth = weighted(&speeds, &DENSE, body);
        // c1 + s (c2 + (1 - s)(c3 + s (c4 + (1 - s) c5)))
        dense.push([start.positions[body], change + bend, -bend + third + fourth, -third - fourth * 2.0, fourth]);
    }
    Trial { state, error: worst, dense }
}
