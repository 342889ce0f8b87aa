//! Mistakes about orbits.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::energy::HALF;
use super::energy::WEIGHT_WORK_REVERSED;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::terms;

/// `g h` far from the ground.
pub const UNIFORM_GRAVITY: Misconception = Misconception {
    id: "gravity-by-radius-squared",
    does: "divides by the square of the distance in the energy of gravity",
    ask: "Which is proportional to one over the distance squared: the force of gravity, or its energy?",
    hint: "The energy is the force integrated over the distance, so it has one power of the distance less.",
};
/// `-GM / a`.
pub const AXIS: Misconception = Misconception {
    id: "whole-axis-for-half",
    does: "confuses the semi-major axis with the major axis",
    ask: "Is a the whole length of the orbit, from the nearest point to the farthest, or half of it?",
    hint: "The nearest and the farthest distance add up to the major axis, which is twice a.",
};
/// `r_max = 2 a`.
pub const OTHER_END: Misconception = Misconception {
    id: "other-end-of-the-axis-forgotten",
    does: "gives the whole axis of an ellipse for the distance of one of its ends from the focus",
    ask: "From which point is this distance counted, and from which to which does the axis reach?",
    hint: "The centre of force is a focus, inside the ellipse: the nearest and the farthest distance share the axis.",
};
/// `T^3 = 4 pi^2 a^2 / GM`.
pub const POWERS: Misconception = Misconception {
    id: "keplers-powers-exchanged",
    does: "exchanges the powers in Kepler's third law",
    ask: "Which power of the period is proportional to which power of the semi-major axis?",
    hint: "Check the units: GM is a length cubed over a time squared.",
};
/// `T^2 = 2 pi a^3 / GM`.
pub const PI_SQUARE: Misconception = Misconception {
    id: "pi-not-squared",
    does: "does not square the factor two pi in the square of the period",
    ask: "What does the factor two pi become when the equation for the period is squared?",
    hint: "Write the period as a factor times a square root, and square all of it.",
};
/// `1 - ecc`.
pub const ECCENTRICITY: Misconception = Misconception {
    id: "eccentricity-not-squared",
    does: "does not square the eccentricity",
    ask: "To which power is the eccentricity raised in the parameter of the orbit?",
    hint: "Multiply the distances of the nearest and the farthest point, in terms of the semi-major axis and the eccentricity.",
};
/// `v^2 = GM (1/r - 1/a)`.
pub const VIS_VIVA: Misconception = Misconception {
    id: "two-of-vis-viva-forgotten",
    does: "leaves the twos out of the energy of an orbit",
    ask: "Which factor does the kinetic energy have, and which one the energy of the whole orbit?",
    hint: "The square of the speed is GM times the difference of two over the distance and one over the semi-major axis.",
};
/// `v^2 = GM / r`.
pub const CIRCULAR: Misconception = Misconception {
    id: "formula-of-a-circular-orbit",
    does: "uses the speed of a circular orbit on an orbit that is no circle",
    ask: "Is this orbit a circle? For which orbits is the square of the speed GM over the distance?",
    hint: "On an ellipse the speed at a distance also depends on the semi-major axis: use the energy.",
};
/// `v^2 = 2 GM / r`.
pub const ESCAPE: Misconception = Misconception {
    id: "escape-speed-for-speed",
    does: "takes the speed of the body for the escape speed, or the reverse",
    ask: "Does the body just escape? What is its energy then, and what is it here?",
    hint: "The escape speed is the square root of two times the speed on a circle at the same distance.",
};
/// `r_max = a + r_min`.
pub const FROM_CENTRE: Misconception = Misconception {
    id: "axis-counted-from-the-focus",
    does: "adds the given distance to the semi-major axis, or subtracts it from it",
    ask: "What do the nearest and the farthest distance add up to: the semi-major axis, or twice that?",
    hint: "Both distances are counted from the focus, and together they are the major axis, twice the semi-major one.",
};
/// `T^2 = 4 pi^2 r^3 / GM`.
pub const DISTANCE_IN_PERIOD: Misconception = Misconception {
    id: "distance-for-axis-in-keplers-law",
    does: "uses a distance from the centre for the semi-major axis in Kepler's third law",
    ask: "Which length enters Kepler's third law: the nearest distance, the farthest one, or their mean?",
    hint: "The period depends on the semi-major axis only: half of the sum of the nearest and the farthest distance.",
};
/// `T^2 = a^3 / GM`.
pub const PI_FORGOTTEN: Misconception = Misconception {
    id: "two-pi-of-the-period-forgotten",
    does: "leaves the factor two pi out of the period",
    ask: "How long is a whole turn on a circle of this radius at this speed?",
    hint: "The period is two pi times the square root of a cubed over GM.",
};
/// `T = a` or `T = a^(2/3)`, in years and astronomical units.
pub const EXPONENT: Misconception = Misconception {
    id: "keplers-exponent",
    does: "raises the semi-major axis to the wrong power for the period",
    ask: "The square of the period is proportional to the cube of the semi-major axis: to which power of the axis is the period itself proportional?",
    hint: "Take the root of both sides of Kepler's third law.",
};
/// `T = 2 pi r / v`.
pub const UNIFORM_TURN: Misconception = Misconception {
    id: "period-at-one-speed",
    does: "divides the circumference of a circle by the speed at one point for the period",
    ask: "Does the body move with this speed on its whole way, and is its way a circle?",
    hint: "The speed changes along an ellipse: use Kepler's third law.",
};

/// Wrong forms of energy under gravity.
pub const ENERGY: &[WrongForm] = &[
    WrongForm { of: &CIRCULAR, write: |law| at_each_end(law, -1) },
    WrongForm { of: &ESCAPE, write: |law| at_each_end(law, -2) },
    WrongForm { of: &HALF, write: |law| law.replaced(&|symbol| speed(law, symbol)) },
    WrongForm { of: &UNIFORM_GRAVITY, write: |law| law.replaced(&|symbol| radius(law, symbol)) },
    WrongForm { of: &WEIGHT_WORK_REVERSED, write: |law| law.replaced(&|symbol| gravity_reversed(law, symbol)) },
];
/// Wrong forms of the energy of an ellipse.
pub const ELLIPSE: &[WrongForm] = &[
    WrongForm { of: &VIS_VIVA, write: vis_viva },
    WrongForm { of: &CIRCULAR, write: circular_axis },
    WrongForm { of: &HALF, write: |law| law.replaced(&|symbol| speed(law, symbol)) },
    WrongForm { of: &AXIS, write: |law| one((law.left(), Expr::integer(2) * law.right())) },
];
/// Wrong forms of the geometry of an ellipse.
pub const APSES: &[WrongForm] = &[
    WrongForm { of: &AXIS, write: axis_of_sum },
    WrongForm { of: &OTHER_END, write: other_end_forgotten },
    WrongForm { of: &FROM_CENTRE, write: from_centre },
];
/// Wrong forms of the period.
pub const PERIOD: &[WrongForm] = &[
    WrongForm { of: &POWERS, write: powers },
    WrongForm { of: &PI_SQUARE, write: pi_square },
    WrongForm { of: &PI_FORGOTTEN, write: pi_forgotten },
    WrongForm { of: &DISTANCE_IN_PERIOD, write: distance_in_period },
    WrongForm { of: &EXPONENT, write: exponent },
    WrongForm { of: &UNIFORM_TURN, write: uniform_turn },
];
/// Wrong forms of the speed on a circular orbit.
pub const CIRCLE: &[WrongForm] = &[
    WrongForm { of: &ESCAPE, write: |law| law.replaced(&|symbol| gravity_times(law, symbol, 2)) },
    WrongForm { of: &UNIFORM_GRAVITY, write: |law| law.replaced(&|symbol| radius(law, symbol)) },
];
/// Wrong forms of the equation of the orbit.
pub const BY_ANGLE: &[WrongForm] = &[WrongForm { of: &FROM_FARTHEST, write: from_farthest }];
/// `r (1 - ecc cos(angle)) = p`.
pub const FROM_FARTHEST: Misconception = Misconception {
    id: "angle-from-the-farthest-point",
    does: "counts the angle in the equation of the orbit from the farthest point",
    ask: "At which point of the orbit is the angle zero: at the nearest, or at the farthest?",
    hint: "Put in an angle of zero: the distance must come out as the least one.",
};
/// Wrong forms of the angular momentum of an orbit.
pub const SHAPE: &[WrongForm] = &[
    WrongForm { of: &ECCENTRICITY, write: |law| law.both(|side| unsquared(law, side)) },
    super::circle::WHOLE_FOR_COMPONENT,
];

/// A speed that counts with twice its square.
fn speed(law: &Taught<'_>, symbol: Symbol) -> Option<Expr> {
    law.is(symbol, Dimension::VELOCITY).then(|| Expr::integer(2).sqrt() * Expr::from(symbol))
}

/// The gravity of a centre, which repels.
fn gravity_reversed(law: &Taught<'_>, symbol: Symbol) -> Option<Expr> {
    law.is(symbol, Dimension::new(0, 3, -2)).then(|| -Expr::from(symbol))
}

fn radius(law: &Taught<'_>, symbol: Symbol) -> Option<Expr> {
    law.is(symbol, Dimension::LENGTH).then(|| Expr::from(symbol).powi(2))
}

/// `a = r_min + r_max`.
fn axis_of_sum(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.1 {
        Expr::Sum(_) => one((law.left(), Expr::integer(2) * law.right())),
        _ => Vec::new(),
    }
}

/// `r_max = 2 a`.
fn other_end_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &factors(&law.sides.1)[..] {
        [Expr::Symbol(axis), Expr::Sum(_)] => one((law.left(), Expr::integer(2) * Expr::from(*axis))),
        _ => Vec::new(),
    }
}

/// The period with the third power, the axis with the second.
fn powers(law: &Taught<'_>) -> Vec<Wrong> {
    let power = |symbol| match () {
        () if law.is(symbol, Dimension::TIME) => Some(Expr::from(symbol).power(Expr::ratio(3, 2))),
        () if law.is(symbol, Dimension::LENGTH) => Some(Expr::from(symbol).power(Expr::ratio(2, 3))),
        () => None,
    };
    law.replaced(&power)
}

/// `v_2^2 / 2 = GM / r_2` times a half, or one: the speed at one end by itself.
fn at_each_end(law: &Taught<'_>, times: i64) -> Vec<Wrong> {
    let ends = [&law.sides.0, &law.sides.1].map(terms);
    let alone = ends.iter().filter_map(|end| match &end[..] {
        [kinetic, gravity] => Some((Expr::integer(2) * kinetic.clone(), Expr::integer(times) * gravity.clone())),
        _ => None,
    });
    alone.flat_map(one).collect()
}

fn vis_viva(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(left) = law.replaced(&|symbol| speed(law, symbol)).pop().and_then(|mut wrong| wrong.equations.pop())
    else {
        return Vec::new();
    };
    let axis = Expr::integer(2) * law.right();
    let size = Expr::apply(Function::Abs, left.0.clone());
    vec![Wrong::from((left.0, axis.clone())), Wrong::from((size, -axis))]
}

/// `a = GM / v^2`.
fn circular_axis(law: &Taught<'_>) -> Vec<Wrong> {
    let kinetic = terms(&law.sides.0).into_iter().find(|term| law.has(term, Dimension::VELOCITY));
    kinetic.map(|kinetic| Wrong::from((kinetic, -law.right()))).into_iter().collect()
}

/// The distances that stand in the energy of the orbit.
fn distances(law: &Taught<'_>) -> Vec<Expr> {
    let all = law.beside("energy-of-an-ellipse").flat_map(|(energy, _)| energy.symbols());
    all.filter(|symbol| law.is(*symbol, Dimension::LENGTH)).map(Expr::from).collect()
}

/// `r_max = a + r` and `r_max = a - r`.
fn from_centre(law: &Taught<'_>) -> Vec<Wrong> {
    let [Expr::Symbol(axis), Expr::Sum(_)] = &factors(&law.sides.1)[..] else { return Vec::new() };
    let ways = distances(law).into_iter().flat_map(|distance| {
        let axis = Expr::from(*axis);
        [axis.clone() + distance.clone(), axis - distance]
    });
    ways.map(|end| Wrong::from((law.left(), end))).collect()
}

/// The semi-major axis in Kepler's third law.
fn axis(law: &Taught<'_>) -> Option<Symbol> {
    law.sides.1.symbols().into_iter().find(|symbol| law.is(*symbol, Dimension::LENGTH))
}

fn distance_in_period(law: &Taught<'_>) -> Vec<Wrong> {
    let ends = law.beside("apses").map(|(end, _)| end.clone());
    let others: BTreeSet<Expr> = distances(law).into_iter().chain(ends).collect();
    let put = |other: &Expr| law.replaced(&|symbol| (Some(symbol) == axis(law)).then(|| other.clone()));
    others.iter().flat_map(put).collect()
}

fn pi_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), law.right() / (Expr::integer(4) * Expr::Pi.powi(2))))
}

/// A year in seconds and the distance of the Earth from the Sun in metres, by which both are counted.
const YEAR: i64 = 31_557_600;
const ASTRONOMICAL_UNIT: i64 = 149_597_870_700;

fn exponent(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(axis) = axis(law) else { return Vec::new() };
    let years = Expr::from(axis) / Expr::integer(ASTRONOMICAL_UNIT);
    let square = |power: Expr| Expr::integer(YEAR).powi(2) * years.clone().power(power);
    [Expr::integer(2), Expr::ratio(4, 3)].into_iter().flat_map(|power| one((law.left(), square(power)))).collect()
}

/// `T^2 = (2 pi r / v)^2`, with the semi-major axis or the distance for the radius.
fn uniform_turn(law: &Taught<'_>) -> Vec<Wrong> {
    let speeds = law.beside("energy-of-an-ellipse").flat_map(|(energy, _)| energy.symbols());
    let Some(speed) = speeds.into_iter().find(|symbol| law.is(*symbol, Dimension::VELOCITY)) else { return Vec::new() };
    let radii = distances(law).into_iter().chain(axis(law).map(Expr::from));
    let turn = |radius: Expr| (Expr::integer(2) * Expr::Pi * radius / Expr::from(speed)).powi(2);
    radii.map(|radius| Wrong::from((law.left(), turn(radius)))).collect()
}

fn gravity_times(law: &Taught<'_>, symbol: Symbol, times: i64) -> Option<Expr> {
    law.is(symbol, Dimension::new(0, 3, -2)).then(|| Expr::integer(times) * Expr::from(symbol))
}

fn from_farthest(law: &Taught<'_>) -> Vec<Wrong> {
    fn reversed(term: &Expr) -> Expr {
        match term {
            Expr::Apply(Function::Cos, _) => -term.clone(),
            other => other.map_children(reversed),
        }
    }
    law.both(reversed)
}

fn pi_square(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), law.right() / (Expr::integer(2) * Expr::Pi)))
}

/// Squares of pure numbers taken away.
fn unsquared(law: &Taught<'_>, term: &Expr) -> Expr {
    match term {
        Expr::Power(pair)
            if pair.1 == Expr::integer(2)
                && matches!(&pair.0, Expr::Symbol(symbol) if law.is(*symbol, Dimension::NONE)) =>
        {
            pair.0.clone()
        }
        other => other.map_children(|part| unsquared(law, part)),
    }
}
