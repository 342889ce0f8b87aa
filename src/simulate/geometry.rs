//! Contacts, where two things can touch: the gap between them, the direction of its impulse, and which of them touch now.

use super::contact::Contact;
use super::state::{State, Vector};
use super::world::{Anchor, World};

/// How far a contact is from touching, and which way an impulse would act: along `normal` on `second`, against it on `first`.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<const D: usize> {
    /// The distance that is left, in m; negative inside.
    pub gap: f64,
    /// The direction in which the gap grows when `second` moves.
    pub normal: Vector<D>,
}

impl<const D: usize> World<D> {
    /// Every place where an impulse could act. On a line only neighbours can meet, in the order in which they stand.
    #[must_use]
    pub fn contacts(&self) -> Vec<Contact> {
        let mut all = Vec::new();
        if D == 1 {
            let order = self.order();
            all.extend(order.windows(2).map(|pair| Contact::Bodies(pair[0], pair[1])));
        } else {
            for second in 1..self.bodies.len() {
                all.extend((0..second).map(|first| Contact::Bodies(first, second)));
            }
        }
        for wall in 0..self.walls.len() {
            all.extend((0..self.bodies.len()).map(|body| Contact::Wall { wall, body }));
        }
        all.extend((0..self.cords.len()).map(Contact::Cord));
        all
    }

    /// The contacts that a method needs which never lets bodies into each other: on a line only the next body reaches a wall.
    pub(super) fn reachable(&self, mut contacts: Vec<Contact>) -> Vec<Contact> {
        if D == 1 {
            let next: Vec<[Option<usize>; 2]> = (0..self.walls.len()).map(|wall| self.next_to(wall)).collect();
            contacts.retain(|contact| match contact {
                Contact::Wall { wall, body } => next[*wall].contains(&Some(*body)),
                _ => true,
            });
        }
        contacts
    }

    /// The body nearest to the face of a wall, and the nearest to its far side where it has one and a body stands behind it.
    fn next_to(&self, wall: usize) -> [Option<usize>; 2] {
        let wall = &self.walls[wall];
        let middle = -wall.thickness.map_or(f64::INFINITY, |thickness| thickness / 2.0);
        let mut sides: [Option<(f64, usize)>; 2] = [None; 2];
        for (index, body) in self.bodies.iter().enumerate() {
            let height = wall.normal.dot(&body.position) - wall.offset;
            let (reach, side) = if height < middle { (-height, 1) } else { (height, 0) };
            let gap = reach - body.radius;
            if sides[side].is_none_or(|(least, _)| gap < least) {
                sides[side] = Some((gap, index));
            }
        }
        sides.map(|nearest| nearest.map(|(_, index)| index))
    }

    /// The bodies from left to right along the first axis; those at one place in the order of the list.
    pub(super) fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.bodies.len()).collect();
        order.sort_by(|&left, &right| self.bodies[left].position[0].total_cmp(&self.bodies[right].position[0]));
        order
    }

    /// The bodies at a contact: `None` stands for a wall or a fixed point.
    #[must_use]
    #[inline]
    pub fn parties(&self, contact: Contact) -> (Option<usize>, usize) {
        match contact {
            Contact::Bodies(first, second) => (Some(first), second),
            Contact::Wall { body, .. } => (None, body),
            Contact::Cord(cord) => match self.cords[cord].from {
                Anchor::Body(first) => (Some(first), self.cords[cord].to),
                Anchor::Point(_) => (None, self.cords[cord].to),
            },
        }
    }

    /// Gap and normal of a contact.
    #[must_use]
    #[inline]
    pub fn geometry(&self, contact: Contact, state: &State<D>) -> Geometry<D> {
        match contact {
            Contact::Bodies(first, second) => {
                let between = state.positions[second] - state.positions[first];
                let radii = self.bodies[first].radius + self.bodies[second].radius;
                if D == 1 {
                    return Geometry { gap: between[0] - radii, normal: Vector::repeat(1.0) };
                }
                let distance = between.norm();
                let normal = if distance > 0.0 { between / distance } else { axis() };
                Geometry { gap: distance - radii, normal }
            }
            Contact::Wall { wall, body } => {
                let wall = &self.walls[wall];
                let radius = self.bodies[body].radius;
                let height = wall.normal.dot(&state.positions[body]) - wall.face(state.time);
                match wall.thickness {
                    Some(thickness) if height < -thickness / 2.0 => {
                        Geometry { gap: -height - thickness - radius, normal: -wall.normal }
                    }
                    _ => Geometry { gap: height - radius, normal: wall.normal },
                }
            }
            Contact::Cord(cord) => {
                let cord = &self.cords[cord];
                let from = match cord.from {
                    Anchor::Body(body) => state.positions[body],
                    Anchor::Point(point) => point,
                };
                let between = state.positions[cord.to] - from;
                let distance = between.norm();
                let normal = if distance > 0.0 { -between / distance } else { axis() };
                Geometry { gap: cord.length - distance, normal }
            }
        }
    }

    /// The gap of a contact, in m.
    #[must_use]
    #[inline]
    pub fn gap(&self, contact: Contact, state: &State<D>) -> f64 {
        self.geometry(contact, state).gap
    }

    /// How fast a gap grows, in m/s.
    #[must_use]
    #[inline]
    pub fn rate(&self, contact: Contact, normal: &Vector<D>, velocities: &[Vector<D>]) -> f64 {
        let (first, second) = self.parties(contact);
        let velocity = normal.dot(&velocities[second]);
        let other = match (first, contact) {
            (Some(first), _) => normal.dot(&velocities[first]),
            (None, Contact::Wall { wall, .. }) => {
                let wall = &self.walls[wall];
                wall.velocity * wall.normal.dot(normal)
            }
            (None, _) => 0.0,
        };
        velocity - other
    }

    /// The reduced mass of the two bodies at a contact, in kg: that of the body alone at a wall.
    #[must_use]
    pub fn reduced_mass(&self, contact: Contact) -> f64 {
        let (first, second) = self.parties(contact);
        let mass = self.bodies[second].mass;
        first.map_or(mass, |first| {
            let other = self.bodies[first].mass;
            // Never the product of the masses, which could overflow.
            let (light, heavy) = if mass < other { (mass, other) } else { (other, mass) };
            light / (1.0 + light / heavy)
        })
    }

    /// The sum of the radii of the bodies at a contact, in m.
    pub(super) fn reach(&self, contact: Contact) -> f64 {
        let (first, second) = self.parties(contact);
        self.bodies[second].radius + first.map_or(0.0, |first| self.bodies[first].radius)
    }

    /// The distance below which a gap is nothing but rounding, in m.
    #[must_use]
    #[inline]
    pub fn tolerance(&self, contact: Contact, state: &State<D>) -> f64 {
        let reach = |body: usize| state.positions[body].amax() + self.bodies[body].radius;
        let (first, second) = self.parties(contact);
        let fixed = match contact {
            Contact::Wall { wall, .. } => self.walls[wall].face(state.time).abs(),
            Contact::Cord(cord) => self.cords[cord].length,
            Contact::Bodies(..) => 0.0,
        };
        16.0 * f64::EPSILON * (reach(second) + first.map_or(0.0, reach) + fixed)
    }

    /// How a message calls a contact: `A-B`, `ball-floor`.
    #[must_use]
    pub fn name_of(&self, contact: Contact) -> String {
        let body = |index: usize| self.bodies[index].name.as_str();
        match contact {
            Contact::Bodies(first, second) => format!("{}-{}", body(first), body(second)),
            Contact::Wall { wall, body: index } => format!("{}-{}", body(index), self.walls[wall].name),
            Contact::Cord(cord) => self.cords[cord].name.clone(),
        }
    }
}

/// A direction for bodies whose centres coincide, where none is better than another.
fn axis<const D: usize>() -> Vector<D> {
    let mut axis = Vector::zeros();
    axis[0] = 1.0;
    axis
}
