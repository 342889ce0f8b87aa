//! Mistakes about orbits.

use momentous_expr::Expr;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::energy::HALF;
use super::energy::WEIGHT_WORK_REVERSED;
use super::rewrite::factors;
use super::rewrite::one;

/// `g h` far from the ground.
pub const UNIFORM_GRAVITY: Misconception = Misconception {
    id: "gravity-by-radius-squared",
    does: "divides by the square of the distance in the energy of gravity",
    ask: "Which is proportional to one over the distance squared: the force of gravity, or its energy?",
    hint: "The energy is the force integrated over the distance, so it has one power of the distance less.",
};
/// `-GM / a`.
pub const AXIS: Misconception = Misconception {
    id: "whole-axis-for-half",
    does: "confuses the semi-major axis with the major axis",
    ask: "Is a the whole length of the orbit, from the nearest point to the farthest, or half of it?",
    hint: "The nearest and the farthest distance add up to the major axis, which is twice a.",
};
/// `r_max = 2 a`.
pub const OTHER_END: Misconception = Misconception {
    id: "other-end-of-the-axis-forgotten",
    does: "gives the whole axis of an ellipse for the distance of one of its ends from the focus",
    ask: "From which point is this distance counted, and from which to which does the axis reach?",
    hint: "The centre of force is a focus, inside the ellipse: the nearest and the farthest distance share the axis.",
};
/// `T^3 = 4 pi^2 a^2 / GM`.
pub const POWERS: Misconception = Misconception {
    id: "keplers-powers-exchanged",
    does: "exchanges the powers in Kepler's third law",
    ask: "Which power of the period is proportional to which power of the semi-major axis?",
    hint: "Check the units: GM is a length cubed over a time squared.",
};
/// `T^2 = 2 pi a^3 / GM`.
pub const PI_SQUARE: Misconception = Misconception {
    id: "pi-not-squared",
    does: "does not square the factor two pi in the square of the period",
    ask: "What does the factor two pi become when the equation for the period is squared?",
    hint: "Write the period as a factor times a square root, and square all of it.",
};
/// `1 - ecc`.
pub const ECCENTRICITY: Misconception = Misconception {
    id: "eccentricity-not-squared",
    does: "does not square the eccentricity",
    ask: "To which power is the eccentricity raised in the parameter of the orbit?",
    hint: "Multiply the distances of the nearest and the farthest point, in terms of the semi-major axis and the eccentricity.",
};

/// Wrong forms of energy under gravity.
pub const ENERGY: &[WrongForm] = &[
    WrongForm { of: &HALF, write: |law| law.replaced(&|symbol| speed(law, symbol)) },
    WrongForm { of: &UNIFORM_GRAVITY, write: |law| law.replaced(&|symbol| radius(law, symbol)) },
    WrongForm { of: &WEIGHT_WORK_REVERSED, write: |law| law.replaced(&|symbol| gravity_reversed(law, symbol)) },
];
/// Wrong forms of the energy of an ellipse.
pub const ELLIPSE: &[WrongForm] = &[
    WrongForm { of: &HALF, write: |law| law.replaced(&|symbol| speed(law, symbol)) },
    WrongForm { of: &AXIS, write: |law| one((law.left(), Expr::integer(2) * law.right())) },
];
/// Wrong forms of the geometry of an ellipse.
pub const APSES: &[WrongForm] =
    &[WrongForm { of: &AXIS, write: axis_of_sum }, WrongForm { of: &OTHER_END, write: other_end_forgotten }];
/// Wrong forms of the period.
pub const PERIOD: &[WrongForm] =
    &[WrongForm { of: &POWERS, write: powers }, WrongForm { of: &PI_SQUARE, write: |law| pi_square(law) }];
/// Wrong forms of the angular momentum of an orbit.
pub const SHAPE: &[WrongForm] = &[WrongForm { of: &ECCENTRICITY, write: |law| law.both(|side| unsquared(law, side)) }];

/// A speed that counts with twice its square.
fn speed(law: &Taught<'_>, symbol: momentous_expr::Symbol) -> Option<Expr> {
    law.is(symbol, Dimension::VELOCITY).then(|| Expr::integer(2).sqrt() * Expr::from(symbol))
}

/// The gravity of a centre, which repels.
fn gravity_reversed(law: &Taught<'_>, symbol: momentous_expr::Symbol) -> Option<Expr> {
    law.is(symbol, Dimension::new(0, 3, -2)).then(|| -Expr::from(symbol))
}

fn radius(law: &Taught<'_>, symbol: momentous_expr::Symbol) -> Option<Expr> {
    law.is(symbol, Dimension::LENGTH).then(|| Expr::from(symbol).powi(2))
}

/// `a = r_min + r_max`.
fn axis_of_sum(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.1 {
        Expr::Sum(_) => one((law.left(), Expr::integer(2) * law.right())),
        _ => Vec::new(),
    }
}

/// `r_max = 2 a`.
fn other_end_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &factors(&law.sides.1)[..] {
        [Expr::Symbol(axis), Expr::Sum(_)] => one((law.left(), Expr::integer(2) * Expr::from(*axis))),
        _ => Vec::new(),
    }
}

/// The period with the third power, the axis with the second.
fn powers(law: &Taught<'_>) -> Vec<Wrong> {
    let power = |symbol| match () {
        () if law.is(symbol, Dimension::TIME) => Some(Expr::from(symbol).power(Expr::ratio(3, 2))),
        () if law.is(symbol, Dimension::LENGTH) => Some(Expr::from(symbol).power(Expr::ratio(2, 3))),
        () => None,
    };
    law.replaced(&power)
}

fn pi_square(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), law.right() / (Expr::integer(2) * Expr::Pi)))
}

/// Squares of pure numbers taken away.
fn unsquared(law: &Taught<'_>, term: &Expr) -> Expr {
    match term {
        Expr::Power(pair)
            if pair.1 == Expr::integer(2)
                && matches!(&pair.0, Expr::Symbol(symbol) if law.is(*symbol, Dimension::NONE)) =>
        {
            pair.0.clone()
        }
        other => other.map_children(|part| unsquared(law, part)),
    }
}
