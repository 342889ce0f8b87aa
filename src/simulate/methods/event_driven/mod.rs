//! The event-driven method: exact free motion between exactly located impacts, and an agenda of what will happen next.
//!
//! Each body keeps its own last event; an impact moves only the bodies that it strikes. On a line only neighbours can meet, so a
//! chain costs as much per impact as a pair, but for the agenda.

mod agenda;
mod field;
mod prediction;
mod run;

use crate::budget::Budget;
use crate::force::Force;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::State;
use crate::trajectory::{Ending, Motion, Segment, Trajectory};
use crate::world::World;

use run::Run;

/// Exact motion, exact impacts.
#[derive(Clone, Copy, Debug, Default)]
pub struct EventDriven;

impl<const D: usize> Method<D> for EventDriven {
    fn name(&self) -> &'static str {
        "event driven"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        let (start, contacts) = world.prepare()?;
        if world.forces.iter().any(|force| matches!(force, Force::Central { .. })) {
            return orbits(world, start, budget);
        }
        Run::new(world, start, world.reachable(contacts), budget)?.finish()
    }
}

/// Orbits of particles about fixed centres, which meet nothing.
fn orbits<const D: usize>(world: &World<D>, start: State<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
    let refusal = |force: &str| Err(Refusal::NoExactMotion { force: force.to_owned() });
    let particles = world.bodies.iter().all(|body| body.radius == 0.0);
    if !world.walls.is_empty() || !world.cords.is_empty() || (world.bodies.len() > 1 && (D == 1 || !particles)) {
        return refusal("central gravity between impacts");
    }
    if world.gravity.amax() > 0.0 || !budget.until.is_finite() {
        return refusal("central gravity with another force, or without an end");
    }
    let mut run = Trajectory::begin(start);
    for (index, body) in world.bodies.iter().enumerate() {
        let mut forces = world.forces.iter().filter(|force| force.body() == index);
        let motion = match (forces.next(), forces.next()) {
            (None, None) => {
                Motion::Uniform { position: body.position, velocity: body.velocity, acceleration: world.gravity }
            }
            (Some(Force::Central { centre, parameter, .. }), None) if *parameter > 0.0 && body.position != *centre => {
                let (centre, parameter) = (*centre, *parameter);
                Motion::Orbit(crate::exact::Orbit {
                    centre,
                    parameter,
                    position: body.position,
                    velocity: body.velocity,
                })
            }
            _ => return refusal("central gravity with another force"),
        };
        run.evaluations += 1;
        let (position, velocity) = motion.at(budget.until);
        if !position.iter().chain(velocity.iter()).all(|value| value.is_finite()) {
            return Err(Refusal::Breakdown { time: budget.until, what: "the orbit meets its centre".to_owned() });
        }
        run.last.positions[index] = position;
        run.last.velocities[index] = velocity;
        run.extend(index, Segment { start: 0.0, end: budget.until, motion }, budget);
    }
    run.last.time = budget.until;
    run.ending = Ending::Time;
    Ok(run)
}
