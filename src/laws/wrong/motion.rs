//! Mistakes about motions that are given as functions.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::integral::ENDS_AVERAGED;
use super::integral::VALUE_TIMES_TIME;
use super::integral::ends_averaged;
use super::integral::half_of_middle;
use super::integral::value_times_time;
use super::resistance::AS_AT_FIRST;
use super::resistance::NEGLECTED;
use super::resistance::displaced;
use super::resistance::displaced_as_at_first;
use super::resistance::displaced_freely;
use super::rewrite::one;

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

/// The greatest velocity for rest.
pub const STATIONARY: Misconception = Misconception {
    id: "greatest-velocity-for-rest",
    does: "takes the moment at which the velocity stops growing for that at which the body is at rest",
    ask: "Which quantity is zero when the body is at rest: its velocity, or the rate at which that changes?",
    hint: "Where the velocity is greatest its rate of change is zero; the body is at rest where the velocity itself is.",
};
/// Back where it began for rest.
pub const BACK_AT_START: Misconception = Misconception {
    id: "return-for-rest",
    does: "takes the moment at which the body is back where it began for that at which it is at rest",
    ask: "Which quantity is zero when the body is at rest: its velocity, or its displacement?",
    hint: "A body that turns round is at rest far from its start: set the velocity to zero, not the displacement.",
};

/// Wrong forms of the velocity at an instant.
pub const VELOCITY: &[WrongForm] = &[
    WrongForm { of: &DIVIDED, write: |law| divided(law, "place-as-told") },
    WrongForm { of: &STATIONARY, write: stationary },
    WrongForm { of: &BACK_AT_START, write: back_at_start },
];
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
    WrongForm { of: &super::integral::HALF_PEAK, write: half_of_middle },
    WrongForm { of: &super::stream::EVEN_GAIN, write: super::stream::even_gain },
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

/// `dv/dt = 0`, where the time is sought at which the velocity is zero.
fn stationary(law: &Taught<'_>) -> Vec<Wrong> {
    let is_time = |own: &Symbol| law.is(*own, Dimension::TIME) && !law.known.contains(own);
    let times: Vec<Symbol> = law.sides.1.symbols().into_iter().filter(is_time).collect();
    let [time] = times[..] else { return Vec::new() };
    one((law.sides.1.differentiate(time).simplify(), Expr::zero()))
}

/// The displacement is zero, where the time is sought at which the velocity is.
fn back_at_start(law: &Taught<'_>) -> Vec<Wrong> {
    let is_time = |symbol: &Symbol| law.is(*symbol, Dimension::TIME) && !law.known.contains(symbol);
    let Some(time) = law.sides.1.symbols().into_iter().find(is_time) else { return Vec::new() };
    let way = law.beside("displacement").find(|(_, way)| way.contains(time));
    way.map(|(_, way)| Wrong::from((way.clone(), Expr::zero()))).into_iter().collect()
}

/// `F = a`, in units in which the mass is one.
fn mass_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| law.is(symbol, Dimension::MASS).then(Expr::one))
}
