//! Particles, the forces and constraints that act on them, and where a state holds them.

use std::borrow::Cow;

use super::in_time::InTime as Timed;
use super::vector::{Vector, ZERO, dot, less, times, within};

/// A particle, and how it starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Particle<'a> {
    pub name: &'a str,
    /// Its mass; none where it is too heavy to be moved.
    pub mass: Option<f64>,
    pub place: Vector,
    pub velocity: Vector,
    /// Its acceleration in free fall.
    pub falls: Vector,
    /// The one direction in which a guide lets it move.
    pub guide: Option<Vector>,
}

/// Particles by their places in a list, each with a vector: for a force, what a unit of its strength does to each; for something
/// stretched between them, how much longer it gets for a metre that each moves.
pub(super) type Lines = Vec<(usize, Vector)>;

/// Lines that stay what they are, or that a state makes.
pub(super) type SharedLines<'a> = Cow<'a, [(usize, Vector)]>;

/// A force on particles.
pub(super) struct Force {
    pub on: Lines,
    pub strength: Strength,
}

/// How strong a force is.
pub(super) enum Strength {
    /// A force that changes with the time.
    InTime(Timed),
    /// Against the velocity along the line, so much for each metre per second, and for the square of it.
    Resistance { linear: f64, quadratic: f64 },
    /// The pull of a spring, which is deformed by so much where all particles are at the origin.
    Spring { stiffness: f64, deformed: f64 },
}

/// The constraint that particles cannot leave.
pub(super) enum Constraint {
    /// A cord or a coupling that keeps its length, or a straight face that one body slides along on another.
    Length(Lines),
    Surface(Surface),
}

/// The surface round a centre on which `x² s_x + y² s_y + z² s_z` is constant, for squares `s`: a sphere or a circle, or a cone with
/// its tip in the centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    pub on: usize,
    /// The particle that carries the surface, where it is not fixed.
    pub carrier: Option<usize>,
    pub centre: Vector,
    pub squares: Vector,
    /// Half the second derivative of the constant by the time.
    pub changes: f64,
}

/// The place of a particle in a state.
pub(super) fn place(state: &[f64], particle: usize) -> Vector {
    within(state, 6 * particle)
}

/// The velocity of a particle in a state, or its acceleration in a slope.
pub(super) fn velocity(state: &[f64], particle: usize) -> Vector {
    within(state, 6 * particle + 3)
}

impl<'a> Particle<'a> {
    /// A particle at the origin that nothing guides, and that does not fall.
    pub(super) fn free(name: &'a str, mass: f64, velocity: Vector) -> Self {
        Self { name, mass: Some(mass), place: ZERO, velocity, falls: ZERO, guide: None }
    }

    /// The effect of a force on it: the acceleration, and what its guide adds to the force.
    pub(super) fn yields(&self, force: Vector) -> (Vector, Vector) {
        let Some(mass) = self.mass else { return (ZERO, ZERO) };
        let felt = self.let_through(force);
        (felt.map(|part| part / mass), less(felt, force))
    }

    /// The part of a vector that its guide lets through.
    pub(super) fn let_through(&self, vector: Vector) -> Vector {
        self.guide.map_or(vector, |along| times(dot(along, vector), along))
    }
}

impl Force {
    /// A force in the time of the stage.
    pub(super) fn in_time(on: Lines, strength: Timed) -> Self {
        Self { on, strength: Strength::InTime(strength) }
    }

    /// A force on one particle that stays what it is.
    pub(super) fn steady(on: usize, force: Vector) -> Self {
        Self::in_time(vec![(on, force)], Timed::steady(1.0))
    }

    /// A spring that is deformed by so much where all particles are at the origin.
    pub(super) fn spring(on: Lines, stiffness: f64, deformed: f64) -> Self {
        Self { on, strength: Strength::Spring { stiffness, deformed } }
    }

    /// A resistance to the motion of a particle along a direction, for each metre per second and for the square of it.
    pub(super) fn resistance(on: usize, along: Vector, [linear, quadratic]: [f64; 2]) -> Self {
        Self { on: vec![(on, along)], strength: Strength::Resistance { linear, quadratic } }
    }

    /// A cord that gives way: it pulls by so much for each metre per second by which it gets longer.
    pub(super) fn damper(on: Lines, linear: f64) -> Self {
        Self { on, strength: Strength::Resistance { linear, quadratic: 0.0 } }
    }

    pub(super) fn strength(&self, time: f64, state: &[f64]) -> f64 {
        match &self.strength {
            Strength::InTime(strength) => strength.at(time),
            Strength::Resistance { linear, quadratic } => {
                let speed = self.moves(state);
                -(linear + quadratic * speed.abs()) * speed
            }
            Strength::Spring { stiffness, deformed } => -stiffness * self.stretched(*deformed, state),
        }
    }

    /// How fast the particles move along the line.
    fn moves(&self, state: &[f64]) -> f64 {
        self.on.iter().fold(0.0, |sum, (index, along)| sum + dot(*along, velocity(state, *index)))
    }

    /// How far a spring is deformed.
    pub(super) fn deformation(&self, state: &[f64]) -> Option<f64> {
        let Strength::Spring { deformed, .. } = self.strength else { return None };
        Some(self.stretched(deformed, state))
    }

    /// How far the line is longer than where all particles are at the origin and it is deformed by so much.
    pub(super) fn stretched(&self, deformed: f64, state: &[f64]) -> f64 {
        self.on.iter().fold(deformed, |sum, (index, along)| sum + dot(*along, place(state, *index)))
    }
}

impl Surface {
    /// A fixed sphere round the origin, for one particle.
    pub(super) fn sphere() -> Self {
        Self { on: 0, carrier: None, centre: ZERO, squares: [1.0; 3], changes: 0.0 }
    }

    /// A fixed circle in the plane of x and y.
    pub(super) fn circle(centre: Vector) -> Self {
        Self { centre, squares: [1.0, 1.0, 0.0], ..Self::sphere() }
    }

    /// A fixed cone whose wall is so far from its axis for each metre of height.
    pub(super) fn cone(tangent: f64) -> Self {
        Self { squares: [1.0, 1.0, -tangent * tangent], ..Self::sphere() }
    }

    fn weighed(&self, vector: Vector) -> Vector {
        [0, 1, 2].map(|component| self.squares[component] * vector[component])
    }
}

impl Constraint {
    /// Along which lines it acts on the particles, and what their accelerations along these lines must add up to.
    pub(super) fn lines(&self, state: &[f64]) -> (SharedLines<'_>, f64) {
        match self {
            Self::Length(lines) => (Cow::Borrowed(lines), 0.0),
            Self::Surface(surface) => {
                let relative = |part: fn(&[f64], usize) -> Vector| {
                    surface
                        .carrier
                        .map_or(part(state, surface.on), |carrier| less(part(state, surface.on), part(state, carrier)))
                };
                let (normal, moving) = (surface.weighed(less(relative(place), surface.centre)), relative(velocity));
                let back = surface.carrier.map(|carrier| (carrier, times(-1.0, normal)));
                let lines = [(surface.on, normal)].into_iter().chain(back).collect();
                (Cow::Owned(lines), surface.changes - dot(moving, surface.weighed(moving)))
            }
        }
    }
}
