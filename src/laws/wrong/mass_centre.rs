//! Mistakes about the mass centre.

use crate::expr::Expr;
use crate::quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::momentum::IMPULSE_REVERSED;
use super::momentum::SIGN_LOST;
use super::momentum::START_FORGOTTEN;
use super::rewrite::factors;
use super::rewrite::gain_reversed;
use super::rewrite::sign_lost;
use super::rewrite::start_forgotten;

/// The mass centre as the middle.
pub const PLAIN_AVERAGE: Misconception = Misconception {
    id: "plain-average",
    does: "takes the plain average instead of the mean weighted by mass",
    ask: "Does each body count the same, whatever its mass?",
    hint: "The mass centre lies nearer to the heavier body: each body counts by its mass.",
};
/// The impulse on one body's mass.
pub const ONE_MASS: Misconception = Misconception {
    id: "one-mass-for-system",
    does: "divides the impulse by the mass of one body instead of that of the system",
    ask: "The mass centre of which system changes its velocity, and what is the mass of that system?",
    hint: "An impulse from outside changes the momentum of the whole system.",
};

/// Wrong forms of the definition.
pub const MASS_CENTRE: &[WrongForm] =
    &[WrongForm { of: &PLAIN_AVERAGE, write: plain_average }, WrongForm { of: &SIGN_LOST, write: sign_lost }];
/// Wrong forms of the motion.
pub const MOTION: &[WrongForm] = &[
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &IMPULSE_REVERSED, write: gain_reversed },
    WrongForm { of: &ONE_MASS, write: one_mass },
];

/// Every mass is one.
fn plain_average(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| law.is(symbol, Dimension::MASS).then(Expr::one))
}

fn one_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    let [Expr::Sum(masses), _] = &parts[..] else { return Vec::new() };
    let total = Expr::Sum(masses.clone());
    masses.iter().flat_map(|mass| law.both(|side| exchanged(side, &total, mass))).collect()
}

fn exchanged(term: &Expr, from: &Expr, to: &Expr) -> Expr {
    if term == from { to.clone() } else { term.map_children(|part| exchanged(part, from, to)) }
}
