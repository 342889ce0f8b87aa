//! Mistakes about kinetic friction.

use momentous_expr::Expr;

use super::Misconception;
use super::Taught;
use super::Wrong;

/// Friction left out.
pub const FRICTION_FORGOTTEN: Misconception = Misconception {
    id: "friction-forgotten",
    does: "leaves out friction",
    ask: "Draw every force that acts on the body in this time. Is one missing from your sum?",
    hint: "The body slides: what does the floor do along the motion?",
};
/// A coefficient of friction that is missing.
pub const FRICTION_COEFFICIENT: Misconception = Misconception {
    id: "friction-coefficient-left-out",
    does: "takes the normal force for the friction, without its coefficient",
    ask: "How large is friction beside the normal force? Where does the coefficient of friction enter?",
    hint: "Kinetic friction is the coefficient times the normal force.",
};
/// Friction along the motion.
pub const FRICTION_REVERSED: Misconception = Misconception {
    id: "friction-reversed",
    does: "makes friction push the body forward",
    ask: "Which way does the body slide, and which way does friction act on it?",
    hint: "Kinetic friction always acts against the direction of sliding.",
};

/// Whether friction stands in a term.
pub(super) fn rubs(law: &Taught<'_>, term: &Expr) -> bool {
    law.meaning("coefficient of kinetic friction").is_some_and(|mu| term.contains(mu))
}

/// Without friction.
pub(super) fn friction_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| (law.meaning("coefficient of kinetic friction") == Some(symbol)).then(Expr::zero))
}

/// The normal force for the friction.
pub(super) fn friction_whole(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| (law.meaning("coefficient of kinetic friction") == Some(symbol)).then(Expr::one))
}

/// Friction with the other sign.
pub(super) fn friction_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    if !rubs(law, &law.sides.0) {
        return Vec::new();
    }
    law.replaced(&|symbol| {
        (law.meaning("coefficient of kinetic friction") == Some(symbol)).then(|| -Expr::from(symbol))
    })
}
