//! The common part of all methods of fixed step: the loop over steps, and impulses at contacts that are found closed.

use crate::budget::{Budget, Keep};
use crate::contact::Contact;
use crate::refusal::Refusal;
use crate::simultaneous::Struck;
use crate::state::{State, Vector};
use crate::trajectory::{Ending, Impact, Motion, Segment, Trajectory};
use crate::world::World;

/// One step of a method: it moves the state on by the step and returns the impacts.
pub(super) trait Step<const D: usize> {
    fn advance(&mut self, world: &World<D>, state: &mut State<D>, step: f64) -> Result<Vec<Impact<D>>, Refusal>;
}

/// The part of a step that is none of its own: what is left of the time is taken along by the last step.
const SLIVER: f64 = 1e-9;

/// Steps from time 0 until the budget ends; the last step is shortened to end on time.
pub(super) fn march<const D: usize>(
    world: &World<D>,
    budget: &Budget,
    step: f64,
    scheme: &mut dyn Step<D>,
) -> Result<Trajectory<D>, Refusal> {
    world.check()?;
    if !(step > 0.0 && step.is_finite()) {
        return Err(Refusal::Invalid { what: "the step must be positive".to_owned() });
    }
    let mut state = world.start();
    let mut run = Trajectory::begin(state.clone());
    let mut count = 0.0;
    run.ending = loop {
        if state.time >= budget.until {
            break Ending::Time;
        }
        if run.impact_count >= budget.impacts {
            break Ending::Impacts;
        }
        if run.steps >= budget.steps {
            break Ending::Exhausted;
        }
        let before = state.clone();
        count += 1.0;
        let end = count * step;
        let end = if budget.until - end <= SLIVER * step { budget.until } else { end };
        let length = end - before.time;
        let impacts = scheme.advance(world, &mut state, length)?;
        state.time = end;
        let finite = |vector: &Vector<D>| vector.iter().all(|value| value.is_finite());
        if !state.positions.iter().chain(&state.velocities).all(finite) {
            return Err(Refusal::Breakdown { time: end, what: "a number is not finite".to_owned() });
        }
        for body in 0..world.bodies.len() {
            let position = before.positions[body];
            let velocity = (state.positions[body] - position) / length;
            let motion = Motion::Uniform { position, velocity, acceleration: Vector::zeros() };
            run.extend(body, Segment { start: before.time, end, motion }, budget);
        }
        for mut impact in impacts {
            impact.time = end;
            run.note(impact, budget);
        }
        run.steps += 1;
        run.evaluations += 1;
        if budget.keep == Keep::Steps {
            run.states.push(state.clone());
        }
    };
    run.last = state;
    Ok(run)
}

/// The contacts whose gap is closed.
pub(super) fn closed<const D: usize>(world: &World<D>, contacts: &[Contact], state: &State<D>) -> Vec<Struck<D>> {
    let mut struck = Vec::new();
    for &contact in contacts {
        let geometry = world.geometry(contact, state);
        if geometry.gap <= 0.0 {
            let rate = world.rate(contact, &geometry.normal, &state.velocities);
            struck.push(Struck { contact, normal: geometry.normal, rate });
        }
    }
    struck
}

/// Newton's law at each closed contact that approaches, one after another, once.
pub(super) fn strike_once<const D: usize>(
    world: &World<D>,
    contacts: &[Contact],
    state: &mut State<D>,
) -> Vec<Impact<D>> {
    let mut impacts = Vec::new();
    for struck in closed(world, contacts, state) {
        let rate = world.rate(struck.contact, &struck.normal, &state.velocities);
        if rate < 0.0 {
            impacts.push(world.strike(struck.contact, &struck.normal, rate, &mut state.velocities));
        }
    }
    impacts
}

/// Impulses that push only, so that each gap then grows at no less than `-e` times its rate before: the projected iteration of
/// Gauss and Seidel, at most `rounds` times or until nothing changes. `before` are the rates that restitution refers to.
pub(super) fn push_apart<const D: usize>(
    world: &World<D>,
    group: &[Struck<D>],
    before: &[f64],
    rounds: usize,
    velocities: &mut [Vector<D>],
) -> Vec<Impact<D>> {
    let mut impulses = vec![0.0; group.len()];
    let first_rates: Vec<f64> =
        group.iter().map(|struck| world.rate(struck.contact, &struck.normal, velocities)).collect();
    let energies: Vec<f64> = group.iter().map(|struck| energy(world, struck, velocities)).collect();
    for _ in 0..rounds {
        let mut change = 0.0_f64;
        for (place, struck) in group.iter().enumerate() {
            let rate = world.rate(struck.contact, &struck.normal, velocities);
            let wanted = -world.restitution_of(struck.contact) * before[place].min(0.0);
            let total = (impulses[place] + world.reduced_mass(struck.contact) * (wanted - rate)).max(0.0);
            let push = total - impulses[place];
            impulses[place] = total;
            change = change.max(push.abs() / (total + f64::MIN_POSITIVE));
            let (first, second) = world.parties(struck.contact);
            velocities[second] += struck.normal * (push / world.bodies[second].mass);
            if let Some(first) = first {
                velocities[first] -= struck.normal * (push / world.bodies[first].mass);
            }
        }
        if change <= 1e-15 {
            break;
        }
    }
    let mut impacts = Vec::new();
    for (place, struck) in group.iter().enumerate().filter(|(place, _)| impulses[*place] > 0.0) {
        let after = world.rate(struck.contact, &struck.normal, velocities);
        impacts.push(Impact {
            time: 0.0,
            contact: struck.contact,
            impulse: struck.normal * impulses[place],
            energy_before: energies[place],
            energy_lost: -impulses[place] * f64::midpoint(first_rates[place], after),
        });
    }
    impacts
}

fn energy<const D: usize>(world: &World<D>, struck: &Struck<D>, velocities: &[Vector<D>]) -> f64 {
    let energy = |body: usize| world.bodies[body].mass * velocities[body].norm_squared() / 2.0;
    let (first, second) = world.parties(struck.contact);
    energy(second) + first.map_or(0.0, energy)
}
