//! A scene as it is watched: from before its impact to after it, and with an end.

use super::budget::{Budget, Keep};
use super::method::Method;
use super::methods::EventDriven;
use super::refusal::Refusal;
use super::world::World;

/// How far bodies are apart, in m, at the start of what is watched of an impact.
const APART: f64 = 2.0;

/// Impacts and steps after which nobody watches any longer.
const MOST_IMPACTS: usize = 100_000;
const MOST_STEPS: usize = 1_000_000;

/// A scene with the time in which it is watched.
#[derive(Clone, Debug)]
pub struct Shown<const D: usize> {
    /// The scene.
    pub world: World<D>,
    /// How long it runs; it has an end, which methods with steps need.
    pub budget: Budget,
    /// The time of the run that is called 0, in s.
    pub origin: f64,
}

impl<const D: usize> Shown<D> {
    /// What is watched of a scene. Bodies that touch are taken back to before they met. Where what is asked is the state before
    /// the first impact (`until_impact`), the run ends there.
    ///
    /// # Errors
    /// The scene has no end that could be found.
    pub fn of(world: &World<D>, budget: &Budget, until_impact: bool) -> Result<Self, Refusal> {
        let budget = budget.keep(Keep::Everything).steps(budget.steps.min(MOST_STEPS));
        let budget = budget.at_most(budget.impacts.min(MOST_IMPACTS));
        if let Some(lead) = lead(world) {
            let budget = Budget::until(2.0 * lead).steps(budget.steps);
            return Ok(Self { world: before(world, lead), budget, origin: lead });
        }
        let mut shown = Self { world: world.clone(), budget, origin: 0.0 };
        if budget.until.is_infinite() {
            shown.budget.until = EventDriven.run(world, &budget.keep(Keep::Count))?.last.time;
            shown.budget.impacts = MOST_IMPACTS;
            if until_impact {
                shown.world.walls.clear();
            }
        }
        Ok(shown)
    }
}

/// For how long bodies that touch and approach, and on which nothing acts, have moved towards each other.
fn lead<const D: usize>(world: &World<D>) -> Option<f64> {
    if !world.forces.is_empty() || world.gravity.amax() > 0.0 || !world.cords.is_empty() {
        return None;
    }
    let state = world.start();
    let touching = world.touching(&world.contacts(), &state);
    let approach = touching.iter().map(|struck| -struck.rate).fold(0.0, f64::max);
    (approach > 0.0).then(|| APART / approach).filter(|lead| lead.is_finite())
}

/// The scene some time before, of bodies on which nothing acts.
fn before<const D: usize>(world: &World<D>, time: f64) -> World<D> {
    let mut world = world.clone();
    for body in &mut world.bodies {
        body.position -= body.velocity * time;
    }
    for wall in &mut world.walls {
        wall.offset -= wall.velocity * time;
    }
    world
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::state::Vector;
    use crate::world::{Body, Wall};

    #[test]
    fn bodies_that_touch_are_watched_from_before_they_met() {
        let mut world = World::<1>::new(0.7);
        world.bodies.push(Body::sphere("A", 3.0, 0.5, [-0.5], [3.0]));
        world.bodies.push(Body::sphere("B", 2.0, 0.5, [0.5], [-2.0]));
        let shown = Shown::of(&world, &Budget::impacts(1), false).unwrap();
        let run = EventDriven.run(&shown.world, &shown.budget).unwrap();
        assert_eq!(run.impacts.len(), 1);
        assert!((run.impacts[0].time - shown.origin).abs() < 1e-15);
        assert!((run.last.velocities[0].x - -0.4).abs() < 1e-15 && (run.last.time - 2.0 * shown.origin).abs() < 1e-15);
    }

    /// From 5 m at g = 10 m/s² the floor comes after 1 s; all bounces at e = 1/2 end after 3 s.
    #[test]
    fn what_has_no_end_of_its_own_gets_one() {
        let mut world = World::<1>::new(0.5);
        world.gravity = Vector::from([-10.0]);
        world.bodies.push(Body::particle("ball", 1.0, [5.0], [0.0]));
        world.walls.push(Wall::new("floor", [1.0], 0.0));
        let fall = Shown::of(&world, &Budget::impacts(1), true).unwrap();
        assert!(fall.world.walls.is_empty() && (fall.budget.until - 1.0).abs() < 1e-15);
        let bounces = Shown::of(&world, &Budget::impacts(usize::MAX), false).unwrap();
        assert!((bounces.budget.until - 3.0).abs() < 1e-12, "{}", bounces.budget.until);
    }
}
