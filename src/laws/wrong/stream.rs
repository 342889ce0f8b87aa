//! Mistakes about what a stream carries and does: its mass flow, its power, and the masses that a rocket or a wagon has on its way.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::terms;

/// `rho A v^2`.
pub const FLOW_BY_SQUARE: Misconception = Misconception {
    id: "flow-by-the-square-of-the-speed",
    does: "squares the speed in a mass flow",
    ask: "How long is the piece of the stream that arrives in one second?",
    hint: "In one second a piece as long as the speed arrives: density times cross-section times speed.",
};
/// `rho A v g`.
pub const FLOW_OF_WEIGHT: Misconception = Misconception {
    id: "weight-flow-for-mass-flow",
    does: "multiplies a mass flow by the acceleration of free fall",
    ask: "Is a mass per second asked, or a weight per second?",
    hint: "Check the units: a mass flow is in kilograms per second.",
};
/// `rho A (v - u)` for a wheel.
pub const SINGLE_VANE: Misconception = Misconception {
    id: "single-vane-for-a-wheel",
    does: "counts only what reaches a single vane that moves away, although a wheel has many",
    ask: "Does all of the jet reach the body, or does part of it never catch up?",
    hint: "On a wheel the next bucket takes what the last one leaves: the whole jet is turned.",
};
/// `P = F v` with another speed.
pub const OTHER_SPEED: Misconception = Misconception {
    id: "power-with-another-speed",
    does: "multiplies the force by the speed of the stream to get the power that the body takes up",
    ask: "Which point does the force push, and how fast does that point move?",
    hint: "The power of a force is the force times the velocity of the body on which it acts.",
};
/// `q v^2 / 2`.
pub const POWER_OF_JET: Misconception = Misconception {
    id: "power-of-the-jet",
    does: "gives the kinetic energy that the stream brings per second for the power of the force",
    ask: "Does the stream give all of its kinetic energy to the body? With which speed does it leave?",
    hint: "The stream keeps some of its energy: the power that the body takes up is force times velocity.",
};
/// `u m_1/m_2`.
pub const LOGARITHM_FORGOTTEN: Misconception = Misconception {
    id: "logarithm-forgotten",
    does: "multiplies the exhaust speed by the ratio of the masses, without the logarithm",
    ask: "The mass becomes smaller all the time: what does the sum of all the small gains in velocity give?",
    hint: "The integral of one over the mass is a logarithm.",
};
/// The exhaust speed of another stage.
pub const OTHER_EXHAUST: Misconception = Misconception {
    id: "exhaust-speed-of-another-stage",
    does: "uses the exhaust speed of another stage of the rocket",
    ask: "Which engine burns in this stage, and how fast is its exhaust?",
    hint: "Write down for each burn its own exhaust speed and its own two masses.",
};
/// `(m_1 + m_2)/2`.
pub const MEAN_MASS: Misconception = Misconception {
    id: "mean-mass-at-the-end",
    does: "takes the mean of the masses before and after for the mass that moves at the end",
    ask: "Which mass moves at the end? Does the velocity that is asked belong to the end, or to the middle?",
    hint: "The momentum at the end has the whole mass at the end in it.",
};
/// `x = (v_1 + v_2)/2 t` with a mass that changes.
pub const EVEN_GAIN: Misconception = Misconception {
    id: "constant-acceleration-with-changing-mass",
    does: "calculates the distance as if the acceleration stayed the same, although the mass changes",
    ask: "The force is constant. Is the acceleration constant, too, while the mass changes?",
    hint: "Integrate the velocity, with the mass as it is at each time.",
};
/// The force of a stream added where it must be subtracted.
pub const STREAM_REVERSED: Misconception = Misconception {
    id: "force-of-stream-reversed",
    does: "gives the force of the stream the wrong sign in the balance of a support",
    ask: "Does the stream press the body onto its support, or lift it?",
    hint: "What falls and is stopped presses down, in addition to the weights.",
};

fn is_speed(law: &Taught<'_>, symbol: Symbol) -> bool {
    law.is(symbol, Dimension::VELOCITY)
}

pub(super) fn flow_by_square(law: &Taught<'_>) -> Vec<Wrong> {
    let right = law.right().substitute(&|symbol| is_speed(law, symbol).then(|| Expr::from(symbol).powi(2)));
    if right == law.sides.1 { Vec::new() } else { one((law.left(), right)) }
}

pub(super) fn flow_of_weight(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), Expr::ratio(981, 100) * law.right()))
}

/// The factors of a force that are differences of two velocities.
fn relative_speeds(law: &Taught<'_>) -> Vec<Expr> {
    let forces = law.beside("force-of-a-stream").flat_map(|(_, force)| factors(force));
    let is_difference = |factor: &Expr| matches!(factor, Expr::Sum(parts) if parts.iter().all(|part| part.symbols().iter().all(|symbol| is_speed(law, *symbol)) && !part.symbols().is_empty()));
    let mut all: Vec<Expr> = forces.filter(is_difference).collect();
    all.sort();
    all.dedup();
    all
}

/// The speed relative to the body in the mass flow of a wheel.
pub(super) fn single_vane(law: &Taught<'_>) -> Vec<Wrong> {
    let put = |relative: &Expr| {
        let is_stream = |symbol: Symbol| terms(relative).contains(&Expr::from(symbol));
        let right = law.right().substitute(&|symbol| is_stream(symbol).then(|| relative.clone()));
        (right != law.sides.1).then(|| Wrong::from((law.left(), right)))
    };
    if law.sides.1.symbols().iter().filter(|symbol| is_speed(law, **symbol)).count() == 1 {
        relative_speeds(law).iter().filter_map(put).collect()
    } else {
        Vec::new()
    }
}

/// The speed of the stream, or the relative one, in the power of its force.
pub(super) fn power_with_other_speed(law: &Taught<'_>) -> Vec<Wrong> {
    let right = law.sides.1.symbols();
    let others = relative_speeds(law).into_iter().flat_map(|relative| {
        let positive = terms(&relative).into_iter().filter(|part| !part.begins_with_minus());
        positive.collect::<Vec<_>>().into_iter().chain([relative])
    });
    let mut others: Vec<Expr> = others.collect();
    others.dedup();
    let put = |other: &Expr| {
        let of = |symbol: Symbol| (is_speed(law, symbol) && right.contains(&symbol)).then(|| other.clone());
        law.right().substitute(&of)
    };
    let changed = others.iter().map(put).filter(|changed| *changed != law.sides.1);
    changed.map(|changed| Wrong::from((law.left(), changed))).collect()
}

/// `q v^2 / 2` for the power of the force.
pub(super) fn power_of_jet(law: &Taught<'_>) -> Vec<Wrong> {
    let flow = law.beside("mass-flow").find_map(|(flow, carried)| {
        let speed = carried.symbols().into_iter().find(|symbol| is_speed(law, *symbol))?;
        Some(Expr::product([Expr::ratio(1, 2), flow.clone(), Expr::from(speed).powi(2)]))
    });
    flow.map(|power| Wrong::from((law.left(), power))).into_iter().collect()
}

/// The argument of the logarithm for the logarithm.
pub(super) fn logarithm_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    fn bare(term: &Expr) -> Expr {
        match term {
            Expr::Apply(Function::Ln, parts) => parts.first().cloned().unwrap_or_else(|| term.clone()),
            other => other.map_children(bare),
        }
    }
    law.both(bare)
}

/// The exhaust speed of another burn: the factor of its logarithm.
pub(super) fn other_exhaust(law: &Taught<'_>) -> Vec<Wrong> {
    let exhaust = |side: &Expr| {
        let burnt = terms(side)
            .into_iter()
            .find(|term| factors(term).iter().any(|part| matches!(part, Expr::Apply(Function::Ln, _))))?;
        burnt.symbols().into_iter().find(|symbol| is_speed(law, *symbol))
    };
    let Some(here) = exhaust(&law.sides.1) else { return Vec::new() };
    let alike = |symbol: &Symbol| {
        let meaning = |symbol: Symbol| law.symbols.entry(symbol).meaning.as_str();
        let is_exhaust = meaning(*symbol).contains("exhaust") || meaning(*symbol).contains("gas");
        *symbol != here && is_speed(law, *symbol) && is_exhaust
    };
    let others = law.known.iter().copied().filter(alike);
    others.flat_map(|other| law.replaced(&|symbol| (symbol == here).then(|| other.into()))).collect()
}

/// `(m_1 + m_2) v / 2` for `m_2 v`, the mass before standing beside the first velocity.
pub(super) fn mean_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let masses = |term: &Expr| Expr::product(factors(term).into_iter().filter(|part| !law.is_velocity(part)));
    let moving = |term: &Expr| factors(term).iter().any(|part| law.is_velocity(part));
    let Some(start) = terms(&law.sides.0).into_iter().find(moving) else { return Vec::new() };
    let Some(velocity) = factors(&law.sides.1).into_iter().find(|part| law.is_velocity(part)) else {
        return Vec::new();
    };
    let mean = Expr::ratio(1, 2) * (masses(&start) + masses(&law.sides.1));
    one((law.left(), mean * velocity))
}

/// The displacement as the mean velocity times the time, or that from rest with one of the masses, of a body whose mass changes.
pub(super) fn even_gain(law: &Taught<'_>) -> Vec<Wrong> {
    let balance = law.beside("momentum-with-gained-mass").chain(law.beside("rocket-equation")).next();
    let Some((start, end)) = balance else { return Vec::new() };
    let mut all = start.symbols();
    all.extend(end.symbols());
    let is_end = |symbol: &Symbol| is_speed(law, *symbol) && law.symbols.entry(*symbol).name.starts_with("v_");
    let ends: Vec<Expr> = all.into_iter().filter(is_end).map(Expr::from).collect();
    let time = law.sides.1.symbols().into_iter().find(|symbol| law.is(*symbol, Dimension::TIME));
    let (Some(time), [_, _]) = (time, &ends[..]) else { return Vec::new() };
    one((law.left(), Expr::product([Expr::ratio(1, 2), Expr::sum(ends), time.into()])))
}

/// What is no weight with the other sign.
pub(super) fn stream_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    if !law.has_gravity(&law.sides.1) {
        return Vec::new();
    }
    let turned = |term: Expr| if law.has_gravity(&term) { term } else { -term };
    law.both(|side| Expr::sum(terms(side).into_iter().map(turned)))
        .into_iter()
        .map(|mut wrong| {
            for sides in &mut wrong.equations {
                sides.0 = law.left();
            }
            wrong
        })
        .collect()
}

/// What is thrown away added to the mass, or what is gained subtracted from it.
pub const MASS_CHANGE_REVERSED: Misconception = Misconception {
    id: "mass-change-reversed",
    does: "adds the mass that leaves, or subtracts the mass that arrives",
    ask: "Does the body become heavier or lighter on its way?",
    hint: "The mass at the end is the mass at the start, less what has left or plus what has joined.",
};
/// Wrong forms of the mass that is left.
pub const MASS_LEFT: &[WrongForm] = &[WrongForm { of: &MASS_CHANGE_REVERSED, write: mass_change_reversed }];

fn mass_change_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    let flows = |term: &Expr| factors(term).iter().any(|part| law.has(part, Dimension::new(1, 0, -1)));
    let Expr::Sum(parts) = &law.sides.1 else { return Vec::new() };
    if !parts.iter().any(flows) {
        return Vec::new();
    }
    one((law.left(), Expr::sum(parts.iter().map(|part| if flows(part) { -part.clone() } else { part.clone() }))))
}
