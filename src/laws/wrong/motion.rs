//! Mistakes about motions that are given as functions.

use momentous_expr::Expr;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::force::ENDS_AVERAGED;
use super::force::VALUE_TIMES_TIME;
use super::resistance::AS_AT_FIRST;
use super::resistance::NEGLECTED;
use super::resistance::displaced;
use super::resistance::displaced_as_at_first;
use super::resistance::displaced_freely;
use super::rewrite::ends_averaged;
use super::rewrite::one;
use super::rewrite::value_times_time;

/// `x / t` for dx/dt.
pub const DIVIDED: Misconception = Misconception {
    id: "divided-by-the-time",
    does: "divides by the time where a rate of change is needed",
    ask: "Does the quantity change at a constant rate, so that its value over the time is also its rate of change?",
    hint: "The rate of change at an instant is the derivative there; the value over the time is at best an average.",
};
/// The weight of a body for its mass, or the mass left out.
pub const MASS_FORGOTTEN: Misconception = Misconception {
    id: "mass-forgotten",
    does: "takes the acceleration for the force",
    ask: "What are the units of an acceleration, and what are those of a force?",
    hint: "The same acceleration needs twice the force for twice the mass.",
};

/// Wrong forms of the velocity at an instant.
pub const VELOCITY: &[WrongForm] = &[WrongForm { of: &DIVIDED, write: |law| divided(law, "place-as-told") }];
/// Wrong forms of the acceleration at an instant.
pub const ACCELERATION: &[WrongForm] = &[WrongForm { of: &DIVIDED, write: |law| divided(law, "velocity-as-told") }];
/// Wrong forms of the net force.
pub const NET_FORCE: &[WrongForm] = &[WrongForm { of: &MASS_FORGOTTEN, write: mass_forgotten }];
/// Wrong forms of an integral over the motion.
pub const DISPLACEMENT: &[WrongForm] = &[
    WrongForm { of: &VALUE_TIMES_TIME, write: value_times_time },
    WrongForm { of: &ENDS_AVERAGED, write: ends_averaged },
    WrongForm { of: &AS_AT_FIRST, write: |law| displaced(law, displaced_as_at_first) },
    WrongForm { of: &NEGLECTED, write: |law| displaced(law, displaced_freely) },
];

/// The value of another law at the end, over the only time in it.
fn divided(law: &Taught<'_>, other: &str) -> Vec<Wrong> {
    let over = |(_, value): &(Expr, Expr)| {
        let mut times = value.symbols().into_iter().filter(|symbol| law.is(*symbol, Dimension::TIME));
        let time = times.next().filter(|_| times.next().is_none())?;
        Some((law.left(), value.clone() / Expr::from(time)))
    };
    law.beside(other).filter_map(over).flat_map(one).collect()
}

/// `F = a`, in units in which the mass is one.
fn mass_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| law.is(symbol, Dimension::MASS).then(Expr::one))
}
