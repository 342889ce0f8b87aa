//! Mistakes about bodies that come apart.

use crate::Sides;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::terms;

/// A relative velocity as one over the ground.
pub const ABSOLUTE: Misconception = Misconception {
    id: "relative-velocity-as-absolute",
    does: "mistakes a relative velocity for a velocity relative to the ground",
    ask: "Relative to what is this velocity given, and does that body move, too?",
    hint: "Momentum is calculated with velocities relative to the ground: add the velocity of the body to which it is relative.",
};
/// The difference taken the wrong way round.
pub const REVERSED: Misconception = Misconception {
    id: "relative-velocity-reversed",
    does: "subtracts the velocities of a relative one in the wrong order",
    ask: "Which body's velocity is it, and relative to which other body?",
    hint: "The velocity of A relative to B is that of A minus that of B.",
};
/// A relative displacement as one over the ground.
pub const ABSOLUTE_WAY: Misconception = Misconception {
    id: "relative-displacement-as-absolute",
    does: "mistakes a relative displacement for one over the ground",
    ask: "Relative to what is this displacement given, and does that body move, too?",
    hint: "The displacement over the ground is the relative one plus that of the body to which it is relative.",
};
/// The difference of displacements taken the wrong way round.
pub const REVERSED_WAY: Misconception = Misconception {
    id: "relative-displacement-reversed",
    does: "subtracts the displacements of a relative one in the wrong order",
    ask: "Whose displacement is it, and relative to which other body?",
    hint: "The displacement of A relative to B is that of A minus that of B.",
};
/// A velocity relative to what a body was, not to what it is.
pub const RELATIVE_TO_BEFORE: Misconception = Misconception {
    id: "relative-to-velocity-before",
    does: "counts a relative velocity from the velocity that the other body had before",
    ask: "The relative velocity is that after the separation: which velocity does the other body have then?",
    hint: "Both velocities in a relative velocity are taken at the same instant.",
};
/// Kinetic energy before left out.
pub const START: Misconception = Misconception {
    id: "start-energy-forgotten",
    does: "leaves out the kinetic energy that was there before",
    ask: "Did anything move before the energy was released?",
    hint: "The energy released is added to the kinetic energy that the bodies already had.",
};
/// Energy released as energy lost.
pub const SUBTRACTED: Misconception = Misconception {
    id: "released-energy-subtracted",
    does: "subtracts the energy that is released",
    ask: "Is there more kinetic energy after the separation, or less?",
    hint: "The energy of a spring or an explosive is added to the kinetic energy.",
};

/// Momentum conserved where a guide acts.
pub const GUIDE_FORGOTTEN: Misconception = Misconception {
    id: "guide-forgotten",
    does: "conserves the momentum at right angles to a guide, too, as if the guide exerted no impulse",
    ask: "Does any external impulse act at right angles to the guide?",
    hint: "Rails, a floor or a cord hold the body with whatever impulse is needed: momentum is conserved along the guide only.",
};

/// What gives way taken as fixed.
pub const CARRIER_FIXED: Misconception = Misconception {
    id: "carrier-taken-as-fixed",
    does: "calculates as if the body that gives way were fixed",
    ask: "Does the body that carries the other one stay at rest, or does it move, too?",
    hint: "What gives way takes up momentum and kinetic energy; where neither moves relative to the other, both still move together.",
};
/// The kinetic energy of what gives way left out.
pub const CARRIER_ENERGY: Misconception = Misconception {
    id: "energy-of-what-gives-way-forgotten",
    does: "leaves out the kinetic energy of the body that gives way",
    ask: "Which bodies move at this instant, and whose kinetic energy have you counted?",
    hint: "Write the kinetic energies of both bodies at both instants, then the weight times the height.",
};

/// Wrong forms of the energy of a body on one that gives way.
pub const CARRIED: &[WrongForm] = &[
    WrongForm { of: &CARRIER_FIXED, write: carrier_fixed },
    WrongForm { of: &CARRIER_ENERGY, write: carrier_energy_forgotten },
    WrongForm { of: &super::energy::SQUARE, write: super::energy::square },
];
/// Wrong forms of the constraint of a guide.
pub const GUIDE: &[WrongForm] = &[WrongForm { of: &GUIDE_FORGOTTEN, write: conserved_across }];
/// Wrong forms of a relative velocity.
pub const RELATIVE: &[WrongForm] = &[
    WrongForm { of: &ABSOLUTE, write: absolute },
    WrongForm { of: &REVERSED, write: |law| one((law.left(), -law.right())) },
    WrongForm { of: &RELATIVE_TO_BEFORE, write: relative_to_before },
    WrongForm { of: &super::restitution::ADDED, write: added },
];
/// Wrong forms of a relative displacement.
pub const RELATIVE_WAY: &[WrongForm] = &[
    WrongForm { of: &ABSOLUTE_WAY, write: absolute },
    WrongForm { of: &REVERSED_WAY, write: |law| one((law.left(), -law.right())) },
];
/// Wrong forms of the balance of energy.
pub const ENERGY: &[WrongForm] = &[
    WrongForm { of: &START, write: start_forgotten },
    WrongForm { of: &SUBTRACTED, write: subtracted },
    WrongForm { of: &super::energy::ONE_BODY, write: all_to_one },
    WrongForm { of: &super::squares::EQUAL_SHARES, write: super::squares::equal_shares },
    WrongForm { of: &super::squares::SHARED_BY_MASS, write: super::squares::shared_by_mass },
];
/// Wrong forms of energy gained.
pub const GAIN: &[WrongForm] = &[
    WrongForm { of: &START, write: gain_from_nothing },
    WrongForm { of: &super::energy::DIFFERENCE, write: super::energy::difference },
];

/// The momentum across the guide, without the impulse of the guide, in place of the constraint. It refers to components that
/// the right way has no need of, so that the turning of the axes comes with it.
fn conserved_across(law: &Taught<'_>) -> Vec<Wrong> {
    let is_impulse = |term: &Expr| matches!(term, Expr::Symbol(symbol) if law.is(*symbol, Dimension::MOMENTUM));
    let held = law.sides.0.symbols();
    let after = law.beside("impulse-momentum-of-a-system").filter(|(_, end)| !end.symbols().is_disjoint(&held));
    let conserved = |(start, end): &Sides| {
        let kept = terms(start).into_iter().filter(|term| !is_impulse(term));
        let turned =
            law.beside("turned-axes").filter(|(direction, _)| !direction.symbols().is_disjoint(&end.symbols()));
        let equations = [(Expr::sum(kept), end.clone())].into_iter().chain(turned.cloned()).collect();
        Wrong { equations, without: &[] }
    };
    after.map(conserved).collect()
}

/// `m v_A1^2 / 2 = m g h`: without the other body, and without what both have in common where they move together.
fn carrier_fixed(law: &Taught<'_>) -> Vec<Wrong> {
    let both = law.beside("same-velocity").flat_map(|(carrier, carried)| [carrier.symbols(), carried.symbols()]);
    let common: Vec<Symbol> = both.flatten().collect();
    law.without(&|term| {
        carries(law, term) || !matches!(term, Expr::Sum(_)) && common.iter().any(|symbol| term.contains(*symbol))
    })
}

/// `m v_A1^2 / 2 = m v_A2^2 / 2 + m g h`, where both move together in the end; elsewhere that is the same as a fixed carrier.
fn carrier_energy_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    if law.beside("same-velocity").next().is_none() || !law.has_gravity(&law.sides.1) {
        return Vec::new();
    }
    law.without(&|term| carries(law, term))
}

/// Whether a term is a kinetic energy of the other body: one without the mass whose weight does work.
fn carries(law: &Taught<'_>, term: &Expr) -> bool {
    let masses =
        |term: &Expr| term.symbols().into_iter().filter(|symbol| law.is(*symbol, Dimension::MASS)).collect::<Vec<_>>();
    let parts = terms(&law.sides.0).into_iter().chain(terms(&law.sides.1));
    let weighed: Vec<Symbol> = parts.filter(|part| law.has_gravity(part)).flat_map(|part| masses(&part)).collect();
    !matches!(term, Expr::Sum(_)) && !masses(term).is_empty() && masses(term).iter().all(|mass| !weighed.contains(mass))
}

/// `v_A = u`.
fn absolute(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [first, _] => one((first.clone(), law.right())),
        _ => Vec::new(),
    }
}

/// `v_A + v_B = u`.
fn added(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [first, second] => one((first.clone() - second.clone(), law.right())),
        _ => Vec::new(),
    }
}

/// `v_A2 - v_1 = u`: the other body's velocity before, from its own balance of momentum.
fn relative_to_before(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = terms(&law.sides.0);
    let [first, other] = &parts[..] else { return Vec::new() };
    let other = -other.clone();
    let is_velocity = |part: &Expr| law.is_velocity(part);
    let balances = law.beside("impulse-momentum").filter(|(_, end)| factors(end).contains(&other));
    let before = balances.flat_map(|(start, _)| terms(start)).flat_map(|term| factors(&term)).filter(is_velocity);
    before.map(|before| Wrong::from((first.clone() - before, law.right()))).collect()
}

/// `E = T_2`: the energy released stands last.
fn start_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [_, .., released] => one((released.clone(), law.right())),
        _ => Vec::new(),
    }
}

fn subtracted(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.0)[..] {
        [before @ .., released] if !before.is_empty() => {
            one((Expr::sum(before.iter().cloned().chain([-released.clone()])), law.right()))
        }
        _ => Vec::new(),
    }
}

/// `E = m v_B2^2 / 2`: all that is released goes to one body.
fn all_to_one(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some(released), bodies) = (terms(&law.sides.0).pop(), terms(&law.sides.1)) else { return Vec::new() };
    bodies.into_iter().map(|body| Wrong::from((released.clone(), body))).collect()
}

fn gain_from_nothing(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.1)[..] {
        [after, _] => one((law.left(), after.clone())),
        _ => Vec::new(),
    }
}
