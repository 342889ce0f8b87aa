//! The reference tasks: scenes whose answer has a closed form, so that the error of a method is known. Each can be jittered, because
//! the phase of an impact aliases with a fixed step, and one lucky scene says nothing.

use super::budget::Budget;
use super::force::{Force, Strength};
use super::state::{State, Vector};
use super::truth::Truth;
use super::world::{Body, Wall, World};

/// g in m/s².
const GRAVITY: f64 = 9.81;

/// A scene, and what is true of it.
pub struct Case<const D: usize> {
    /// The scene.
    pub world: World<D>,
    /// How long it runs.
    pub budget: Budget,
    /// The truth about its run.
    pub truth: Truth<D>,
}

/// A family of scenes around one.
#[derive(Clone, Copy)]
pub struct Task<const D: usize> {
    /// Its name.
    pub name: &'static str,
    /// A description of what happens in it.
    pub about: &'static str,
    /// The scene with its first given changed by this part; 0 is the task as it is known.
    pub jittered: fn(f64) -> Case<D>,
    /// The truth by its closed form, with the same change: the reference for all methods.
    pub closed_form: fn(f64) -> Truth<D>,
}

/// The tasks on a line.
pub const ON_A_LINE: &[Task<1>] = &[
    Task { name: "bounce", about: "five bounces at e = 3/4", jittered: bounce, closed_form: bounce_exactly },
    Task {
        name: "bounce with drag",
        about: "five bounces in air",
        jittered: bounce_with_drag,
        closed_form: bounce_with_drag_exactly,
    },
    Task { name: "half-sine force", about: "no impact", jittered: half_sine, closed_form: half_sine_exactly },
    Task { name: "head-on", about: "one impact of two bodies", jittered: head_on, closed_form: head_on_exactly },
    Task { name: CONTACT, about: "one impact of bodies that touch", jittered: contact, closed_form: contact_exactly },
    Task { name: "chain", about: "nine impacts of ten balls", jittered: chain, closed_form: chain_exactly },
    Task { name: "ramp force", about: "no impact", jittered: ramp, closed_form: ramp_exactly },
];

/// The tasks in the plane.
pub const IN_THE_PLANE: &[Task<2>] = &[
    Task { name: "oblique", about: "one impact of two discs", jittered: oblique, closed_form: oblique_exactly },
    Task { name: "Kepler", about: "half an ellipse", jittered: kepler, closed_form: kepler_exactly },
];

/// The task without a way to the impact, in which methods differ by nothing but their cost: the table of costs has it, no chart.
pub const CONTACT: &str = "contact";

/// The end of a run on a line.
fn end(time: f64, positions: &[f64], velocities: &[f64]) -> State<1> {
    let all = |values: &[f64]| values.iter().map(|value| Vector::from([*value])).collect();
    State { time, positions: all(positions), velocities: all(velocities) }
}

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
    Case { world: dropped(height), budget: Budget::until(10.0).at_most(5), truth: bounce_exactly(jitter) }
}

fn bounce_exactly(jitter: f64) -> Truth<1> {
    let height = 4.0 * (1.0 + jitter);
    let (fall, speed) = ((2.0 * height / GRAVITY).sqrt(), (2.0 * GRAVITY * height).sqrt());
    // 1 + 2 (e + e^2 + ...), and e^k: both exact.
    let bounces = [(1.0, 1.0), (2.5, 0.75), (3.625, 0.5625), (4.46875, 0.421_875), (653.0 / 128.0, 0.316_406_25)];
    let impacts = bounces.map(|(times, kept)| (times * fall, Vector::from([1.75 * kept * speed]))).to_vec();
    let last = end(653.0 / 128.0 * fall, &[0.0], &[0.75 * 0.316_406_25 * speed]);
    Truth { impacts, length: last.time, last, way: height, speed }
}

/// The terminal speed of the bounce with drag, in m/s.
const TERMINAL: f64 = 20.0;

/// The same with a terminal speed of 20 m/s.
fn bounce_with_drag(jitter: f64) -> Case<1> {
    let mut world = dropped(4.0 * (1.0 + jitter));
    world.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / (TERMINAL * TERMINAL) });
    Case { world, budget: Budget::until(10.0).at_most(5), truth: bounce_with_drag_exactly(jitter) }
}

/// Down: v^2 = `v_t`^2 (1 - exp(-2 h/unit)), t = (`v_t`/g) artanh(v/`v_t`). Up: t = (`v_t`/g) arctan(v/`v_t`), h = unit/2 ln(1 + v^2/`v_t`^2).
fn bounce_with_drag_exactly(jitter: f64) -> Truth<1> {
    let unit = TERMINAL * TERMINAL / GRAVITY;
    let way = 4.0 * (1.0 + jitter);
    let (mut height, mut time, mut impacts, mut speed) = (way, 0.0, Vec::new(), 0.0_f64);
    let mut up = 0.0;
    for _ in 0..5 {
        // Up to the height, and down again; the first time down only.
        time += TERMINAL / GRAVITY * libm::atan(up);
        let share = (-libm::expm1(-2.0 * height / unit)).sqrt();
        time += TERMINAL / GRAVITY * libm::atanh(share);
        impacts.push((time, Vector::from([1.75 * TERMINAL * share])));
        speed = speed.max(TERMINAL * share);
        up = 0.75 * share;
        height = unit / 2.0 * libm::log1p(up * up);
    }
    Truth { impacts, last: end(time, &[0.0], &[TERMINAL * up]), length: time, way, speed }
}

/// 3 kg at 3 m/s against 2 kg at -2 m/s with e = 0.7.
fn head_on(jitter: f64) -> Case<1> {
    let speed = 3.0 * (1.0 + jitter);
    let mut world = World::new(0.7);
    world.bodies.push(Body::particle("A", 3.0, [0.0], [speed]));
    world.bodies.push(Body::particle("B", 2.0, [1.0], [-2.0]));
    Case { world, budget: Budget::until(1.0), truth: head_on_exactly(jitter) }
}

fn head_on_exactly(jitter: f64) -> Truth<1> {
    let speed = 3.0 * (1.0 + jitter);
    let time = 1.0 / (speed + 2.0);
    let [after_a, after_b] = after_head_on(speed);
    let place = speed * time;
    let positions = [place + after_a * (1.0 - time), place + after_b * (1.0 - time)];
    let way = place.max((positions[1] - 1.0).abs());
    let impulse = Vector::from([2.0 * (after_b + 2.0)]);
    Truth { impacts: vec![(time, impulse)], last: end(1.0, &positions, &[after_a, after_b]), length: 1.0, way, speed }
}

fn after_head_on(speed: f64) -> [f64; 2] {
    let after = (3.0 * speed - 4.0 - 2.0 * 0.7 * (speed + 2.0)) / 5.0;
    [after, after + 0.7 * (speed + 2.0)]
}

/// The same bodies, as large as billiard balls, which touch from the start: only the impact is left.
fn contact(jitter: f64) -> Case<1> {
    let speed = 3.0 * (1.0 + jitter);
    let mut world = World::new(0.7);
    world.bodies.push(Body::sphere("A", 3.0, 0.03, [0.0], [speed]));
    world.bodies.push(Body::sphere("B", 2.0, 0.03, [0.06], [-2.0]));
    Case { world, budget: Budget::until(1.0).at_most(1), truth: contact_exactly(jitter) }
}

/// Only the impact is asked for: when it is found, and where, is not.
fn contact_exactly(jitter: f64) -> Truth<1> {
    let speed = 3.0 * (1.0 + jitter);
    let after = after_head_on(speed);
    let impulse = Vector::from([2.0 * (after[1] + 2.0)]);
    let last = end(0.0, &[0.0, 0.06], &after);
    Truth { impacts: vec![(0.0, impulse)], last, length: f64::MAX, way: f64::MAX, speed }
}

/// Ten equal balls at e = 0.9: each gives its neighbour (1 + e)/2 of its velocity.
fn chain(jitter: f64) -> Case<1> {
    let speed = 1.0 + jitter;
    let mut world = World::new(0.9);
    for (place, name) in [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0].into_iter().zip("ABCDEFGHIJ".chars()) {
        let velocity = if place > 0.0 { 0.0 } else { speed };
        world.bodies.push(Body::sphere(&name.to_string(), 1.0, 0.25, [place], [velocity]));
    }
    Case { world, budget: Budget::until(12.0), truth: chain_exactly(jitter) }
}

fn chain_exactly(jitter: f64) -> Truth<1> {
    let (until, gap) = (12.0, 0.5);
    let (mut time, mut speed, mut impacts) = (0.0, 1.0 + jitter, Vec::new());
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    for place in [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0] {
        time += gap / speed;
        impacts.push((time, Vector::from([0.95 * speed])));
        // What a ball does not give to the next one it keeps.
        let kept = 0.05 * speed;
        positions.push(place + gap + kept * (until - time));
        velocities.push(kept);
        speed *= 0.95;
    }
    let way = speed * (until - time);
    positions.push(9.0 + way);
    velocities.push(speed);
    Truth { impacts, last: end(until, &positions, &velocities), length: until, way, speed: 1.0 + jitter }
}

/// A force that grows by 6 N/s on 2 kg at rest: x = k t^3/(6 m).
fn ramp(jitter: f64) -> Case<1> {
    let rate = 6.0 * (1.0 + jitter);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("A", 2.0, [0.0], [0.0]));
    let strength = Strength::polynomial(&[0.0, rate]);
    world.forces.push(Force::Varying { body: 0, direction: Vector::from([1.0]), strength });
    Case { world, budget: Budget::until(2.0), truth: ramp_exactly(jitter) }
}

fn ramp_exactly(jitter: f64) -> Truth<1> {
    let rate = 6.0 * (1.0 + jitter);
    let (way, speed) = (rate * 8.0 / 12.0, rate * 4.0 / 4.0);
    Truth { impacts: Vec::new(), last: end(2.0, &[way], &[speed]), length: 2.0, way, speed }
}

/// A force that rises to 10 N and goes back within 2 s as half a sine, on 4 kg at rest: no polynomial in the time.
fn half_sine(jitter: f64) -> Case<1> {
    let greatest = 10.0 * (1.0 + jitter);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("A", 4.0, [0.0], [0.0]));
    let law = move |time: f64| greatest * libm::sin(std::f64::consts::FRAC_PI_2 * time);
    let (direction, strength) = (Vector::from([1.0]), Strength::Function(std::sync::Arc::new(law)));
    world.forces.push(Force::Varying { body: 0, direction, strength });
    Case { world, budget: Budget::until(2.0), truth: half_sine_exactly(jitter) }
}

/// The impulse of half a sine is 2/pi of its height times its length, and by symmetry the mean velocity is half the last.
fn half_sine_exactly(jitter: f64) -> Truth<1> {
    let speed = 10.0 * (1.0 + jitter) / std::f64::consts::PI;
    Truth { impacts: Vec::new(), last: end(2.0, &[speed], &[speed]), length: 2.0, way: speed, speed }
}

/// Equal smooth discs whose lines of motion are 0.6 of a diameter apart, e = 0.8: the struck one has (1 + e)/2 cos of the speed.
fn oblique(jitter: f64) -> Case<2> {
    let passing = 0.6 * (1.0 + jitter);
    let mut world = World::new(0.8);
    world.bodies.push(Body::sphere("A", 1.0, 0.5, [-2.0, 0.0], [3.0, 0.0]));
    world.bodies.push(Body::sphere("B", 1.0, 0.5, [0.0, passing], [0.0, 0.0]));
    Case { world, budget: Budget::until(1.0), truth: oblique_exactly(jitter) }
}

fn oblique_exactly(jitter: f64) -> Truth<2> {
    let passing = 0.6 * (1.0 + jitter);
    let along = ((1.0 - passing) * (1.0 + passing)).sqrt();
    let (time, impulse) = ((2.0 - along) / 3.0, Vector::from([along, passing]) * (2.7 * along));
    let velocities = vec![Vector::from([3.0, 0.0]) - impulse, impulse];
    let from = [Vector::from([-along, 0.0]), Vector::from([0.0, passing])];
    let places = from.iter().zip(&velocities).map(|(place, velocity)| place + velocity * (1.0 - time));
    let positions: Vec<Vector<2>> = places.collect();
    let way = (positions[0] - Vector::from([-2.0, 0.0])).norm().max((positions[1] - from[1]).norm());
    Truth {
        impacts: vec![(time, impulse)],
        last: State { time: 1.0, positions, velocities },
        length: 1.0,
        way,
        speed: 3.0,
    }
}

/// Half an ellipse from its perigee at 1 with eccentricity 1/2.
fn kepler(jitter: f64) -> Case<2> {
    let eccentricity = 0.5 * (1.0 + jitter);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("satellite", 1.0, [1.0, 0.0], [0.0, (1.0 + eccentricity).sqrt()]));
    world.forces.push(Force::Central { body: 0, centre: Vector::zeros(), parameter: 1.0 });
    let axis = 1.0 / (1.0 - eccentricity);
    Case { world, budget: Budget::until(half_a_turn(axis)), truth: kepler_exactly(jitter) }
}

fn half_a_turn(axis: f64) -> f64 {
    std::f64::consts::PI * axis * axis.sqrt()
}

/// At the apogee the distance is greatest and the speed least, at right angles to each other.
fn kepler_exactly(jitter: f64) -> Truth<2> {
    let eccentricity = 0.5 * (1.0 + jitter);
    let (speed, far) = ((1.0 + eccentricity).sqrt(), (1.0 + eccentricity) / (1.0 - eccentricity));
    let last = State {
        time: half_a_turn(1.0 / (1.0 - eccentricity)),
        positions: vec![Vector::from([-far, 0.0])],
        velocities: vec![Vector::from([0.0, -speed / far])],
    };
    Truth { impacts: Vec::new(), length: last.time, last, way: 1.0 + far, speed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Method;
    use crate::methods::{EventDriven, RungeKutta};

    /// From a calculation with 30 digits.
    #[test]
    fn the_tasks_have_their_known_answers() {
        let line = |place: usize| (ON_A_LINE[place].closed_form)(0.0);
        for (place, expected) in [(0, 4.606_952_149_432_536), (1, 4.257_661_947_038_265)] {
            assert!((line(place).impacts[4].0 - expected).abs() < 3e-15, "{}", ON_A_LINE[place].name);
        }
        for (place, body, expected) in
            [(2, 0, 3.183_098_861_837_906_7), (3, 0, -0.4), (4, 0, -0.4), (5, 9, 0.630_249_409_724_609_4), (6, 0, 6.0)]
        {
            let computed = line(place).last.velocities[body].x;
            assert!((computed - expected).abs() < 3e-15, "{}: {computed}", ON_A_LINE[place].name);
        }
        assert!((line(6).last.positions[0].x - 4.0).abs() < 1e-15);
        let plane = |place: usize| (IN_THE_PLANE[place].closed_form)(0.0);
        assert!((plane(0).last.velocities[1].norm() - 2.16).abs() < 1e-15);
        assert!((plane(1).last.positions[0].norm() - 3.0).abs() < 1e-15);
    }

    /// In jittered scenes the closed forms and the methods find the same, in every impact and at the end.
    #[test]
    fn the_closed_forms_are_what_accurate_methods_find() {
        fn off<const D: usize>(task: &Task<D>, jitter: f64) -> f64 {
            let case = (task.jittered)(jitter);
            let run = EventDriven.run(&case.world, &case.budget);
            let run = run.or_else(|_| RungeKutta { tolerance: 1e-14 }.run(&case.world, &case.budget));
            run.ok().and_then(|run| case.truth.error(&run)).unwrap_or(f64::INFINITY)
        }
        for jitter in [0.0, 0.0073, -0.0091] {
            for task in ON_A_LINE {
                assert!(off(task, jitter) < 2e-12, "{} {jitter}: {:e}", task.name, off(task, jitter));
            }
            for task in IN_THE_PLANE {
                assert!(off(task, jitter) < 2e-15, "{} {jitter}: {:e}", task.name, off(task, jitter));
            }
        }
    }
}
