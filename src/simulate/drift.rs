//! Drift: how much of the energy and the momentum that a motion keeps is left after a thousand to a million bounces and periods.

use std::time::Instant;

use super::budget::{Budget, Keep};
use super::force::Force;
use super::methods::{MethodKind, Setting};
use super::state::{State, Vector};
use super::world::{Anchor, Body, Cord, Wall, World};

/// Steps to a period of the motion, for the methods that have steps.
const STEPS_PER_PERIOD: f64 = 200.0;

/// The error of a step, for the method that chooses its steps.
const TOLERANCE: f64 = 1e-9;

/// The numbers of periods after which the drift is measured.
const PERIODS: [u32; 4] = [1_000, 10_000, 100_000, 1_000_000];

/// A method whose run takes longer than this, in s, is not run for ten times as many periods.
const LONGEST: f64 = 2.0;

/// A motion that goes on for ever, as tables call it, and the momentum that it keeps beside the energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LastingMotion {
    /// Its name.
    pub name: &'static str,
    /// The kind of momentum; `None` where something from outside changes it.
    pub momentum: Option<&'static str>,
}

const BOUNCES: LastingMotion = LastingMotion { name: "bounces", momentum: None };
const TIED_BALLS: LastingMotion = LastingMotion { name: "tied balls", momentum: Some("momentum") };
const ORBITS: LastingMotion = LastingMotion { name: "orbits", momentum: Some("angular momentum") };

/// All of them.
pub const LASTING_MOTIONS: [LastingMotion; 3] = [BOUNCES, TIED_BALLS, ORBITS];

/// A motion as a world, and the measures that stay as they are in it.
struct Lasting<const D: usize> {
    motion: LastingMotion,
    world: World<D>,
    /// In s.
    period: f64,
    /// The energy in J.
    energy: fn(&World<D>, &State<D>) -> f64,
    /// The momentum in N s, or the angular momentum in N m s; `None` where something from outside changes it.
    momentum: Option<fn(&World<D>, &State<D>) -> f64>,
}

/// One method after so many periods of one motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Drift {
    /// The motion.
    pub motion: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its step in s, or its tolerance; `None` where it has no setting.
    pub setting: Option<f64>,
    /// The number of periods.
    pub periods: u32,
    /// The time of the run in s.
    pub seconds: f64,
    /// The change of the energy, as a part of it; `None` where the run was refused or given up.
    pub energy: Option<f64>,
    /// The change of the momentum, or of the angular momentum, as a part of it.
    pub momentum: Option<f64>,
    /// The name of the refusal.
    pub refusal: Option<String>,
}

/// Runs every method for up to so many periods of every motion; `done` is called after each of the [`drifts_of`] runs or what is left out.
///
/// ```
/// use momentous_simulate::drifts;
///
/// let all = drifts(1_000, &mut || ());
/// let of = |method| all.iter().find(|drift| drift.motion == "orbits" && drift.method == method).unwrap();
/// assert!(of("event driven").energy.unwrap() < 1e-12);
/// // A symplectic method has a wrong energy, which stays within bounds; explicit Euler gains more and more.
/// assert!(of("symplectic Euler").energy.unwrap() < 0.1);
/// assert!(of("explicit Euler").energy.unwrap() > 0.1);
/// ```
#[must_use]
pub fn drifts(most_periods: u32, done: &mut dyn FnMut()) -> Vec<Drift> {
    let mut all = Vec::new();
    for motion in [bounces(), tied_balls()] {
        run_all(&motion, most_periods, done, &mut all);
    }
    run_all(&orbits(), most_periods, done, &mut all);
    all
}

/// The number of runs for up to so many periods.
#[must_use]
pub fn drifts_of(most_periods: u32) -> usize {
    LASTING_MOTIONS.len() * methods().count() * PERIODS.iter().filter(|periods| **periods <= most_periods).count()
}

/// The methods that go through many periods.
fn methods() -> impl Iterator<Item = MethodKind> {
    MethodKind::ALL.iter().copied().filter(|method| !matches!(method, MethodKind::ClosedForm | MethodKind::LinearSolve))
}

fn run_all<const D: usize>(motion: &Lasting<D>, most_periods: u32, done: &mut dyn FnMut(), all: &mut Vec<Drift>) {
    for method in methods() {
        let mut goes_on = true;
        for periods in PERIODS.into_iter().filter(|periods| *periods <= most_periods) {
            if goes_on {
                let drift = measured(motion, method, periods);
                goes_on = drift.energy.is_some() && drift.seconds < LONGEST;
                all.push(drift);
            }
            done();
        }
    }
}

fn measured<const D: usize>(motion: &Lasting<D>, method: MethodKind, periods: u32) -> Drift {
    let value = match method.setting() {
        Setting::None => 0.0,
        Setting::Tolerance => TOLERANCE,
        Setting::Step => motion.period / STEPS_PER_PERIOD,
    };
    let setting = (method.setting() != Setting::None).then_some(value);
    let until = motion.period * f64::from(periods);
    let budget = Budget::until(until).at_most(usize::MAX).steps(usize::MAX).keep(Keep::Count);
    let start = Instant::now();
    let run = method.with::<D>(value).run(&motion.world, &budget);
    let seconds = start.elapsed().as_secs_f64();
    let first = motion.world.start();
    let changed = |measure: fn(&World<D>, &State<D>) -> f64, last: &State<D>| {
        let [before, after] = [&first, last].map(|state| measure(&motion.world, state));
        ((after - before) / before).abs()
    };
    let last = run.as_ref().ok().map(|run| &run.last);
    Drift {
        motion: motion.motion.name,
        method: method.name(),
        setting,
        periods,
        seconds,
        energy: last.map(|last| changed(motion.energy, last)),
        momentum: last.and_then(|last| motion.momentum.map(|momentum| changed(momentum, last))),
        refusal: run.as_ref().err().map(|refusal| refusal.name().to_owned()),
    }
}

/// g in m/s².
const GRAVITY: f64 = 9.81;

/// A ball that is dropped from 1 m and bounces with e = 1, from top to top.
fn bounces() -> Lasting<1> {
    let mut world = World::new(1.0);
    world.gravity = Vector::from([-GRAVITY]);
    world.bodies.push(Body::particle("ball", 1.0, [1.0], [0.0]));
    world.walls.push(Wall::new("floor", [1.0], 0.0));
    let energy = |world: &World<1>, state: &State<1>| {
        world.kinetic_energy(&state.velocities) + world.bodies[0].mass * GRAVITY * state.positions[0].x
    };
    Lasting { motion: BOUNCES, world, period: 2.0 * (2.0 / GRAVITY).sqrt(), energy, momentum: None }
}

/// Two balls of 2 kg and 1 kg on a cord of 1 m: with e = 1 they meet, part, and meet again after the cord was taut.
fn tied_balls() -> Lasting<1> {
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("A", 2.0, [0.0], [1.0]));
    world.bodies.push(Body::particle("B", 1.0, [0.5], [0.25]));
    world.cords.push(Cord { name: "cord".to_owned(), from: Anchor::Body(0), to: 1, length: 1.0, restitution: 1.0 });
    // There and back, at a relative speed of 0.75 m/s.
    let period = 2.0 / 0.75;
    let energy = |world: &World<1>, state: &State<1>| world.kinetic_energy(&state.velocities);
    let momentum = |world: &World<1>, state: &State<1>| world.momentum(&state.velocities).x;
    Lasting { motion: TIED_BALLS, world, period, energy, momentum: Some(momentum) }
}

/// An orbit of eccentricity 1/2, from perigee to perigee.
fn orbits() -> Lasting<2> {
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("satellite", 1.0, [1.0, 0.0], [0.0, 1.5_f64.sqrt()]));
    world.forces.push(Force::Central { body: 0, centre: Vector::zeros(), parameter: 1.0 });
    let energy = |world: &World<2>, state: &State<2>| {
        world.kinetic_energy(&state.velocities) - world.bodies[0].mass / state.positions[0].norm()
    };
    let momentum =
        |world: &World<2>, state: &State<2>| world.bodies[0].mass * state.positions[0].perp(&state.velocities[0]);
    let period = std::f64::consts::TAU * 8.0_f64.sqrt();
    Lasting { motion: ORBITS, world, period, energy, momentum: Some(momentum) }
}
