//! Mistakes about arms and moments of inertia: one of the two factors of length left out, a body taken for a particle.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::terms;

/// `m r omega` for `m r^2 omega`.
pub const ARM_NOT_SQUARED: Misconception = Misconception {
    id: "arm-not-squared",
    does: "multiplies an angular velocity by the distance once, where the square of the distance belongs",
    ask: "How fast does a point at this distance move, and what is the moment of its momentum?",
    hint: "The speed is the distance times the angular velocity, and its moment has the distance once more: a moment of inertia has its square.",
};
/// `m d^2` for a body that is spread out.
pub const AS_PARTICLE: Misconception = Misconception {
    id: "body-as-particle",
    does: "takes a body that is spread out for a particle at the distance of another one",
    ask: "How is the mass of this body spread? Is all of it as far from the axle as the point that is struck?",
    hint: "Use the moment of inertia of the whole body about the axle, as the problem gives it.",
};

const TURNS: Dimension = Dimension::new(0, 0, -1);

/// Each momentum alone without its arm.
pub(super) fn one_arm_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let all = terms(&law.sides.1);
    if all.len() < 2 {
        return Vec::new();
    }
    let bare = |term: &Expr| {
        let parts = factors(term);
        let is_moment = parts.iter().any(|part| law.is_velocity(part));
        let kept: Vec<Expr> = parts.iter().filter(|part| !law.has(part, Dimension::LENGTH)).cloned().collect();
        (is_moment && kept.len() < parts.len()).then(|| Expr::product(kept))
    };
    each_alone(law, &all, &bare)
}

/// The law with one of its terms changed, each in turn.
fn each_alone(law: &Taught<'_>, all: &[Expr], change: &dyn Fn(&Expr) -> Option<Expr>) -> Vec<Wrong> {
    let changed = all.iter().enumerate().filter_map(|(place, term)| Some((place, change(term)?)));
    let with = |(at, other): (usize, Expr)| {
        let parts = all.iter().enumerate();
        Expr::sum(parts.map(|(place, term)| if place == at { other.clone() } else { term.clone() }))
    };
    changed.map(|way| Wrong::from((law.left(), with(way)))).collect()
}

/// `v = omega` for `v = r omega`: the moment of the momentum has the distance once.
pub(super) fn speed_without_arm(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    if !parts.iter().any(|part| law.has(part, TURNS)) || !law.is_velocity(&law.sides.0) {
        return Vec::new();
    }
    let kept: Vec<Expr> = parts.iter().filter(|part| !law.has(part, Dimension::LENGTH)).cloned().collect();
    if kept.len() == parts.len() { Vec::new() } else { one((law.left(), Expr::product(kept))) }
}

/// Every square of a length beside an angular velocity to the first power.
pub(super) fn arm_not_squared(law: &Taught<'_>) -> Vec<Wrong> {
    let once = |factor: Expr| match &factor {
        Expr::Power(pair) if pair.1 == Expr::integer(2) && law.has(&pair.0, Dimension::LENGTH) => pair.0.clone(),
        _ => factor,
    };
    law.both(|side| {
        let terms = terms(side).into_iter();
        Expr::sum(
            terms.map(
                |term| {
                    if law.has(&term, TURNS) { Expr::product(factors(&term).into_iter().map(once)) } else { term }
                },
            ),
        )
    })
}

/// `m_D d^2` with the arm of a particle beside the body, in the place of its moment of inertia.
pub(super) fn as_particle(law: &Taught<'_>) -> Vec<Wrong> {
    let all = terms(&law.sides.1);
    let (bodies, particles): (Vec<&Expr>, Vec<&Expr>) = all.iter().partition(|term| law.has(term, TURNS));
    let arm = |term: &Expr| {
        let is_length = |symbol: &Symbol| law.is(*symbol, Dimension::LENGTH);
        term.symbols().into_iter().find(is_length)
    };
    let Some(arm) = particles.iter().find_map(|term| arm(term)) else { return Vec::new() };
    if bodies.is_empty() || bodies.iter().any(|body| body.contains(arm)) {
        return Vec::new();
    }
    let gathered = |term: &Expr| {
        let kept =
            factors(term).into_iter().filter(|part| part.as_number().is_none() && !law.has(part, Dimension::LENGTH));
        Expr::product(kept.chain([Expr::from(arm).powi(2)]))
    };
    one((
        law.left(),
        Expr::sum(all.iter().map(|term| if law.has(term, TURNS) { gathered(term) } else { term.clone() })),
    ))
}

/// `J r = H_2 - H_1` with a distance of the body: the linear impulse for the angular one.
pub(super) fn linear_for_angular(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = terms(&law.sides.0);
    let [start @ .., impulse] = &parts[..] else { return Vec::new() };
    if !matches!(impulse, Expr::Symbol(_)) || start.is_empty() {
        return Vec::new();
    }
    let momenta = law.beside("angular-momentum").flat_map(|(_, momentum)| terms(momentum));
    let arms = momenta.filter(|term| !law.has(term, TURNS)).flat_map(|term| term.symbols());
    let mut lengths: Vec<Symbol> = arms.filter(|symbol| law.is(*symbol, Dimension::LENGTH)).collect();
    lengths.sort_unstable();
    lengths.dedup();
    let with = |length: Symbol| Expr::sum(start.iter().cloned().chain([impulse.clone() * Expr::from(length)]));
    lengths.into_iter().map(|length| Wrong::from((with(length), law.right()))).collect()
}
