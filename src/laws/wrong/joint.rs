//! Mistakes about bodies that move on together, and about forces that do not balance.

use momentous_expr::Expr;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::rewrite::factors;
use super::rewrite::terms;

/// `v = (m_A + m_B) v_A / m_A`.
pub const RATIO_INVERTED: Misconception = Misconception {
    id: "mass-ratio-inverted",
    does: "turns the ratio of the masses upside down",
    ask: "More mass moves afterwards: is the velocity then larger or smaller than before?",
    hint: "Momentum stays the same, so the velocity is in inverse proportion to the mass that moves.",
};
/// `F - m g = 0`.
pub const AT_REST: Misconception = Misconception {
    id: "forces-taken-to-balance",
    does: "lets the forces balance, although the velocity of the body changes",
    ask: "Does the velocity of the body stay the same? What does that say of the sum of the forces on it?",
    hint: "Forces balance on a body at rest or in uniform motion; here their sum changes the momentum.",
};

/// `(m_A + m_B) v_A = m_A v` for the body that strikes.
pub(super) fn ratio_inverted(law: &Taught<'_>) -> Vec<Wrong> {
    let [Expr::Sum(masses), velocity] = &factors(&law.sides.1)[..] else { return Vec::new() };
    let total = Expr::Sum(masses.clone());
    let inverted = |term: Expr| {
        let (speeds, mass): (Vec<Expr>, Vec<Expr>) = factors(&term).into_iter().partition(|part| law.is_velocity(part));
        let [speed] = &speeds[..] else { return None };
        Some(Wrong::from((total.clone() * speed.clone(), Expr::product(mass) * velocity.clone())))
    };
    terms(&law.sides.0).into_iter().next().and_then(inverted).into_iter().collect()
}

/// The impulses alone add up to zero, the weight among them.
pub(super) fn in_balance(law: &Taught<'_>) -> Vec<Wrong> {
    let moves = |term: &Expr| law.has(term, Dimension::VELOCITY);
    let impulses: Vec<Expr> = terms(&law.sides.0).into_iter().filter(|term| !moves(term)).collect();
    let forces = impulses
        .iter()
        .flat_map(Expr::symbols)
        .filter(|symbol| law.is(*symbol, Dimension::FORCE) || law.is(*symbol, Dimension::MOMENTUM));
    let is_sought = forces.into_iter().any(|symbol| !law.known.contains(&symbol));
    if is_sought && impulses.iter().any(|term| law.has_gravity(term)) && moves(&law.sides.1) {
        vec![Wrong::from((Expr::sum(impulses), Expr::zero()))]
    } else {
        Vec::new()
    }
}
