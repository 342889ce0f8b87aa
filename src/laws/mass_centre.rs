//! The centre of mass of a system and its motion.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// Velocity and position of the centre of mass.
pub const MASS_CENTRE: Law = Law {
    id: "mass-centre",
    name: "the definition of the centre of mass",
    statement: "The total mass times the velocity (or position) of the centre of mass is the sum of each mass times its velocity (or position).",
    signs: "As for the velocities.",
    when: "Always.",
    source: "Definition.",
    wrong: wrong::mass_centre::MASS_CENTRE,
};

/// The mass of bodies that are one.
pub const TOTAL_MASS: Law = Law {
    id: "total-mass",
    name: "the sum of the masses",
    statement: "The mass of a body is the sum of the masses of its parts.",
    signs: "Masses are positive.",
    when: "The parts join to form the body, or it comes apart into them, and nothing is lost.",
    source: "Conservation of mass.",
    wrong: &[],
};

/// Motion of the centre of mass.
pub const MOTION: Law = Law {
    id: "motion-of-the-mass-centre",
    name: "the principle of impulse and momentum for the whole system",
    statement: "The total mass times the change of the velocity of the centre of mass is the sum of the external impulses.",
    signs: "Impulses along the axis are positive.",
    when: "Always; internal impulses cancel in pairs.",
    source: "The principle of impulse and momentum for each body, added up.",
    wrong: wrong::mass_centre::MOTION,
};

/// The rate of change of the momentum of a system.
pub const RATE: Law = Law {
    id: "rate-of-momentum",
    name: "Newton's second law for the whole system",
    statement: "The rate of change of the momentum of a system is the sum of the external forces on its bodies.",
    signs: "Positive along the axis.",
    when: "Always; internal forces cancel in pairs.",
    source: "Newton's second law for each body, added up.",
    wrong: wrong::mass_centre::RATE,
};

/// The acceleration of the centre of mass.
pub const ACCELERATION: Law = Law {
    id: "acceleration-of-the-mass-centre",
    name: "the motion of the centre of mass",
    statement: "The total mass times the acceleration of the centre of mass is the rate of change of the momentum of the system.",
    signs: "Positive along the axis.",
    when: "No mass changes.",
    source: "The definition of the centre of mass, differentiated.",
    wrong: wrong::mass_centre::ACCELERATION,
};

/// The path of the centre of mass.
pub const PATH: Law = Law {
    id: "path-of-the-mass-centre",
    name: "the motion of the centre of mass",
    statement: "In free flight the centre of mass of a system moves as a single body would, whatever forces its parts exert on each other.",
    signs: "Positive along the axis; g is negative where the axis points up.",
    when: "Weight is the only external force, and no part has landed.",
    source: "The principle of impulse and momentum for the whole system, integrated over time.",
    wrong: &[],
};

/// A centre of mass that stays where it is.
pub const REST: Law = Law {
    id: "mass-centre-at-rest",
    name: "the principle of the centre of mass",
    statement: "If no external impulse acts along an axis and the centre of mass is at rest, the sum of the masses times their displacements is zero.",
    signs: "Displacements along the axis are positive.",
    when: "The system is at rest at first, and no external force acts along the axis.",
    source: "The principle of impulse and momentum for the whole system, integrated over time.",
    wrong: wrong::mass_centre::DISPLACEMENTS,
};

/// Displacements in a system that nothing acts on from outside.
pub const DISPLACEMENTS: Law = Law {
    id: "displacements-without-external-impulse",
    name: "the principle of the centre of mass",
    statement: "If no external impulse acts along an axis, the sum of the masses times their displacements is the momentum of the system times the time.",
    signs: "Displacements along the axis are positive.",
    when: "No external force acts along the axis.",
    source: "The principle of impulse and momentum for the whole system, integrated over time.",
    wrong: wrong::mass_centre::DISPLACEMENTS,
};

/// The displacement of the centre of mass.
pub const DISPLACEMENT: Law = Law {
    id: "displacement-of-the-mass-centre",
    name: "the motion of the centre of mass",
    statement: "If no external impulse acts along an axis, the displacement of the centre of mass is its velocity times the time; at rest, it stays where it is.",
    signs: "Positive along the axis.",
    when: "No external force acts along the axis.",
    source: "The principle of impulse and momentum for the whole system, integrated over time.",
    wrong: wrong::mass_centre::DISPLACEMENT,
};

/// Velocities seen from the centre of mass.
pub const RELATIVE: Law = Law {
    id: "velocity-relative-to-the-mass-centre",
    name: "the velocity relative to the centre of mass",
    statement: "The velocity of a body relative to the centre of mass is its velocity minus that of the centre of mass.",
    signs: "As for the velocities.",
    when: "Always.",
    source: "Relative motion.",
    wrong: wrong::mass_centre::RELATIVE,
};

/// Momentum relative to the centre of mass.
pub const NO_MOMENTUM: Law = Law {
    id: "no-momentum-relative-to-the-mass-centre",
    name: "the definition of the centre of mass",
    statement: "The momenta of a system relative to its centre of mass add up to zero.",
    signs: "As for the velocities.",
    when: "Always.",
    source: "The definition of the centre of mass, with velocities relative to it.",
    wrong: wrong::mass_centre::NO_MOMENTUM,
};

/// Koenig's theorem for the kinetic energy.
pub const ENERGY: Law = Law {
    id: "kinetic-energy-of-a-system",
    name: "Koenig's theorem",
    statement: "The kinetic energy of a system is that of its total mass moving with the centre of mass, plus that of the motion relative to the centre of mass.",
    signs: "Never negative.",
    when: "Always.",
    source: "The definition of kinetic energy; the mixed terms vanish because the momenta relative to the centre of mass add up to zero.",
    wrong: wrong::mass_centre::ENERGY,
};

/// Koenig's theorem for the angular momentum.
pub const ANGULAR: Law = Law {
    id: "angular-momentum-of-a-system",
    name: "Koenig's theorem",
    statement: "The angular momentum of a system about a fixed point is the moment of its total momentum, taken at the centre of mass, plus its angular momentum about the centre of mass.",
    signs: "In a plane, the sense from x towards y is positive; in space, the right-hand rule holds for each axis.",
    when: "Always.",
    source: "The definition of angular momentum, with each position measured from the centre of mass.",
    wrong: wrong::mass_centre::ANGULAR,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &TOTAL_MASS,
    &MASS_CENTRE,
    &MOTION,
    &RATE,
    &ACCELERATION,
    &PATH,
    &REST,
    &DISPLACEMENTS,
    &DISPLACEMENT,
    &RELATIVE,
    &NO_MOMENTUM,
    &ENERGY,
    &ANGULAR,
];

/// `sum of m (r_2 - r_1)` over (mass, from, to).
#[must_use]
pub fn displaced(parts: &[(Expr, Expr, Expr)]) -> Expr {
    Expr::sum(parts.iter().map(|(mass, from, to)| mass.clone() * (to.clone() - from.clone())))
}

/// `(sum of m) q_G = sum of m q` over (mass, q), q being a position or a velocity component.
#[must_use]
pub fn mass_centre(centre: &Expr, parts: &[(Expr, Expr)]) -> Sides {
    (total_mass(parts) * centre.clone(), super::momentum::total(parts))
}

/// The sum of the masses.
#[must_use]
pub fn total_mass(parts: &[(Expr, Expr)]) -> Expr {
    Expr::sum(parts.iter().map(|(mass, _)| mass.clone()))
}
