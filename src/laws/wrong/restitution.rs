//! Mistakes about restitution.

use crate::Sides;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::momentum::SIGN_LOST;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::sign_lost;
use super::rewrite::sine_and_cosine;
use super::rewrite::terms;

/// Approach as a share of separation.
pub const INVERTED: Misconception = Misconception {
    id: "restitution-inverted",
    does: "divides by the coefficient of restitution",
    ask: "Which is larger in an impact that loses energy: the speed of approach, or that of separation?",
    hint: "The coefficient of restitution is at most one. Which of the two speeds does it multiply?",
};
/// Velocities in the wrong order.
pub const ORDER: Misconception = Misconception {
    id: "separation-reversed",
    does: "subtracts the velocities of separation in the order of approach",
    ask: "Which body is ahead after the impact, and whose velocity must then be larger?",
    hint: "Approach is first minus second; separation is second minus first.",
};
/// A relative velocity as a sum.
pub const ADDED: Misconception = Misconception {
    id: "relative-velocity-added",
    does: "adds velocities where their difference is the relative one",
    ask: "How fast does one body move as seen from the other?",
    hint: "A relative velocity is a difference of velocities, each with its own sign.",
};
/// e as the ratio of the velocities of one body.
pub const ONE_BODY: Misconception = Misconception {
    id: "restitution-of-one-body",
    does: "gives one body e times a single velocity",
    ask: "Does restitution compare single velocities, or the relative velocities of two bodies?",
    hint: "Only from a fixed wall does a body rebound with e times its own speed.",
};
/// e left out.
pub const ELASTIC: Misconception = Misconception {
    id: "restitution-left-out",
    does: "treats the impact as perfectly elastic",
    ask: "Is the impact elastic? Where does the coefficient of restitution enter?",
    hint: "Bodies separate as fast as they approached only where no energy is lost.",
};
/// Bodies that stay together.
pub const AS_PLASTIC: Misconception = Misconception {
    id: "impact-as-plastic",
    does: "treats the impact as perfectly plastic",
    ask: "Do the bodies stay together after the impact? What does the coefficient of restitution say of that?",
    hint: "Bodies move on together only where the coefficient of restitution is zero.",
};
/// Velocities exchanged, as of equal masses in an elastic impact.
pub const EXCHANGED: Misconception = Misconception {
    id: "velocities-exchanged",
    does: "assumes that the bodies exchange their velocities",
    ask: "Under which two conditions do bodies simply exchange their velocities? Do both hold here?",
    hint: "The masses must be equal, and the impact perfectly elastic.",
};
/// e as a share of energy.
pub const AS_ENERGY: Misconception = Misconception {
    id: "restitution-of-energy",
    does: "mistakes the coefficient of restitution for a ratio of energies",
    ask: "Is the coefficient of restitution a ratio of speeds, or of energies?",
    hint: "Energies are proportional to the squares of speeds; the coefficient compares the speeds themselves.",
};
/// Through the wall.
pub const THROUGH: Misconception = Misconception {
    id: "rebound-sign-lost",
    does: "lets the body continue in its original direction",
    ask: "Which way does the body move along the normal before the impact, and which way after it?",
    hint: "The component along the normal reverses, so its sign changes.",
};
/// A moving surface taken to be at rest.
pub const AT_REST: Misconception = Misconception {
    id: "surface-at-rest",
    does: "takes a moving surface to be at rest",
    ask: "Does the surface itself move? What is the velocity of the body relative to it?",
    hint: "Restitution compares velocities relative to the surface.",
};

/// The body that strikes comes to rest.
pub const STRIKER_STOPS: Misconception = Misconception {
    id: "striker-stops",
    does: "assumes that the striking body comes to rest, although the bodies stay together",
    ask: "If the bodies stay together, can one of them be at rest while the other moves?",
    hint: "Bodies that stay together have the same velocity, and both masses move with it.",
};

/// Wrong forms of a plastic impact.
pub const PLASTIC: &[WrongForm] = &[
    WrongForm { of: &STRIKER_STOPS, write: striker_stops },
    WrongForm { of: &super::inertia::ARM_NOT_SQUARED, write: super::inertia::speed_without_arm },
];
/// Wrong forms of the impulses of the two phases.
pub const PHASES: &[WrongForm] =
    &[WrongForm { of: &INVERTED, write: inverted }, WrongForm { of: &AS_ENERGY, write: as_energy }];
/// Wrong forms for two bodies.
pub const BODIES: &[WrongForm] = &[
    WrongForm { of: &INVERTED, write: inverted },
    WrongForm { of: &ORDER, write: reversed },
    WrongForm { of: &SIGN_LOST, write: sign_lost },
    WrongForm { of: &ADDED, write: added },
    WrongForm { of: &ONE_BODY, write: one_body },
    WrongForm { of: &ELASTIC, write: elastic },
    WrongForm { of: &AS_PLASTIC, write: |law| with_coefficient(law, |_| Expr::zero()) },
    WrongForm { of: &EXCHANGED, write: exchanged },
    WrongForm { of: &AS_ENERGY, write: |law| [as_energy(law), share_of_energy(law)].concat() },
    WrongForm { of: &super::geometry::SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &super::geometry::WHOLE, write: super::rewrite::whole },
];
/// Wrong forms at a surface.
pub const SURFACE: &[WrongForm] = &[
    WrongForm { of: &INVERTED, write: inverted },
    WrongForm { of: &THROUGH, write: reversed },
    WrongForm { of: &ELASTIC, write: |law| [elastic(law), sent_back(law)].concat() },
    WrongForm { of: &AS_ENERGY, write: as_energy },
    WrongForm { of: &AT_REST, write: at_rest },
    WrongForm { of: &ADDED, write: surface_added },
    WrongForm { of: &super::geometry::SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &super::geometry::WHOLE, write: super::rewrite::whole },
];

/// `v_A2 = 0`, where two bodies are used.
fn striker_stops(law: &Taught<'_>) -> Vec<Wrong> {
    match law.quantities(Dimension::VELOCITY).len() {
        2 => one((law.right(), Expr::zero())),
        _ => Vec::new(),
    }
}

/// The sides with the coefficient made something else.
fn with_coefficient(law: &Taught<'_>, change: impl Fn(Expr) -> Expr) -> Vec<Wrong> {
    let Some(e) = law.coefficient(&law.sides.1) else { return Vec::new() };
    law.replaced(&|symbol| (Expr::from(symbol) == e).then(|| change(e.clone())))
}

/// `e` on the side of the separation.
fn inverted(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(e) = law.coefficient(&law.sides.1) else { return Vec::new() };
    let bare = law.right().substitute(&|symbol| (Expr::from(symbol) == e).then(Expr::one));
    one((e * law.left(), bare))
}

fn reversed(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), -law.right()))
}

fn elastic(law: &Taught<'_>) -> Vec<Wrong> {
    with_coefficient(law, |_| Expr::one())
}

/// `v_2 = -v_1` where the surface gives nothing back: both velocities stand in the balance of momentum.
fn sent_back(law: &Taught<'_>) -> Vec<Wrong> {
    if !law.sides.1.is_zero() {
        return Vec::new();
    }
    let after = law.sides.0.symbols();
    let balances = law.beside("impulse-momentum").filter(|(_, end)| !end.symbols().is_disjoint(&after));
    let before = balances.flat_map(|(start, _)| factors(&terms(start)[0])).filter(|part| law.is_velocity(part));
    before.map(|before| Wrong::from((law.left(), -before))).collect()
}

fn as_energy(law: &Taught<'_>) -> Vec<Wrong> {
    with_coefficient(law, Expr::sqrt)
}

/// The velocities after the impact and before it, of the first and of the second body: `[[A2, B2], [A1, B1]]`.
fn velocities(law: &Taught<'_>) -> Option<[[Expr; 2]; 2]> {
    let e = law.coefficient(&law.sides.1)?;
    let approach = law.right().substitute(&|symbol| (Expr::from(symbol) == e).then(Expr::one));
    let pair = |difference: &Expr| match &terms(difference)[..] {
        [first, second] => Some([first.clone(), -second.clone()]),
        _ => None,
    };
    let ([b2, a2], [a1, b1]) = (pair(&law.sides.0)?, pair(&approach)?);
    Some([[a2, b2], [a1, b1]])
}

fn added(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some([[a2, b2], [a1, b1]]), Some(e)) = (velocities(law), law.coefficient(&law.sides.1)) else {
        return Vec::new();
    };
    let sum: Sides = (law.left(), e.clone() * (a1.clone() + b1.clone()));
    vec![sum.into(), (b2.clone() + a2.clone(), law.right()).into(), (b2 + a2, e * (a1 + b1)).into()]
}

fn one_body(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some([[a2, b2], [a1, _]]), Some(e)) = (velocities(law), law.coefficient(&law.sides.1)) else {
        return Vec::new();
    };
    let rebounds = e * a1.clone();
    vec![
        (a2.clone(), -rebounds.clone()).into(),
        (a2.clone(), rebounds.clone()).into(),
        (a2, a1 - rebounds.clone()).into(),
        (b2, rebounds).into(),
    ]
}

/// `v_B2 = sqrt(e) v_A1`: the body that is struck takes a share e of the energy.
fn share_of_energy(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some([[_, b2], [a1, _]]), Some(e)) = (velocities(law), law.coefficient(&law.sides.1)) else {
        return Vec::new();
    };
    one((b2, e.sqrt() * a1))
}

fn exchanged(law: &Taught<'_>) -> Vec<Wrong> {
    let Some([[a2, b2], [a1, b1]]) = velocities(law) else { return Vec::new() };
    vec![Wrong { equations: vec![(a2, b1), (b2, a1)], without: &["conservation-of-momentum"] }]
}

/// The velocities of the surface itself: they stand on both sides, and each of the body's on one.
fn of_surface(law: &Taught<'_>) -> Vec<Symbol> {
    let behind = law.sides.1.symbols();
    let both = law.sides.0.symbols().into_iter().filter(|symbol| behind.contains(symbol));
    both.filter(|symbol| law.is(*symbol, Dimension::VELOCITY)).collect()
}

/// The surface's velocity made something else: in the approach, in the separation, in both.
fn with_surface(law: &Taught<'_>, change: impl Fn(Symbol) -> Expr) -> Vec<Wrong> {
    let surface = of_surface(law);
    if surface.is_empty() {
        return Vec::new();
    }
    let changed = |side: &Expr| side.substitute(&|symbol| surface.contains(&symbol).then(|| change(symbol)));
    let [separation, approach] = [changed(&law.sides.0), changed(&law.sides.1)];
    vec![(law.left(), approach.clone()).into(), (separation.clone(), law.right()).into(), (separation, approach).into()]
}

/// Without the surface's own velocity.
fn at_rest(law: &Taught<'_>) -> Vec<Wrong> {
    with_surface(law, |_| Expr::zero())
}

/// The surface's velocity added where it must be subtracted.
fn surface_added(law: &Taught<'_>) -> Vec<Wrong> {
    with_surface(law, |symbol| -Expr::from(symbol))
}
