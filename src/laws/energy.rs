//! Kinetic energy and what an impact loses of it.

use crate::expr::Expr;

use super::Law;
use super::wrong;

/// Kinetic energy.
pub const KINETIC: Law = Law {
    id: "kinetic-energy",
    name: "the definition of kinetic energy",
    statement: "The kinetic energy of a body is half its mass times its speed squared; that of a system is the sum over its bodies.",
    signs: "Never negative, whatever the direction of motion.",
    when: "Always.",
    source: "Definition.",
    wrong: wrong::energy::KINETIC,
};

/// Energy lost in a stage.
pub const LOSS: Law = Law {
    id: "energy-lost",
    name: "the balance of kinetic energy",
    statement: "The kinetic energy lost is the kinetic energy before less the kinetic energy after.",
    signs: "A loss is positive.",
    when: "Always; in an impact without a source of energy it is never negative.",
    source: "Definition.",
    wrong: wrong::energy::LOSS,
};

/// Energy gained in a stage.
pub const GAIN: Law = Law {
    id: "energy-gained",
    name: "the balance of kinetic energy",
    statement: "The kinetic energy gained is the kinetic energy after less the kinetic energy before.",
    signs: "A gain is positive.",
    when: "Always; in a separation something supplies it: an explosive, a spring, muscles.",
    source: "Definition.",
    wrong: &[],
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&KINETIC, &LOSS, &GAIN];

/// `m v^2 / 2`, with the square of the speed as a sum of squared components.
#[must_use]
pub fn kinetic(mass: &Expr, components: &[Expr]) -> Expr {
    let squares = Expr::sum(components.iter().map(|component| component.clone().powi(2)));
    Expr::product([Expr::ratio(1, 2), mass.clone(), squares])
}
