//! A scene as numbers: spheres, walls, cords, forces and the laws of their impacts, in SI units.

use super::contact::Contact;
use super::force::Force;
use super::refusal::Refusal;
use super::state::{State, Vector};

/// A sphere (a disc in the plane, a bead on a line) that does not spin. A particle has the radius 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Body<const D: usize> {
    /// How messages call it.
    pub name: String,
    /// Its mass in kg, positive.
    pub mass: f64,
    /// Its radius in m.
    pub radius: f64,
    /// The place of its centre at time 0, in m.
    pub position: Vector<D>,
    /// Its velocity at time 0, in m/s.
    pub velocity: Vector<D>,
}

impl<const D: usize> Body<D> {
    /// A particle.
    #[must_use]
    pub fn particle(name: &str, mass: f64, position: [f64; D], velocity: [f64; D]) -> Self {
        Self::sphere(name, mass, 0.0, position, velocity)
    }

    /// A sphere of a radius.
    #[must_use]
    pub fn sphere(name: &str, mass: f64, radius: f64, position: [f64; D], velocity: [f64; D]) -> Self {
        Self { name: name.to_owned(), mass, radius, position: position.into(), velocity: velocity.into() }
    }
}

/// A smooth plane of a body too heavy to be moved: a wall, a floor, a slope, a ceiling.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<const D: usize> {
    /// How messages call it.
    pub name: String,
    /// The unit normal, away from the wall towards the bodies.
    pub normal: Vector<D>,
    /// The place of the face at time 0: its points have this component along the normal, in m.
    pub offset: f64,
    /// The velocity of the face along the normal, in m/s.
    pub velocity: f64,
    /// How thick the wall is, in m, where it has a far side; `None` for a wall that fills everything behind its face.
    pub thickness: Option<f64>,
}

impl<const D: usize> Wall<D> {
    /// A wall at rest whose face goes through `offset` along the direction `normal`, which need not have the length 1.
    #[must_use]
    pub fn new(name: &str, normal: [f64; D], offset: f64) -> Self {
        let normal = Vector::from(normal);
        let length = normal.norm();
        let normal = if length > 0.0 { normal / length } else { normal };
        Self { name: name.to_owned(), normal, offset, velocity: 0.0, thickness: None }
    }

    /// The same wall with a far side.
    #[must_use]
    pub fn thick(mut self, thickness: f64) -> Self {
        self.thickness = Some(thickness);
        self
    }

    /// The same wall, moving along its normal.
    #[must_use]
    pub fn moving(mut self, velocity: f64) -> Self {
        self.velocity = velocity;
        self
    }

    /// The place of the near face at a time, along the normal.
    #[must_use]
    pub fn face(&self, time: f64) -> f64 {
        self.offset + self.velocity * time
    }
}

/// The anchor of a cord at its first end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor<const D: usize> {
    /// A body, by its place in the list.
    Body(usize),
    /// A fixed point.
    Point(Vector<D>),
}

/// A light cord that cannot be longer than its length; when it comes taut there is an impact along it.
#[derive(Clone, Debug, PartialEq)]
pub struct Cord<const D: usize> {
    /// How messages call it.
    pub name: String,
    /// Its first end.
    pub from: Anchor<D>,
    /// The body at its other end, by its place in the list.
    pub to: usize,
    /// Its length in m.
    pub length: f64,
    /// The coefficient of restitution when it comes taut: 0 for a cord that does not stretch.
    pub restitution: f64,
}

/// The rule for contacts that share a body and are struck at the same instant; Newton's law alone does not say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Together {
    /// Ask for a law: the run is refused by name.
    #[default]
    Refuse,
    /// Newton's law at every contact at once: each pair separates at `e` times its own speed of approach.
    Newton,
    /// One pair after another, the one that approaches fastest first, until none approaches.
    OneByOne,
}

/// A scene as numbers. Times begin at 0.
///
/// ```
/// use momentous_simulate::{Body, Budget, EventDriven, Method, World};
///
/// let mut world = World::<1>::new(0.7);
/// world.bodies.push(Body::particle("A", 3.0, [0.0], [3.0]));
/// world.bodies.push(Body::particle("B", 2.0, [1.0], [-2.0]));
/// let run = EventDriven.run(&world, &Budget::until(1.0)).unwrap();
/// assert_eq!(run.impacts.len(), 1);
/// assert!((run.last.velocities[0].x - -0.4).abs() < 1e-15);
/// ```
#[derive(Clone, Debug)]
pub struct World<const D: usize> {
    /// The spheres.
    pub bodies: Vec<Body<D>>,
    /// The walls.
    pub walls: Vec<Wall<D>>,
    /// The cords.
    pub cords: Vec<Cord<D>>,
    /// The acceleration that every body has, in m/s².
    pub gravity: Vector<D>,
    /// The other forces.
    pub forces: Vec<Force<D>>,
    /// The coefficient of restitution where nothing else is said.
    pub restitution: f64,
    /// The coefficients of particular contacts.
    pub restitutions: Vec<(Contact, f64)>,
    /// The rule for simultaneous impacts.
    pub together: Together,
}

impl<const D: usize> World<D> {
    /// An empty world with this coefficient of restitution at every contact.
    #[must_use]
    pub fn new(restitution: f64) -> Self {
        Self {
            bodies: Vec::new(),
            walls: Vec::new(),
            cords: Vec::new(),
            gravity: Vector::zeros(),
            forces: Vec::new(),
            restitution,
            restitutions: Vec::new(),
            together: Together::Refuse,
        }
    }

    /// The coefficient of restitution of a contact.
    #[must_use]
    pub fn restitution_of(&self, contact: Contact) -> f64 {
        if let Contact::Cord(cord) = contact {
            return self.cords[cord].restitution;
        }
        let pair = self.restitutions.iter().find(|(other, _)| *other == contact);
        pair.map_or(self.restitution, |(_, value)| *value)
    }

    /// The kinetic energy of bodies with these velocities, in J.
    #[must_use]
    pub fn kinetic_energy(&self, velocities: &[Vector<D>]) -> f64 {
        self.bodies.iter().zip(velocities).map(|(body, velocity)| body.mass * velocity.norm_squared() / 2.0).sum()
    }

    /// The momentum of bodies with these velocities, in N s.
    #[must_use]
    pub fn momentum(&self, velocities: &[Vector<D>]) -> Vector<D> {
        self.bodies.iter().zip(velocities).map(|(body, velocity)| velocity * body.mass).sum()
    }

    /// Whether the numbers make a scene: finite, masses positive, coefficients between 0 and 1, nothing inside anything else.
    ///
    /// # Errors
    /// The first thing that is wrong, by name.
    pub fn check(&self) -> Result<(), Refusal> {
        self.prepare().map(drop)
    }

    /// The same, but for what is inside what.
    fn check_numbers(&self) -> Result<(), Refusal> {
        let invalid = |what: String| Err(Refusal::Invalid { what });
        if D == 0 || self.bodies.is_empty() {
            return invalid("there is no body".to_owned());
        }
        let finite = |vector: &Vector<D>| vector.iter().all(|value| value.is_finite());
        for body in &self.bodies {
            if !(body.mass.is_finite() && body.mass > 0.0 && body.radius.is_finite() && body.radius >= 0.0) {
                return invalid(format!("{} needs a positive mass and a radius", body.name));
            }
            if !finite(&body.position) || !finite(&body.velocity) {
                return invalid(format!("{} has a position or a velocity that is not finite", body.name));
            }
        }
        for wall in &self.walls {
            let thick = wall.thickness.is_none_or(|thickness| thickness > 0.0);
            if !((wall.normal.norm() - 1.0).abs() < 1e-9
                && wall.offset.is_finite()
                && wall.velocity.is_finite()
                && thick)
            {
                return invalid(format!("{} needs a normal, an offset and a positive thickness", wall.name));
            }
        }
        for cord in &self.cords {
            let tied = match cord.from {
                Anchor::Body(body) => body < self.bodies.len() && body != cord.to,
                Anchor::Point(point) => finite(&point),
            };
            if !tied || cord.to >= self.bodies.len() || !(cord.length > 0.0 && cord.length.is_finite()) {
                return invalid(format!("{} needs two ends and a positive length", cord.name));
            }
        }
        let coefficients = self.restitutions.iter().map(|(_, value)| *value);
        let cords = self.cords.iter().map(|cord| cord.restitution);
        if coefficients.chain(cords).chain([self.restitution]).any(|e| !(0.0..=1.0).contains(&e)) {
            return invalid("a coefficient of restitution is outside the range 0 to 1".to_owned());
        }
        if !finite(&self.gravity) || self.forces.iter().any(|force| !force.is_sound(self.bodies.len())) {
            return invalid("a force is not finite, or acts on no body".to_owned());
        }
        Ok(())
    }

    /// The state at time 0 and every contact, of a world that was checked.
    ///
    /// # Errors
    /// The first thing that is wrong, by name.
    pub(super) fn prepare(&self) -> Result<(State<D>, Vec<Contact>), Refusal> {
        self.check_numbers()?;
        let (state, contacts) = (self.start(), self.contacts());
        for &contact in &contacts {
            if self.gap(contact, &state) < -self.tolerance(contact, &state) {
                return Err(Refusal::Overlap { contact: self.name_of(contact) });
            }
        }
        Ok((state, contacts))
    }

    /// The state at time 0.
    #[must_use]
    pub fn start(&self) -> State<D> {
        State {
            time: 0.0,
            positions: self.bodies.iter().map(|body| body.position).collect(),
            velocities: self.bodies.iter().map(|body| body.velocity).collect(),
        }
    }
}
