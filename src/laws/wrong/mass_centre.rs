//! Mistakes about the centre of mass.

use momentous_expr::Expr;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::momentum::IMPULSE_REVERSED;
use super::momentum::ONE_MASS;
use super::momentum::SIGN_LOST;
use super::momentum::START_FORGOTTEN;
use super::rewrite::factors;
use super::rewrite::gain_reversed;
use super::rewrite::one;
use super::rewrite::sign_lost;
use super::rewrite::start_forgotten;
use super::rewrite::terms;
use super::separation::REVERSED;

/// The centre of mass as the middle.
pub const PLAIN_AVERAGE: Misconception = Misconception {
    id: "plain-average",
    does: "takes the plain average instead of the mean weighted by mass",
    ask: "Does each body count equally, whatever its mass?",
    hint: "The centre of mass lies nearer to the heavier body: each body is weighted by its mass.",
};
/// Each displacement times the mass of the other body.
pub const MASSES_EXCHANGED: Misconception = Misconception {
    id: "masses-exchanged",
    does: "gives each body the mass of the other",
    ask: "Which mass belongs to which displacement or velocity?",
    hint: "Each mass multiplies the quantity of its own body: the heavier body moves less, and the centre of mass lies nearer to it.",
};
/// The sum over the number of bodies.
pub const BY_NUMBER: Misconception = Misconception {
    id: "divided-by-the-number-of-bodies",
    does: "divides the sum of the products with the masses by the number of bodies, or not at all",
    ask: "What do the masses with which you weighted add up to? By what must the sum be divided?",
    hint: "A mean weighted by mass is the sum of mass times value over the sum of the masses.",
};
/// A centre of mass that stays although the system moves.
pub const CENTRE_STAYS: Misconception = Misconception {
    id: "mass-centre-kept-in-place",
    does: "leaves the centre of mass where it was, although the system moves",
    ask: "Does the system have momentum before?",
    hint: "Without external impulses the centre of mass keeps its velocity: it stays in place only if it was at rest.",
};

/// Absolute velocities in the energy of relative motion.
pub const NOT_RELATIVE: Misconception = Misconception {
    id: "velocity-not-relative",
    does: "leaves the velocity of the centre of mass out of a relative velocity",
    ask: "Relative to what is the velocity taken?",
    hint: "Relative to the centre of mass, a body moves with the difference of the two velocities.",
};
/// One of several forces.
pub const SOME_FORCES: Misconception = Misconception {
    id: "one-force-for-all",
    does: "counts one of the forces on the system only",
    ask: "Which external forces act on the bodies of the system? Is each of them among yours?",
    hint: "Every external force on any of the bodies changes the momentum of the system, and its moment the angular momentum.",
};
/// One of the two parts of Koenig's theorem left out.
pub const PART_FORGOTTEN: Misconception = Misconception {
    id: "part-of-koenig-forgotten",
    does: "leaves out the part of the centre of mass, or the part relative to it",
    ask: "Of which two parts does the motion of a system consist?",
    hint: "One part is that of the total mass at the centre of mass, the other that of the motion relative to it.",
};

/// Wrong forms of a relative velocity.
pub const RELATIVE: &[WrongForm] = &[
    WrongForm { of: &NOT_RELATIVE, write: |law| first_term(law) },
    WrongForm { of: &REVERSED, write: |law| one((law.left(), -law.right())) },
];
/// Wrong forms of the energy of a system.
pub const ENERGY: &[WrongForm] = &[WrongForm { of: &PART_FORGOTTEN, write: each_term }];
/// Wrong forms of the angular momentum of a system.
pub const ANGULAR: &[WrongForm] = &[WrongForm { of: &PART_FORGOTTEN, write: each_term }];

/// Wrong forms of the definition.
pub const MASS_CENTRE: &[WrongForm] = &[
    WrongForm { of: &PLAIN_AVERAGE, write: plain_average },
    WrongForm { of: &SIGN_LOST, write: sign_lost },
    WrongForm { of: &MASSES_EXCHANGED, write: masses_exchanged },
    WrongForm { of: &BY_NUMBER, write: by_number },
];
/// Wrong forms of the momenta relative to the centre of mass.
pub const NO_MOMENTUM: &[WrongForm] = &[WrongForm { of: &PLAIN_AVERAGE, write: plain_average }];
/// Wrong forms of the displacements without external impulses.
pub const DISPLACEMENTS: &[WrongForm] = &[
    WrongForm { of: &PLAIN_AVERAGE, write: plain_average },
    WrongForm { of: &CENTRE_STAYS, write: stays },
    WrongForm { of: &MASSES_EXCHANGED, write: masses_exchanged },
];
/// Wrong forms of the displacement of the centre of mass.
pub const DISPLACEMENT: &[WrongForm] = &[WrongForm { of: &CENTRE_STAYS, write: stays }];
/// Wrong forms of the motion.
pub const MOTION: &[WrongForm] = &[
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &IMPULSE_REVERSED, write: gain_reversed },
    WrongForm { of: &ONE_MASS, write: one_mass },
];

/// Wrong forms of the rate of change of momentum.
pub const RATE: &[WrongForm] = &[WrongForm { of: &SOME_FORCES, write: each_term }];
/// Wrong forms of the acceleration of the centre of mass.
pub const ACCELERATION: &[WrongForm] = &[WrongForm { of: &ONE_MASS, write: one_mass }];

/// The first term of the right side alone.
fn first_term(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.1)[..] {
        [first, _, ..] => one((law.left(), first.clone())),
        _ => Vec::new(),
    }
}

/// Each of several terms of the right side alone.
fn each_term(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = terms(&law.sides.1);
    let alone = parts.iter().map(|part| Wrong::from((law.left(), part.clone())));
    if parts.len() > 1 { alone.collect() } else { Vec::new() }
}

/// What is multiplied by a time is left out of the right side.
fn stays(law: &Taught<'_>) -> Vec<Wrong> {
    let all = terms(&law.sides.1);
    let rest: Vec<Expr> = all.iter().filter(|term| !law.has(term, Dimension::TIME)).cloned().collect();
    if rest.len() < all.len() { one((law.left(), Expr::sum(rest))) } else { Vec::new() }
}

/// `n x = m_A x_A + m_B x_B`, and the sum itself.
fn by_number(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.0);
    let [Expr::Sum(masses), centre] = &parts[..] else { return Vec::new() };
    let count = i64::try_from(masses.len()).unwrap_or(2);
    [count, 1].into_iter().flat_map(|count| one((Expr::integer(count) * centre.clone(), law.right()))).collect()
}

/// Every mass is one.
fn plain_average(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| law.is(symbol, Dimension::MASS).then(Expr::one))
}

/// The masses of two bodies exchanged.
fn masses_exchanged(law: &Taught<'_>) -> Vec<Wrong> {
    let [one, other] = law.quantities(Dimension::MASS)[..] else { return Vec::new() };
    law.replaced(&|symbol| {
        let swapped = if symbol == one { Some(other) } else { (symbol == other).then_some(one) };
        swapped.map(Expr::from)
    })
}

fn one_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let sides = [&law.sides.1, &law.sides.0].map(factors);
    let masses = sides.iter().find_map(|parts| match &parts[..] {
        [Expr::Sum(masses), _] => Some(masses),
        _ => None,
    });
    let Some(masses) = masses else { return Vec::new() };
    let total = Expr::Sum(masses.clone());
    masses.iter().flat_map(|mass| law.both(|side| exchanged(side, &total, mass))).collect()
}

fn exchanged(term: &Expr, from: &Expr, to: &Expr) -> Expr {
    if term == from { to.clone() } else { term.map_children(|part| exchanged(part, from, to)) }
}
