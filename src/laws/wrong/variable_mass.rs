//! Mistakes about streams and rockets.

use crate::expr::Expr;
use crate::expr::Function;
use crate::quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::force::WEIGHT_AS_MASS;
use super::momentum::START_FORGOTTEN;
use super::momentum::WEIGHT_FORGOTTEN;
use super::rewrite::one;
use super::rewrite::start_forgotten;
use super::rewrite::terms;

/// What leaves a vane counted like what comes.
pub const LEAVING_ADDED: Misconception = Misconception {
    id: "leaving-stream-added",
    does: "gives the momentum that leaves with the stream the wrong sign",
    ask: "Where does the stream go when it leaves the body, forwards or backwards?",
    hint: "The force comes from the change: the velocity before minus the velocity after, each with its sign.",
};
/// What leaves a vane left out.
pub const LEAVING_FORGOTTEN: Misconception = Misconception {
    id: "leaving-stream-forgotten",
    does: "leaves out the momentum that the stream has when it leaves",
    ask: "Does the stream have any momentum when it leaves the body?",
    hint: "Only a stream that spreads at right angles, or stays, leaves with no momentum along its old direction.",
};
/// The speed over the ground on a moving body.
pub const BODY_SPEED: Misconception = Misconception {
    id: "speed-of-body-forgotten",
    does: "uses the speed of the stream relative to the ground, although the body moves",
    ask: "How fast does the stream move relative to the body?",
    hint: "Subtract the speed of the body from that of the stream, both in the mass flow and in the change of velocity.",
};
/// A stream taken to come back.
pub const RETURNED: Misconception = Misconception {
    id: "stream-taken-to-return",
    does: "assumes that the stream comes straight back, although it does not",
    ask: "Where does the stream go after it has met the body?",
    hint: "A stream that comes straight back exerts twice the force of one that spreads sideways, or stays.",
};
/// `q v / 2` for `q v`.
pub const STREAM_ENERGY: Misconception = Misconception {
    id: "energy-for-momentum-of-stream",
    does: "calculates the force from the kinetic energy that the stream gains or loses",
    ask: "Does all the work of the force become kinetic energy of the stream, or is some of it lost as the stream is slowed or dragged along?",
    hint: "Use momentum: the force is the mass flow times the change of velocity, without a factor of one half.",
};
/// The mass taken to stay.
pub const MASS_KEPT: Misconception = Misconception {
    id: "rocket-mass-kept",
    does: "divides the momentum of the exhaust by the mass at the start, as if the mass stayed the same",
    ask: "Does the thrust move the same mass at the end of the burn as at its start?",
    hint: "The rocket becomes lighter all the time: the small gains in velocity add up to a logarithm.",
};
/// A logarithm to the base of ten.
pub const BASE_TEN: Misconception = Misconception {
    id: "logarithm-to-base-ten",
    does: "uses the logarithm to base ten",
    ask: "Which logarithm results from integrating one over the mass?",
    hint: "The integral of one over the mass is the natural logarithm of the mass.",
};

/// Wrong forms of the force of a stream.
pub const STREAM: &[WrongForm] = &[
    WrongForm { of: &LEAVING_ADDED, write: |law| law.both(|side| leaving(side, &|part| -part)) },
    WrongForm { of: &LEAVING_FORGOTTEN, write: |law| law.both(|side| leaving(side, &|_| Expr::zero())) },
    WrongForm { of: &BODY_SPEED, write: body_at_rest },
    WrongForm { of: &RETURNED, write: returned },
    WrongForm { of: &STREAM_ENERGY, write: |law| one((law.left(), law.right() * Expr::ratio(1, 2))) },
];
/// Wrong forms of what arrives.
pub const FLOW: &[WrongForm] = &[WrongForm { of: &BODY_SPEED, write: body_at_rest }];
/// Wrong forms of what a support carries.
pub const SUPPORT: &[WrongForm] = &[
    WrongForm { of: &WEIGHT_FORGOTTEN, write: |law| law.without(&|term| law.has_gravity(term)) },
    WrongForm { of: &WEIGHT_AS_MASS, write: weight_as_mass },
];
/// Wrong forms of the rocket equation.
pub const ROCKET: &[WrongForm] = &[
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &WEIGHT_FORGOTTEN, write: |law| law.without(&|term| law.has_gravity(term)) },
    WrongForm { of: &MASS_KEPT, write: |law| law.both(|side| logarithm(side, &linear)) },
    WrongForm { of: &BASE_TEN, write: |law| law.both(|side| logarithm(side, &to_base_ten)) },
];
/// Wrong forms of the acceleration under thrust.
pub const ACCELERATION: &[WrongForm] = &[WrongForm { of: &WEIGHT_FORGOTTEN, write: thrust_alone }];
/// Wrong forms of the condition of lift-off.
pub const LIFT_OFF: &[WrongForm] = &[WrongForm { of: &WEIGHT_AS_MASS, write: weight_as_mass }];

/// The thrust in place of the net force.
fn thrust_alone(law: &Taught<'_>) -> Vec<Wrong> {
    let Some((_, all)) = law.beside("sum-of-forces").find(|sides| sides.0 == law.sides.0) else { return Vec::new() };
    let rest: Vec<Expr> = terms(all).into_iter().filter(|term| !law.has_gravity(term)).collect();
    if rest.len() == terms(all).len() { Vec::new() } else { one((Expr::sum(rest), law.right())) }
}

/// The term with a sine or a cosine beside a number, changed: `1 - cos(theta)`.
fn leaving(term: &Expr, change: &dyn Fn(Expr) -> Expr) -> Expr {
    match term {
        Expr::Sum(parts) if parts.iter().any(|part| part.as_number().is_some()) => {
            let changed = parts.iter().map(|part| match part.as_number() {
                Some(_) => part.clone(),
                None => change(part.clone()),
            });
            Expr::sum(changed)
        }
        other => other.map_children(|part| leaving(part, change)),
    }
}

/// Twice the force of a stream that neither is turned by an angle nor comes back.
fn returned(law: &Taught<'_>) -> Vec<Wrong> {
    if law.right() == leaving(&law.sides.1, &|_| Expr::zero()) {
        one((law.left(), law.right() * Expr::integer(2)))
    } else {
        Vec::new()
    }
}

/// The speed of the body, where it is used, as zero.
fn body_at_rest(law: &Taught<'_>) -> Vec<Wrong> {
    let moves = |symbol| law.symbols.entry(symbol).meaning.contains("along the stream");
    law.replaced(&|symbol| (law.is(symbol, Dimension::VELOCITY) && moves(symbol)).then(Expr::zero))
}

fn weight_as_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let gravity = law.symbols.find("g");
    law.replaced(&|symbol| (gravity == Some(symbol)).then(|| law.unit_acceleration.clone()))
}

fn logarithm(term: &Expr, instead: &dyn Fn(&Expr) -> Expr) -> Expr {
    match term {
        Expr::Apply(Function::Ln, parts) => parts.first().map_or_else(|| term.clone(), instead),
        other => other.map_children(|part| logarithm(part, instead)),
    }
}

/// `(m_1 - m_2) / m_1` for the logarithm of `m_1 / m_2`.
fn linear(ratio: &Expr) -> Expr {
    Expr::one() - ratio.clone().powi(-1)
}

fn to_base_ten(ratio: &Expr) -> Expr {
    let natural = |term: Expr| Expr::apply(Function::Ln, term);
    natural(ratio.clone()) / natural(Expr::integer(10))
}
