//! Motions given as functions: velocity, acceleration and force from them.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// The place at an instant.
pub const PLACE: Law = Law {
    id: "place-as-told",
    name: "the position as a function of time",
    statement: "The position at an instant is the value of the given function at that time.",
    signs: "Positive along the axis.",
    when: "The problem gives the position as a function of time.",
    source: "The problem.",
    wrong: &[],
};

/// The velocity at an instant.
pub const VELOCITY: Law = Law {
    id: "velocity-as-told",
    name: "substitution into the function",
    statement: "The velocity at an instant is the value of the given function there; if the position is given, the velocity is its rate of change.",
    signs: "Positive along the axis.",
    when: "The problem gives the velocity or the position as a function.",
    source: "The problem; the definition of velocity.",
    wrong: wrong::motion::VELOCITY,
};

/// The acceleration at an instant.
pub const ACCELERATION: Law = Law {
    id: "acceleration-as-rate",
    name: "the definition of acceleration",
    statement: "Acceleration is the rate of change of velocity with time; if the velocity is given as a function of position, it is the velocity times its derivative with respect to position.",
    signs: "Positive along the axis.",
    when: "The velocity is known as a function.",
    source: "Definition; the chain rule.",
    wrong: wrong::motion::ACCELERATION,
};

/// The net force at an instant.
pub const NET_FORCE: Law = Law {
    id: "net-force",
    name: "Newton's second law",
    statement: "The sum of all forces on a body is its mass times its acceleration: the rate of change of its momentum.",
    signs: "Positive along the axis.",
    when: "The mass does not change.",
    source: "The principle of impulse and momentum for a short time.",
    wrong: wrong::motion::NET_FORCE,
};

/// The net force where every force is known.
pub const ALL_FORCES: Law = Law {
    id: "sum-of-forces",
    name: "the sum of the forces",
    statement: "The net force on a body at an instant is the sum of all forces on it, each with its value at that instant.",
    signs: "Positive along the axis.",
    when: "All forces on the body are known.",
    source: "The definition.",
    wrong: &[],
};

/// The way in a time.
pub const DISPLACEMENT: Law = Law {
    id: "displacement",
    name: "the integral of the velocity",
    statement: "The displacement of a body is the integral of its velocity over time: the area under the velocity-time curve.",
    signs: "Positive along the axis.",
    when: "The velocity is known as a function of time.",
    source: "The definition of velocity, integrated.",
    wrong: wrong::motion::DISPLACEMENT,
};

/// The time that a way takes.
pub const TIME_OF_WAY: Law = Law {
    id: "time-of-a-way",
    name: "the separation of variables",
    statement: "The time for a distance is the integral of the reciprocal of the velocity over that distance.",
    signs: "Positive along the axis.",
    when: "The velocity is known as a function of position, and is not zero anywhere in between.",
    source: "The definition of velocity, solved for the time and integrated.",
    wrong: wrong::motion::DISPLACEMENT,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&PLACE, &VELOCITY, &ACCELERATION, &NET_FORCE, &ALL_FORCES, &DISPLACEMENT, &TIME_OF_WAY];

/// `F = m a`.
#[must_use]
pub fn net_force(mass: &Expr, acceleration: &Expr, force: &Expr) -> Sides {
    (force.clone(), mass.clone() * acceleration.clone())
}
