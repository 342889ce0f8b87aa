//! The closed form: a motion without impacts, and a ball that bounces on a level floor, by their formulas.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::exact::first_contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::Vector;
use crate::trajectory::{Ending, Impact, Motion, Segment, Trajectory};
use crate::world::World;

use super::EventDriven;

/// A formula, where there is one for the whole run.
#[derive(Clone, Copy, Debug, Default)]
pub struct ClosedForm;

impl<const D: usize> Method<D> for ClosedForm {
    fn name(&self) -> &'static str {
        "closed form"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        if let Some(bouncing) = Bouncing::of(world) {
            world.check()?;
            return bouncing.run(budget);
        }
        if world.contacts().is_empty() {
            // Nothing can meet, so that there is one motion for each body, of each law of its forces.
            return EventDriven.run(world, budget);
        }
        Err(Refusal::NoFormula)
    }
}

/// One body that is thrown or dropped on a level floor at rest.
struct Bouncing<'a, const D: usize> {
    world: &'a World<D>,
    /// The weight's acceleration away from the floor: negative.
    acceleration: f64,
    restitution: f64,
}

/// A body just before an impact, by its component along the normal of the floor.
struct Arrival {
    time: f64,
    /// Towards the floor: positive.
    speed: f64,
}

impl<'a, const D: usize> Bouncing<'a, D> {
    fn of(world: &'a World<D>) -> Option<Self> {
        let ([_], [wall], [], [], 1) = (&world.bodies[..], &world.walls[..], &world.cords[..], &world.forces[..], D)
        else {
            return None;
        };
        let acceleration = wall.normal.dot(&world.gravity);
        let restitution = world.restitution_of(FLOOR);
        let falls = acceleration < 0.0 && wall.velocity == 0.0 && wall.thickness.is_none();
        falls.then_some(Self { world, acceleration, restitution })
    }

    fn run(&self, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        let (body, normal) = (&self.world.bodies[0], self.world.walls[0].normal);
        let mut run = Trajectory::begin(self.world.start());
        let geometry = self.world.geometry(FLOOR, &run.last);
        let rate = normal.dot(&body.velocity);
        let Some(first) = first_contact(geometry.gap.max(0.0), rate, self.acceleration) else {
            let what = "the body never reaches the floor".to_owned();
            return Err(Refusal::Breakdown { time: 0.0, what });
        };
        let on_floor = body.position - normal * geometry.gap;
        let mut arrival = Arrival { time: first.after, speed: -first.rate };
        let (mut since, mut place, mut velocity) = (0.0, body.position, body.velocity);
        run.ending = loop {
            if run.impact_count >= budget.impacts {
                break Ending::Impacts;
            }
            if run.steps >= budget.steps {
                break Ending::Exhausted;
            }
            let motion = Motion::Uniform { position: place, velocity, acceleration: self.world.gravity };
            if arrival.time > budget.until {
                run.last.time = budget.until;
                (run.last.positions[0], run.last.velocities[0]) = motion.at(budget.until - since);
                run.extend(0, Segment { start: since, end: budget.until, motion }, budget);
                break Ending::Time;
            }
            run.extend(0, Segment { start: since, end: arrival.time, motion }, budget);
            run.note(self.impact(&normal, &arrival), budget);
            run.steps += 1;
            run.evaluations += 1;
            (since, place, velocity) = (arrival.time, on_floor, normal * (self.restitution * arrival.speed));
            run.last.time = since;
            (run.last.positions[0], run.last.velocities[0]) = (place, velocity);
            let speed = self.restitution * arrival.speed;
            // Up and down again at the speed with which it left.
            let next = Arrival { time: since - 2.0 * speed / self.acceleration, speed };
            if next.time <= arrival.time {
                run.last.velocities[0] = Vector::zeros();
                break Ending::Rest { contact: FLOOR, time: self.end(first.after, -first.rate) };
            }
            arrival = next;
        };
        Ok(run)
    }

    fn impact(&self, normal: &Vector<D>, arrival: &Arrival) -> Impact<D> {
        let (mass, e) = (self.world.bodies[0].mass, self.restitution);
        let energy_before = mass * arrival.speed * arrival.speed / 2.0;
        Impact {
            time: arrival.time,
            contact: FLOOR,
            impulse: normal * (mass * (1.0 + e) * arrival.speed),
            energy_before,
            energy_lost: energy_before * (1.0 - e) * (1.0 + e),
        }
    }

    /// When infinitely many bounces are over: the first flight takes `2 e v/g`, each one `e` times the one before.
    fn end(&self, first: f64, speed: f64) -> f64 {
        first - 2.0 * speed / self.acceleration * self.restitution / (1.0 - self.restitution)
    }
}

/// The only contact of one body and one wall.
const FLOOR: Contact = Contact::Wall { wall: 0, body: 0 };

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::world::{Body, Wall};

    fn thrown(height: f64, velocity: f64, restitution: f64) -> World<1> {
        let mut world = World::new(restitution);
        world.gravity = Vector::from([-9.81]);
        world.bodies.push(Body::particle("ball", 2.0, [height], [velocity]));
        world.walls.push(Wall::new("floor", [1.0], 0.0));
        world
    }

    #[test]
    fn it_is_the_event_driven_run_without_its_events() {
        let budgets = [Budget::impacts(7), Budget::until(2.5), Budget::until(0.1), Budget::until(50.0)];
        for world in [thrown(4.0, 0.0, 0.75), thrown(0.0, 5.0, 0.5), thrown(1e-12, -3.0, 0.9), thrown(2.0, 1.0, 0.0)] {
            for budget in budgets {
                let (fixed, other) =
                    (ClosedForm.run(&world, &budget).unwrap(), EventDriven.run(&world, &budget).unwrap());
                assert!((fixed.last.time - other.last.time).abs() < 1e-12 * other.last.time, "{budget:?}");
                let (left, right) = (fixed.last.velocities[0].x, other.last.velocities[0].x);
                assert!((left - right).abs() < 1e-9, "{budget:?}: {left} {right}");
                for (left, right) in fixed.impacts.iter().zip(&other.impacts).take(20) {
                    assert!((left.time - right.time).abs() <= 1e-14 * right.time.max(1e-3), "{left:?} {right:?}");
                    assert!((left.energy_lost - right.energy_lost).abs() <= 1e-13 * right.energy_before);
                }
            }
        }
    }

    #[test]
    fn what_may_meet_has_no_formula_here() {
        let mut world = thrown(4.0, 0.0, 0.75);
        world.bodies.push(Body::particle("other", 1.0, [5.0], [0.0]));
        assert_eq!(ClosedForm.run(&world, &Budget::until(1.0)).unwrap_err(), Refusal::NoFormula);
    }
}
