//! Scenes on which methods are known to break: infinitely many impacts, contacts that coincide or nearly do, slow and small motions,
//! forces of an instant, and motions that lose their digits. Expected values are from event by event in 120 digits.

use std::sync::Arc;

use crate::budget::Budget;
use crate::force::{Force, Strength};
use crate::state::Vector;
use crate::trajectory::Trajectory;
use crate::world::{Body, Wall, World};

use super::Trial;
use super::scenes::{GRAVITY, Measure, beads, dropped, orbit, speed_of, time_of_last, trial};

/// A scene without an answer: whatever a method says is wrong, unless it refuses.
fn nothing<const D: usize>() -> Measure<D> {
    Box::new(|_: &Trajectory<D>| None)
}

pub(super) fn on_a_line() -> Vec<Trial<1>> {
    [moving_walls(), touching_walls(), nearly_at_once(), without_return(), long(), small()]
        .into_iter()
        .flatten()
        .collect()
}

fn moving_walls() -> Vec<Trial<1>> {
    let mut rising = dropped(4.0, 0.75);
    rising.walls[0].velocity = 0.5;
    let mut squeezed = World::<1>::new(1.0);
    squeezed.bodies.push(Body::particle("ball", 1.0, [0.5], [1.0]));
    squeezed.walls.push(Wall::new("left", [1.0], 0.0).moving(0.1));
    squeezed.walls.push(Wall::new("right", [-1.0], -1.0).moving(0.1));
    let (fifth, fiftieth) = (Budget::until(10.0).at_most(5), Budget::until(4.9).at_most(50));
    let past = Budget::until(6.0).at_most(2_000);
    vec![
        trial("rising floor: the fifth bounce", rising, fifth, time_of_last(), 4.563_315_696_022_77, 1e-12),
        trial("squeezed: the 50th impact", squeezed.clone(), fiftieth, time_of_last(), 4.541_284_403_669_724, 1e-12),
        trial("squeezed: past the end", squeezed, past, nothing(), f64::NAN, 0.0),
    ]
}

/// 4 m/s upwards at 8 m/s² turn at 1 m, exactly.
fn touching_walls() -> Vec<Trial<1>> {
    let ceiling = |height: f64| {
        let mut world = World::<1>::new(0.5);
        world.gravity = Vector::from([-8.0]);
        world.bodies.push(Body::particle("ball", 1.0, [0.0], [4.0]));
        world.walls.push(Wall::new("ceiling", [-1.0], -height));
        world
    };
    let until = Budget::until(0.9);
    vec![
        trial("ceiling just touched", ceiling(1.0), until, speed_of(0), 4.0 - 8.0 * 0.9, 1e-13),
        trial("ceiling touched by 1e-12 m", ceiling(1.0 - 1e-12), until, speed_of(0), -3.200_005_999_933_634_6, 1e-12),
    ]
}

fn nearly_at_once() -> Vec<Trial<1>> {
    let three = |apart: f64| beads(0.8, &[(1.0, -2.0, 1.0), (1.0, 0.0, 0.0), (1.0, 2.0 + apart, -1.0)]);
    let until = Budget::until(3.0);
    vec![
        trial("three at once but for 1e-9 m", three(1e-9), until, speed_of(0), -0.719, 1e-13),
        trial("three at once but for 1e-12 m", three(1e-12), until, speed_of(0), -0.719, 1e-13),
        trial("three at once but for 1e-15 m", three(1e-15), until, speed_of(0), -0.719, 1e-13),
        trial("three at once", three(0.0), until, nothing(), f64::NAN, 0.0),
    ]
}

/// Heights and speeds are asked for with 1 added, where they are 0.
fn without_return() -> Vec<Trial<1>> {
    let height: Measure<1> = Box::new(|run| Some(1.0 + run.last.positions[0].x));
    let speed: Measure<1> = Box::new(|run| Some(1.0 + run.last.velocities[0].x));
    let mut pair = beads(0.0, &[(1.0, 0.5, 0.0), (1.0, 1.0, -1.0)]);
    pair.walls.push(Wall::new("wall", [1.0], 0.0));
    let mut blocks = beads(0.5, &[(1.0, 1.0, 0.0), (1e8, 2.0, -1.0)]);
    blocks.walls.push(Wall::new("wall", [1.0], 0.0));
    let third = Budget::until(2.0).at_most(3);
    let (sixth, past) = (Budget::until(3.0).at_most(6), Budget::until(10.0).steps(20_000));
    vec![
        trial("e = 0 on a floor", dropped(4.0, 0.0), Budget::until(2.0), height, 1.0, 1e-12),
        trial(
            "e = 1e-6 on a floor: the third bounce",
            dropped(4.0, 1e-6),
            third,
            time_of_last(),
            0.903_049_088_067_831_8,
            1e-12,
        ),
        trial("two that stick meet a dead wall", pair, Budget::until(3.0), speed, 1.0, 1e-12),
        trial("1 to 1e8 and a wall: the sixth", blocks.clone(), sixth, time_of_last(), 1.984_127_001_859_410_6, 1e-12),
        trial("1 to 1e8 and a wall: past the collapse", blocks, past, nothing(), f64::NAN, 0.0),
    ]
}

fn long() -> Vec<Trial<1>> {
    let fall = (8.0_f64 / GRAVITY).sqrt();
    let (last, most) = (Budget::until(4_000.0).at_most(2_000), Budget::until(200.0).at_most(300));
    let mut drag = dropped(4.0, 1.0 - 1e-6);
    drag.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / 400.0 });
    let pulse = |time: f64| {
        let part = (time - 5.0) / 1e-3;
        let sine = libm::sin(std::f64::consts::PI * part);
        if (0.0..1.0).contains(&part) { 2e3 * sine * sine } else { 0.0 }
    };
    let mut pushed = World::<1>::new(1.0);
    pushed.bodies.push(Body::particle("A", 1.0, [0.0], [0.0]));
    let (direction, strength) = (Vector::from([1.0]), Strength::Function(Arc::new(pulse)));
    pushed.forces.push(Force::Varying { body: 0, direction, strength });
    let slow = |step: f64, trial: Trial<1>| Trial { step, ..trial };
    let nearly = dropped(4.0, 1.0 - 1e-9);
    vec![
        slow(5e-2, trial("e = 1: bounce 2000", dropped(4.0, 1.0), last, time_of_last(), 3_999.0 * fall, 1e-12)),
        slow(5e-2, trial("e = 1 - 1e-9: bounce 2000", nearly, last, time_of_last(), 3_611.282_470_223_349, 1e-12)),
        slow(1e-2, trial("drag, e = 1 - 1e-6: bounce 300", drag, most, time_of_last(), 123.922_071_745_589_5, 1e-9)),
        trial("a push of 1 ms in 10 s", pushed, Budget::until(10.0), speed_of(0), 1.0, 1e-9),
    ]
}

fn small() -> Vec<Trial<1>> {
    let meeting = |speed: f64| beads(0.5, &[(1.0, 0.0, speed), (1.0, speed, 0.0)]);
    let mut tiny = dropped(1e-9, 0.75);
    tiny.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / 400.0 });
    let third = Trial {
        step: 5e-8,
        ..trial(
            "drop from 1 nm in air: the third bounce",
            tiny,
            Budget::until(1e-4).at_most(3),
            time_of_last(),
            5.175_931_320_527_319e-5,
            1e-9,
        )
    };
    let until = Budget::until(2.0);
    vec![
        trial("approach at 1e-12 m/s", meeting(1e-12), until, speed_of(1), 0.75e-12, 1e-12),
        trial("approach at 1e-200 m/s", meeting(1e-200), until, speed_of(1), 0.75e-200, 1e-12),
        third,
    ]
}

pub(super) fn in_the_plane() -> Vec<Trial<2>> {
    [discs(), corners(), ellipses(), billiards()].into_iter().flatten().collect()
}

fn across(body: usize) -> Measure<2> {
    Box::new(move |run| Some(run.last.velocities[body].y))
}

fn discs() -> Vec<Trial<2>> {
    let into_two = |off: f64| {
        let mut world = World::<2>::new(0.8);
        world.bodies.push(Body::sphere("A", 1.0, 0.5, [-3.0, off], [1.0, 0.0]));
        world.bodies.push(Body::sphere("B", 1.0, 0.5, [0.0, 0.55], [0.0, 0.0]));
        world.bodies.push(Body::sphere("C", 1.0, 0.5, [0.0, -0.55], [0.0, 0.0]));
        world
    };
    let until = Budget::until(5.0);
    vec![
        trial("a disc into two", into_two(0.0), until, nothing(), f64::NAN, 0.0),
        trial("a disc into two, 1e-9 m off", into_two(1e-9), until, across(0), -0.146_966_012_162_123_1, 1e-12),
    ]
}

fn corners() -> Vec<Trial<2>> {
    let particle = |restitution: f64, place: [f64; 2], velocity: [f64; 2], walls: [[f64; 2]; 2]| {
        let mut world = World::<2>::new(restitution);
        world.bodies.push(Body::particle("A", 1.0, place, velocity));
        world.walls.push(Wall::new("one", walls[0], 0.0));
        world.walls.push(Wall::new("other", walls[1], 0.0));
        world
    };
    let (right, sixty) = ([[1.0, 0.0], [0.0, 1.0]], [[0.0, 1.0], [0.866_025_403_784_438_6, -0.5]]);
    let into = |off: f64| {
        let place = [2.0 * 0.866_025_403_784_438_6, 2.0 * 0.5 + off];
        particle(0.8, place, [-0.866_025_403_784_438_6, -0.5], sixty)
    };
    let until = Budget::until(3.0);
    let along: Measure<2> = Box::new(|run| Some(run.last.positions[0].x));
    let square = particle(0.5, [1.0, 2.0], [-1.0, -1.5], right);
    vec![
        trial("a corner of 90 degrees", square, until, along, 1.0, 1e-13),
        trial("a corner of 60 degrees", into(0.0), until, nothing(), f64::NAN, 0.0),
        trial("a corner of 60 degrees, 1e-7 m off", into(1e-7), until, across(0), 0.350_499_999_999_999_9, 1e-12),
    ]
}

/// A quarter of the period from the perigee at 1.
fn ellipses() -> Vec<Trial<2>> {
    let distance: fn() -> Measure<2> = || Box::new(|run| Some(run.last.positions[0].norm()));
    let quarter = |name, eccentricity: f64, time: f64, expected: f64, tolerance: f64| {
        let world = orbit(1.0, (1.0 + eccentricity).sqrt());
        Trial { step: time / 3000.0, ..trial(name, world, Budget::until(time), distance(), expected, tolerance) }
    };
    vec![
        quarter("orbit of e = 0.99", 0.99, 1_570.796_326_794_956_7, 166.362_188_482_017_5, 1e-12),
        // The speed at the perigee, in doubles, fixes the axis to 1e-10.
        quarter("orbit of e = 0.999999", 0.999_999, 1_570_796_326.202_592, 1_673_611.028_762_596_5, 1e-9),
    ]
}

/// A disc among four heavy ones: each impact multiplies an error by some ten.
fn billiards() -> Vec<Trial<2>> {
    let mut world = World::<2>::new(1.0);
    world.bodies.push(Body::sphere("A", 1.0, 0.05, [0.02, 0.03], [1.0, 0.37]));
    for (name, place) in ["B", "C", "D", "E"].iter().zip([[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]) {
        world.bodies.push(Body::sphere(name, 1e30, 0.97, place, [0.0, 0.0]));
    }
    let after = |name, impacts: usize, expected: f64, tolerance: f64| {
        let along: Measure<2> = Box::new(|run| Some(run.last.velocities[0].x));
        trial(name, world.clone(), Budget::until(100.0).at_most(impacts), along, expected, tolerance)
    };
    vec![
        after("billiard: 10 impacts", 10, -0.671_036_463_261_599_4, 1e-11),
        after("billiard: 20 impacts", 20, -1.050_056_271_083_939, 1e-9),
        after("billiard: 30 impacts", 30, -0.126_966_793_860_849_27, 1e-9),
        after("billiard: 40 impacts", 40, 0.428_227_204_760_252_2, 1e-9),
    ]
}
