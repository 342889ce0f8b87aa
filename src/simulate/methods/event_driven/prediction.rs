//! When a contact will be struck, if nothing else happens before.

use crate::contact::Contact;
use crate::exact::{Meeting, first_contact, first_fall};
use crate::gap::gap_polynomial;
use crate::state::{State, Vector};
use crate::trajectory::Motion;
use crate::world::{Anchor, World};

use super::field::{Moving, expansion};

/// When a contact closes, how fast, and along which normal where that is known better than from the positions then.
#[derive(Clone, Copy, Debug)]
pub(super) struct Predicted<const D: usize> {
    pub after: f64,
    pub rate: Option<f64>,
    pub normal: Option<Vector<D>>,
}

impl<const D: usize> Predicted<D> {
    fn plain(meeting: Meeting) -> Self {
        Self { after: meeting.after, rate: Some(meeting.rate), normal: None }
    }
}

/// The first time within `horizon` at which a contact is struck. `state` holds the parties as they are now.
pub(super) fn predict<const D: usize>(
    world: &World<D>,
    contact: Contact,
    state: &State<D>,
    moving: &[Moving<D>],
    elapsed: impl Fn(usize) -> f64,
    horizon: f64,
) -> Option<Predicted<D>> {
    let (first, second) = world.parties(contact);
    let pulled = uniform(&moving[second].motion);
    let other = first.map_or(Some(Vector::zeros()), |first| uniform(&moving[first].motion));
    let predicted = match (pulled, other) {
        (Some(pulled), Some(other)) => {
            let acceleration = pulled - other;
            match contact {
                Contact::Bodies(..) if D > 1 && acceleration.amax() == 0.0 => spheres(world, contact, state),
                Contact::Bodies(..) | Contact::Cord(_) if D > 1 => {
                    polynomial(world, contact, state, moving, elapsed, horizon)
                }
                Contact::Cord(cord) => cord_on_a_line(world, cord, state, acceleration[0]),
                Contact::Bodies(..) | Contact::Wall { .. } => {
                    let geometry = world.geometry(contact, state);
                    let rate = world.rate(contact, &geometry.normal, &state.velocities);
                    let curvature = geometry.normal.dot(&acceleration);
                    first_contact(closed(world, contact, state, geometry.gap), rate, curvature).map(Predicted::plain)
                }
            }
        }
        _ => polynomial(world, contact, state, moving, elapsed, horizon),
    };
    predicted.filter(|predicted| predicted.after <= horizon)
}

/// A gap that is nothing but rounding is none.
fn closed<const D: usize>(world: &World<D>, contact: Contact, state: &State<D>, gap: f64) -> f64 {
    if gap <= world.tolerance(contact, state) { 0.0 } else { gap }
}

fn uniform<const D: usize>(motion: &Motion<D>) -> Option<Vector<D>> {
    match motion {
        Motion::Uniform { acceleration, .. } => Some(*acceleration),
        _ => None,
    }
}

/// Two spheres whose relative motion is straight, from the distance at which they would pass each other: grazing keeps its digits.
fn spheres<const D: usize>(world: &World<D>, contact: Contact, state: &State<D>) -> Option<Predicted<D>> {
    let Contact::Bodies(first, second) = contact else { return None };
    let reach = world.bodies[first].radius + world.bodies[second].radius;
    let between = state.positions[second] - state.positions[first];
    let relative = state.velocities[second] - state.velocities[first];
    let speed = relative.norm();
    let along = relative.normalize();
    let ahead = between.dot(&along);
    if speed == 0.0 || ahead >= 0.0 {
        return None;
    }
    let across = between - along * ahead;
    let passing = across.norm();
    if passing >= reach {
        return None;
    }
    let half = ((reach - passing) * (reach + passing)).sqrt();
    let distance = between.norm();
    let way = if closed(world, contact, state, distance - reach) == 0.0 {
        0.0
    } else {
        (distance - reach) * (distance + reach) / (half - ahead)
    };
    let normal = (across - along * half) / reach;
    Some(Predicted { after: way / speed, rate: Some(-speed * half / reach), normal: Some(normal) })
}

/// A cord on a line comes taut on one side or on the other.
fn cord_on_a_line<const D: usize>(
    world: &World<D>,
    cord: usize,
    state: &State<D>,
    acceleration: f64,
) -> Option<Predicted<D>> {
    let cord = &world.cords[cord];
    let (from, speed) = match cord.from {
        Anchor::Body(body) => (state.positions[body][0], state.velocities[body][0]),
        Anchor::Point(point) => (point[0], 0.0),
    };
    let between = state.positions[cord.to][0] - from;
    let rate = state.velocities[cord.to][0] - speed;
    let tolerance = 16.0 * f64::EPSILON * (cord.length + between.abs() + from.abs());
    let closed = |gap: f64| if gap <= tolerance { 0.0 } else { gap };
    let right = first_contact(closed(cord.length - between), -rate, -acceleration);
    let left = first_contact(closed(cord.length + between), rate, acceleration);
    let first = [right, left].into_iter().flatten().min_by(|one, other| one.after.total_cmp(&other.after));
    first.map(Predicted::plain)
}

/// Any polynomial motion: the gap, or the difference of the squares of distance and reach, is a polynomial.
fn polynomial<const D: usize>(
    world: &World<D>,
    contact: Contact,
    state: &State<D>,
    moving: &[Moving<D>],
    elapsed: impl Fn(usize) -> f64,
    horizon: f64,
) -> Option<Predicted<D>> {
    let (first, second) = world.parties(contact);
    let mut relative = expansion(&moving[second].motion, elapsed(second));
    if let Some(first) = first {
        let other = expansion(&moving[first].motion, elapsed(first));
        relative.resize(relative.len().max(other.len()), Vector::zeros());
        for (coefficient, other) in relative.iter_mut().zip(other) {
            *coefficient -= other;
        }
    }
    let gap = gap_polynomial(world, contact, state, &relative, 1.0);
    first_fall(&gap, horizon).map(|after| Predicted { after, rate: None, normal: None })
}
