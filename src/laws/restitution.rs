//! Restitution: how much of the approach comes back.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// Newton's law of restitution along the line of impact.
pub const RESTITUTION: Law = Law {
    id: "restitution",
    name: "the law of restitution",
    statement: "Along the line of impact, the speed of separation is e times the speed of approach.",
    signs: "Velocities along the line of impact, from the first body to the second, are positive; approach is first minus second, separation second minus first.",
    when: "An impact of two bodies, along the line of impact only; e lies between 0 (they stay together) and 1 (no energy is lost).",
    source: "Newton's law of restitution, an experimental law.",
    wrong: wrong::restitution::BODIES,
};

/// Restitution at a surface that cannot be moved.
pub const RESTITUTION_SURFACE: Law = Law {
    id: "restitution-at-a-surface",
    name: "the law of restitution at a surface",
    statement: "Along the surface's normal, a body leaves a fixed surface with e times the speed with which it arrived.",
    signs: "Velocities along the outward normal are positive.",
    when: "An impact on a surface too heavy to be moved, along its normal only.",
    source: "Newton's law of restitution with one very heavy body.",
    wrong: wrong::restitution::SURFACE,
};

/// Bodies that stay together.
pub const PLASTIC: Law = Law {
    id: "plastic-impact",
    name: "the condition of a plastic impact",
    statement: "Bodies that stay together have the same velocity afterwards.",
    signs: "As for the velocities.",
    when: "The bodies stick, couple, or one is caught in the other (e = 0).",
    source: "Kinematics.",
    wrong: wrong::restitution::PLASTIC,
};

/// The velocity at the greatest deformation.
pub const COMMON: Law = Law {
    id: "greatest-deformation",
    name: "conservation of linear momentum",
    statement: "At the end of the deformation both bodies have the same velocity along the line of impact.",
    signs: "Velocities along the line of impact, from the first body to the second, are positive.",
    when: "In every impact; with a fixed surface that velocity is the surface's.",
    source: "Conservation of momentum up to that instant.",
    wrong: &[],
};

/// The impulse of deformation.
pub const DEFORMATION: Law = Law {
    id: "impulse-of-deformation",
    name: "the principle of impulse and momentum for the phase of deformation",
    statement: "The impulse of deformation changes the velocity of a body to the common one.",
    signs: "A magnitude.",
    when: "Along the line of impact, from the first contact to the greatest deformation.",
    source: "The principle of impulse and momentum.",
    wrong: &[],
};

/// The ratio of the two impulses.
pub const PHASES: Law = Law {
    id: "impulses-of-the-two-phases",
    name: "the definition of the coefficient of restitution by impulses",
    statement: "The impulse of restitution is e times the impulse of deformation.",
    signs: "Magnitudes.",
    when: "Along the line of impact of a smooth contact, where it is equivalent to the ratio of velocities.",
    source: "Poisson's hypothesis.",
    wrong: wrong::restitution::PHASES,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&RESTITUTION, &RESTITUTION_SURFACE, &PLASTIC, &COMMON, &DEFORMATION, &PHASES];

/// `v_B2 - v_A2 = e (v_A1 - v_B1)`: A the first body, B the second, along the line of impact from A to B.
#[must_use]
pub fn restitution(e: &Expr, before: [&Expr; 2], after: [&Expr; 2]) -> Sides {
    let approach = before[0].clone() - before[1].clone();
    (after[1].clone() - after[0].clone(), e.clone() * approach)
}

/// `v_2 - w = -e (v_1 - w)` along the outward normal of a surface that moves with `w`.
#[must_use]
pub fn at_surface(e: &Expr, surface: &Expr, before: &Expr, after: &Expr) -> Sides {
    let approach = before.clone() - surface.clone();
    (after.clone() - surface.clone(), -(e.clone() * approach))
}
