//! Mistakes about bodies that come apart.

use crate::expr::Expr;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::rewrite::one;
use super::rewrite::terms;

/// A relative velocity as one over the ground.
pub const ABSOLUTE: Misconception = Misconception {
    id: "relative-velocity-as-absolute",
    does: "takes a relative velocity for a velocity over the ground",
    ask: "Relative to what is this velocity told, and does that move too?",
    hint: "Momentum is counted with velocities over the ground: add the velocity of the body from which it is told.",
};
/// The difference taken the wrong way round.
pub const REVERSED: Misconception = Misconception {
    id: "relative-velocity-reversed",
    does: "subtracts the velocities of a relative one in the wrong order",
    ask: "Which of the two bodies is looked at, and from which is it seen?",
    hint: "The velocity of A relative to B is that of A less that of B.",
};
/// Kinetic energy before left out.
pub const START: Misconception = Misconception {
    id: "start-energy-forgotten",
    does: "leaves out the kinetic energy that was there before",
    ask: "Did anything move before the energy was released?",
    hint: "The energy released is added to the kinetic energy that the bodies had already.",
};
/// Energy released as energy lost.
pub const SUBTRACTED: Misconception = Misconception {
    id: "released-energy-subtracted",
    does: "subtracts the energy that is released",
    ask: "Is there more kinetic energy after the separation, or less?",
    hint: "What a spring or an explosive gives is gained by the motion.",
};

/// Wrong forms of a relative velocity.
pub const RELATIVE: &[WrongForm] = &[
    WrongForm { of: &ABSOLUTE, write: absolute },
    WrongForm { of: &REVERSED, write: |law| one((law.left(), -law.right())) },
];
/// Wrong forms of the balance of energy.
pub const ENERGY: &[WrongForm] =
    &[WrongForm { of: &START, write: start_forgotten }, WrongForm { of: &SUBTRACTED, write: subtracted }];
/// Wrong forms of energy gained.
pub const GAIN: &[WrongForm] = &[WrongForm { of: &START, write: gain_from_nothing }];

/// `v_A = u`.
fn absolute(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [own, _] => one((own.clone(), law.right())),
        _ => Vec::new(),
    }
}

/// `E = T_2`: the energy released stands last.
fn start_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [_, .., released] => one((released.clone(), law.right())),
        _ => Vec::new(),
    }
}

fn subtracted(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [before @ .., released] if !before.is_empty() => {
            one((Expr::sum(before.iter().cloned().chain([-released.clone()])), law.right()))
        }
        _ => Vec::new(),
    }
}

fn gain_from_nothing(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.1)[..] {
        [after, _] => one((law.left(), after.clone())),
        _ => Vec::new(),
    }
}
