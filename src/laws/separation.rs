//! Bodies that come apart, and bodies that a guide holds.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// The mass of the parts.
pub const MASS: Law = Law {
    id: "mass-of-the-parts",
    name: "conservation of mass",
    statement: "The masses of the parts add up to that of the whole.",
    signs: "Masses are positive.",
    when: "Nothing is lost when a body separates into parts or bodies join.",
    source: "Conservation of mass.",
    wrong: &[],
};

/// Bodies that move as one.
pub const TOGETHER: Law = Law {
    id: "together-before",
    name: "the condition of moving together",
    statement: "Bodies that move together have the same velocity.",
    signs: "As for the velocities.",
    when: "Before they part, the bodies do not move relative to each other.",
    source: "Kinematics.",
    wrong: &[],
};

/// Energy that becomes motion.
pub const ENERGY: Law = Law {
    id: "energy-released",
    name: "the balance of energy",
    statement: "The kinetic energy before plus the energy released into motion is the kinetic energy after.",
    signs: "Energy that becomes kinetic energy is positive.",
    when: "The energy of an explosive, a spring or muscles becomes kinetic energy; any part that does not is not counted.",
    source: "The principle of work and energy for all bodies together.",
    wrong: wrong::separation::ENERGY,
};

/// Relative velocity.
pub const RELATIVE: Law = Law {
    id: "relative-velocity",
    name: "the definition of relative velocity",
    statement: "The velocity of one body relative to another is its own velocity minus that of the other.",
    signs: "Positive along the axis, for the velocities and for the relative velocity.",
    when: "Always, with the other body's velocity at the instant for which the relative velocity is given.",
    source: "Kinematics.",
    wrong: wrong::separation::RELATIVE,
};

/// A guided body.
pub const GUIDE: Law = Law {
    id: "guided-motion",
    name: "the constraint of the guide",
    statement: "A guided body has no velocity at right angles to its guide.",
    signs: "As for the velocities.",
    when: "The guide does not give way and the body does not leave it.",
    source: "Kinematics.",
    wrong: wrong::separation::GUIDE,
};

/// Bodies that start from rest.
pub const AT_REST: Law = Law {
    id: "start-from-rest",
    name: "the condition at the start",
    statement: "A body that starts from rest has zero velocity at the start.",
    signs: "As for the velocities.",
    when: "As the problem states.",
    source: "The problem.",
    wrong: &[],
};

/// Energy of a body that sinks on another.
pub const DESCENT: Law = Law {
    id: "energy-of-a-descent",
    name: "conservation of energy",
    statement: "The kinetic energy of both bodies increases by the weight of the one that sinks times the height.",
    signs: "A height through which a body sinks is positive.",
    when: "All contacts are smooth, and the support does no work.",
    source: "Work and energy for both bodies together.",
    wrong: wrong::energy::CONSERVATION,
};

/// Energy of a body that rises or sinks on another.
pub const CARRIED: Law = Law {
    id: "energy-on-what-gives-way",
    name: "conservation of energy",
    statement: "The kinetic energies of a body and of the one on which it rises or sinks, and the weight of the first times its height, have the same sum at both ends.",
    signs: "A height above the lower end is positive.",
    when: "All contacts are smooth, cords are light, and what supports the second body does no work.",
    source: "Work and energy for both bodies together.",
    wrong: wrong::separation::CARRIED,
};

/// A body on the face of another.
pub const ALONG_FACE: Law = Law {
    id: "motion-along-a-face",
    name: "the constraint of the face",
    statement: "Relative to the body on which it slides, a body moves along the face.",
    signs: "As for the velocities.",
    when: "The bodies stay in contact.",
    source: "Kinematics.",
    wrong: &[],
};

/// Displacement as seen from another body.
pub const RELATIVE_WAY: Law = Law {
    id: "relative-displacement",
    name: "the definition of relative displacement",
    statement: "The displacement of one body relative to another is its own displacement minus that of the other.",
    signs: "Positive along the axis.",
    when: "Always.",
    source: "Kinematics.",
    wrong: wrong::separation::RELATIVE_WAY,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] =
    &[&MASS, &TOGETHER, &ENERGY, &RELATIVE, &GUIDE, &AT_REST, &DESCENT, &CARRIED, &ALONG_FACE, &RELATIVE_WAY];

/// `E + T_1 = T_2`, over the kinetic energies of each body.
#[must_use]
pub fn energy(released: &Expr, before: &[Expr], after: &[Expr]) -> Sides {
    let start = before.iter().cloned().chain([released.clone()]);
    (Expr::sum(start), Expr::sum(after.iter().cloned()))
}

/// `v_A - v_B = u`.
#[must_use]
pub fn relative(one: &Expr, other: &Expr, relative: &Expr) -> Sides {
    (one.clone() - other.clone(), relative.clone())
}
