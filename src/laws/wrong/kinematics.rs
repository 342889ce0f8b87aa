//! Mistakes about falls and bounces.

use crate::expr::Expr;
use crate::quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::momentum::SIGN_LOST;
use super::rewrite::gain_reversed;
use super::rewrite::one;
use super::rewrite::sign_lost;
use super::rewrite::start_forgotten;

/// `v^2 = g h`.
pub const TWO: Misconception = Misconception {
    id: "fall-two-forgotten",
    does: "leaves out the factor of two in the speed of a fall",
    ask: "Weight times height becomes kinetic energy: which factor does that leave in front of g and h?",
    hint: "Write the energy before and after the fall, and solve for the speed.",
};
/// `v = 2 g h`.
pub const ROOT: Misconception = Misconception {
    id: "fall-root-forgotten",
    does: "does not take the root in the speed of a fall",
    ask: "What are the units of g times h? Are they those of a speed?",
    hint: "The energy of a fall gives the square of the speed.",
};
/// `h' = e h`.
pub const HEIGHT_BY_E: Misconception = Misconception {
    id: "height-by-e",
    does: "multiplies the height by e at each bounce",
    ask: "The coefficient multiplies the speed. What does that do to the height?",
    hint: "The height goes with the square of the speed with which the body leaves the floor.",
};
/// `v' = e^2 v`.
pub const SPEED_BY_E_SQUARED: Misconception = Misconception {
    id: "speed-by-e-squared",
    does: "multiplies a speed or a time by e\u{b2} at each bounce",
    ask: "Which quantity goes with e, and which with its square?",
    hint: "Speeds and times of flight go with e, heights and energies with its square.",
};
/// One bounce too few or too many.
pub const ONE_OFF: Misconception = Misconception {
    id: "bounces-miscounted",
    does: "counts one bounce too few or too many",
    ask: "How many bounces has the body made at this moment?",
    hint: "Write the first two bounces down one by one, and begin with the release, when nothing has bounced yet.",
};
/// Flights counted one way only.
pub const ONE_WAY: Misconception = Misconception {
    id: "flights-one-way",
    does: "counts only one way of each flight",
    ask: "What does the body do between two bounces? How often does it pass each height?",
    hint: "After the first fall, every flight goes up and comes down again.",
};
/// The first fall counted as a whole flight.
pub const FIRST_TWICE: Misconception = Misconception {
    id: "first-fall-doubled",
    does: "counts the first fall as a whole flight",
    ask: "How does the first part of the motion differ from all later flights?",
    hint: "The body is let go from above: the first fall has no rise before it.",
};

/// `a t^2`.
pub const FALL_HALF: Misconception = Misconception {
    id: "fall-half-forgotten",
    does: "leaves out the factor of one half in the way fallen",
    ask: "The velocity of a fall grows from the first moment on: what is its mean over the time?",
    hint: "Draw the velocity over the time: the way is the area under a triangle.",
};
/// The first velocity left out.
pub const FIRST_VELOCITY: Misconception = Misconception {
    id: "first-velocity-forgotten",
    does: "leaves out the velocity with which the flight begins",
    ask: "Does the body start from rest along this axis?",
    hint: "Without gravity, where would the body be after this time?",
};

/// Gravity that speeds a rising body up.
pub const GRAVITY_REVERSED: Misconception = Misconception {
    id: "gravity-reversed",
    does: "lets gravity act in the opposite direction",
    ask: "Which way does the axis point, and which way does gravity?",
    hint: "Give the velocity and gravity their signs along the same axis.",
};
/// The place at the start left out.
pub const START_PLACE: Misconception = Misconception {
    id: "start-place-forgotten",
    does: "leaves out the place from which the motion begins",
    ask: "Where is the body when the time begins to count?",
    hint: "Velocity times time is how far the body moves, not yet where it is.",
};

/// Wrong forms of velocity and time in a fall.
pub const FALL_TIME: &[WrongForm] = &[
    WrongForm { of: &FIRST_VELOCITY, write: start_forgotten },
    WrongForm { of: &GRAVITY_REVERSED, write: gain_reversed },
];
/// Wrong forms of uniform motion.
pub const UNIFORM: &[WrongForm] = &[
    WrongForm { of: &START_PLACE, write: |law| law.without(&|term| !law.has(term, Dimension::VELOCITY)) },
    WrongForm { of: &SIGN_LOST, write: sign_lost },
];
/// Wrong forms of the speed after a fall.
pub const FALL_SPEED: &[WrongForm] =
    &[WrongForm { of: &TWO, write: two_forgotten }, WrongForm { of: &ROOT, write: root_forgotten }];
/// Wrong forms of the place in a flight.
pub const FLIGHT_PLACE: &[WrongForm] = &[
    WrongForm { of: &FALL_HALF, write: |law| law.both(|side| doubled(law, side)) },
    WrongForm { of: &FIRST_VELOCITY, write: |law| law.without(&|term| law.has(term, Dimension::VELOCITY)) },
];
/// Wrong forms of a bounce's height.
pub const BOUNCE_HEIGHT: &[WrongForm] =
    &[WrongForm { of: &HEIGHT_BY_E, write: |law| e_to(law, Expr::sqrt) }, WrongForm { of: &ONE_OFF, write: one_off }];
/// Wrong forms of a bounce's speed.
pub const BOUNCE_SPEED: &[WrongForm] = &[
    WrongForm { of: &SPEED_BY_E_SQUARED, write: |law| e_to(law, squared) },
    WrongForm { of: &ONE_OFF, write: one_off },
];
/// Wrong forms of the time of bounces.
pub const BOUNCE_TIME: &[WrongForm] = &[
    WrongForm { of: &SPEED_BY_E_SQUARED, write: |law| e_to(law, squared) },
    WrongForm { of: &ONE_WAY, write: |law| series(law, &Expr::one()) },
    WrongForm { of: &FIRST_TWICE, write: |law| series(law, &Expr::integer(2)) },
    WrongForm { of: &ONE_OFF, write: one_off },
];
/// Wrong forms of the whole path.
pub const BOUNCE_PATH: &[WrongForm] = &[
    WrongForm { of: &HEIGHT_BY_E, write: |law| e_to(law, Expr::sqrt) },
    WrongForm { of: &ONE_WAY, write: |law| series(law, &Expr::one()) },
    WrongForm { of: &FIRST_TWICE, write: |law| series(law, &Expr::integer(2)) },
];

fn squared(term: Expr) -> Expr {
    term.powi(2)
}

/// `v_2^2 = v_1^2 + g h`.
fn two_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.both(|side| halved(law, side))
}

fn halved(law: &Taught<'_>, term: &Expr) -> Expr {
    match term {
        Expr::Product(_) if law.has_gravity(term) => Expr::ratio(1, 2) * term.clone(),
        other => other.map_children(|part| halved(law, part)),
    }
}

fn doubled(law: &Taught<'_>, term: &Expr) -> Expr {
    match term {
        Expr::Product(_) if law.has_gravity(term) => Expr::integer(2) * term.clone(),
        other => other.map_children(|part| doubled(law, part)),
    }
}

fn root_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.0 {
        Expr::Power(pair) if pair.1 == Expr::integer(2) => one((pair.0.clone(), law.right())),
        _ => Vec::new(),
    }
}

/// The coefficient of restitution made something else.
fn e_to(law: &Taught<'_>, change: fn(Expr) -> Expr) -> Vec<Wrong> {
    let e = law.meaning("coefficient of restitution");
    law.replaced(&|symbol| (e == Some(symbol)).then(|| change(symbol.into())))
}

fn one_off(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(count) = law.meaning("number of bounces") else { return Vec::new() };
    let by = |step: i64| law.replaced(&|symbol| (symbol == count).then(|| Expr::from(symbol) + Expr::integer(step)));
    [by(-1), by(1)].concat()
}

/// The sum of a geometric series with another numerator in place of `1 + q`.
fn series(law: &Taught<'_>, numerator: &Expr) -> Vec<Wrong> {
    let Expr::Product(parts) = &law.sides.1 else { return Vec::new() };
    let is_numerator = |part: &&Expr| matches!(part, Expr::Sum(_)) && !law.has(part, Dimension::LENGTH);
    if parts.iter().filter(is_numerator).count() != 1 {
        return Vec::new();
    }
    let changed = parts.iter().map(|part| if is_numerator(&part) { numerator.clone() } else { part.clone() });
    one((law.left(), Expr::product(changed)))
}
