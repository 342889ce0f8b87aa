//! Mistakes about kinetic energy and its loss.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::friction::FRICTION_COEFFICIENT;
use super::friction::FRICTION_FORGOTTEN;
use super::friction::FRICTION_REVERSED;
use super::friction::friction_forgotten;
use super::friction::friction_reversed;
use super::friction::friction_whole;
use super::friction::rubs;
use super::kinematics::SPEEDS_ADDED;
use super::momentum::OTHER_WEIGHT;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::terms;

/// `m v^2`.
pub const HALF: Misconception = Misconception {
    id: "half-forgotten",
    does: "leaves out the factor of one half of a kinetic energy",
    ask: "How is kinetic energy defined, with every factor?",
    hint: "Compare the factors in front of mass and squared speed with the definition.",
};
/// `m v / 2`.
pub const SQUARE: Misconception = Misconception {
    id: "square-forgotten",
    does: "does not square the speed in a kinetic energy",
    ask: "How does the kinetic energy change when the speed is doubled?",
    hint: "Kinetic energy is proportional to the square of the speed: check the units of yours.",
};
/// The energy of one body for that of the system.
pub const ONE_BODY: Misconception = Misconception {
    id: "energy-of-one-body",
    does: "counts the kinetic energy of one body only",
    ask: "Whose kinetic energies belong to the system?",
    hint: "The energy lost is that of all bodies before minus that of all bodies after.",
};
/// What is left for what is lost.
pub const REMAINDER: Misconception = Misconception {
    id: "remainder-for-loss",
    does: "gives the energy that is left for the energy that is lost",
    ask: "Did you find the energy that is lost, or the energy that is left?",
    hint: "A loss is the difference between two energies: check which one you have written down.",
};
/// `(1 - e^2) T_1`.
pub const SHARE: Misconception = Misconception {
    id: "loss-as-share-of-e",
    does: "takes 1 - e\u{b2} or 1 - e of the whole kinetic energy as lost",
    ask: "Can the bodies ever lose the energy with which their centre of mass moves?",
    hint: "The coefficient concerns only the relative motion; the motion of the centre of mass does not change.",
};
/// `m (v_1 - v_2)^2 / 2`.
pub const DIFFERENCE: Misconception = Misconception {
    id: "difference-squared",
    does: "squares the difference of velocities instead of subtracting squares",
    ask: "Is the difference of two squares the square of the difference?",
    hint: "Calculate the energy before and the energy after separately, then subtract.",
};

/// The work of weight left out.
pub const WEIGHT_WORK: Misconception = Misconception {
    id: "work-of-weight-forgotten",
    does: "leaves out the work of the weight",
    ask: "Does the body end higher or lower than it began?",
    hint: "Weight takes energy on the way up and gives it back on the way down.",
};
/// The work of weight with the wrong sign.
pub const WEIGHT_WORK_REVERSED: Misconception = Misconception {
    id: "work-of-weight-reversed",
    does: "gives the work of the weight the wrong sign",
    ask: "Does weight speed the body up or slow it down here?",
    hint: "Compare the direction of the weight with that in which the body moves.",
};
/// `m v_x^2 / 2`.
pub const ONE_COMPONENT: Misconception = Misconception {
    id: "energy-of-one-component",
    does: "counts one component of a velocity only in a kinetic energy",
    ask: "Which speed stands in a kinetic energy: that along one axis, or the whole?",
    hint: "The square of the speed is the sum of the squares of its components, whichever of them the impact changes.",
};
/// `k s^2`.
pub const SPRING_HALF: Misconception = Misconception {
    id: "spring-half-forgotten",
    does: "leaves out the factor of one half in the energy of a spring",
    ask: "The force of a spring grows from zero: what is its average over the distance?",
    hint: "Draw the force against the deformation: the energy is the area of a triangle.",
};

/// `k s / 2`.
pub const SPRING_SQUARE: Misconception = Misconception {
    id: "spring-square-forgotten",
    does: "does not square the deformation in the energy of a spring",
    ask: "How much more energy does a spring hold when it is pressed twice as far?",
    hint: "The force and the distance both grow with the deformation: check the units of your energy.",
};

/// The lower body taken as fixed.
pub const LOWER_FIXED: Misconception = Misconception {
    id: "lower-body-taken-as-fixed",
    does: "lets the upper body slide until it is at rest, as if the lower body were fixed",
    ask: "Does the lower body stay at rest? With what velocity do both move when the sliding ends?",
    hint: "Friction speeds the lower body up, so both still have kinetic energy when they move together.",
};

/// A way over the ground for the way that one body slides on the other.
pub const OVER_GROUND: Misconception = Misconception {
    id: "distance-over-the-ground",
    does: "gives how far a body moves over the ground for how far one slides on the other",
    ask: "Relative to what is this distance counted: to the ground, or to the other body, which moves as well?",
    hint: "The distance of sliding is the difference of the distances that both bodies move over the ground.",
};

/// Wrong forms of the work of friction between two bodies.
pub const RUBBING: &[WrongForm] = &[
    WrongForm { of: &LOWER_FIXED, write: lower_fixed },
    WrongForm { of: &OTHER_WEIGHT, write: other_weight },
    WrongForm { of: &FRICTION_REVERSED, write: friction_reversed },
    WrongForm { of: &ONE_BODY, write: upper_body },
    WrongForm { of: &OVER_GROUND, write: over_ground },
];
/// Wrong forms of the heat of friction.
pub const HEAT: &[WrongForm] = &[WrongForm { of: &OTHER_WEIGHT, write: other_weight }];
/// Wrong forms of work and energy.
pub const WORK: &[WrongForm] = &[
    WrongForm { of: &HALF, write: |law| law.both(|side| kinetic_doubled(law, side)) },
    WrongForm { of: &FRICTION_FORGOTTEN, write: friction_forgotten },
    WrongForm { of: &FRICTION_REVERSED, write: friction_reversed },
    WrongForm { of: &FRICTION_COEFFICIENT, write: friction_whole },
    WrongForm { of: &WEIGHT_WORK, write: weight_work_forgotten },
    WrongForm { of: &WEIGHT_WORK_REVERSED, write: |law| law.both(|side| weight_work(law, side)) },
    WrongForm { of: &SPRING_HALF, write: |law| law.both(|side| spring_doubled(law, side)) },
    WrongForm { of: &SPRING_SQUARE, write: |law| law.both(|side| spring_unsquared(law, side)) },
    WrongForm { of: &ONE_BODY, write: kinetic_of_one },
    WrongForm { of: &SQUARE, write: square },
    WrongForm { of: &super::squares::MASS_ON_ONE_SIDE, write: super::squares::mass_on_one_side },
    WrongForm { of: &SPEEDS_ADDED, write: super::squares::speeds_added },
];
/// Wrong forms of conservation of energy.
pub const CONSERVATION: &[WrongForm] = &[
    WrongForm { of: &WEIGHT_WORK, write: weight_work_forgotten },
    WrongForm { of: &WEIGHT_WORK_REVERSED, write: |law| law.both(|side| weight_work(law, side)) },
    WrongForm { of: &SPRING_HALF, write: |law| law.both(|side| spring_doubled(law, side)) },
    WrongForm { of: &SPRING_SQUARE, write: |law| law.both(|side| spring_unsquared(law, side)) },
    WrongForm { of: &HALF, write: |law| law.both(|side| kinetic_doubled(law, side)) },
    WrongForm { of: &SQUARE, write: square },
    WrongForm { of: &SPEEDS_ADDED, write: super::squares::speeds_added },
    WrongForm { of: &super::squares::STATIC_SPRING, write: super::squares::static_spring },
    WrongForm { of: &super::squares::LENGTH_FOR_STRETCH, write: super::squares::length_for_stretch },
    WrongForm { of: &super::squares::STRETCHES_SUBTRACTED, write: super::squares::stretches_subtracted },
];
/// Wrong forms of the energy of a spring.
pub const SPRING: &[WrongForm] =
    &[WrongForm { of: &SPRING_HALF, write: |law| law.both(|side| spring_doubled(law, side)) }];
/// Wrong forms of kinetic energy.
pub const KINETIC: &[WrongForm] = &[
    WrongForm { of: &HALF, write: |law| one((law.left(), Expr::integer(2) * law.right())) },
    WrongForm { of: &SQUARE, write: square },
    WrongForm { of: &ONE_BODY, write: one_body },
    WrongForm { of: &ONE_COMPONENT, write: |law| [one_component(law, 0), one_component(law, 1)].concat() },
];
/// Wrong forms of the loss.
pub const LOSS: &[WrongForm] = &[
    WrongForm { of: &REMAINDER, write: remainder },
    WrongForm { of: &SHARE, write: share },
    WrongForm { of: &DIFFERENCE, write: difference },
    WrongForm { of: &super::squares::REDUCED_MASS, write: super::squares::reduced_mass_forgotten },
];

/// Whether a term is the work of a weight: not that of the friction which the weight causes.
fn is_weight(law: &Taught<'_>, term: &Expr) -> bool {
    law.has_gravity(term) && !matches!(term, Expr::Sum(_)) && !rubs(law, term)
}

/// The other masses of the stage, and their sum with the one that rubs, in its place where friction stands.
fn other_weight(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(upper) = rubbing_mass(law) else { return Vec::new() };
    let beside = law.beside("work-of-friction-between-bodies").flat_map(|(start, _)| start.symbols());
    let mut others: Vec<Symbol> = law.quantities(Dimension::MASS);
    others.extend(
        beside.filter(|symbol| law.is(*symbol, Dimension::MASS) && !law.quantities(Dimension::MASS).contains(symbol)),
    );
    let others = others.into_iter().filter(|symbol| *symbol != upper).map(Expr::from);
    let taken = others.flat_map(|mass| [mass.clone(), mass + Expr::from(upper)]);
    let rewritten = taken.flat_map(|mass| {
        law.both(|side| {
            let swap = |term: Expr| {
                let replaced = |symbol| (symbol == upper).then(|| mass.clone());
                if rubs(law, &term) { term.substitute(&replaced) } else { term }
            };
            Expr::sum(terms(side).into_iter().map(swap))
        })
    });
    rewritten.collect()
}

/// The kinetic energy of the body on top only.
fn upper_body(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(upper) = rubbing_mass(law) else { return Vec::new() };
    let of_upper = |side: &Expr| Expr::sum(terms(side).into_iter().filter(|term| term.contains(upper)));
    law.both(of_upper)
}

/// Friction takes all the kinetic energy of the body on top.
fn lower_fixed(law: &Taught<'_>) -> Vec<Wrong> {
    let upper = upper_body(law).into_iter().flat_map(|wrong| wrong.equations);
    upper.map(|(start, _)| Wrong::from((start, Expr::zero()))).collect()
}

/// Work and energy of one body, for its distance over the ground: friction takes energy from the body on top and gives it to the other.
fn over_ground(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(upper) = rubbing_mass(law) else { return Vec::new() };
    let of_lower = |term: Expr| match (rubs(law, &term), term.contains(upper)) {
        (true, _) => Some(-term),
        (false, true) => None,
        (false, false) => Some(term),
    };
    let lower = law.both(|side| Expr::sum(terms(side).into_iter().filter_map(of_lower)));
    [upper_body(law), lower].concat()
}

/// The mass in the term of friction.
fn rubbing_mass(law: &Taught<'_>) -> Option<Symbol> {
    let [left, right] = [&law.sides.0, &law.sides.1].map(terms);
    let friction = left.into_iter().chain(right).find(|term| rubs(law, term))?;
    friction.symbols().into_iter().find(|symbol| law.is(*symbol, Dimension::MASS))
}

fn weight_work_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.without(&|term| is_weight(law, term))
}

fn weight_work(law: &Taught<'_>, side: &Expr) -> Expr {
    let parts = terms(side);
    Expr::sum(parts.into_iter().map(|part| if is_weight(law, &part) { -part } else { part }))
}

/// The energy of each spring twice: what has a stiffness, which is an energy over a length squared.
fn spring_doubled(law: &Taught<'_>, side: &Expr) -> Expr {
    let spring = Dimension::new(1, 0, -2);
    let parts = terms(side);
    Expr::sum(parts.into_iter().map(|part| if law.has(&part, spring) { Expr::integer(2) * part } else { part }))
}

/// The deformation of each spring to the first power.
fn spring_unsquared(law: &Taught<'_>, side: &Expr) -> Expr {
    let spring = Dimension::new(1, 0, -2);
    Expr::sum(terms(side).into_iter().map(|part| if law.has(&part, spring) { unsquared(&part) } else { part }))
}

/// The kinetic energy with the mass of one of the bodies that move together, and with all that does work.
fn kinetic_of_one(law: &Taught<'_>) -> Vec<Wrong> {
    let masses = |term: &Expr| {
        factors(term).into_iter().find(|part| matches!(part, Expr::Sum(_)) && law.has(part, Dimension::MASS))
    };
    let moves = |term: &Expr| law.has(term, Dimension::VELOCITY);
    let together =
        [&law.sides.0, &law.sides.1].into_iter().flat_map(terms).filter(moves).find_map(|term| masses(&term));
    let Some(together) = together else { return Vec::new() };
    let alone = |mass: Expr| {
        let swap = |factor: Expr| if factor == together { mass.clone() } else { factor };
        let change = |term: Expr| if moves(&term) { Expr::product(factors(&term).into_iter().map(swap)) } else { term };
        law.both(|side| Expr::sum(terms(side).into_iter().map(change)))
    };
    terms(&together).into_iter().flat_map(alone).collect()
}

/// Of every squared speed the square of one component.
fn one_component(law: &Taught<'_>, place: usize) -> Vec<Wrong> {
    fn within(law: &Taught<'_>, term: &Expr, place: usize) -> Expr {
        let is_square = |part: &Expr| match part {
            Expr::Power(pair) => pair.1 == Expr::integer(2) && law.is_velocity(&pair.0),
            _ => false,
        };
        match term {
            Expr::Sum(parts) if parts.iter().all(is_square) => parts.get(place).unwrap_or(term).clone(),
            other => other.map_children(|part| within(law, part, place)),
        }
    }
    law.both(|side| within(law, side, place))
}

pub(super) fn square(law: &Taught<'_>) -> Vec<Wrong> {
    law.both(unsquared)
}

fn unsquared(term: &Expr) -> Expr {
    match term {
        Expr::Power(pair) if pair.1 == Expr::integer(2) => pair.0.clone(),
        other => other.map_children(unsquared),
    }
}

/// Each kinetic energy twice.
fn kinetic_doubled(law: &Taught<'_>, side: &Expr) -> Expr {
    let is_kinetic = |part: &Expr| law.has(part, Dimension::VELOCITY) && !law.has_gravity(part);
    Expr::sum(terms(side).into_iter().map(|part| if is_kinetic(&part) { Expr::integer(2) * part } else { part }))
}

/// The energy of one body alone, or that of joined bodies with the mass of one.
fn one_body(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.1 {
        Expr::Sum(bodies) => bodies.iter().map(|body| Wrong::from((law.left(), body.clone()))).collect(),
        joined => {
            let parts = factors(joined);
            let masses = parts.iter().find(|part| matches!(part, Expr::Sum(_)) && law.has(part, Dimension::MASS));
            let Some(together) = masses else { return Vec::new() };
            let others = Expr::product(parts.iter().filter(|part| *part != together).cloned());
            terms(together).into_iter().map(|mass| Wrong::from((law.left(), mass * others.clone()))).collect()
        }
    }
}

fn remainder(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.1)[..] {
        [_, after] => one((law.left(), -after.clone())),
        _ => Vec::new(),
    }
}

/// A share of all the energy before, or of that of one body.
fn share(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some(e), Some(before)) = (law.restitution(), terms(&law.sides.1).into_iter().next()) else {
        return Vec::new();
    };
    let lost = |kept: Expr, energy: &Expr| Wrong::from((law.left(), (Expr::one() - kept) * energy.clone()));
    let bodies = law.beside("kinetic-energy").filter(|(energy, _)| *energy == before).map(|(_, bodies)| terms(bodies));
    let bodies = bodies.filter(|bodies| bodies.len() > 1).flatten();
    let of_one: Vec<Wrong> = bodies.map(|body| lost(e.clone().powi(2), &body)).collect();
    [vec![lost(e.clone().powi(2), &before), lost(e, &before)], of_one].concat()
}

/// Body by body, where each keeps its mass.
pub(super) fn difference(law: &Taught<'_>) -> Vec<Wrong> {
    let energy = |sought: &Expr| {
        let symbol = sought.symbols().into_iter().next()?;
        let energies = law.beside("kinetic-energy").find(|sides| sides.0 == Expr::from(symbol))?;
        terms(&energies.1).iter().map(|term| mass_and_speed(law, term)).collect::<Option<Vec<_>>>()
    };
    let both = terms(&law.sides.1);
    let [before, after] = &both[..] else { return Vec::new() };
    let (Some(before), Some(after)) = (energy(before), energy(after)) else { return Vec::new() };
    if before.len() != after.len() || before.iter().zip(&after).any(|(one, other)| one.0 != other.0) {
        return Vec::new();
    }
    let bodies = before.into_iter().zip(after);
    let squares =
        bodies.map(|((mass, start), (_, end))| Expr::product([Expr::ratio(1, 2), mass, (start - end).powi(2)]));
    one((law.left(), Expr::sum(squares)))
}

/// m and v of `m v^2 / 2`.
fn mass_and_speed(law: &Taught<'_>, term: &Expr) -> Option<(Expr, Expr)> {
    let parts = factors(term);
    let mass = parts.iter().filter(|part| law.has(part, Dimension::MASS)).cloned();
    let speed = parts.iter().find_map(|part| match part {
        Expr::Power(pair) if pair.1 == Expr::integer(2) && law.has(&pair.0, Dimension::VELOCITY) => {
            Some(pair.0.clone())
        }
        _ => None,
    })?;
    Some((Expr::product(mass), speed))
}
