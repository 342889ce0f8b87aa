//! Mistakes about energies: speeds where their squares add up, a mass that does not cancel, shares of what is released.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::terms;

/// The mass on one side only.
pub const MASS_ON_ONE_SIDE: Misconception = Misconception {
    id: "mass-on-one-side-only",
    does: "keeps the mass on one side of an equation in which it cancels",
    ask: "In which terms of this equation does the mass of the body stand?",
    hint: "The mass stands in the kinetic energy and in the work of weight and friction: it cancels.",
};
/// `k s = m g`.
pub const STATIC_SPRING: Misconception = Misconception {
    id: "spring-loaded-by-weight",
    does: "lets the weight press the spring, as if the body rested on it",
    ask: "What presses the spring here: a weight at rest, or a body that arrives with a speed?",
    hint: "At the greatest deformation all the kinetic energy is in the spring.",
};
/// `k l^2 / 2` with the length of the spring.
pub const LENGTH_FOR_STRETCH: Misconception = Misconception {
    id: "length-for-deformation",
    does: "uses the whole length of a spring or cord for its extension",
    ask: "How long is the spring when it is slack, and by how much is it longer now?",
    hint: "The energy of a spring has the square of its deformation in it: its length less its natural length.",
};
/// `k (s_1 - s_2)^2 / 2`.
pub const STRETCHES_SUBTRACTED: Misconception = Misconception {
    id: "difference-of-deformations-squared",
    does: "squares the difference of two deformations instead of subtracting their squares",
    ask: "Is the difference of two squares the square of the difference?",
    hint: "Calculate the energy of the spring at both instants, then subtract.",
};
/// `E/2` to each body.
pub const EQUAL_SHARES: Misconception = Misconception {
    id: "energy-shared-equally",
    does: "gives each body half of the energy that is released",
    ask: "Both bodies get momenta of the same size. Which of them gets the larger kinetic energy?",
    hint: "With momenta of the same size, the kinetic energies are as one over the masses.",
};
/// `E m_A / (m_A + m_B)` to body A.
pub const SHARED_BY_MASS: Misconception = Misconception {
    id: "energy-shared-by-mass",
    does: "shares the energy that is released in proportion to the masses",
    ask: "Both bodies get momenta of the same size. Which of them gets the larger kinetic energy, the heavier or the lighter one?",
    hint: "Write each kinetic energy as the square of the momentum over twice the mass.",
};
/// `(m_A + m_B) (v_A - v_B)^2 / 2`.
pub const REDUCED_MASS: Misconception = Misconception {
    id: "reduced-mass-forgotten",
    does: "uses the mass of both bodies together in the energy of the relative motion",
    ask: "Which mass belongs to the energy of two bodies that move relative to each other?",
    hint: "The energy of the relative motion has the reduced mass in it: the product of the masses over their sum.",
};

/// The square of a velocity: its base.
fn squared_velocity(law: &Taught<'_>, term: &Expr) -> Option<Expr> {
    factors(term).into_iter().find_map(|factor| match &factor {
        Expr::Power(pair) if pair.1 == Expr::integer(2) && law.is_velocity(&pair.0) => Some(pair.0.clone()),
        _ => None,
    })
}

/// `m (v_2 - v_1)^2 / 2` in place of the difference of the energies of one body that moves at both instants.
pub(super) fn speeds_added(law: &Taught<'_>) -> Vec<Wrong> {
    let kinetic = |side: &Expr| {
        let all = terms(side).into_iter();
        all.filter_map(|term| Some((squared_velocity(law, &term)?, term))).collect::<Vec<_>>()
    };
    let (before, after) = (kinetic(&law.sides.0), kinetic(&law.sides.1));
    let ([(first, energy)], [(last, later)]) = (&before[..], &after[..]) else { return Vec::new() };
    let rest = |side: &Expr, without: &Expr| terms(side).into_iter().filter(|term| term != without).collect::<Vec<_>>();
    let put = |symbol: &Expr, term: &Expr, other: Expr| {
        let Expr::Symbol(speed) = symbol else { return term.clone() };
        term.substitute(&|part| (part == *speed).then(|| other.clone()))
    };
    if put(first, energy, last.clone()) != *later {
        return Vec::new();
    }
    let gain = put(last, later, last.clone() - first.clone());
    let left = rest(&law.sides.0, energy);
    let right = rest(&law.sides.1, later).into_iter().chain([gain]);
    one((Expr::sum(left), Expr::sum(right)))
}

/// The kinetic energies with the mass that cancels, or the rest with it: each mass that is given.
pub(super) fn mass_on_one_side(law: &Taught<'_>) -> Vec<Wrong> {
    if !law.quantities(Dimension::MASS).is_empty() {
        return Vec::new();
    }
    let masses: Vec<Symbol> = law.known.iter().copied().filter(|symbol| law.is(*symbol, Dimension::MASS)).collect();
    let weighed = |mass: Symbol, by: i64| {
        law.both(|side| {
            let moves = |term: Expr| match squared_velocity(law, &term) {
                Some(_) => term * Expr::from(mass).powi(by),
                None => term,
            };
            Expr::sum(terms(side).into_iter().map(moves))
        })
    };
    masses.iter().flat_map(|mass| [weighed(*mass, 1), weighed(*mass, -1)].concat()).collect()
}

fn is_spring(law: &Taught<'_>, term: &Expr) -> bool {
    law.has(term, Dimension::new(1, 0, -2))
}

/// `k s = m g` for a body that arrives at a spring.
pub(super) fn static_spring(law: &Taught<'_>) -> Vec<Wrong> {
    let all = || [&law.sides.0, &law.sides.1].into_iter().flat_map(terms);
    let (Some(spring), Some(kinetic)) =
        (all().find(|term| is_spring(law, term)), all().find(|term| squared_velocity(law, term).is_some()))
    else {
        return Vec::new();
    };
    let force = factors(&spring).into_iter().filter_map(|factor| match &factor {
        Expr::Power(pair) if pair.1 == Expr::integer(2) => Some(pair.0.clone()),
        Expr::Number(_) => None,
        _ => Some(factor),
    });
    let masses = factors(&kinetic).into_iter().filter(|factor| law.has(factor, Dimension::MASS));
    let weight = Expr::product(masses.chain([Expr::ratio(981, 100)]));
    one((Expr::product(force), weight))
}

/// The lengths of a spring for its deformations, at each end alone and at both.
pub(super) fn length_for_stretch(law: &Taught<'_>) -> Vec<Wrong> {
    let whole = |side: &Expr| {
        let of = |term: Expr| {
            let is_stretch = |part: &Expr| matches!(part, Expr::Sum(_)) && law.has(part, Dimension::LENGTH);
            let lengthened = |factor: Expr| match &factor {
                Expr::Power(pair) if pair.1 == Expr::integer(2) && is_stretch(&pair.0) => {
                    let length = terms(&pair.0).into_iter().find(|part| !part.begins_with_minus());
                    length.unwrap_or_else(|| pair.0.clone()).powi(2)
                }
                _ => factor,
            };
            if is_spring(law, &term) { Expr::product(factors(&term).into_iter().map(lengthened)) } else { term }
        };
        Expr::sum(terms(side).into_iter().map(of))
    };
    let [left, right] = [whole(&law.sides.0), whole(&law.sides.1)];
    let ways = [(left.clone(), right.clone()), (left, law.right()), (law.left(), right)];
    ways.into_iter().filter(|sides| sides != law.sides).map(Wrong::from).collect()
}

/// One energy with the difference of the deformations, where there was one before and is one afterwards.
pub(super) fn stretches_subtracted(law: &Taught<'_>) -> Vec<Wrong> {
    let stretch = |term: &Expr| {
        factors(term).into_iter().find_map(|factor| match &factor {
            Expr::Power(pair) if pair.1 == Expr::integer(2) && law.has(&pair.0, Dimension::LENGTH) => {
                Some(pair.0.clone())
            }
            _ => None,
        })
    };
    let spring = |side: &Expr| {
        let springs: Vec<Expr> = terms(side).into_iter().filter(|term| is_spring(law, term)).collect();
        let [only] = &springs[..] else { return None };
        Some((only.clone(), stretch(only)?))
    };
    let (Some((energy, first)), Some((later, last))) = (spring(&law.sides.0), spring(&law.sides.1)) else {
        return Vec::new();
    };
    let stiffness = energy.clone() / first.clone().powi(2);
    let gain = stiffness * (first - last).powi(2);
    let left = terms(&law.sides.0).into_iter().map(|term| if term == energy { gain.clone() } else { term });
    let right = terms(&law.sides.1).into_iter().filter(|term| *term != later);
    one((Expr::sum(left), Expr::sum(right)))
}

/// `E = 2 (m v^2 / 2)` for each body.
pub(super) fn equal_shares(law: &Taught<'_>) -> Vec<Wrong> {
    shares(law, &|_, count| Expr::integer(i64::try_from(count).unwrap_or(2)))
}

/// `E m_A / (m_A + m_B) = m_A v_A^2 / 2` for each body.
pub(super) fn shared_by_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let masses = |term: &Expr| Expr::product(factors(term).into_iter().filter(|part| law.has(part, Dimension::MASS)));
    let total = Expr::sum(terms(&law.sides.1).iter().map(masses));
    shares(law, &|body, _| total.clone() / masses(body))
}

/// All that is released as a multiple of the energy of one body, each in turn; the momentum before is not looked at.
fn shares(law: &Taught<'_>, times: &dyn Fn(&Expr, usize) -> Expr) -> Vec<Wrong> {
    let (Some(released), bodies) = (terms(&law.sides.0).pop(), terms(&law.sides.1)) else { return Vec::new() };
    if bodies.len() < 2 {
        return Vec::new();
    }
    let share = |body: &Expr| Wrong {
        equations: vec![(released.clone(), times(body, bodies.len()) * body.clone())],
        without: &[],
    };
    bodies.iter().map(share).collect()
}

/// The loss as the energy of the relative motion, with a wrong mass.
pub(super) fn reduced_mass_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let before = terms(&law.sides.1).into_iter().next();
    let Some(bodies) = law.beside("kinetic-energy").find(|(energy, _)| Some(energy) == before.as_ref()) else {
        return Vec::new();
    };
    let of = |term: Expr| {
        let speed = squared_velocity(law, &term)?;
        let masses = factors(&term).into_iter().filter(|part| law.has(part, Dimension::MASS));
        Some((Expr::product(masses), speed))
    };
    let bodies: Vec<(Expr, Expr)> = terms(&bodies.1).into_iter().filter_map(of).collect();
    let [(first, speed), (second, other)] = &bodies[..] else { return Vec::new() };
    let kept = law.restitution().map_or_else(Expr::zero, |e| e.powi(2));
    let relative = Expr::apply(Function::Abs, speed.clone() - other.clone()).powi(2);
    let energy = |mass: Expr| Expr::product([Expr::ratio(1, 2), mass, relative.clone(), Expr::one() - kept.clone()]);
    one((law.left(), energy(first.clone() + second.clone())))
}
