//! Mistakes about momentum and impulse.

use crate::Sides;
use momentous_expr::Expr;
use momentous_expr::Function;
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
use super::integral::VALUE_TIMES_TIME;
use super::integral::growth_not_halved;
use super::rewrite::all_but_one;
use super::rewrite::factors;
use super::rewrite::gain_reversed;
use super::rewrite::one;
use super::rewrite::sign_lost;
use super::rewrite::sine_and_cosine;
use super::rewrite::start_forgotten;
use super::rewrite::terms;
use super::rewrite::whole;

/// Speeds for velocities.
pub const SIGN_LOST: Misconception = Misconception {
    id: "sign-lost",
    does: "uses a speed where a velocity belongs",
    ask: "Which of the velocities point against the positive axis, and what does that do to their signs?",
    hint: "Draw the axis, and write each velocity with the sign that its direction gives it.",
};
/// `J = m v_2`.
pub const START_FORGOTTEN: Misconception = Misconception {
    id: "start-momentum-forgotten",
    does: "leaves out the momentum that the body had at the start",
    ask: "An impulse changes momentum: from which momentum to which?",
    hint: "Did the body have momentum before? The impulse is the difference of the two.",
};
/// `m v_1 + J = 0`.
pub const END_FORGOTTEN: Misconception = Misconception {
    id: "end-momentum-forgotten",
    does: "leaves out the momentum that the body has at the end",
    ask: "An impulse changes momentum: from which momentum to which?",
    hint: "Does the body still move afterwards? The impulse is the difference of the two momenta.",
};
/// The mass of another body.
pub const OTHER_MASS: Misconception = Misconception {
    id: "mass-of-another-body",
    does: "uses the mass of another body",
    ask: "Whose momentum changes here, and what is the mass of this body?",
    hint: "The mass, the velocities and the impulse in one equation all belong to the same body.",
};
/// A force that opposes the motion counted as one that helps it.
pub const IMPULSE_REVERSED: Misconception = Misconception {
    id: "impulse-reversed",
    does: "takes the impulses in the opposite direction",
    ask: "In which direction does each force act, and does it make the momentum along the axis larger or smaller?",
    hint: "Impulse is the momentum after minus the momentum before, in that order, with their signs.",
};
/// Weight left out beside other forces.
pub const WEIGHT_FORGOTTEN: Misconception = Misconception {
    id: "weight-forgotten",
    does: "leaves out the impulse of weight",
    ask: "Draw every force that acts on the body in this time. Is one missing from your sum?",
    hint: "Gravity acts all the time, and over this time its impulse is not small.",
};
/// Gravity that speeds a rising body up.
pub const GRAVITY_REVERSED: Misconception = Misconception {
    id: "gravity-reversed",
    does: "takes gravity in the opposite direction",
    ask: "Which way does the axis point, and which way does gravity?",
    hint: "Give the velocity and gravity their signs along the same axis.",
};
/// The weight of the lower body, or of both, for that of the upper one.
pub const OTHER_WEIGHT: Misconception = Misconception {
    id: "friction-of-the-other-body",
    does: "takes the weight of the lower body, or of both, for the normal force between them",
    ask: "Which body presses on the surface where the two rub, and with what weight?",
    hint: "The normal force between the bodies carries the body on top, and nothing else.",
};
/// Only one body of a system counted before.
pub const PARTNER_FORGOTTEN: Misconception = Misconception {
    id: "partner-forgotten",
    does: "leaves the momentum of one body out of the sum",
    ask: "Which bodies belong to the system, and which of them move before, which afterwards?",
    hint: "Every body that moves carries momentum: count the terms on both sides.",
};
/// `m v^2` in place of `m v`.
pub const ENERGY_CONSERVED: Misconception = Misconception {
    id: "energy-for-momentum",
    does: "conserves kinetic energy through an impact in which it is lost",
    ask: "Which quantity stays the same when bodies meet: momentum, or kinetic energy?",
    hint: "Where bodies stay together, or one goes through the other, kinetic energy is lost; what is conserved follows from the impulses.",
};
/// `m v^2 / 2` in place of `m v`, in the balance of one body.
pub const ENERGY_FOR_IMPULSE: Misconception = Misconception {
    id: "energy-for-impulse",
    does: "takes the change of kinetic energy for the impulse",
    ask: "Does an impulse change momentum, or kinetic energy? Which power of the velocity stands in it?",
    hint: "Momentum is mass times velocity, without a factor of one half; check the units of your answer.",
};
/// The common body with the mass of one part.
pub const JOINT_MASS: Misconception = Misconception {
    id: "joint-mass-forgotten",
    does: "uses the mass of only one body for the joined bodies",
    ask: "What moves after the bodies have joined, and what is its mass?",
    hint: "After they have joined, both masses move with the common velocity.",
};
/// The mass of one body for that of the system.
pub const ONE_MASS: Misconception = Misconception {
    id: "one-mass-for-system",
    does: "uses the mass of one body instead of that of the system",
    ask: "Which bodies change their velocity together, and what is their mass?",
    hint: "An external impulse changes the momentum of the whole system.",
};
/// The mean of two velocities.
pub const PLAIN_MEAN: Misconception = Misconception {
    id: "velocities-averaged",
    does: "adds velocities where momenta belong, or takes their plain average",
    ask: "Does a heavy body count more than a light one for the common velocity?",
    hint: "Write momentum, mass times velocity, for each body; velocities alone do not add.",
};
/// Action and reaction of the same sign.
pub const SAME_SIGN: Misconception = Misconception {
    id: "reaction-same-direction",
    does: "gives action and reaction the same direction",
    ask: "The two bodies push each other: in which direction is each pushed?",
    hint: "Action and reaction are opposite, so along one axis they have opposite signs.",
};
/// The heavier body hits harder.
pub const HEAVIER_HARDER: Misconception = Misconception {
    id: "heavier-hits-harder",
    does: "makes the two impulses of an impact unequal, the one on the heavier body larger",
    ask: "Compare the forces that the two bodies exert on each other at each moment of contact. Is one of them larger?",
    hint: "Do the masses appear in Newton's third law?",
};
/// Restitution along the surface as well.
pub const WHOLE_VELOCITY: Misconception = Misconception {
    id: "restitution-on-whole-velocity",
    does: "applies the coefficient of restitution to the component along the surface too",
    ask: "In which direction does a smooth contact push, and which component of the velocity can it change?",
    hint: "Restitution concerns the line of impact only; across it, a smooth contact exerts no impulse.",
};

/// Pounds of weight as pounds of mass.
pub const WEIGHT_AS_MASS: Misconception = Misconception {
    id: "weight-as-mass",
    does: "uses a weight as a mass",
    ask: "Is a weight or a mass given? Which of the two enters the momentum?",
    hint: "A weight is a force; the mass is the weight divided by the acceleration of free fall.",
};
/// Weight beside an impact.
pub const WEIGHT_IN_IMPACT: Misconception = Misconception {
    id: "weight-in-impact",
    does: "includes the impulse of weight during an impact",
    ask: "How large is the impulse of weight during the contact, compared with that of the impact?",
    hint: "A force that is not impulsive has a negligible impulse in so short a time: weight is neglected.",
};

/// Wrong forms of momentum.
pub const MOMENTUM: &[WrongForm] =
    &[WrongForm { of: &SIGN_LOST, write: sign_lost }, WrongForm { of: &ENERGY_FOR_IMPULSE, write: energy_for_impulse }];
/// Wrong forms of conservation.
pub const CONSERVATION: &[WrongForm] = &[
    WrongForm { of: &SIGN_LOST, write: sign_lost },
    WrongForm { of: &ENERGY_CONSERVED, write: energy_conserved },
    WrongForm { of: &JOINT_MASS, write: joint_mass },
    WrongForm { of: &PLAIN_MEAN, write: plain_mean },
    WrongForm { of: &super::joint::RATIO_INVERTED, write: super::joint::ratio_inverted },
    WrongForm { of: &PARTNER_FORGOTTEN, write: partner_forgotten },
    WrongForm { of: &super::geometry::SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &super::geometry::WHOLE, write: whole },
];
/// Wrong forms of impulse and momentum.
pub const IMPULSE_MOMENTUM: &[WrongForm] = &[
    WrongForm { of: &SIGN_LOST, write: sign_lost },
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &VALUE_TIMES_TIME, write: growth_not_halved },
    WrongForm { of: &END_FORGOTTEN, write: end_forgotten },
    WrongForm { of: &OTHER_MASS, write: other_mass },
    WrongForm { of: &OTHER_WEIGHT, write: friction_of_other },
    WrongForm { of: &ENERGY_FOR_IMPULSE, write: energy_for_impulse },
    WrongForm { of: &WEIGHT_AS_MASS, write: weight_moves },
    WrongForm { of: &IMPULSE_REVERSED, write: gain_reversed },
    WrongForm { of: &WEIGHT_FORGOTTEN, write: weight_forgotten },
    WrongForm { of: &GRAVITY_REVERSED, write: weight_reversed },
    WrongForm { of: &WEIGHT_IN_IMPACT, write: weight_in_impact },
    WrongForm { of: &super::joint::AT_REST, write: super::joint::in_balance },
    WrongForm { of: &FRICTION_FORGOTTEN, write: friction_forgotten },
    WrongForm { of: &FRICTION_REVERSED, write: friction_reversed },
    WrongForm { of: &FRICTION_COEFFICIENT, write: friction_whole },
    WrongForm { of: &ONE_MASS, write: one_of_several },
    WrongForm { of: &super::geometry::SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &super::geometry::WHOLE, write: whole },
];
/// Wrong forms of impulse and momentum of a system.
pub const SYSTEM: &[WrongForm] = &[
    WrongForm { of: &SIGN_LOST, write: sign_lost },
    WrongForm { of: &ONE_MASS, write: one_of_several },
    WrongForm { of: &super::geometry::SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &super::geometry::WHOLE, write: whole },
];
/// Wrong forms of the third law.
pub const THIRD_LAW: &[WrongForm] =
    &[WrongForm { of: &SAME_SIGN, write: same_sign }, WrongForm { of: &HEAVIER_HARDER, write: heavier_harder }];
/// Wrong forms of what a smooth contact leaves as it is.
pub const NO_IMPULSE: &[WrongForm] = &[WrongForm { of: &WHOLE_VELOCITY, write: whole_velocity }];

/// `m v_1 + J = 0`.
fn end_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let moves = law.has(&law.sides.1, Dimension::VELOCITY);
    if moves { one((law.left(), Expr::zero())) } else { Vec::new() }
}

/// The mass of another body throughout.
fn other_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let beside = law.beside("impulse-momentum").flat_map(|(_, end)| end.symbols());
    let others: Vec<Symbol> = beside.filter(|symbol| law.is(*symbol, Dimension::MASS)).collect();
    match law.quantities(Dimension::MASS)[..] {
        [_] => law.of_other_mass(&others, &|_| true),
        _ => Vec::new(),
    }
}

/// The weight of another body where friction stands.
fn friction_of_other(law: &Taught<'_>) -> Vec<Wrong> {
    let others = law.quantities(Dimension::MASS);
    law.of_other_mass(&others, &|term| {
        rubs(law, term) && !factors(term).iter().any(|part| matches!(part, Expr::Sum(_)))
    })
}

/// Weight that acts upwards.
fn weight_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    let is_weight = |term: &Expr| is_impulse_of_gravity(law, term) && !rubs(law, term);
    let reversed =
        |side: &Expr| Expr::sum(terms(side).into_iter().map(|term| if is_weight(&term) { -term } else { term }));
    law.both(reversed)
}

fn is_impulse_of_gravity(law: &Taught<'_>, term: &Expr) -> bool {
    law.has_gravity(term) && !law.has(term, Dimension::VELOCITY)
}

/// `m_A v_A1^2 + m_B v_B1^2 = (m_A + m_B) v^2`, where no coefficient says what is lost.
fn energy_conserved(law: &Taught<'_>) -> Vec<Wrong> {
    if law.restitution().is_some() {
        return Vec::new();
    }
    law.replaced(&|symbol| law.is(symbol, Dimension::VELOCITY).then(|| Expr::from(symbol).powi(2)))
}

/// `m v_1^2 / 2 + J = m v_2^2 / 2`, each with the sign of the velocity.
fn energy_for_impulse(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| {
        let size = || Expr::apply(Function::Abs, symbol.into());
        law.is(symbol, Dimension::VELOCITY).then(|| Expr::product([Expr::ratio(1, 2), symbol.into(), size()]))
    })
}

/// The weight stands for the mass where the weight itself is right.
fn weight_moves(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(gravity) = law.symbols.find("g").filter(|_| law.has_gravity(&law.sides.0)) else { return Vec::new() };
    let weight = Expr::from(gravity) / law.unit_acceleration.clone();
    let weighed = |term: Expr| if law.has(&term, Dimension::VELOCITY) { weight.clone() * term } else { term };
    law.both(|side| Expr::sum(terms(side).into_iter().map(weighed)))
}

fn joint_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    let [Expr::Sum(masses), velocity] = &parts[..] else { return Vec::new() };
    masses.iter().map(|mass| Wrong::from((law.left(), mass.clone() * velocity.clone()))).collect()
}

/// `v = (v_A1 + v_B1) / 2`, and `v = v_A1 + v_B1`.
fn plain_mean(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    let [Expr::Sum(masses), velocity] = &parts[..] else { return Vec::new() };
    let velocities: Vec<Expr> = law
        .sides
        .0
        .symbols()
        .into_iter()
        .filter(|symbol| law.is(*symbol, Dimension::VELOCITY))
        .map(Expr::from)
        .collect();
    let sum = Wrong::from((Expr::sum(velocities.iter().cloned()), velocity.clone()));
    if velocities.len() != masses.len() {
        return vec![sum];
    }
    let count = Expr::integer(i64::try_from(masses.len()).unwrap_or(2));
    vec![Wrong::from((Expr::sum(velocities), count * velocity.clone())), sum]
}

/// One body of several left out before, or one of several afterwards.
fn partner_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let [before, after] = [all_but_one(&law.sides.0), all_but_one(&law.sides.1)];
    let before = before.into_iter().map(|kept| Wrong::from((kept, law.right())));
    before.chain(after.into_iter().map(|kept| Wrong::from((law.left(), kept)))).collect()
}

/// What external impulses do to several bodies, with the terms of one of them only.
fn one_of_several(law: &Taught<'_>) -> Vec<Wrong> {
    let masses = |term: &Expr| -> Vec<Symbol> {
        term.symbols().into_iter().filter(|symbol| law.is(*symbol, Dimension::MASS)).collect()
    };
    let bodies = terms(&law.sides.1);
    let is_momentum = |term: &Expr| law.has(term, Dimension::VELOCITY) && !masses(term).is_empty();
    if bodies.len() < 2 || terms(&law.sides.0).iter().all(is_momentum) {
        return Vec::new();
    }
    let alone = bodies.iter().flat_map(|body| {
        let masses_of_body = masses(body);
        let is_other = |term: &Expr| {
            let of = masses(term);
            let is_single = !factors(term).iter().any(|factor| matches!(factor, Expr::Sum(_)));
            is_single && !of.is_empty() && !of.iter().any(|mass| masses_of_body.contains(mass))
        };
        // Without the forces on the others, and with all forces.
        [law.without(&is_other), law.without(&|term| is_momentum(term) && is_other(term))].concat()
    });
    alone.collect()
}

fn weight_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let all = law.without(&|term| is_impulse_of_gravity(law, term));
    let but_friction = law.without(&|term| is_impulse_of_gravity(law, term) && !rubs(law, term));
    all.into_iter().chain(but_friction).collect()
}

/// `m v_1 + J - m g dt = m v_2`, or with the other sign, where the duration of an impact is told and gravity spoken of.
fn weight_in_impact(law: &Taught<'_>) -> Vec<Wrong> {
    let mean = law.beside("mean-force").next().map(|sides| factors(&sides.1));
    let Some([_, time]) = mean.as_deref() else { return Vec::new() };
    let Some(weight) = impulse_of_weight(law, law.sides, time) else { return Vec::new() };
    let counted = |weight: Expr| Wrong::from((law.left() + weight, law.right()));
    vec![counted(-weight.clone()), counted(weight)]
}

/// What weight would add in that time to a balance of momentum in which it has no part.
pub(super) fn impulse_of_weight(law: &Taught<'_>, balance: &Sides, time: &Expr) -> Option<Expr> {
    let gravity = law.symbols.find("g").filter(|_| !law.has_gravity(&balance.0))?;
    let speeds = [&balance.0, &balance.1].into_iter().flat_map(Expr::symbols);
    let mut speeds = speeds.filter(|speed| law.symbols.entry(*speed).dimension == Dimension::VELOCITY);
    let level = speeds.any(|speed| law.symbols.entry(speed).name.rsplit_once('.').is_some_and(|(_, axis)| axis == "x"));
    let [mass, _] = &factors(&balance.1)[..] else { return None };
    (!level).then(|| Expr::product([mass.clone(), gravity.into(), time.clone()]))
}

fn same_sign(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), -law.right()))
}

/// `J_B / m_B = -J_A / m_A`.
fn heavier_harder(law: &Taught<'_>) -> Vec<Wrong> {
    let mass = |impulse: &Expr| {
        let symbol = impulse.symbols().into_iter().next()?;
        let law_of_impulse = law.beside("impulse-momentum").find(|sides| sides.0.contains(symbol))?;
        factors(&law_of_impulse.1).into_iter().next()
    };
    match (mass(&law.sides.0), mass(&law.sides.1)) {
        (Some(first), Some(second)) => one((law.left() * second, law.right() * first)),
        _ => Vec::new(),
    }
}

fn whole_velocity(law: &Taught<'_>) -> Vec<Wrong> {
    law.restitution().map(|e| Wrong::from((law.left(), e * law.right()))).into_iter().collect()
}
