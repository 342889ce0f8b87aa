//! Newton's law of restitution at one smooth contact.

use super::contact::Contact;
use super::state::Vector;
use super::trajectory::Impact;
use super::world::World;

/// The velocities of two masses along a line after an impact in which they approached at `approach` (positive), and the impulse.
///
/// The form decides how far the energy drifts over millions of impacts: `v_G + e (v_G - v)`, about the velocity of the centre of mass.
#[must_use]
pub fn direct_impact(masses: [f64; 2], velocities: [f64; 2], restitution: f64) -> [f64; 2] {
    let [m1, m2] = masses;
    let [v1, v2] = velocities;
    // The velocity of the centre of mass, as a correction of the heavier body's: 0.25 kg against the Earth keeps its digits.
    let centre = if m1 >= m2 {
        let ratio = m2 / m1;
        v1 + ratio / (1.0 + ratio) * (v2 - v1)
    } else {
        let ratio = m1 / m2;
        v2 + ratio / (1.0 + ratio) * (v1 - v2)
    };
    [centre + restitution * (centre - v1), centre + restitution * (centre - v2)]
}

impl<const D: usize> World<D> {
    /// Applies Newton's law at one contact whose gap changes at `rate` (negative). Returns the impact, without its time.
    pub(super) fn strike(
        &self,
        contact: Contact,
        normal: &Vector<D>,
        rate: f64,
        velocities: &mut [Vector<D>],
    ) -> Impact<D> {
        let restitution = self.restitution_of(contact);
        let (first, second) = self.parties(contact);
        let mass = self.bodies[second].mass;
        let mut energy_before = mass * velocities[second].norm_squared() / 2.0;
        let reduced = self.reduced_mass(contact);
        let mut energy_lost = reduced * (1.0 - restitution) * (1.0 + restitution) * rate * rate / 2.0;
        if let Some(first) = first {
            let other = self.bodies[first].mass;
            energy_before += other * velocities[first].norm_squared() / 2.0;
            let before = [normal.dot(&velocities[first]), normal.dot(&velocities[second])];
            let after = direct_impact([other, mass], before, restitution);
            turn(&mut velocities[first], normal, before[0], after[0]);
            turn(&mut velocities[second], normal, before[1], after[1]);
        } else {
            let before = normal.dot(&velocities[second]);
            let face = before - rate;
            turn(&mut velocities[second], normal, before, face - restitution * rate);
            // A wall that moves does work on the body: J u.
            energy_lost -= mass * (1.0 + restitution) * -rate * face;
        }
        let impulse = normal * (reduced * (1.0 + restitution) * -rate);
        Impact { time: 0.0, contact, impulse, energy_before, energy_lost }
    }
}

/// Changes the component of a velocity along a normal; on a line it is set, so that no digit is lost.
fn turn<const D: usize>(velocity: &mut Vector<D>, normal: &Vector<D>, before: f64, after: f64) {
    if D == 1 {
        *velocity = normal * after;
    } else {
        *velocity += normal * (after - before);
    }
}
