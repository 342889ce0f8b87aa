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
        (self.way, self.speed) = self.with(state);
    }

    /// The longest way and the greatest speed, with those of a state.
    fn with(&self, state: &State<D>) -> (f64, f64) {
        let ways = state.positions.iter().zip(&self.from).map(|(place, from)| (place - from).amax());
        let speeds = state.velocities.iter().map(Matrix::amax);
        (ways.fold(self.way, f64::max), speeds.fold(self.speed, f64::max))
    }
}

/// A step of a world that is tried: its slopes, which the next one begins with where it goes on from here, and what is read off them.
#[derive(Clone, Debug)]
pub(super) struct Trial<const D: usize> {
    /// The state at its end.
    pub state: State<D>,
    /// The estimated error over what is tolerated.
    pub error: f64,
    /// The positions on the way: coefficients of 1, s, ..., s^4, where s goes from 0 to 1.
    pub dense: Vec<[Vector<D>; 5]>,
    /// The number of times that the forces were worked out.
    pub evaluations: usize,
    speeds: [Vec<Vector<D>>; STAGES.len()],
    pulls: [Vec<Vector<D>>; STAGES.len()],
    /// Whether the slopes of the first stage are those of the start.
    begun: bool,
}

impl<const D: usize> Trial<D> {
    pub(super) fn new(start: &State<D>) -> Self {
        let none = || core::array::from_fn(|_| vec![Vector::zeros(); start.positions.len()]);
        let (state, dense) = (start.clone(), vec![[Vector::zeros(); 5]; start.positions.len()]);
        Self { state, error: 0.0, dense, evaluations: 0, speeds: none(), pulls: none(), begun: false }
    }

    /// Forgets the slopes of the start: a force has another law, or a body another velocity.
    pub(super) fn begin_anew(&mut self) {
        self.begun = false;
    }

    /// The last stage of an accepted step is the first of the next one.
    pub(super) fn accepted(&mut self) {
        self.speeds.swap(0, STAGES.len() - 1);
        self.pulls.swap(0, STAGES.len() - 1);
        self.begun = true;
    }

    /// Tries a step; `stop` is a time at which forces change, which no stage may reach.
    #[allow(clippy::needless_range_loop, reason = "stages and bodies are numbered in the formulas")]
    pub(super) fn step(
        &mut self,
        world: &World<D>,
        start: &State<D>,
        length: f64,
        (tolerance, sizes): (f64, &Sizes<D>),
        stop: f64,
    ) {
        let bodies = world.bodies.len();
        for stage in usize::from(self.begun)..STAGES.len() {
            self.state.time = (start.time + NODES[stage] * length).min(stop.next_down());
            for body in 0..bodies {
                let (mut position, mut velocity) = (Vector::zeros(), Vector::zeros());
                for (before, weight) in STAGES[stage].iter().enumerate() {
                    position += self.speeds[before][body] * *weight;
                    velocity += self.pulls[before][body] * *weight;
                }
                self.state.positions[body] = start.positions[body] + position * length;
                self.state.velocities[body] = start.velocities[body] + velocity * length;
            }
            world.accelerate(&self.state, &mut self.pulls[stage]);
            self.speeds[stage].copy_from_slice(&self.state.velocities);
            self.evaluations += 1;
        }
        self.begun = true;
        self.state.time = start.time + length;
        let weighted = |slopes: &[Vec<Vector<D>>; STAGES.len()], weights: &[f64; 7], body: usize| {
            let terms = slopes.iter().zip(weights).map(|(slope, weight)| slope[body] * *weight);
            terms.sum::<Vector<D>>() * length
        };
        let (way, speed) = sizes.with(&self.state);
        self.error = 0.0;
        for body in 0..bodies {
            for (slopes, size) in [(&self.speeds, way), (&self.pulls, speed)] {
                let error = weighted(slopes, &ERROR, body).amax();
                if error != 0.0 {
                    let part = error / (tolerance * size);
                    self.error = if part.is_finite() { self.error.max(part) } else { 1e10 };
                }
            }
            let change = self.state.positions[body] - start.positions[body];
            let bend = self.speeds[0][body] * length - change;
            let third = change - self.speeds[6][body] * length - bend;
            let fourth = weighted(&self.speeds, &DENSE, body);
            // c1 + s (c2 + (1 - s)(c3 + s (c4 + (1 - s) c5)))
            self.dense[body] =
                [start.positions[body], change + bend, -bend + third + fourth, -third - fourth * 2.0, fourth];
        }
    }
}
