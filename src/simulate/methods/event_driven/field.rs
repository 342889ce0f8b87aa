//! The free motion of each body: its acceleration as a polynomial in the time until the next change of a force.

use crate::exact::{Clock, shifted};
use crate::force::{Force, HIGHEST_POWER, Strength};
use crate::refusal::Refusal;
use crate::state::Vector;
use crate::trajectory::Motion;
use crate::world::World;

/// A body in free motion since its last event.
#[derive(Clone, Debug)]
pub(super) struct Moving<const D: usize> {
    pub since: Clock,
    pub motion: Motion<D>,
}

/// The motion of a body from a state on, under the forces that hold at a time.
pub(super) fn motion_from<const D: usize>(
    world: &World<D>,
    body: usize,
    time: f64,
    position: Vector<D>,
    velocity: Vector<D>,
) -> Result<Motion<D>, Refusal> {
    let refusal = |force: &str| Refusal::NoExactMotion { force: force.to_owned() };
    let mass = world.bodies[body].mass;
    let mut acceleration = world.gravity;
    let mut varying: Vec<Vector<D>> = Vec::new();
    for force in world.forces.iter().filter(|force| force.body() == body) {
        match force {
            Force::Constant { force, .. } => acceleration += force / mass,
            Force::Varying { strength: Strength::Function(_), .. } => {
                return Err(refusal("a force that is not a polynomial in time"));
            }
            Force::Varying { direction, strength: Strength::Pieces(pieces), .. } => {
                let Some(piece) = pieces.iter().find(|piece| time < piece.until) else { continue };
                let local = shifted(&piece.coefficients, time);
                if local.len() > HIGHEST_POWER + 1 {
                    return Err(refusal("a force that grows faster than the sixth power of the time"));
                }
                varying.resize(varying.len().max(local.len()), Vector::zeros());
                for (power, coefficient) in local.iter().enumerate() {
                    varying[power] += direction * (coefficient / mass);
                }
            }
            Force::Drag { coefficient, .. } if *coefficient == 0.0 => {}
            Force::Drag { .. } => return Err(refusal("quadratic drag")),
            Force::Central { .. } => return Err(refusal("central gravity between impacts")),
        }
    }
    if let Some(first) = varying.first_mut() {
        *first += acceleration;
        acceleration = *first;
    }
    if varying.len() < 2 {
        return Ok(Motion::Uniform { position, velocity, acceleration });
    }
    let mut coefficients = vec![position, velocity];
    let mut power = 0.0;
    for term in varying {
        coefficients.push(term / ((power + 1.0) * (power + 2.0)));
        power += 1.0;
    }
    Ok(Motion::Polynomial(coefficients))
}

/// The coefficients of a motion in the time since a later moment, and the acceleration where it is constant.
pub(super) fn expansion<const D: usize>(motion: &Motion<D>, elapsed: f64) -> Vec<Vector<D>> {
    let mut local = match motion {
        Motion::Uniform { position, velocity, acceleration } => vec![*position, *velocity, acceleration / 2.0],
        Motion::Polynomial(coefficients) => coefficients.clone(),
        Motion::Orbit(_) => Vec::new(),
    };
    if elapsed != 0.0 {
        for done in 0..local.len() {
            for place in (done..local.len().saturating_sub(1)).rev() {
                let next = local[place + 1];
                local[place] += next * elapsed;
            }
        }
    }
    local
}
