//! Forces over time: impulse, average force, weight, friction.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// The impulse of a force as its integral over time.
pub const IMPULSE: Law = Law {
    id: "impulse-of-a-force",
    name: "the definition of impulse",
    statement: "The impulse of a force is its integral over time: the area under its force-time curve.",
    signs: "Positive along the axis.",
    when: "Always; a constant force gives force times time.",
    source: "Definition.",
    wrong: wrong::force::IMPULSE,
};

/// Average force over a duration.
pub const MEAN_FORCE: Law = Law {
    id: "mean-force",
    name: "the definition of the average force",
    statement: "The impulse of a force is its average value times the time for which it acts.",
    signs: "As for the impulse.",
    when: "Always.",
    source: "Definition.",
    wrong: wrong::force::MEAN_FORCE,
};

/// Weight.
pub const WEIGHT: Law = Law {
    id: "weight",
    name: "the definition of weight",
    statement: "The weight of a body is its mass times the acceleration of free fall.",
    signs: "Positive as a magnitude; it acts downwards.",
    when: "Near the ground.",
    source: "Newton's second law for free fall.",
    wrong: wrong::force::WEIGHT,
};

/// Balance of forces across a floor.
pub const NORMAL_FORCE: Law = Law {
    id: "normal-force",
    name: "the balance of forces at right angles to the surface",
    statement: "The normal force on a body that stays on a floor balances the components of its weight and of the other forces perpendicular to the floor.",
    signs: "The normal force is positive where the floor pushes.",
    when: "The body does not leave the floor.",
    source: "Newton's second law at right angles to the surface, where nothing accelerates.",
    wrong: wrong::force::NORMAL_FORCE,
};

/// Balance of forces on a body that does not accelerate.
pub const BALANCE: Law = Law {
    id: "balance-of-forces",
    name: "the balance of forces",
    statement: "The forces on a body that is at rest or moves at constant velocity add up to zero.",
    signs: "Positive along the axis.",
    when: "The velocity of the body does not change.",
    source: "Newton's second law, where nothing accelerates.",
    wrong: wrong::cone::BALANCE,
};

/// Kinetic friction.
pub const FRICTION: Law = Law {
    id: "kinetic-friction",
    name: "the law of kinetic friction",
    statement: "The friction on a sliding body is the coefficient of kinetic friction times the normal force.",
    signs: "The magnitude is positive; it acts against the motion.",
    when: "The body slides and does not change its direction during the stage.",
    source: "Coulomb's law of dry friction, an experimental law.",
    wrong: wrong::circle::FRICTION,
};

/// Static threshold.
pub const THRESHOLD: Law = Law {
    id: "static-friction-threshold",
    name: "the threshold of static friction",
    statement: "A body at rest starts to slide once the push equals the coefficient of static friction times the normal force.",
    signs: "Magnitudes.",
    when: "The body is at rest and the push grows.",
    source: "Coulomb's law of dry friction, an experimental law.",
    wrong: wrong::force::THRESHOLD,
};

/// Force of a spring.
pub const HOOKE: Law = Law {
    id: "hookes-law",
    name: "Hooke's law",
    statement: "The force of a spring is its stiffness times its deformation.",
    signs: "Magnitudes; the force acts against the deformation.",
    when: "The spring is light and not overstretched.",
    source: "Hooke's law, an experimental law.",
    wrong: wrong::circle::SPRING_FORCE,
};

/// Pull of a cord on a circle.
pub const CORD: Law = Law {
    id: "tension-on-a-circle",
    name: "Newton's second law towards the centre of the circle",
    statement: "The tension minus the weight's component along the cord is the mass times the acceleration towards the centre, which is the speed squared over the radius.",
    signs: "Positive towards the centre; the angle is measured from the vertical below the centre.",
    when: "The body moves on a circle.",
    source: "Newton's second law and the acceleration of motion on a circle.",
    wrong: wrong::force::CORD,
};

/// Push of a circular track.
pub const TRACK: Law = Law {
    id: "normal-force-on-a-circle",
    name: "Newton's second law towards the centre of the circle",
    statement: "The normal force minus the weight's component along the radius is the mass times the acceleration towards the centre, which is the speed squared over the radius.",
    signs: "Positive towards the centre; the angle is measured from the vertical below the centre.",
    when: "The body moves on the inside of a smooth circular track.",
    source: "Newton's second law and the acceleration of motion on a circle.",
    wrong: wrong::force::TRACK,
};

/// The force that holds a body on a level circle.
pub const HOLDING: Law = Law {
    id: "pull-on-a-level-circle",
    name: "Newton's second law towards the centre of the circle",
    statement: "The force that holds a body on a level circle is the mass times the acceleration towards the centre, which is the speed squared over the radius.",
    signs: "Positive towards the centre.",
    when: "The circle is horizontal, and no other force has a component towards its centre.",
    source: "Newton's second law and the acceleration of motion on a circle.",
    wrong: wrong::circle::TURN,
};

/// A conical pendulum.
pub const CONICAL: Law = Law {
    id: "conical-pendulum",
    name: "Newton's second law for a conical pendulum",
    statement: "The vertical component of the tension balances the weight; the horizontal one gives the acceleration towards the centre. So the speed squared over the radius is g times the tangent of the cord's angle with the vertical.",
    signs: "All are positive; the angle lies between the cord and the vertical.",
    when: "The body moves steadily round a horizontal circle.",
    source: "Newton's second law, along the vertical and towards the centre.",
    wrong: wrong::cone::CONICAL,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &IMPULSE,
    &MEAN_FORCE,
    &WEIGHT,
    &BALANCE,
    &NORMAL_FORCE,
    &FRICTION,
    &THRESHOLD,
    &HOOKE,
    &CORD,
    &TRACK,
    &HOLDING,
    &CONICAL,
];

/// `S - m g cos(angle) = m v^2 / L`, with the square of the speed as a sum of squared components.
#[must_use]
pub fn tension(
    tension: &Expr,
    [mass, gravity]: [&Expr; 2],
    cosine: &Expr,
    components: &[Expr],
    length: &Expr,
) -> Sides {
    let weight = Expr::product([mass.clone(), gravity.clone(), cosine.clone()]);
    let squares = Expr::sum(components.iter().map(|component| component.clone().powi(2)));
    (tension.clone() - weight, mass.clone() * squares / length.clone())
}

/// `J = F_avg dt`.
#[must_use]
pub fn mean_force(impulse: &Expr, force: &Expr, duration: &Expr) -> Sides {
    (impulse.clone(), force.clone() * duration.clone())
}
