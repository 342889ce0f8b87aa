//! One step of a world by the pair of order 5, and the sizes by which its error is measured.

use nalgebra::Matrix;

use crate::ode::{FIFTH, Step};
use crate::state::{State, Vector};
use crate::world::World;

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

/// A step of a world that is tried.
#[derive(Clone)]
pub(super) struct Trial<const D: usize> {
    /// The state at its end.
    pub state: State<D>,
    /// The estimated error over what is tolerated.
    pub error: f64,
    /// The positions on the way: coefficients of 1, s, ..., s^4, where s goes from 0 to 1.
    pub dense: Vec<[Vector<D>; 5]>,
    step: Step<7>,
    /// The places and then the velocities of the start.
    start: Vec<f64>,
    pulls: Vec<Vector<D>>,
}

impl<const D: usize> Trial<D> {
    pub(super) fn new(start: &State<D>) -> Self {
        let bodies = start.positions.len();
        let (step, dense) = (Step::new(&FIFTH, 2 * D * bodies), vec![[Vector::zeros(); 5]; bodies]);
        let flat = vec![0.0; 2 * D * bodies];
        Self { state: start.clone(), error: 0.0, dense, step, start: flat, pulls: vec![Vector::zeros(); bodies] }
    }

    /// The number of times that the forces were worked out.
    pub(super) fn evaluations(&self) -> usize {
        self.step.evaluations
    }

    /// Forgets the slopes of the start: a force has another law, or a body another velocity.
    pub(super) fn begin_anew(&mut self) {
        self.step.begin_anew();
    }

    /// The last stage of an accepted step is the first of the next one.
    pub(super) fn accepted(&mut self) {
        self.step.accepted();
    }

    /// Tries a step; `stop` is a time at which forces change, which no stage may reach.
    pub(super) fn step(
        &mut self,
        world: &World<D>,
        start: &State<D>,
        length: f64,
        (tolerance, sizes): (f64, &Sizes<D>),
        stop: f64,
    ) {
        let Self { state, step, start: flat, pulls, .. } = self;
        let half = flat.len() / 2;
        flatten(&start.positions, &mut flat[..half]);
        flatten(&start.velocities, &mut flat[half..]);
        step.take((start.time, flat), length, |time, numbers, slope| {
            state.time = time.min(stop.next_down());
            unflatten(&numbers[..half], &mut state.positions);
            unflatten(&numbers[half..], &mut state.velocities);
            world.accelerate(state, pulls);
            slope[..half].copy_from_slice(&numbers[half..]);
            flatten(pulls, &mut slope[half..]);
        });
        state.time = start.time + length;
        let (way, speed) = sizes.with(state);
        let error = step.error(length, |place| tolerance * if place < half { way } else { speed });
        self.error = if error.is_finite() { error } else { GONE };
        for (body, dense) in self.dense.iter_mut().enumerate() {
            for part in 0..D {
                let quartic = step.within(flat, length, body * D + part);
                dense.iter_mut().zip(quartic).for_each(|(vector, value)| vector[part] = value);
            }
        }
    }
}

/// The error of a step that leads nowhere.
const GONE: f64 = 1e10;

fn flatten<const D: usize>(vectors: &[Vector<D>], numbers: &mut [f64]) {
    for (vector, part) in vectors.iter().zip(numbers.chunks_exact_mut(D)) {
        part.copy_from_slice(vector.as_slice());
    }
}

fn unflatten<const D: usize>(numbers: &[f64], vectors: &mut [Vector<D>]) {
    for (vector, part) in vectors.iter_mut().zip(numbers.chunks_exact(D)) {
        vector.copy_from_slice(part);
    }
}
