//! Penalty contact: a spring and a dashpot that push while the bodies overlap, calibrated so that an impact returns e.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Impact, Trajectory};
use crate::world::World;

use super::marching::{Step, march};

/// A spring and a dashpot at every contact, stepped by symplectic Euler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// The step in s.
    pub step: f64,
    /// The stiffness in N/m; `None` for the one with which an impact takes [`STEPS_PER_CONTACT`] steps.
    pub stiffness: Option<f64>,
}

/// The steps that an impact takes where no stiffness is said.
pub const STEPS_PER_CONTACT: f64 = 40.0;

impl<const D: usize> Method<D> for Penalty {
    fn name(&self) -> &'static str {
        "penalty"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        world.check()?;
        let mut springs = Vec::new();
        for contact in world.contacts() {
            let mass = world.reduced_mass(contact);
            let restitution = world.restitution_of(contact);
            let damping = damping_ratio(restitution).ok_or(Refusal::NoCalibration { restitution })?;
            let frequency = match self.stiffness {
                Some(stiffness) => (stiffness / mass).sqrt(),
                None => std::f64::consts::PI / (STEPS_PER_CONTACT * self.step),
            };
            let product = self.step * frequency * damping.max(1.0);
            if product >= 2.0 {
                return Err(Refusal::Unstable { product });
            }
            let stiffness = mass * frequency * frequency;
            springs.push(Spring { contact, stiffness, dashpot: 2.0 * damping * frequency * mass, under_way: None });
        }
        march(world, budget, self.step, &mut Scheme { springs, accelerations: Vec::new() })
    }
}

/// The damping ratio with which a linear spring and dashpot return `e`, where the contact ends when its force does, since it
/// cannot pull (Schwager and Pöschel 2007): `e = exp(-2 phi cot phi)` with `cos phi` the ratio, and its continuation beyond 1.
/// `None` for `e = 0`, which needs an infinite one.
///
/// ```
/// use momentous_simulate::damping_ratio;
/// assert_eq!(damping_ratio(1.0), Some(0.0));
/// assert!((damping_ratio((-2.0_f64).exp()).unwrap() - 1.0).abs() < 1e-9);
/// assert_eq!(damping_ratio(0.0), None);
/// ```
#[must_use]
pub fn damping_ratio(restitution: f64) -> Option<f64> {
    let (mut low, mut high) = (0.0, 1e6);
    if restitution >= 1.0 {
        return Some(0.0);
    }
    if restitution < returned(high) || restitution <= 0.0 {
        return None;
    }
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if returned(middle) > restitution {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(f64::midpoint(low, high))
}

/// The coefficient of restitution of a damping ratio.
fn returned(ratio: f64) -> f64 {
    let beside = ratio - 1.0;
    let exponent = if beside.abs() < 1e-7 {
        1.0 + 2.0 * beside / 3.0
    } else if ratio < 1.0 {
        let phi = libm::acos(ratio);
        phi * ratio / libm::sin(phi)
    } else {
        let psi = libm::acosh(ratio);
        psi * ratio / libm::sinh(psi)
    };
    libm::exp(-2.0 * exponent)
}

/// The spring and the dashpot of a contact.
struct Spring<const D: usize> {
    contact: Contact,
    stiffness: f64,
    dashpot: f64,
    /// The impulse so far and the kinetic energy at the start, while it is pressed.
    under_way: Option<(Vector<D>, f64)>,
}

struct Scheme<const D: usize> {
    springs: Vec<Spring<D>>,
    accelerations: Vec<Vector<D>>,
}

impl<const D: usize> Step<D> for Scheme<D> {
    fn advance(&mut self, world: &World<D>, state: &mut State<D>, step: f64) -> Result<Vec<Impact<D>>, Refusal> {
        world.accelerate(state, &mut self.accelerations);
        let mut impacts = Vec::new();
        for spring in &mut self.springs {
            let contact = spring.contact;
            let (first, second) = world.parties(contact);
            let energy = || {
                let energy = |body: usize| world.bodies[body].mass * state.velocities[body].norm_squared() / 2.0;
                energy(second) + first.map_or(0.0, energy)
            };
            let geometry = world.geometry(contact, state);
            let rate = world.rate(contact, &geometry.normal, &state.velocities);
            let force = -spring.stiffness * geometry.gap - spring.dashpot * rate;
            let presses = geometry.gap < 0.0 && force > 0.0;
            if presses {
                let push = geometry.normal * force;
                self.accelerations[second] += push / world.bodies[second].mass;
                if let Some(first) = first {
                    self.accelerations[first] -= push / world.bodies[first].mass;
                }
                let (impulse, _) = spring.under_way.get_or_insert_with(|| (Vector::zeros(), energy()));
                *impulse += push * step;
            } else if let Some((impulse, energy_before)) = spring.under_way.take() {
                let energy_lost = energy_before - energy();
                impacts.push(Impact { time: 0.0, contact, impulse, energy_before, energy_lost });
            }
        }
        for body in 0..world.bodies.len() {
            state.velocities[body] += self.accelerations[body] * step;
            let velocity = state.velocities[body];
            state.positions[body] += velocity * step;
        }
        state.time += step;
        Ok(impacts)
    }
}
