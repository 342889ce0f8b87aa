//! The reference tasks: scenes whose answer has a closed form, so that the error of a method is known. Each can be jittered, because
//! the phase of an impact aliases with a fixed step, and one lucky scene says nothing.

use super::budget::Budget;
use super::force::{Force, Strength};
use super::state::Vector;
use super::trajectory::Trajectory;
use super::world::{Body, Wall, World};

/// g in m/s².
const GRAVITY: f64 = 9.81;

/// A scene, the number that is asked for, and its true value.
pub struct Case<const D: usize> {
    /// The scene.
    pub world: World<D>,
    /// How long it runs.
    pub budget: Budget,
    /// The number that is asked for; `None` where a run does not have it.
    pub measure: fn(&Trajectory<D>) -> Option<f64>,
    /// Its true value.
    pub expected: f64,
}

/// A family of scenes around one.
#[derive(Clone, Copy)]
pub struct Task<const D: usize> {
    /// Its name.
    pub name: &'static str,
    /// What is asked for, with its unit.
    pub asks: &'static str,
    /// The scene with its first given changed by this part; 0 is the task as it is known.
    pub jittered: fn(f64) -> Case<D>,
    /// The number that is asked for, by its closed form, with the same change: the reference for all methods.
    pub closed_form: fn(f64) -> f64,
}

/// The tasks on a line.
pub const ON_A_LINE: &[Task<1>] = &[
    Task { name: "bounce", asks: "time of the fifth bounce, s", jittered: bounce, closed_form: bounce_exactly },
    Task {
        name: "bounce with drag",
        asks: "time of the fifth bounce, s",
        jittered: bounce_with_drag,
        closed_form: bounce_with_drag_exactly,
    },
    Task {
        name: "half-sine force",
        asks: "velocity after 2 s, m/s",
        jittered: half_sine,
        closed_form: half_sine_exactly,
    },
    Task {
        name: "head-on",
        asks: "velocity of A after the impact, m/s",
        jittered: head_on,
        closed_form: head_on_exactly,
    },
    Task {
        name: "contact",
        asks: "velocity of A after the impact, m/s",
        jittered: contact,
        closed_form: head_on_exactly,
    },
    Task { name: "chain", asks: "velocity of the last of ten balls, m/s", jittered: chain, closed_form: chain_exactly },
    Task { name: "ramp force", asks: "position after 2 s, m", jittered: ramp, closed_form: ramp_exactly },
];

/// The tasks in the plane.
pub const IN_THE_PLANE: &[Task<2>] = &[
    Task { name: "oblique", asks: "speed of the struck disc, m/s", jittered: oblique, closed_form: oblique_exactly },
    Task { name: "Kepler", asks: "distance at apogee, m", jittered: kepler, closed_form: kepler_exactly },
];

fn dropped(height: f64) -> World<1> {
    let mut world = World::new(0.75);
    world.gravity = Vector::from([-GRAVITY]);
    world.bodies.push(Body::particle("ball", 1.0, [height], [0.0]));
    world.walls.push(Wall::new("floor", [1.0], 0.0));
    world
}

/// A drop from 4 m with e = 3/4: the fifth bounce is at 653/128 times the first.
fn bounce(jitter: f64) -> Case<1> {
    let height = 4.0 * (1.0 + jitter);
    Case {
        world: dropped(height),
        budget: Budget::until(10.0).at_most(5),
        measure: |run| run.impacts.get(4).map(|impact| impact.time),
        expected: bounce_exactly(jitter),
    }
}

fn bounce_exactly(jitter: f64) -> f64 {
    653.0 / 128.0 * (8.0 * (1.0 + jitter) / GRAVITY).sqrt()
}

/// The terminal speed of the bounce with drag, in m/s.
const TERMINAL: f64 = 20.0;

/// The same with a terminal speed of 20 m/s.
fn bounce_with_drag(jitter: f64) -> Case<1> {
    let mut world = dropped(4.0 * (1.0 + jitter));
    world.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / (TERMINAL * TERMINAL) });
    Case {
        world,
        budget: Budget::until(10.0).at_most(5),
        measure: |run| run.impacts.get(4).map(|impact| impact.time),
        expected: bounce_with_drag_exactly(jitter),
    }
}

/// Down: v^2 = `v_t`^2 (1 - exp(-2 h/unit)), t = (`v_t`/g) artanh(v/`v_t`). Up: t = (`v_t`/g) arctan(v/`v_t`), h = unit/2 ln(1 + v^2/`v_t`^2).
fn bounce_with_drag_exactly(jitter: f64) -> f64 {
    let unit = TERMINAL * TERMINAL / GRAVITY;
    let mut height = 4.0 * (1.0 + jitter);
    let mut time = 0.0;
    for bounce in 0..5 {
        let share = (-libm::expm1(-2.0 * height / unit)).sqrt();
        time += TERMINAL / GRAVITY * libm::atanh(share);
        if bounce < 4 {
            let up = 0.75 * share;
            time += TERMINAL / GRAVITY * libm::atan(up);
            height = unit / 2.0 * libm::log1p(up * up);
        }
    }
    time
}

/// 3 kg at 3 m/s against 2 kg at -2 m/s with e = 0.7.
fn head_on(jitter: f64) -> Case<1> {
    let speed = 3.0 * (1.0 + jitter);
    let mut world = World::new(0.7);
    world.bodies.push(Body::particle("A", 3.0, [0.0], [speed]));
    world.bodies.push(Body::particle("B", 2.0, [1.0], [-2.0]));
    Case {
        world,
        budget: Budget::until(1.0),
        measure: |run| Some(run.last.velocities[0].x),
        expected: head_on_exactly(jitter),
    }
}

fn head_on_exactly(jitter: f64) -> f64 {
    let speed = 3.0 * (1.0 + jitter);
    (3.0 * speed - 4.0 - 2.0 * 0.7 * (speed + 2.0)) / 5.0
}

/// The same bodies, as large as billiard balls, which touch from the start: only the impact is left.
fn contact(jitter: f64) -> Case<1> {
    let speed = 3.0 * (1.0 + jitter);
    let mut world = World::new(0.7);
    world.bodies.push(Body::sphere("A", 3.0, 0.03, [0.0], [speed]));
    world.bodies.push(Body::sphere("B", 2.0, 0.03, [0.06], [-2.0]));
    Case {
        world,
        budget: Budget::until(1.0).at_most(1),
        measure: |run| (run.impact_count == 1).then(|| run.last.velocities[0].x),
        expected: head_on_exactly(jitter),
    }
}

/// Ten equal balls at e = 0.9: each gives its neighbour (1 + e)/2 of its velocity.
fn chain(jitter: f64) -> Case<1> {
    let speed = 1.0 + jitter;
    let mut world = World::new(0.9);
    for (place, name) in [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0].into_iter().zip("ABCDEFGHIJ".chars()) {
        let velocity = if place > 0.0 { 0.0 } else { speed };
        world.bodies.push(Body::sphere(&name.to_string(), 1.0, 0.25, [place], [velocity]));
    }
    Case {
        world,
        budget: Budget::until(12.0),
        measure: |run| Some(run.last.velocities[9].x),
        expected: chain_exactly(jitter),
    }
}

fn chain_exactly(jitter: f64) -> f64 {
    (1.0 + jitter) * libm::pow(0.95, 9.0)
}

/// A force that grows by 6 N/s on 2 kg at rest: x = k t^3/(6 m).
fn ramp(jitter: f64) -> Case<1> {
    let rate = 6.0 * (1.0 + jitter);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("A", 2.0, [0.0], [0.0]));
    let strength = Strength::polynomial(&[0.0, rate]);
    world.forces.push(Force::Varying { body: 0, direction: Vector::from([1.0]), strength });
    Case {
        world,
        budget: Budget::until(2.0),
        measure: |run| Some(run.last.positions[0].x),
        expected: ramp_exactly(jitter),
    }
}

fn ramp_exactly(jitter: f64) -> f64 {
    6.0 * (1.0 + jitter) * 8.0 / 12.0
}

/// A force that rises to 10 N and goes back within 2 s as half a sine, on 4 kg at rest: no polynomial in the time.
fn half_sine(jitter: f64) -> Case<1> {
    let greatest = 10.0 * (1.0 + jitter);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("A", 4.0, [0.0], [0.0]));
    let law = move |time: f64| greatest * libm::sin(std::f64::consts::FRAC_PI_2 * time);
    let (direction, strength) = (Vector::from([1.0]), Strength::Function(std::sync::Arc::new(law)));
    world.forces.push(Force::Varying { body: 0, direction, strength });
    Case {
        world,
        budget: Budget::until(2.0),
        measure: |run| Some(run.last.velocities[0].x),
        expected: half_sine_exactly(jitter),
    }
}

/// The impulse of half a sine is 2/pi of its height times its length.
fn half_sine_exactly(jitter: f64) -> f64 {
    10.0 * (1.0 + jitter) / std::f64::consts::PI
}

/// Equal smooth discs whose lines of motion are 0.6 of a diameter apart, e = 0.8: the struck one has (1 + e)/2 cos of the speed.
fn oblique(jitter: f64) -> Case<2> {
    let passing = 0.6 * (1.0 + jitter);
    let mut world = World::new(0.8);
    world.bodies.push(Body::sphere("A", 1.0, 0.5, [-2.0, 0.0], [3.0, 0.0]));
    world.bodies.push(Body::sphere("B", 1.0, 0.5, [0.0, passing], [0.0, 0.0]));
    Case {
        world,
        budget: Budget::until(1.0),
        measure: |run| Some(run.last.velocities[1].norm()),
        expected: oblique_exactly(jitter),
    }
}

fn oblique_exactly(jitter: f64) -> f64 {
    let passing = 0.6 * (1.0 + jitter);
    2.7 * ((1.0 - passing) * (1.0 + passing)).sqrt()
}

/// Half an ellipse from its perigee at 1 with eccentricity 1/2.
fn kepler(jitter: f64) -> Case<2> {
    let eccentricity = 0.5 * (1.0 + jitter);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("satellite", 1.0, [1.0, 0.0], [0.0, (1.0 + eccentricity).sqrt()]));
    world.forces.push(Force::Central { body: 0, centre: Vector::zeros(), parameter: 1.0 });
    let axis = 1.0 / (1.0 - eccentricity);
    Case {
        world,
        budget: Budget::until(std::f64::consts::PI * axis * axis.sqrt()),
        measure: |run| Some(run.last.positions[0].norm()),
        expected: kepler_exactly(jitter),
    }
}

fn kepler_exactly(jitter: f64) -> f64 {
    let eccentricity = 0.5 * (1.0 + jitter);
    (1.0 + eccentricity) / (1.0 - eccentricity)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tasks_have_their_known_answers() {
        // From a calculation with 30 digits.
        for (task, expected) in [
            (ON_A_LINE[0], 4.606_952_149_432_536),
            (ON_A_LINE[1], 4.257_661_947_038_265),
            (ON_A_LINE[2], 3.183_098_861_837_906_7),
            (ON_A_LINE[3], -0.4),
            (ON_A_LINE[4], -0.4),
            (ON_A_LINE[6], 4.0),
        ] {
            let value = (task.jittered)(0.0).expected;
            assert!((value - expected).abs() < 3e-15, "{}: {value}", task.name);
        }
        assert!(((IN_THE_PLANE[0].jittered)(0.0).expected - 2.16).abs() < 1e-15);
        assert!(((IN_THE_PLANE[1].jittered)(0.0).expected - 3.0).abs() < 1e-15);
    }
}
