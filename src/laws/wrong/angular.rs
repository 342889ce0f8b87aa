//! Mistakes about angular momentum.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::integral::ENDS_AVERAGED;
use super::integral::VALUE_TIMES_TIME;
use super::integral::ends_averaged;
use super::integral::value_times_time;
use super::mass_centre::SOME_FORCES;
use super::rewrite::factors;
use super::rewrite::gain_reversed;
use super::rewrite::one;
use super::rewrite::start_forgotten;
use super::rewrite::terms;

/// Momentum for angular momentum.
pub const RADIUS_FORGOTTEN: Misconception = Misconception {
    id: "arm-forgotten",
    does: "leaves the arm out of an angular momentum",
    ask: "How is an angular momentum obtained from a momentum?",
    hint: "Check the units: a moment of momentum contains a length.",
};
/// Distance for perpendicular distance.
pub const DISTANCE: Misconception = Misconception {
    id: "distance-for-arm",
    does: "takes the distance of the body as the arm of its momentum",
    ask: "At what distance from the point does the line pass along which the body moves?",
    hint: "The arm is the perpendicular distance of the line of motion, not the distance of the body.",
};
/// The two moments added.
pub const MOMENTS_ADDED: Misconception = Misconception {
    id: "moments-added",
    does: "adds the moments of both components regardless of their sense",
    ask: "In which sense does each component turn about the point?",
    hint: "One of the two moments may be negative: draw both components.",
};
/// All of the mass at the rim.
pub const ROTOR_AS_RING: Misconception = Misconception {
    id: "rotor-as-ring",
    does: "leaves out the number in a moment of inertia, as if all the mass were at the greatest distance",
    ask: "How is the mass of the body spread between its axle and its rim?",
    hint: "Use the moment of inertia that the problem gives, with every factor.",
};
/// `m b^2 / 12` for `m b^2 / 3`.
pub const ABOUT_THE_CENTRE: Misconception = Misconception {
    id: "inertia-about-the-centre",
    does: "uses the moment of inertia about the centre for that about the end",
    ask: "About which axis does the body turn, and about which is your moment of inertia?",
    hint: "About its end a rod has four times the moment of inertia that it has about its centre.",
};
/// `m r^2 / 2`.
pub const PARTICLE_AS_DISC: Misconception = Misconception {
    id: "particle-as-disc",
    does: "gives particles at a distance from the axle the factor of one half that belongs to a disc",
    ask: "Which bodies are spread between the axle and the rim, and which have all their mass at one distance?",
    hint: "A particle has its mass times the square of its distance, without a factor of one half.",
};
/// Components with the wrong arms.
pub const ARMS_EXCHANGED: Misconception = Misconception {
    id: "arms-exchanged",
    does: "multiplies each component by the coordinate along it",
    ask: "Does a component of the momentum have a moment about a point that lies straight ahead of it?",
    hint: "The arm of each component is the coordinate perpendicular to it.",
};
/// `J_M = H_2`.
pub const START_FORGOTTEN: Misconception = Misconception {
    id: "start-angular-momentum-forgotten",
    does: "leaves out the angular momentum at the start",
    ask: "An angular impulse changes the angular momentum: from which value to which?",
    hint: "Was there angular momentum before the moment began to act?",
};
/// A moment that speeds up counted as one that slows down.
pub const REVERSED: Misconception = Misconception {
    id: "angular-impulse-reversed",
    does: "takes the angular impulse in the opposite sense",
    ask: "Does the moment turn with the motion or against it?",
    hint: "Choose a positive sense, and give both the motion and the moment their signs.",
};
/// `H' = 0`.
pub const TAKEN_AS_CONSERVED: Misconception = Misconception {
    id: "angular-momentum-taken-as-conserved",
    does: "assumes that the angular momentum is conserved, although a force has a moment about the point",
    ask: "Does any force have a moment about this point?",
    hint: "Angular momentum about a point is conserved only if the moments of all forces about it add up to zero.",
};
/// Velocity kept as the radius changes.
pub const VELOCITY_KEPT: Misconception = Misconception {
    id: "velocity-kept",
    does: "keeps the velocity as the radius changes",
    ask: "Which quantity stays the same while the radius changes, and why?",
    hint: "The force has no moment about the centre, but it does work: what is conserved then?",
};
/// Angular velocity kept as the radius changes.
pub const RATE_KEPT: Misconception = Misconception {
    id: "angular-velocity-kept",
    does: "keeps the angular velocity as the radius changes",
    ask: "Which quantity stays the same while the radius changes, and why?",
    hint: "A skater who draws in the arms spins faster: the angular velocity is not what stays the same.",
};
/// Radius squared with a linear velocity.
pub const RADIUS_SQUARED: Misconception = Misconception {
    id: "radius-squared",
    does: "squares the radius that multiplies a velocity",
    ask: "Does the square of the radius belong to the velocity, or to the angular velocity?",
    hint: "Radius times transverse velocity is what stays the same.",
};

/// The factors of the vector product in the wrong order.
pub const FACTORS_EXCHANGED: Misconception = Misconception {
    id: "vector-product-reversed",
    does: "takes the factors of the vector product in the wrong order",
    ask: "Which factor comes first in the moment: the position, or the force or momentum there?",
    hint: "The order decides the sign: the position vector comes first. Check it with the right-hand rule.",
};

/// What carries the bodies counted as light.
pub const ROTOR_FORGOTTEN: Misconception = Misconception {
    id: "moment-of-inertia-forgotten",
    does: "leaves out the angular momentum of what carries the bodies",
    ask: "What turns together with the bodies, and is it light?",
    hint: "A body that turns has an angular momentum of its own: its moment of inertia times its angular velocity.",
};

/// The area of a rectangle for that of a triangle.
pub const TRIANGLE: Misconception = Misconception {
    id: "triangle-as-rectangle",
    does: "leaves out the factor of one half of the area of a triangle",
    ask: "Which shape does the radius sweep in a short time, and what is its area?",
    hint: "The area of a triangle is half the product of its base and its height.",
};

/// Wrong forms of angular momentum.
pub const ANGULAR_MOMENTUM: &[WrongForm] = &[
    WrongForm {
        of: &RADIUS_FORGOTTEN,
        write: |law| [radius_forgotten(law), super::inertia::one_arm_forgotten(law)].concat(),
    },
    WrongForm { of: &DISTANCE, write: |law| moment(law, distance) },
    WrongForm { of: &MOMENTS_ADDED, write: |law| moment(law, |[x, y], [u, v]| x * v + y * u) },
    WrongForm { of: &ARMS_EXCHANGED, write: arms_exchanged },
    WrongForm { of: &ROTOR_AS_RING, write: |law| rotors(law, |number| Some(Rational::ONE / number)) },
    WrongForm { of: &ABOUT_THE_CENTRE, write: |law| rotors(law, of_centre) },
    WrongForm { of: &PARTICLE_AS_DISC, write: particle_as_disc },
    WrongForm { of: &FACTORS_EXCHANGED, write: reversed },
    WrongForm { of: &ROTOR_FORGOTTEN, write: rotor_forgotten },
    WrongForm { of: &super::inertia::ARM_NOT_SQUARED, write: super::inertia::arm_not_squared },
    WrongForm { of: &super::inertia::AS_PARTICLE, write: super::inertia::as_particle },
];
/// Wrong forms of the moment of a force.
pub const MOMENT: &[WrongForm] = &[
    WrongForm { of: &MOMENTS_ADDED, write: signs_lost },
    WrongForm { of: &FACTORS_EXCHANGED, write: moment_reversed },
    WrongForm { of: &SOME_FORCES, write: one_force },
];
/// Wrong forms of the moment equation.
pub const RATE: &[WrongForm] = &[WrongForm { of: &TAKEN_AS_CONSERVED, write: |law| one((law.left(), Expr::zero())) }];
/// Wrong forms of angular impulse and momentum.
pub const ANGULAR_IMPULSE: &[WrongForm] = &[
    WrongForm { of: &START_FORGOTTEN, write: start_forgotten },
    WrongForm { of: &REVERSED, write: gain_reversed },
    WrongForm { of: &VELOCITY_KEPT, write: |law| arms(law, 1) },
    WrongForm { of: &RATE_KEPT, write: |law| [arms(law, 2), together(law)].concat() },
    WrongForm { of: &RADIUS_SQUARED, write: |law| arms(law, -1) },
    WrongForm { of: &RADIUS_FORGOTTEN, write: super::inertia::linear_for_angular },
];
/// `v_1^2 r_1 = v_2^2 r_2`.
pub const BY_ROOT: Misconception = Misconception {
    id: "speed-of-circular-orbits",
    does: "compares the speeds as on two circles, by the square root of the distance",
    ask: "Does the body move on a circle at both instants? What stays the same on this path?",
    hint: "The speeds on different circles belong to different motions; on one path distance times transverse velocity stays the same.",
};
/// Wrong forms of conservation.
pub const CONSERVATION: &[WrongForm] = &[
    WrongForm { of: &VELOCITY_KEPT, write: |law| arms(law, 1) },
    WrongForm { of: &RATE_KEPT, write: |law| arms(law, 2) },
    WrongForm { of: &RADIUS_SQUARED, write: |law| arms(law, -1) },
];
/// Wrong forms of the impulse of a moment.
pub const MOMENT_IMPULSE: &[WrongForm] = &[
    WrongForm { of: &VALUE_TIMES_TIME, write: value_times_time },
    WrongForm { of: &ENDS_AVERAGED, write: ends_averaged },
];
/// Wrong forms of motion under a central force.
pub const CENTRAL: &[WrongForm] = &[
    WrongForm { of: &VELOCITY_KEPT, write: |law| radius_to(law, 0) },
    WrongForm { of: &RATE_KEPT, write: |law| radius_to(law, -1) },
    WrongForm { of: &RADIUS_SQUARED, write: |law| radius_to(law, 2) },
    WrongForm { of: &BY_ROOT, write: by_root },
    super::circle::WHOLE_FOR_COMPONENT,
];
/// Wrong forms of the areal rate.
pub const AREAL: &[WrongForm] =
    &[WrongForm { of: &TRIANGLE, write: |law| one((law.left(), Expr::integer(2) * law.right())) }];

/// The terms of moments of inertia left out: those with an angular velocity of their own.
fn rotor_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let all = terms(&law.sides.1);
    let turns = Dimension::new(0, 0, -1);
    let rest: Vec<Expr> = all.iter().filter(|term| !law.has(term, turns)).cloned().collect();
    if rest.is_empty() || rest.len() == all.len() { Vec::new() } else { one((law.left(), Expr::sum(rest))) }
}

/// Moments of inertia times something that follows from their number.
fn rotors(law: &Taught<'_>, times: fn(&Rational) -> Option<Rational>) -> Vec<Wrong> {
    let turns = Dimension::new(0, 0, -1);
    let changed = |term: &Expr| {
        let number = factors(term).iter().find_map(|part| part.as_number().cloned())?;
        let is_share = number > Rational::ZERO && number < Rational::ONE && law.has(term, turns);
        let by = times(&number).filter(|_| is_share)?;
        Some(Expr::Number(by) * term.clone())
    };
    let all = terms(&law.sides.1);
    if all.iter().all(|term| changed(term).is_none()) {
        return Vec::new();
    }
    one((law.left(), Expr::sum(all.iter().map(|term| changed(term).unwrap_or_else(|| term.clone())))))
}

/// From the end of a rod, which has a third of its mass times its length squared, to the centre.
fn of_centre(number: &Rational) -> Option<Rational> {
    (number * Rational::from(3) == Rational::ONE).then(|| Rational::ONE / Rational::from(4))
}

/// The terms beside a disc with its factor of one half.
fn particle_as_disc(law: &Taught<'_>) -> Vec<Wrong> {
    let is_disc = |term: &Expr| factors(term).iter().any(|part| part.as_number().is_some());
    let all = terms(&law.sides.1);
    if !all.iter().any(is_disc) || all.iter().all(is_disc) {
        return Vec::new();
    }
    let halved = |term: Expr| if is_disc(&term) { term } else { Expr::ratio(1, 2) * term };
    one((law.left(), Expr::sum(all.into_iter().map(halved))))
}

/// `m (x u - y v)`, and the sum of both: the product of what lies along the same axis.
fn arms_exchanged(law: &Taught<'_>) -> Vec<Wrong> {
    let difference = moment(law, |[x, y], [u, v]| x * u - y * v);
    difference.into_iter().chain(moment(law, |[x, y], [u, v]| x * u + y * v)).collect()
}

/// Momenta without their arms; what turns as a whole keeps its moment of inertia.
fn radius_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let turns = Dimension::new(0, 0, -1);
    let bare = |term: &Expr| {
        let parts = factors(term);
        let kept: Vec<Expr> = parts.iter().filter(|part| !law.has(part, Dimension::LENGTH)).cloned().collect();
        let is_moment = !law.has(term, turns) && kept.len() < parts.len() && kept.len() > 1;
        is_moment.then(|| Expr::product(kept))
    };
    let all = terms(&law.sides.1);
    if all.iter().all(|term| bare(term).is_none()) {
        return Vec::new();
    }
    one((law.left(), Expr::sum(all.iter().map(|term| bare(term).unwrap_or_else(|| term.clone())))))
}

/// `m (x v - y u)` with something else in the brackets, made from position and velocity.
fn moment(law: &Taught<'_>, change: impl Fn([Expr; 2], [Expr; 2]) -> Expr) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    let [mass, Expr::Sum(moments)] = &parts[..] else { return Vec::new() };
    let of = |term: &Expr| {
        let letters = factors(term).into_iter().filter(|factor| factor.as_number().is_none()).collect::<Vec<_>>();
        <[Expr; 2]>::try_from(letters).ok()
    };
    let [first, second] = &moments[..] else { return Vec::new() };
    let (Some([x, v]), Some([y, u])) = (of(first), of(second)) else { return Vec::new() };
    one((law.left(), mass.clone() * change([x, y], [u, v])))
}

/// Every term that enters a moment with a minus sign, with a plus.
fn signs_lost(law: &Taught<'_>) -> Vec<Wrong> {
    let lost = |part: &Expr| {
        if factors(part).first() == Some(&Expr::integer(-1)) { -part.clone() } else { part.clone() }
    };
    let sides = (law.left(), Expr::sum(terms(&law.sides.1).iter().map(lost)));
    if sides == *law.sides { Vec::new() } else { one(sides) }
}

/// The moment of each force alone, where there are several: its terms share a quantity that is neither a place nor a time nor a number.
fn one_force(law: &Taught<'_>) -> Vec<Wrong> {
    let apart = [Dimension::LENGTH, Dimension::TIME, Dimension::NONE];
    let mut forces: Vec<(BTreeSet<Symbol>, Expr)> = Vec::new();
    for term in terms(&law.sides.1) {
        let of_force = |symbol: &Symbol| apart.iter().all(|dimension| !law.is(*symbol, *dimension));
        let force = (term.symbols().into_iter().filter(of_force).collect(), term);
        let (same, others): (Vec<_>, Vec<_>) =
            forces.into_iter().partition(|(symbols, _)| !symbols.is_disjoint(&force.0));
        forces = others;
        forces.push(same.into_iter().fold(force, |(all, sum), (symbols, part)| (&all | &symbols, part + sum)));
    }
    let alone = forces.iter().map(|(_, moment)| Wrong::from((law.left(), moment.clone())));
    if forces.len() > 1 { alone.collect() } else { Vec::new() }
}

/// The moment with the other sign, where it is the vector product of a position and a momentum.
fn reversed(law: &Taught<'_>) -> Vec<Wrong> {
    moment(law, |[x, y], [u, v]| y * u - x * v)
}

/// The same of a force.
fn moment_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    if terms(&law.sides.1).len() > 1 { one((law.left(), -law.right())) } else { Vec::new() }
}

fn distance([x, y]: [Expr; 2], [u, v]: [Expr; 2]) -> Expr {
    let length = |a: Expr, b: Expr| (a.powi(2) + b.powi(2)).sqrt();
    length(x, y) * length(u, v)
}

/// `H_1 r_2^n = H_2 r_1^n`: the velocity stays for n = 1, the angular velocity for n = 2.
fn arms(law: &Taught<'_>, power: i64) -> Vec<Wrong> {
    let arm = |momentum: &Expr| {
        let definition = law.beside("angular-momentum").find(|sides| sides.0 == *momentum)?;
        // Of several bodies each has a distance of its own.
        if matches!(definition.1, Expr::Sum(_)) {
            return None;
        }
        factors(&definition.1).into_iter().find(|factor| law.has(factor, Dimension::LENGTH))
    };
    let [before] = &terms(&law.sides.0)[..] else { return Vec::new() };
    match (arm(before), arm(&law.sides.1)) {
        (Some(first), Some(second)) if first != second => {
            one((before.clone() * second.powi(power), law.right() * first.powi(power)))
        }
        _ => Vec::new(),
    }
}

/// `v_1 r_2 = v_2 r_1` for one of several bodies, or the angular velocity of what carries them, unchanged.
fn together(law: &Taught<'_>) -> Vec<Wrong> {
    let [before] = &terms(&law.sides.0)[..] else { return Vec::new() };
    let parts = |momentum: &Expr| {
        let definition = law.beside("angular-momentum").find(|sides| sides.0 == *momentum);
        definition.map_or_else(Vec::new, |sides| terms(&sides.1))
    };
    let (start, end) = (parts(before), parts(&law.sides.1));
    if start.len() < 2 || end.len() < 2 {
        return Vec::new();
    }
    let turns = |all: &[Expr]| {
        let mut symbols = all.iter().flat_map(Expr::symbols);
        symbols.find(|symbol| law.is(*symbol, Dimension::new(0, 0, -1))).map(Expr::from)
    };
    if let (Some(first), Some(second)) = (turns(&start), turns(&end)) {
        return one((first, second));
    }
    let moves = |all: &[Expr]| {
        let parts = factors(all.first()?);
        let arm =
            parts.iter().find(|factor| matches!(factor, Expr::Symbol(symbol) if law.is(*symbol, Dimension::LENGTH)))?;
        Some((arm.clone(), parts.iter().find(|factor| law.is_velocity(factor))?.clone()))
    };
    match (moves(&start), moves(&end)) {
        (Some((arm, velocity)), Some((other, after))) => one((velocity * other, after * arm)),
        _ => Vec::new(),
    }
}

/// Both sides with another power of the radius.
fn by_root(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| law.is(symbol, Dimension::LENGTH).then(|| Expr::from(symbol).sqrt()))
}

fn radius_to(law: &Taught<'_>, power: i64) -> Vec<Wrong> {
    law.replaced(&|symbol| law.is(symbol, Dimension::LENGTH).then(|| Expr::from(symbol).powi(power)))
}
