//! A scene as it is watched: from before its impact to after it, and with an end.

use super::budget::{Budget, Keep};
use super::contact::Contact;
use super::method::Method;
use super::methods::EventDriven;
use super::record::Record;
use super::refusal::Refusal;
use super::state::Vector;
use super::trajectory::{Ending, Trajectory};
use super::world::World;

/// How far bodies are apart, in m, at the start of what is watched of an impact.
const APART: f64 = 2.0;

/// Impacts and steps after which nobody watches any longer.
const MOST_IMPACTS: usize = 100_000;
const MOST_STEPS: usize = 1_000_000;

/// How many times as long as the exact run another method may take to the impact that ends it.
const LONGER: f64 = 2.0;

/// Bodies that are so many times as fast as they approach are run in a frame that moves along.
const MUCH_FASTER: f64 = 8.0;

/// Ends of a scene that is watched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A time.
    Time,
    /// The impact of this number, counted from 1, which is still seen.
    Impact(usize),
    /// Rest, after more impacts than anybody counts.
    Rest,
}

/// A scene with the time in which it is watched.
#[derive(Clone, Debug)]
pub struct Shown<const D: usize> {
    /// The scene.
    pub world: World<D>,
    /// How long it runs; it has an end, which methods with steps need.
    pub budget: Budget,
    /// The end, as it is asked for.
    pub end: End,
    /// How long it takes by exact motion, in s: a step is a part of that.
    pub length: f64,
    /// The time of the run that is called 0, in s.
    pub origin: f64,
    /// The velocity with which whoever runs the scene moves along, in m/s.
    pub frame: Vector<D>,
}

impl<const D: usize> Shown<D> {
    /// Shows a scene as it is watched. Bodies that touch are taken back to before they met. Where what is asked is the state
    /// before the first impact (`until_impact`), the run ends there.
    ///
    /// # Errors
    /// The scene has no end that could be found.
    pub fn of(world: &World<D>, budget: &Budget, until_impact: bool) -> Result<Self, Refusal> {
        let asked = budget.impacts;
        let budget = budget.keep(Keep::Everything).steps(budget.steps.min(MOST_STEPS));
        if let Some(Meeting { lead, frame }) = meeting(world) {
            let (origin, length, end) = (lead, 2.0 * lead, End::Time);
            let budget = Budget::until(length).steps(budget.steps).at_most(MOST_IMPACTS);
            return Ok(Self { world: before(&world.seen_from(frame, 0.0), lead), budget, end, length, origin, frame });
        }
        let budget = budget.at_most(asked.min(MOST_IMPACTS));
        let (length, frame) = (budget.until, Vector::zeros());
        let mut shown = Self { world: world.clone(), budget, end: End::Time, length, origin: 0.0, frame };
        if budget.until.is_finite() {
            return Ok(shown);
        }
        let exact = EventDriven.run(world, &budget.keep(Keep::Count))?;
        // A run that ends where it starts has no length of its own.
        shown.length = if exact.last.time > 0.0 { exact.last.time } else { 1.0 };
        if until_impact {
            shown.world.walls.clear();
            shown.budget = shown.budget.at_most(MOST_IMPACTS);
            shown.budget.until = shown.length;
            return Ok(shown);
        }
        // An impact that is asked for is part of the run: no time is compared with its own, which rounding moves.
        shown.budget.until = LONGER * shown.length;
        match exact.ending {
            Ending::Rest { .. } => (shown.end, shown.budget.until) = (End::Rest, shown.length),
            Ending::Impacts if asked == usize::MAX => shown.end = End::Rest,
            Ending::Impacts | Ending::Exhausted => shown.end = End::Impact(asked),
            Ending::NoMoreImpacts | Ending::Time => {}
        }
        Ok(shown)
    }

    /// The record of a run, as the scene is told.
    #[must_use]
    pub fn record(&self, run: &Trajectory<D>) -> Record {
        let back = -self.frame;
        match run.seen_from(&self.world, back, self.origin) {
            Some(told) if back.amax() > 0.0 => Record::of(&self.world.seen_from(back, self.origin), &told, self.origin),
            _ => Record::of(&self.world, run, self.origin),
        }
    }

    /// Why a run is not the whole of what is asked for; none where it is.
    #[must_use]
    pub fn cut_off(&self, run: &Trajectory<D>) -> Option<String> {
        let impacts = run.impact_count;
        match (run.ending, self.end) {
            (Ending::Exhausted, _) => Some("before its time: too many steps".to_owned()),
            (_, End::Impact(count)) if impacts < count => {
                Some(format!("before its time: after {impacts} of {count} impacts"))
            }
            (Ending::Impacts, End::Rest | End::Time) if impacts >= MOST_IMPACTS => {
                Some(format!("before its time: after {impacts} impacts"))
            }
            _ => None,
        }
    }
}

/// Bodies that touch and approach, and on which nothing acts.
struct Meeting<const D: usize> {
    /// For how long they are watched before, in s.
    lead: f64,
    /// The velocity of the frame in which they are run.
    frame: Vector<D>,
}

fn meeting<const D: usize>(world: &World<D>) -> Option<Meeting<D>> {
    if !world.forces.is_empty() || world.gravity.amax() > 0.0 || !world.cords.is_empty() {
        return None;
    }
    let state = world.start();
    let touching = world.touching(&world.contacts(), &state);
    let struck = touching.iter().min_by(|one, other| one.rate.total_cmp(&other.rate))?;
    let lead = Some(APART / -struck.rate).filter(|lead| struck.rate < 0.0 && lead.is_finite())?;
    let fastest = world.bodies.iter().map(|body| body.velocity.norm()).fold(0.0, f64::max);
    // The difference of two nearly equal speeds is exact, so that one of the two bodies is at rest in the frame.
    let frame = if fastest < MUCH_FASTER * -struck.rate {
        Vector::zeros()
    } else if let Contact::Wall { wall, .. } = struck.contact {
        struck.normal * world.walls[wall].velocity
    } else {
        world.bodies[world.parties(struck.contact).1].velocity
    };
    Some(Meeting { lead, frame })
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
    use crate::methods::{ClosedForm, RungeKutta};
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

    /// 1 + 1e-9 m/s behind 1 m/s meets it after two thousand million seconds, in which both go as many metres.
    #[test]
    fn bodies_of_nearly_equal_speed_meet_when_they_touch() {
        for (fast, slow) in [(1.000_000_001, 1.0), (1000.0001, 1000.0), (-7.0, -7.000_000_1)] {
            let mut world = World::<1>::new(0.7);
            world.bodies.push(Body::sphere("A", 3.0, 0.5, [-0.5], [fast]));
            world.bodies.push(Body::sphere("B", 2.0, 0.5, [0.5], [slow]));
            let shown = Shown::of(&world, &Budget::impacts(1), false).unwrap();
            let record = shown.record(&EventDriven.run(&shown.world, &shown.budget).unwrap());
            let (impact, approach) = (&record.impacts[0], fast - slow);
            assert!(impact.time.abs() < 1e-15 * shown.length, "{impact:?}");
            assert!((impact.impulse[0] / (1.2 * 1.7 * approach) - 1.0).abs() < 1e-15, "{impact:?}");
            assert!((impact.energy_before / (1.5 * fast * fast + slow * slow) - 1.0).abs() < 1e-15, "{impact:?}");
            let [first, last] = [record.moments.first().unwrap(), record.moments.last().unwrap()];
            assert!((last.velocities[1][0] - (slow + 1.7 * 0.6 * approach)).abs() < 1e-12 * slow.abs());
            assert!((first.balance() - last.balance()).abs() < 1e-12 * first.balance());
            assert!((first.momentum[0] - last.momentum[0]).abs() < 1e-12 * first.momentum[0].abs());
        }
    }

    /// A plate that flies nearly as fast as the ball that strikes it gives and takes the work of its impulse.
    #[test]
    fn a_wall_that_moves_along_keeps_the_balance() {
        let mut world = World::<1>::new(0.5);
        world.bodies.push(Body::particle("ball", 2.0, [0.0], [-30.0]));
        world.walls.push(Wall::new("plate", [1.0], 0.0).moving(-29.0));
        let shown = Shown::of(&world, &Budget::impacts(1), false).unwrap();
        let record = shown.record(&EventDriven.run(&shown.world, &shown.budget).unwrap());
        let (impact, last) = (&record.impacts[0], record.moments.last().unwrap());
        assert!((last.velocities[0][0] + 28.5).abs() < 1e-13 && (impact.energy_before - 900.0).abs() < 1e-10);
        assert!((impact.energy_after - 28.5 * 28.5).abs() < 1e-10 && (last.balance() - 900.0).abs() < 1e-10);
        assert!((record.walls[0].offset, record.walls[0].velocity) == (0.0, -29.0));
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
        assert!((bounces.length - 3.0).abs() < 1e-12 && bounces.end == End::Rest, "{bounces:?}");
    }

    /// Rounding may put the last impact before or after the time at which another method has it: it is seen all the same.
    #[test]
    fn the_impact_that_is_asked_for_is_seen() {
        for (height, restitution, count) in [(1.45, 0.61, 5), (1.0, 0.95, 100), (1.0, 0.9, 20), (0.3, 0.77, 7)] {
            let mut world = World::<1>::new(restitution);
            world.gravity = Vector::from([-9.81]);
            world.bodies.push(Body::particle("ball", 1.0, [height], [0.0]));
            world.walls.push(Wall::new("floor", [1.0], 0.0));
            let shown = Shown::of(&world, &Budget::impacts(count), false).unwrap();
            let exact = EventDriven.run(&shown.world, &shown.budget).unwrap();
            let formula = ClosedForm.run(&shown.world, &shown.budget).unwrap();
            let steps = RungeKutta { tolerance: 1e-10 }.run(&shown.world, &shown.budget).unwrap();
            for run in [exact, formula, steps] {
                assert_eq!((run.impacts.len(), shown.cut_off(&run)), (count, None));
                assert!(run.last.velocities[0].x > 0.0, "it has left the floor: {:?}", run.last);
            }
        }
    }

    #[test]
    fn a_run_that_nobody_watches_to_its_end_says_so() {
        let mut world = World::<1>::new(1.0);
        world.gravity = Vector::from([-10.0]);
        world.bodies.push(Body::particle("ball", 1.0, [5.0], [0.0]));
        world.walls.push(Wall::new("floor", [1.0], 0.0));
        let shown = Shown::of(&world, &Budget::impacts(1_000_000), false).unwrap();
        let run = ClosedForm.run(&shown.world, &shown.budget.keep(Keep::Count)).unwrap();
        assert_eq!(shown.cut_off(&run).unwrap(), "before its time: after 100000 of 1000000 impacts");
    }
}
