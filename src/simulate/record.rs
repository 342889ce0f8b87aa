//! A run as plain numbers at common instants, whatever its dimension: what plots and tables are made of.

use super::contact::Contact;
use super::force::Force;
use super::state::{State, Vector};
use super::trajectory::Trajectory;
use super::world::{Body, World};

/// The evenly spaced instants of a record.
const EVENLY: u32 = 240;

/// The impacts whose instants a record has; the table of impacts has all.
const INSTANTS: usize = 300;

/// Gauss' rule with three points: where they are between -1 and 1, and their weights.
pub(super) const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// A run as plain numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// The bodies.
    pub bodies: Vec<Recorded>,
    /// The walls and floors.
    pub walls: Vec<RecordedWall>,
    /// The pivot about which all bodies move.
    pub pivot: Option<Pivot>,
    /// How far the last body, a point of an arm seen along the line of what strikes it, is from the arm's pivot, in m.
    pub lever: Option<f64>,
    /// The common instants in order; that of an impact stands twice, just before and just after.
    pub moments: Vec<Moment>,
    /// The impacts in order.
    pub impacts: Vec<RecordedImpact>,
}

/// A body of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    /// Its name.
    pub name: String,
    /// Its mass in kg, at the start.
    pub mass: f64,
    /// Its radius in m; 0 where it is a particle.
    pub radius: f64,
}

/// The pivot about which all bodies of a record move.
#[derive(Clone, Debug, PartialEq)]
pub struct Pivot {
    /// Its place, in m.
    pub at: Vec<f64>,
    /// The tie from it to the bodies.
    pub tie: Tie,
}

/// The tie from a pivot to bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tie {
    /// Nothing.
    Nothing,
    /// A cord to each.
    Cords,
    /// An arm to one of them, by its place among the bodies.
    Arm(usize),
}

/// A wall of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedWall {
    /// Its name.
    pub name: String,
    /// The unit normal, towards the bodies.
    pub normal: Vec<f64>,
    /// The place of its face at time 0, along the normal, in m.
    pub offset: f64,
    /// The velocity of its face along the normal, in m/s.
    pub velocity: f64,
}

/// The places and velocities of all bodies at an instant, and the two balances.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The time in s.
    pub time: f64,
    /// The mass of each body, in kg: that of a rocket changes.
    pub masses: Vec<f64>,
    /// The position of each body, in m.
    pub positions: Vec<Vec<f64>>,
    /// The velocity of each body, in m/s.
    pub velocities: Vec<Vec<f64>>,
    /// The centre of mass, in m.
    pub centre: Vec<f64>,
    /// The momentum of all, in N s.
    pub momentum: Vec<f64>,
    /// The impulse so far of what acts from outside: walls, weight, forces; in N s.
    pub outside: Vec<f64>,
    /// The kinetic energy of all, in J.
    pub kinetic: f64,
    /// The potential energy of all under gravity, in J.
    pub potential: f64,
    /// The energy lost in impacts so far, in J.
    pub lost: f64,
    /// The work so far of forces that have no potential here, in J.
    pub work: f64,
}

impl Moment {
    /// The energy that the balance keeps constant, in J: kinetic and potential energy and what impacts took, less the work of
    /// forces.
    #[must_use]
    pub fn balance(&self) -> f64 {
        self.kinetic + self.potential + self.lost - self.work
    }
}

/// A row of the table of impacts.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedImpact {
    /// When, in s.
    pub time: f64,
    /// Which bodies or surfaces meet: `A-B`, `ball-floor`.
    pub contact: String,
    /// The impulse on the second of them, in N s.
    pub impulse: Vec<f64>,
    /// The kinetic energy of the bodies there just before, in J.
    pub energy_before: f64,
    /// The same just after, in J.
    pub energy_after: f64,
}

impl Record {
    /// The record of a run that kept everything; times count from `origin` (s).
    ///
    /// ```
    /// use momentous_simulate::{Body, Budget, EventDriven, Method, Record, World};
    ///
    /// let mut world = World::<1>::new(0.7);
    /// world.bodies.push(Body::particle("A", 3.0, [0.0], [3.0]));
    /// world.bodies.push(Body::particle("B", 2.0, [1.0], [-2.0]));
    /// let record = Record::of(&world, &EventDriven.run(&world, &Budget::until(1.0)).unwrap(), 0.0);
    /// assert_eq!(record.impacts[0].contact, "A-B");
    /// assert!(record.moments.iter().all(|moment| (moment.momentum[0] - 5.0).abs() < 1e-12));
    /// assert!(record.moments.iter().all(|moment| (moment.balance() - 17.5).abs() < 1e-12));
    /// ```
    #[must_use]
    pub fn of<const D: usize>(world: &World<D>, run: &Trajectory<D>, origin: f64) -> Self {
        Self::at(world, run, origin, instants(world, run))
    }

    /// The record of a run that kept its steps, at their ends alone, just after them: between them a path is drawn, not computed.
    #[must_use]
    pub fn of_steps<const D: usize>(world: &World<D>, run: &Trajectory<D>) -> Self {
        let ends: Vec<f64> = run.paths.first().into_iter().flatten().map(|segment| segment.end).collect();
        let every = ends.len().div_ceil(INSTANTS).max(1);
        // The last of them is where the run ends.
        let kept = ends.iter().rev().step_by(every).copied().collect::<Vec<f64>>();
        let all = kept.into_iter().chain([0.0]).map(|time| (time, time > 0.0));
        Self::at(world, run, 0.0, all.rev().collect())
    }

    fn at<const D: usize>(world: &World<D>, run: &Trajectory<D>, origin: f64, instants: Vec<Instant>) -> Self {
        let recorded = |body: &Body<D>| Recorded { name: body.name.clone(), mass: body.mass, radius: body.radius };
        let bodies = world.bodies.iter().map(recorded).collect();
        let walls = world.walls.iter().map(|wall| RecordedWall {
            name: wall.name.clone(),
            normal: wall.normal.iter().copied().collect(),
            offset: wall.face(origin),
            velocity: wall.velocity,
        });
        let impacts = run.impacts.iter().map(|impact| RecordedImpact {
            time: impact.time - origin,
            contact: world.name_of(impact.contact),
            impulse: impact.impulse.iter().copied().collect(),
            energy_before: impact.energy_before,
            energy_after: impact.energy_after(),
        });
        let walls = walls.collect();
        Self {
            bodies,
            walls,
            pivot: None,
            lever: None,
            moments: moments(world, run, origin, instants),
            impacts: impacts.collect(),
        }
    }
}

/// An instant, and whether it is looked at just after what happens then.
type Instant = (f64, bool);

fn instants<const D: usize>(world: &World<D>, run: &Trajectory<D>) -> Vec<Instant> {
    let end = run.last.time;
    let mut all: Vec<Instant> =
        (0..=EVENLY).map(|step| (end * f64::from(step) / f64::from(EVENLY), step == EVENLY)).collect();
    for impact in run.impacts.iter().take(INSTANTS) {
        all.extend([(impact.time, false), (impact.time, true)]);
    }
    all.extend(world.breakpoints().into_iter().filter(|time| *time < end).map(|time| (time, false)));
    all.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
    all.dedup();
    all
}

fn state_at<const D: usize>(world: &World<D>, run: &Trajectory<D>, (time, after): Instant) -> State<D> {
    if time <= 0.0 && !after {
        return world.start();
    }
    let mut state = run.last.clone();
    state.time = time;
    if after && time >= run.last.time {
        return run.last.clone();
    }
    // A path between the ends of steps is a chord; the method itself has the velocity at an end.
    let end = run.states.partition_point(|state| state.time < time);
    if let Some(state) = run.states.get(end).filter(|state| after && state.time <= time) {
        return state.clone();
    }
    for body in 0..world.bodies.len() {
        let moving = if after { run.just_after(body, time) } else { run.at(body, time) };
        if let Some((position, velocity)) = moving {
            (state.positions[body], state.velocities[body]) = (position, velocity);
        }
    }
    state
}

fn moments<const D: usize>(world: &World<D>, run: &Trajectory<D>, origin: f64, instants: Vec<Instant>) -> Vec<Moment> {
    let total: f64 = world.bodies.iter().map(|body| body.mass).sum();
    let at_start = potential(world, &world.start());
    let (mut impulse, mut work, mut lost): (Vector<D>, f64, f64) = (Vector::zeros(), 0.0, 0.0);
    let (mut done, mut last) = (0, 0.0);
    let mut all = Vec::new();
    for instant in instants {
        let (time, after) = instant;
        let (pushed, worked) = pushed(world, run, last, time);
        impulse += pushed;
        work += worked;
        last = time;
        while let Some(impact) =
            run.impacts.get(done).filter(|impact| impact.time < time || after && impact.time <= time)
        {
            lost += impact.energy_lost;
            if is_outside(world, impact.contact) {
                impulse += impact.impulse;
            }
            done += 1;
        }
        let state = state_at(world, run, instant);
        let stored = potential(world, &state);
        let weighed = world.bodies.iter().zip(&state.positions).map(|(body, position)| position * (body.mass / total));
        let list = |vector: Vector<D>| vector.iter().copied().collect::<Vec<f64>>();
        all.push(Moment {
            time: time - origin,
            centre: list(weighed.sum()),
            momentum: list(world.momentum(&state.velocities)),
            outside: list(impulse),
            kinetic: world.kinetic_energy(&state.velocities),
            potential: stored,
            lost,
            work: work + stored - at_start,
            masses: world.bodies.iter().map(|body| body.mass).collect(),
            positions: state.positions.into_iter().map(list).collect(),
            velocities: state.velocities.into_iter().map(list).collect(),
        });
    }
    all
}

/// The impulse and the work of all forces between two instants, by Gauss' rule with three points.
fn pushed<const D: usize>(world: &World<D>, run: &Trajectory<D>, from: f64, to: f64) -> (Vector<D>, f64) {
    let (mut impulse, mut work) = (Vector::zeros(), 0.0);
    let (middle, half) = (f64::midpoint(from, to), (to - from) / 2.0);
    if half <= 0.0 {
        return (impulse, work);
    }
    for (place, weight) in GAUSS {
        let state = state_at(world, run, (middle + place * half, false));
        for ((body, velocity), acceleration) in
            world.bodies.iter().zip(&state.velocities).zip(world.accelerations(&state))
        {
            let force: Vector<D> = acceleration * body.mass;
            impulse += force * (weight * half);
            work += force.dot(velocity) * weight * half;
        }
    }
    (impulse, work)
}

/// Whether an impact's impulse comes from something that is no body of the scene.
fn is_outside<const D: usize>(world: &World<D>, contact: Contact) -> bool {
    world.parties(contact).0.is_none()
}

/// The potential energy under gravity, of the place and of centres.
fn potential<const D: usize>(world: &World<D>, state: &State<D>) -> f64 {
    let weights: f64 =
        world.bodies.iter().zip(&state.positions).map(|(body, place)| -body.mass * world.gravity.dot(place)).sum();
    let pulls = world.forces.iter().map(|force| match force {
        Force::Central { body, centre, parameter } => {
            -parameter * world.bodies[*body].mass / (state.positions[*body] - centre).norm()
        }
        _ => 0.0,
    });
    weights + pulls.sum::<f64>()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::budget::Budget;
    use crate::force::Strength;
    use crate::method::Method;
    use crate::methods::{EventDriven, ExplicitEuler, RungeKutta};
    use crate::world::Wall;

    fn dropped() -> World<1> {
        let mut world = World::new(0.5);
        world.gravity = Vector::from([-10.0]);
        world.bodies.push(Body::particle("ball", 2.0, [5.0], [0.0]));
        world.walls.push(Wall::new("floor", [1.0], 0.0));
        world
    }

    /// From 5 m at g = 10 m/s²: the floor after 1 s at 10 m/s, back at 5 m/s, and on the floor again 1 s later.
    #[test]
    fn a_bounce_keeps_both_balances() {
        let world = dropped();
        let record = Record::of(&world, &EventDriven.run(&world, &Budget::until(1.5)).unwrap(), 1.0);
        let impact = &record.impacts[0];
        assert_eq!((impact.time, impact.contact.as_str(), impact.impulse[0]), (0.0, "ball-floor", 30.0));
        assert_eq!((impact.energy_before, impact.energy_after), (100.0, 25.0));
        let at_impact: Vec<&Moment> = record.moments.iter().filter(|moment| moment.time == 0.0).collect();
        assert_eq!(at_impact.iter().map(|moment| moment.velocities[0][0]).collect::<Vec<_>>(), [-10.0, 5.0]);
        for moment in &record.moments {
            assert!((moment.balance() - 100.0).abs() < 1e-9, "{moment:?}");
            assert!((moment.momentum[0] - moment.outside[0]).abs() < 1e-9, "{moment:?}");
        }
    }

    #[test]
    fn forces_without_a_potential_are_counted_as_work() {
        let mut world = dropped();
        world.walls.clear();
        world.forces.push(Force::Drag { body: 0, coefficient: 0.1 });
        let strength = Strength::polynomial(&[0.0, 3.0]);
        world.forces.push(Force::Varying { body: 0, direction: Vector::from([1.0]), strength });
        let run = RungeKutta { tolerance: 1e-11 }.run(&world, &Budget::until(2.0)).unwrap();
        let moments = Record::of(&world, &run, 0.0).moments;
        assert!(moments.last().is_some_and(|moment| moment.work < -10.0), "drag takes energy");
        for moment in moments {
            assert!((moment.balance() - 100.0).abs() < 1e-7, "{moment:?}");
            assert!((moment.momentum[0] - moment.outside[0]).abs() < 1e-7, "{moment:?}");
        }
    }

    #[test]
    fn a_method_that_makes_energy_is_seen_to_do_so() {
        let mut world = World::<2>::new(1.0);
        world.bodies.push(Body::particle("satellite", 1.0, [1.0, 0.0], [0.0, 1.0]));
        world.forces.push(Force::Central { body: 0, centre: Vector::zeros(), parameter: 1.0 });
        let run = ExplicitEuler { step: 0.06 }.run(&world, &Budget::until(6.0)).unwrap();
        let record = Record::of(&world, &run, 0.0);
        let (first, last) = (record.moments.first().unwrap(), record.moments.last().unwrap());
        assert!(last.kinetic + last.potential > first.kinetic + first.potential + 0.05);
    }
}
