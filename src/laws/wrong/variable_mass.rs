//! Mistakes about streams and rockets.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::momentum::IMPULSE_REVERSED;
use super::momentum::SIGN_LOST;
use super::momentum::START_FORGOTTEN;
use super::momentum::WEIGHT_AS_MASS;
use super::momentum::WEIGHT_FORGOTTEN;
use super::rewrite::factors;
use super::rewrite::gain_reversed;
use super::rewrite::one;
use super::rewrite::sign_lost;
use super::rewrite::start_forgotten;
use super::rewrite::terms;
use super::stream;

/// What leaves a vane counted like what comes.
pub const LEAVING_ADDED: Misconception = Misconception {
    id: "leaving-stream-added",
    does: "gives the momentum that leaves with the stream the wrong sign",
    ask: "Where does the stream go when it leaves the body, forwards or backwards?",
    hint: "The force comes from the change: the velocity before minus the velocity after, each with its sign.",
};
/// What leaves a vane left out.
pub const LEAVING_FORGOTTEN: Misconception = Misconception {
    id: "leaving-stream-forgotten",
    does: "leaves out the momentum that the stream has when it leaves",
    ask: "Does the stream have any momentum when it leaves the body?",
    hint: "Only a stream that spreads at right angles, or stays, leaves with no momentum along its old direction.",
};
/// The speed over the ground on a moving body.
pub const BODY_SPEED: Misconception = Misconception {
    id: "speed-of-body-forgotten",
    does: "uses the speed of the stream relative to the ground, although the body moves",
    ask: "How fast does the stream move relative to the body?",
    hint: "Subtract the speed of the body from that of the stream, both in the mass flow and in the change of velocity.",
};
/// A stream taken to come back.
pub const RETURNED: Misconception = Misconception {
    id: "stream-taken-to-return",
    does: "assumes that the stream comes straight back, although it does not",
    ask: "Where does the stream go after it has met the body?",
    hint: "A stream that comes straight back exerts twice the force of one that spreads sideways, or stays.",
};
/// `q v / 2` for `q v`.
pub const STREAM_ENERGY: Misconception = Misconception {
    id: "energy-for-momentum-of-stream",
    does: "calculates the force from the kinetic energy that the stream gains or loses",
    ask: "Does all the work of the force become kinetic energy of the stream, or is some of it lost as the stream is slowed or dragged along?",
    hint: "Use momentum: the force is the mass flow times the change of velocity, without a factor of one half.",
};
/// `q g` for `q v`.
pub const STREAM_WEIGHT: Misconception = Misconception {
    id: "weight-for-momentum-of-stream",
    does: "multiplies the mass flow by the acceleration of free fall",
    ask: "Is the force of the stream its weight, or does it come from a change of velocity?",
    hint: "The force is the mass flow times the change of velocity; weight has no part in it.",
};
/// The mass taken to stay.
pub const MASS_KEPT: Misconception = Misconception {
    id: "rocket-mass-kept",
    does: "divides the momentum of the exhaust by the mass at the start or at the end, as if the mass stayed the same",
    ask: "Does the thrust move the same mass at the end of the burn as at its start?",
    hint: "The rocket becomes lighter all the time: the small gains in velocity add up to a logarithm.",
};
/// The mass that was burnt in the place of the mass that is left.
pub const BURNT_FOR_LEFT: Misconception = Misconception {
    id: "burnt-mass-for-the-rest",
    does: "divides by the mass that was thrown away in place of the mass that is left",
    ask: "Which two masses does the rocket have, before the burn and after it?",
    hint: "The mass after the burn is the mass before it less what was thrown away.",
};
/// A logarithm to the base of ten.
pub const BASE_TEN: Misconception = Misconception {
    id: "logarithm-to-base-ten",
    does: "uses the logarithm to base ten",
    ask: "Which logarithm results from integrating one over the mass?",
    hint: "The integral of one over the mass is the natural logarithm of the mass.",
};
/// The mass taken to stay what it was, although some joins or leaves.
pub const CHANGE_FORGOTTEN: Misconception = Misconception {
    id: "change-of-mass-forgotten",
    does: "takes the mass to stay what it is at the start, or at the end",
    ask: "Is the mass that moves at the end the same as that at the start?",
    hint: "Mass joins the body or leaves it all the time: write the mass at the end by the flow and the time.",
};
/// `m_1 v_1^2 = m_2 v_2^2` for a body that is loaded.
pub const LOAD_BY_ENERGY: Misconception = Misconception {
    id: "energy-for-momentum-of-load",
    does: "conserves kinetic energy while mass joins the body and is dragged along",
    ask: "What happens to each grain when it meets the body: does it bounce off, or is it dragged along?",
    hint: "Each grain that joins the body makes a small plastic impact: momentum is conserved in it, and kinetic energy is lost.",
};
/// `m_1 v_1 + F dt = m_2 v_2` for a body that leaks.
pub const LEAK_AS_THRUST: Misconception = Misconception {
    id: "leak-as-thrust",
    does: "leaves out the momentum that the lost mass carries away, as if what leaves pushed the body on",
    ask: "Which velocity does the mass have at the moment it leaves, and which momentum does it carry away?",
    hint: "Only what is thrown relative to the body pushes it. What merely falls out keeps the velocity that it has.",
};
/// The momentum that arriving mass needs left out.
pub const DRAGGED_FORGOTTEN: Misconception = Misconception {
    id: "arriving-mass-forgotten",
    does: "leaves out the force that it takes to bring the arriving mass to the velocity of the body",
    ask: "Which velocity does the mass have before it joins the body, and which afterwards?",
    hint: "In each unit of time the arriving mass gains momentum, and the body has to give it.",
};

/// Wrong forms of the force of a stream.
pub const STREAM: &[WrongForm] = &[
    WrongForm { of: &LEAVING_ADDED, write: |law| law.both(|side| leaving(side, &|part| -part)) },
    WrongForm { of: &LEAVING_FORGOTTEN, write: |law| law.both(|side| leaving(side, &|_| Expr::zero())) },
    WrongForm { of: &BODY_SPEED, write: body_at_rest },
    WrongForm { of: &RETURNED, write: returned },
    WrongForm { of: &STREAM_ENERGY, write: stream_energy },
    WrongForm { of: &STREAM_WEIGHT, write: stream_weight },
];
/// Wrong forms of what arrives.
pub const FLOW: &[WrongForm] = &[
    WrongForm { of: &BODY_SPEED, write: body_at_rest },
    WrongForm { of: &stream::FLOW_BY_SQUARE, write: stream::flow_by_square },
    WrongForm { of: &stream::FLOW_OF_WEIGHT, write: stream::flow_of_weight },
    WrongForm { of: &stream::SINGLE_VANE, write: stream::single_vane },
];
/// Wrong forms of the power of a force.
pub const POWER: &[WrongForm] = &[
    WrongForm { of: &stream::OTHER_SPEED, write: stream::power_with_other_speed },
    WrongForm { of: &stream::POWER_OF_JET, write: stream::power_of_jet },
];
/// Wrong forms of the way during a burn.
pub const BURN_WAY: &[WrongForm] = &[WrongForm { of: &stream::EVEN_GAIN, write: stream::even_gain }];
/// Wrong forms of what a support carries.
pub const SUPPORT: &[WrongForm] = &[
    WrongForm { of: &WEIGHT_FORGOTTEN, write: |law| law.without(&|term| law.has_gravity(term)) },
    WrongForm { of: &WEIGHT_AS_MASS, write: weight_as_mass },
    WrongForm { of: &stream::STREAM_REVERSED, write: stream::stream_reversed },
];
/// Wrong forms of the rocket equation.
pub const ROCKET: &[WrongForm] = &[
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &WEIGHT_FORGOTTEN, write: |law| law.without(&|term| law.has_gravity(term)) },
    WrongForm { of: &MASS_KEPT, write: mass_kept },
    WrongForm { of: &BURNT_FOR_LEFT, write: burnt_for_left },
    WrongForm { of: &BASE_TEN, write: |law| law.both(|side| logarithm(side, &to_base_ten)) },
    WrongForm { of: &IMPULSE_REVERSED, write: |law| law.both(|side| logarithm(side, &reversed)) },
    WrongForm { of: &stream::LOGARITHM_FORGOTTEN, write: stream::logarithm_forgotten },
    WrongForm { of: &stream::OTHER_EXHAUST, write: stream::other_exhaust },
];
/// Wrong forms of the acceleration under thrust.
pub const ACCELERATION: &[WrongForm] = &[WrongForm { of: &WEIGHT_FORGOTTEN, write: thrust_alone }];
/// Wrong forms of the condition of lift-off.
pub const LIFT_OFF: &[WrongForm] = &[WrongForm { of: &WEIGHT_AS_MASS, write: weight_as_mass }];
/// Wrong forms of impulse and momentum of a body that gains mass.
pub const GAINING: &[WrongForm] = &[
    WrongForm { of: &CHANGE_FORGOTTEN, write: first_mass_kept },
    WrongForm { of: &stream::MEAN_MASS, write: stream::mean_mass },
    WrongForm { of: &LOAD_BY_ENERGY, write: load_by_energy },
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &SIGN_LOST, write: sign_lost },
    WrongForm { of: &IMPULSE_REVERSED, write: gain_reversed },
];
/// Wrong forms of the velocity of a body that loses mass.
pub const LOSING: &[WrongForm] = &[
    WrongForm { of: &CHANGE_FORGOTTEN, write: mass_kept },
    WrongForm { of: &LEAK_AS_THRUST, write: leak_as_thrust },
    WrongForm { of: &BASE_TEN, write: |law| law.both(|side| logarithm(side, &to_base_ten)) },
];
/// Wrong forms of the acceleration of a body whose mass changes.
pub const CHANGING: &[WrongForm] = &[WrongForm { of: &DRAGGED_FORGOTTEN, write: arriving_forgotten }];

/// The thrust in place of the net force.
fn thrust_alone(law: &Taught<'_>) -> Vec<Wrong> {
    let Some((_, all)) = law.beside("sum-of-forces").find(|sides| sides.0 == law.sides.0) else { return Vec::new() };
    let rest: Vec<Expr> = terms(all).into_iter().filter(|term| !law.has_gravity(term)).collect();
    if rest.len() == terms(all).len() { Vec::new() } else { one((Expr::sum(rest), law.right())) }
}

/// The term with a sine or a cosine beside a number, changed: `1 - cos(theta)`.
fn leaving(term: &Expr, change: &dyn Fn(Expr) -> Expr) -> Expr {
    match term {
        Expr::Sum(parts) if parts.iter().any(|part| part.as_number().is_some()) => {
            let changed = parts.iter().map(|part| match part.as_number() {
                Some(_) => part.clone(),
                None => change(part.clone()),
            });
            Expr::sum(changed)
        }
        other => other.map_children(|part| leaving(part, change)),
    }
}

/// Twice the force of a stream that does not come back; of one that is turned by an angle, as if that were half a turn.
fn returned(law: &Taught<'_>) -> Vec<Wrong> {
    let back = leaving(&law.sides.1, &|_| Expr::one());
    let right = if law.right() == back { law.right() * Expr::integer(2) } else { back };
    one((law.left(), right))
}

/// `q v^2 / 2` in numbers, as well as `q v / 2`; and `q v^2`.
fn stream_energy(law: &Taught<'_>) -> Vec<Wrong> {
    let velocity = |symbol| law.is(symbol, Dimension::VELOCITY);
    let squared = law.right().substitute(&|symbol| velocity(symbol).then(|| Expr::from(symbol).powi(2)));
    let half = Expr::ratio(1, 2);
    let forces = [half.clone() * law.right(), half * squared.clone(), squared];
    forces.into_iter().map(|force| Wrong::from((law.left(), force))).collect()
}

/// `F = q g`.
fn stream_weight(law: &Taught<'_>) -> Vec<Wrong> {
    let is_flow = |symbol: &Symbol| law.is(*symbol, Dimension::new(1, 0, -1));
    let flows = law.sides.1.symbols().into_iter().filter(is_flow);
    let sense = law.right() / Expr::apply(Function::Abs, law.right());
    let weight = |flow: Symbol| Expr::product([sense.clone(), Expr::ratio(981, 100), flow.into()]);
    flows.map(|flow| Wrong::from((law.left(), weight(flow)))).collect()
}

/// The speed of the body, where it is used, as zero.
fn body_at_rest(law: &Taught<'_>) -> Vec<Wrong> {
    let moves = |symbol| law.symbols.entry(symbol).meaning.contains("along the stream");
    law.replaced(&|symbol| (law.is(symbol, Dimension::VELOCITY) && moves(symbol)).then(Expr::zero))
}

fn weight_as_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let gravity = law.symbols.find("g");
    law.replaced(&|symbol| (gravity == Some(symbol)).then(|| law.unit_acceleration.clone()))
}

fn logarithm(term: &Expr, instead: &dyn Fn(&Expr) -> Expr) -> Expr {
    match term {
        Expr::Apply(Function::Ln, parts) => parts.first().map_or_else(|| term.clone(), instead),
        other => other.map_children(|part| logarithm(part, instead)),
    }
}

/// `(m_1 - m_2) / m_1` for the logarithm of `m_1 / m_2`.
fn linear(ratio: &Expr) -> Expr {
    Expr::one() - ratio.clone().powi(-1)
}

/// The mass at the start throughout, or that at the end.
fn mass_kept(law: &Taught<'_>) -> Vec<Wrong> {
    let ways: [&dyn Fn(&Expr) -> Expr; 2] = [&linear, &|ratio| ratio.clone() - Expr::one()];
    ways.into_iter().flat_map(|instead| law.both(|side| logarithm(side, instead))).collect()
}

/// The logarithm of `m_1 / (m_1 - m_2)`.
fn burnt_for_left(law: &Taught<'_>) -> Vec<Wrong> {
    let instead = |ratio: &Expr| Expr::apply(Function::Ln, (Expr::one() - ratio.clone().powi(-1)).powi(-1));
    law.both(|side| logarithm(side, &instead))
}

/// The logarithm with the other sign.
fn reversed(ratio: &Expr) -> Expr {
    -Expr::apply(Function::Ln, ratio.clone())
}

fn to_base_ten(ratio: &Expr) -> Expr {
    let natural = |term: Expr| Expr::apply(Function::Ln, term);
    natural(ratio.clone()) / natural(Expr::integer(10))
}

/// `m_1 v_1 + J = m_1 v_2`.
fn first_mass_kept(law: &Taught<'_>) -> Vec<Wrong> {
    let started = terms(&law.sides.0).into_iter().next().unwrap_or_else(Expr::zero);
    let [before, after] =
        [&started, &law.sides.1].map(|momentum| factors(momentum).into_iter().find(|factor| law.is_velocity(factor)));
    let (Some(before), Some(after)) = (before, after) else { return Vec::new() };
    let masses = factors(&started).into_iter().filter(|factor| *factor != before);
    one((law.left(), Expr::product(masses.chain([after]))))
}

/// `m_1 v_1^2 = m_2 v_2^2`, where nothing else acts.
fn load_by_energy(law: &Taught<'_>) -> Vec<Wrong> {
    if terms(&law.sides.0).len() > 1 {
        return Vec::new();
    }
    law.replaced(&|symbol| law.is(symbol, Dimension::VELOCITY).then(|| Expr::from(symbol).powi(2)))
}

/// `v_2 - r v_1 = F/q (r - 1)` with the ratio r of the masses: the momentum of what is left, with nothing carried away.
fn leak_as_thrust(law: &Taught<'_>) -> Vec<Wrong> {
    let is_mass = |term: &Expr| matches!(term, Expr::Symbol(symbol) if law.is(*symbol, Dimension::MASS));
    let Some((after, left)) = law.beside("mass-thrown-away").find(|sides| is_mass(&sides.0)) else {
        return Vec::new();
    };
    let before = Expr::sum(terms(left).into_iter().filter(|term| !term.begins_with_minus()));
    let ratio = before / after.clone();
    let carried = |part: Expr| if part.begins_with_minus() { ratio.clone() * part } else { part };
    let left = Expr::sum(terms(&law.sides.0).into_iter().map(carried));
    // Without a force, the law says that the velocity stays.
    let right = if law.is_velocity(&law.sides.1) {
        ratio * law.right()
    } else {
        logarithm(&law.sides.1, &|_| ratio.clone() - Expr::one())
    };
    one((left, right))
}

/// The forces alone on the right side.
fn arriving_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let forces = |term: &Expr| !matches!(term, Expr::Symbol(_));
    if terms(&law.sides.1).len() > 1 { law.without(&forces) } else { Vec::new() }
}
