//! Linear impulse and momentum, the third law, and conservation.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// The principle of impulse and momentum for one body along one axis.
pub const IMPULSE_MOMENTUM: Law = Law {
    id: "impulse-momentum",
    name: "the principle of impulse and momentum",
    statement: "The momentum of a body at the end equals its momentum at the start plus the impulses of the forces that act on it.",
    signs: "Velocities and impulses along the axis are positive, against it negative.",
    when: "Always, for each body and each axis.",
    source: "Newton's second law, integrated over time.",
    wrong: wrong::momentum::IMPULSE_MOMENTUM,
};

/// Action and reaction of an internal impulse.
pub const THIRD_LAW: Law = Law {
    id: "action-reaction",
    name: "Newton's third law",
    statement: "The impulses that two bodies exert on each other are equal and opposite.",
    signs: "Each impulse is positive along the axis.",
    when: "Always, for the impulses between two bodies.",
    source: "Newton's third law, integrated over time.",
    wrong: wrong::momentum::THIRD_LAW,
};

/// Conservation along an axis along which no external impulse acts.
pub const CONSERVATION: Law = Law {
    id: "conservation-of-momentum",
    name: "conservation of linear momentum",
    statement: "Along an axis along which no external impulse acts, the total momentum of a system stays the same.",
    signs: "Velocities along the axis are positive, against it negative.",
    when: "The impulses within the system cancel in pairs, and no external impulse acts along the axis.",
    source: "The principle of impulse and momentum for each body, added up.",
    wrong: wrong::momentum::CONSERVATION,
};

/// Impulses from outside on a system.
pub const SYSTEM: Law = Law {
    id: "impulse-momentum-of-a-system",
    name: "the principle of impulse and momentum for the system",
    statement: "The total momentum of a system at the end equals that at the start plus the external impulses.",
    signs: "Velocities and impulses along the axis are positive, against it negative.",
    when: "Always, for each axis; the impulses within the system cancel in pairs.",
    source: "The principle of impulse and momentum for each body, added up.",
    wrong: wrong::momentum::SYSTEM,
};

/// A velocity component along which no impulse acts.
pub const NO_IMPULSE: Law = Law {
    id: "no-impulse-no-change",
    name: "the principle of impulse and momentum",
    statement: "Along an axis along which no impulse acts on a body, its velocity stays the same.",
    signs: "Velocities along the axis are positive, against it negative.",
    when: "The contact is smooth, so that its impulse has no component along the axis.",
    source: "The principle of impulse and momentum for the body alone.",
    wrong: wrong::momentum::NO_IMPULSE,
};

/// Momentum as the product of mass and velocity.
pub const MOMENTUM: Law = Law {
    id: "momentum",
    name: "the definition of momentum",
    statement: "The momentum of a body is its mass times its velocity; that of a system is the sum over its bodies.",
    signs: "As for the velocity.",
    when: "Always.",
    source: "Definition.",
    wrong: wrong::momentum::MOMENTUM,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&MOMENTUM, &IMPULSE_MOMENTUM, &THIRD_LAW, &CONSERVATION, &SYSTEM, &NO_IMPULSE];

/// `m v_1 + sum of impulses = m v_2`.
#[must_use]
pub fn impulse_momentum(mass: &Expr, before: &Expr, impulses: &[Expr], after: &Expr) -> Sides {
    let start = mass.clone() * before.clone();
    (Expr::sum([start].into_iter().chain(impulses.iter().cloned())), mass.clone() * after.clone())
}

/// Sum of `m v` over (mass, velocity).
#[must_use]
pub fn total(parts: &[(Expr, Expr)]) -> Expr {
    Expr::sum(parts.iter().map(|(mass, velocity)| mass.clone() * velocity.clone()))
}

/// `sum of m v_1 + J = sum of m v_2`, with an impulse from outside.
#[must_use]
pub fn system(before: &[(Expr, Expr)], outside: &Expr, after: &[(Expr, Expr)]) -> Sides {
    (total(before) + outside.clone(), total(after))
}

/// The total momentum before and after.
#[must_use]
pub fn conservation(before: &[(Expr, Expr)], after: &[(Expr, Expr)]) -> Sides {
    (total(before), total(after))
}
