//! The scenes of the suite. Expected values are exact fractions, or come from closed forms in 30 digits and more.

use crate::budget::Budget;
use crate::force::Force;
use crate::state::Vector;
use crate::trajectory::{Ending, Trajectory};
use crate::world::{Body, Wall, World};

use super::Trial;

/// g in m/s².
pub(super) const GRAVITY: f64 = 9.81;

/// The scenes on a line.
pub(super) fn on_a_line() -> Vec<Trial<1>> {
    [zeno(), bounces(), collapses(), cradles(), walls(), roots()].into_iter().flatten().collect()
}

pub(super) type Measure<const D: usize> = Box<dyn Fn(&Trajectory<D>) -> Option<f64>>;

pub(super) fn trial<const D: usize>(
    name: &'static str,
    world: World<D>,
    budget: Budget,
    measure: Measure<D>,
    expected: f64,
    tolerance: f64,
) -> Trial<D> {
    Trial { name, world, budget, step: 1e-3, measure, expected, tolerance }
}

/// A ball over a floor.
pub(super) fn dropped(height: f64, restitution: f64) -> World<1> {
    let mut world = World::new(restitution);
    world.gravity = Vector::from([-GRAVITY]);
    world.bodies.push(Body::particle("ball", 1.0, [height], [0.0]));
    world.walls.push(Wall::new("floor", [1.0], 0.0));
    world
}

/// Beads on a line: mass, place, velocity.
pub(super) fn beads(restitution: f64, beads: &[(f64, f64, f64)]) -> World<1> {
    let mut world = World::new(restitution);
    for (name, (mass, place, velocity)) in ["A", "B", "C", "D", "E"].iter().zip(beads) {
        world.bodies.push(Body::particle(name, *mass, [*place], [*velocity]));
    }
    world
}

#[allow(clippy::cast_precision_loss, reason = "counts of impacts are small")]
fn count() -> Measure<1> {
    Box::new(|run| Some(run.impact_count as f64))
}

pub(super) fn speed_of(body: usize) -> Measure<1> {
    Box::new(move |run| Some(run.last.velocities[body].x))
}

pub(super) fn time_of_last() -> Measure<1> {
    Box::new(|run| run.impacts.last().map(|impact| impact.time))
}

fn zeno() -> Vec<Trial<1>> {
    let rest: Measure<1> = Box::new(|run| match run.ending {
        Ending::Rest { time, .. } => Some(time),
        _ => None,
    });
    let slow = Trial {
        step: 5e-2,
        ..trial(
            "Zeno: bounce 10000 at e = 0.999",
            dropped(4.0, 0.999),
            Budget::until(1806.0).at_most(10_000),
            time_of_last(),
            1_805.109_929_326_35,
            1e-13,
        )
    };
    let end = Budget::until(7.0).steps(200_000);
    vec![trial("Zeno: the end of all bounces", dropped(4.0, 0.75), end, rest, 6.321_330_973_80, 1e-11), slow]
}

fn bounces() -> Vec<Trial<1>> {
    let mut drag = dropped(4.0, 0.75);
    drag.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / 400.0 });
    let fifth = Budget::until(10.0).at_most(5);
    vec![
        trial("bounce: time of the fifth", dropped(4.0, 0.75), fifth, time_of_last(), 4.606_952_149_432_536, 1e-12),
        trial("bounce with drag: time of the fifth", drag, fifth, time_of_last(), 4.257_661_947_038_265, 1e-9),
    ]
}

fn collapses() -> Vec<Trial<1>> {
    let three = |e| beads(e, &[(1.0, 0.0, 1.0), (1.0, 1.0, 0.0), (1.0, 2.5, -1.0)]);
    let until = Budget::until(10.0);
    vec![
        trial("collapse: impacts at e = 0.073", three(0.073), until, count(), 27.0, 0.0),
        trial("collapse: impacts at e = 0.1", three(0.1), until, count(), 6.0, 0.0),
        trial("collapse: at e = 0.05", three(0.05), until, Box::new(|_| None), f64::NAN, 0.0),
    ]
}

fn cradles() -> Vec<Trial<1>> {
    let apart = |e, number: usize| {
        let places = [(1.0, 0.0, 1.0), (1.0, 1.0, 0.0), (1.0, 2.0, 0.0), (1.0, 3.0, 0.0), (1.0, 4.0, 0.0)];
        beads(e, &places[..number])
    };
    let mut touching = apart(1.0, 3);
    for ball in &mut touching.bodies {
        ball.radius = 0.5;
    }
    let until = Budget::until(200.0);
    let mut all = vec![
        trial("cradle: 3 balls, e = 0.9, the last", apart(0.9, 3), until, speed_of(2), 361.0 / 400.0, 1e-14),
        trial("cradle: 3 balls, e = 0.5, the first", apart(0.5, 3), until, speed_of(0), 13.0 / 64.0, 1e-14),
        trial("cradle: 5 balls, e = 0.5, impacts", apart(0.5, 5), until, count(), 10.0, 0.0),
        trial("cradle: 5 balls, e = 0.5, the first", apart(0.5, 5), until, speed_of(0), 2521.0 / 16384.0, 1e-14),
        trial("cradle: 3 balls that touch", touching, Budget::until(1.0), speed_of(2), 2.0 / 3.0, 1e-14),
    ];
    for trial in &mut all {
        trial.step = 1e-2;
    }
    all
}

fn walls() -> Vec<Trial<1>> {
    let galperin = |ratio| {
        let mut world = beads(1.0, &[(1.0, 1.0, 0.0), (ratio, 2.0, -1.0)]);
        world.walls.push(Wall::new("wall", [1.0], 0.0));
        world
    };
    let shot = |speed: f64| {
        let mut world = World::<1>::new(1.0);
        world.bodies.push(Body::sphere("ball", 0.001, 0.0025, [1.0], [-speed]));
        world.walls.push(Wall::new("wall", [1.0], 0.0).thick(0.01));
        world
    };
    let back = |name, speed: f64| {
        let until = 2.0 * (1.0 - 0.0025) / speed + 0.1 / speed;
        let place: Measure<1> = Box::new(|run| Some(run.last.positions[0].x));
        Trial { step: 1.0 / 240.0, ..trial(name, shot(speed), Budget::until(until), place, 1.1, 1e-13) }
    };
    let earth = beads(0.8, &[(5.97e24, 0.0, 0.0), (0.25, 1.0, -10.0)]);
    let until = Budget::until(10.0);
    vec![
        trial("mass ratio 100: impacts", galperin(1e2), until, count(), 31.0, 0.0),
        trial("mass ratio 10^4: impacts", galperin(1e4), until, count(), 314.0, 0.0),
        trial("mass ratio 10^6: impacts", galperin(1e6), until, count(), 3141.0, 0.0),
        back("tunnelling at 50 m/s", 50.0),
        back("tunnelling at 100 m/s", 100.0),
        back("tunnelling at 300 m/s", 300.0),
        trial("the Earth as a wall", earth, Budget::until(1.0), speed_of(1), 8.0, 1e-15),
    ]
}

fn roots() -> Vec<Trial<1>> {
    let ceiling = |height: f64| {
        let mut world = World::<1>::new(0.5);
        world.gravity = Vector::from([-GRAVITY]);
        world.bodies.push(Body::particle("ball", 1.0, [0.0], [10.0]));
        world.walls.push(Wall::new("ceiling", [-1.0], -height));
        world
    };
    let mut close = dropped(1e-12, 0.5);
    close.bodies[0].velocity = Vector::from([-3.0]);
    let equal = beads(0.7, &[(1.0, 0.0, 1000.001), (1.0, 1e-4, 1000.0)]);
    let lost: Measure<1> = Box::new(|run| run.impacts.first().map(|impact| impact.energy_lost));
    let first: fn() -> Measure<1> = || Box::new(|run| run.impacts.first().map(|impact| impact.time));
    let once = Budget::until(1.5).at_most(1);
    vec![
        trial("ceiling at 5 m", ceiling(5.0), once, first(), 0.878_857_810_886, 1e-12),
        trial("ceiling at 5.09 m", ceiling(5.09), once, first(), 0.982_025_159_869, 1e-12),
        // 2 h / (v + sqrt(v^2 + 2 g h)), whose second term is 1e-12 of the first
        trial("small root", close, once, first(), 1e-12 / 3.0, 1e-11),
        trial("nearly equal speeds: energy lost", equal, once, lost, 1.275e-7, 1e-9),
    ]
}

/// An orbit about the origin from a perigee, where it goes at right angles.
pub(super) fn orbit(radius: f64, speed: f64) -> World<2> {
    let mut world = World::<2>::new(1.0);
    world.bodies.push(Body::particle("satellite", 1.0, [radius, 0.0], [0.0, speed]));
    world.forces.push(Force::Central { body: 0, centre: Vector::zeros(), parameter: 1.0 });
    world
}

/// The scenes in the plane.
pub(super) fn in_the_plane() -> Vec<Trial<2>> {
    let energy: Measure<2> =
        Box::new(|run| Some(run.last.velocities[0].norm_squared() / 2.0 - 1.0 / run.last.positions[0].norm()));
    let distance: fn() -> Measure<2> = || Box::new(|run| Some(run.last.positions[0].norm()));
    let tau = std::f64::consts::TAU;
    let circle = Trial {
        step: tau / 100.0,
        ..trial("circular orbit, 10 turns: energy", orbit(1.0, 1.0), Budget::until(10.0 * tau), energy, -0.5, 1e-8)
    };
    // Half a period of the ellipse with perigee 1 and eccentricity 1/2: its apogee 3.
    let half = tau / 2.0 * 8.0_f64.sqrt();
    let near = 2.0_f64.sqrt();
    let nearly = libm::sqrt(2.0 - 1e-10);
    // d = 2^-40 is exact, so that the positions hold it: the struck disc leaves at cos = sqrt(d (2 - d)).
    let d = 2.0_f64.powi(-40);
    let mut grazing = World::<2>::new(1.0);
    grazing.bodies.push(Body::sphere("A", 1.0, 0.5, [-1.5, 0.0], [1.0, 0.0]));
    grazing.bodies.push(Body::sphere("B", 1.0, 0.5, [0.0, 1.0 - d], [0.0, 0.0]));
    let struck: Measure<2> = Box::new(|run| Some(run.last.velocities[1].norm()));
    vec![
        circle,
        trial("Kepler: apogee of e = 1/2", orbit(1.0, 1.5_f64.sqrt()), Budget::until(half), distance(), 3.0, 1e-9),
        trial("parabola, t = 2", orbit(1.0, near), Budget::until(2.0), distance(), 2.080_859_460_392_876_5, 1e-10),
        trial("e = 1 - 1e-10, t = 2", orbit(1.0, nearly), Budget::until(2.0), distance(), 2.080_859_460_306_794, 1e-10),
        trial("grazing discs", grazing, Budget::until(3.0), struck, (d * (2.0 - d)).sqrt(), 1e-12),
    ]
}
