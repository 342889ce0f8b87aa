//! The gap of a contact as a polynomial, for bodies whose motion is one.

use super::contact::Contact;
use super::state::{State, Vector};
use super::world::{Anchor, World};

/// A polynomial with the sign of the gap, from the coefficients of the second party's position relative to the first's. Where the
/// distance itself is no polynomial it is the difference of the squares. `unit` is the time, in s, that the variable 1 stands for.
pub(super) fn gap_polynomial<const D: usize>(
    world: &World<D>,
    contact: Contact,
    state: &State<D>,
    relative: &[Vector<D>],
    unit: f64,
) -> Vec<f64> {
    let geometry = world.geometry(contact, state);
    let mut gap: Vec<f64> = match contact {
        Contact::Cord(cord) => {
            let cord = &world.cords[cord];
            let mut relative = relative.to_vec();
            if let Anchor::Point(point) = cord.from {
                relative[0] -= point;
            }
            squares(&relative, cord.length).iter().map(|value| -value).collect()
        }
        Contact::Bodies(first, second) if D > 1 => {
            squares(relative, world.bodies[first].radius + world.bodies[second].radius)
        }
        Contact::Bodies(..) | Contact::Wall { .. } => relative.iter().map(|term| geometry.normal.dot(term)).collect(),
    };
    if let Contact::Wall { wall, .. } = contact {
        let wall = &world.walls[wall];
        gap[1] -= wall.velocity * unit * wall.normal.dot(&geometry.normal);
    }
    if D == 1 && matches!(contact, Contact::Bodies(..)) || matches!(contact, Contact::Wall { .. }) {
        gap[0] = geometry.gap;
    }
    if geometry.gap.abs() <= world.tolerance(contact, state) {
        gap[0] = 0.0;
    }
    gap
}

/// The coefficients of `|r|^2 - reach^2`.
fn squares<const D: usize>(relative: &[Vector<D>], reach: f64) -> Vec<f64> {
    let mut sum = vec![0.0; 2 * relative.len() - 1];
    for (one, left) in relative.iter().enumerate() {
        for (other, right) in relative.iter().enumerate() {
            sum[one + other] += left.dot(right);
        }
    }
    let distance = relative[0].norm();
    sum[0] = (distance - reach) * (distance + reach);
    sum
}
