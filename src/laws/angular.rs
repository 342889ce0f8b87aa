//! Angular momentum about a fixed point.

use crate::expr::Expr;

use super::Law;
use super::wrong;

/// The moment of momentum.
pub const ANGULAR_MOMENTUM: Law = Law {
    id: "angular-momentum",
    name: "the definition of angular momentum",
    statement: "The angular momentum of a particle about a fixed point is the moment of its momentum: perpendicular distance times momentum.",
    signs: "Counter-clockwise is positive.",
    when: "About a fixed point, or about the mass centre.",
    source: "Definition, H = r x m v.",
    wrong: wrong::angular::ANGULAR_MOMENTUM,
};

/// Angular impulse and momentum.
pub const ANGULAR_IMPULSE: Law = Law {
    id: "angular-impulse-momentum",
    name: "the principle of angular impulse and momentum",
    statement: "The angular momentum about a fixed point at the end equals that at the start plus the angular impulses of the moments about that point.",
    signs: "Counter-clockwise is positive.",
    when: "About a fixed point, or about the mass centre.",
    source: "Newton's second law, its moment integrated over time.",
    wrong: wrong::angular::ANGULAR_IMPULSE,
};

/// The integral of a moment.
pub const MOMENT_IMPULSE: Law = Law {
    id: "angular-impulse",
    name: "the definition of angular impulse",
    statement: "The angular impulse of a moment is its integral over time.",
    signs: "Counter-clockwise is positive.",
    when: "Always; a constant moment gives moment times time.",
    source: "Definition.",
    wrong: wrong::angular::MOMENT_IMPULSE,
};

/// Conservation about the centre of a central force.
pub const CENTRAL: Law = Law {
    id: "central-force",
    name: "conservation of angular momentum under a central force",
    statement: "A force whose line passes through a fixed point has no moment about it, so radius times transverse velocity stays the same.",
    signs: "Counter-clockwise is positive.",
    when: "Every force on the particle points to or from the fixed point.",
    source: "The principle of angular impulse and momentum, divided by the mass.",
    wrong: wrong::angular::CENTRAL,
};

/// Kepler's second law.
pub const AREAL: Law = Law {
    id: "areal-rate",
    name: "Kepler's second law",
    statement: "The radius sweeps out area at the constant rate of half the radius times the transverse velocity.",
    signs: "Counter-clockwise is positive.",
    when: "Under a central force.",
    source: "The area of a thin triangle, and conservation of angular momentum.",
    wrong: wrong::angular::AREAL,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&ANGULAR_MOMENTUM, &MOMENT_IMPULSE, &ANGULAR_IMPULSE, &CENTRAL, &AREAL];

/// `m (x v_y - y v_x)`: the moment of momentum about the origin of the position.
#[must_use]
pub fn moment_of_momentum(mass: &Expr, position: [&Expr; 2], velocity: [&Expr; 2]) -> Expr {
    let moment = position[0].clone() * velocity[1].clone() - position[1].clone() * velocity[0].clone();
    mass.clone() * moment
}
