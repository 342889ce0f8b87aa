//! Mistakes about falls and flights.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::momentum::GRAVITY_REVERSED;
use super::momentum::SIGN_LOST;
use super::rewrite::factors;
use super::rewrite::gain_reversed;
use super::rewrite::sign_lost;
use super::rewrite::start_forgotten;

/// `v^2 = g h`.
pub const TWO: Misconception = Misconception {
    id: "fall-two-forgotten",
    does: "leaves out the factor of two in the speed of a fall",
    ask: "Weight times height becomes kinetic energy: which factor does that leave in front of g and h?",
    hint: "Write the energy before and after the fall, and solve for the speed.",
};
/// `v = 2 g h`.
pub const ROOT: Misconception = Misconception {
    id: "fall-root-forgotten",
    does: "does not take the square root in the speed of a fall",
    ask: "What are the units of g times h? Are they those of a speed?",
    hint: "The energy of a fall gives the square of the speed.",
};
/// `v_2 = v_1 + sqrt(2 g h)`.
pub const SPEEDS_ADDED: Misconception = Misconception {
    id: "speeds-added-for-squares",
    does: "adds to the initial speed the speed that would be reached from rest",
    ask: "What adds up in a fall: speeds, or their squares?",
    hint: "Work adds to the kinetic energy, which has the square of the speed in it.",
};
/// The time of a contact for that of a fall.
pub const OTHER_TIME: Misconception = Misconception {
    id: "time-of-another-stage",
    does: "uses the given time for a part of the motion to which it does not belong",
    ask: "How long does what lasts for the given time, and is that the fall?",
    hint: "Write next to each time in which part of the motion it passes.",
};
/// `a t^2`.
pub const FALL_HALF: Misconception = Misconception {
    id: "fall-half-forgotten",
    does: "leaves out the factor of one half in the distance fallen",
    ask: "The velocity of a fall grows from the first moment on: what is its average over the time?",
    hint: "Draw the velocity against time: the distance is the area of a triangle.",
};
/// `(v_1 + v_2) t`, from rest `v_2 t`.
pub const MEAN_HALF: Misconception = Misconception {
    id: "mean-half-forgotten",
    does: "multiplies the time by the sum of the velocities before and after, not by their mean",
    ask: "The velocity changes evenly: what is its mean over the time?",
    hint: "Draw the velocity against time: the displacement is the area under the line.",
};
/// The first velocity left out.
pub const FIRST_VELOCITY: Misconception = Misconception {
    id: "first-velocity-forgotten",
    does: "leaves out the initial velocity of the flight",
    ask: "Does the body start from rest along this axis?",
    hint: "Without gravity, where would the body be after this time?",
};

/// The strands of the two bodies exchanged.
pub const STRANDS_EXCHANGED: Misconception = Misconception {
    id: "strands-exchanged",
    does: "makes the body on the movable pulley move faster than the string, not slower",
    ask: "By how much does each strand of a movable pulley become shorter when the string is pulled by one metre?",
    hint: "The length that is pulled is shared between the strands.",
};
/// A movable pulley taken for a fixed one.
pub const STRANDS_FORGOTTEN: Misconception = Misconception {
    id: "strands-forgotten",
    does: "gives both bodies the same speed, although one hangs from a movable pulley",
    ask: "How far does the movable pulley rise when the string is pulled by one metre?",
    hint: "The length that is pulled is shared between the strands.",
};
/// Wrong forms of the constraint of a string over movable pulleys.
pub const STRANDS: &[WrongForm] = &[
    WrongForm { of: &STRANDS_EXCHANGED, write: |law| strands_to(law, -1) },
    WrongForm { of: &STRANDS_FORGOTTEN, write: strands_forgotten },
];

/// The place at the start left out.
pub const START_PLACE: Misconception = Misconception {
    id: "start-place-forgotten",
    does: "leaves out the initial position",
    ask: "Where is the body at time zero?",
    hint: "Velocity times time is how far the body moves, not where it is.",
};

/// Wrong forms of velocity and time in a fall.
pub const FALL_TIME: &[WrongForm] = &[
    WrongForm { of: &FIRST_VELOCITY, write: start_forgotten },
    WrongForm { of: &GRAVITY_REVERSED, write: gain_reversed },
];
/// Wrong forms of uniform motion.
pub const UNIFORM: &[WrongForm] = &[
    WrongForm { of: &START_PLACE, write: |law| law.without(&|term| !law.has(term, Dimension::VELOCITY)) },
    WrongForm { of: &SIGN_LOST, write: sign_lost },
];
/// Wrong forms of the displacement under forces that stay the same.
pub const MEAN_VELOCITY: &[WrongForm] = &[WrongForm { of: &MEAN_HALF, write: |law| law.both(without_numbers) }];
/// Wrong forms of the speed after a fall.
pub const FALL_SPEED: &[WrongForm] = &[
    WrongForm { of: &TWO, write: two_forgotten },
    WrongForm { of: &ROOT, write: root_forgotten },
    WrongForm { of: &SPEEDS_ADDED, write: speeds_added },
    WrongForm { of: &OTHER_TIME, write: by_other_time },
];
/// Wrong forms of the place in a flight.
pub const FLIGHT_PLACE: &[WrongForm] = &[
    WrongForm { of: &FALL_HALF, write: |law| law.both(|side| doubled(law, side)) },
    WrongForm { of: &FIRST_VELOCITY, write: |law| law.without(&|term| law.has(term, Dimension::VELOCITY)) },
    WrongForm { of: &START_PLACE, write: |law| law.without(&|term| is_place(law, term)) },
];
/// `v_2 = v_1 + sqrt(2 g h)`, upwards or downwards.
fn speeds_added(law: &Taught<'_>) -> Vec<Wrong> {
    let is_square =
        |term: &Expr| matches!(term, Expr::Power(pair) if pair.1 == Expr::integer(2) && law.is_velocity(&pair.0));
    let (Expr::Power(after), Expr::Sum(parts)) = (&law.sides.0, &law.sides.1) else { return Vec::new() };
    let Some(Expr::Power(before)) = parts.iter().find(|part| is_square(part)) else { return Vec::new() };
    let fallen = Expr::sum(parts.iter().filter(|part| !is_square(part)).cloned());
    let gained = Expr::apply(Function::Abs, fallen).sqrt();
    [gained.clone(), -gained].map(|gained| Wrong::from((after.0.clone(), before.0.clone() + gained))).into()
}

/// `v = g t` with the one time that is given.
fn by_other_time(law: &Taught<'_>) -> Vec<Wrong> {
    let times: Vec<Symbol> = law.known.iter().copied().filter(|symbol| law.is(*symbol, Dimension::TIME)).collect();
    let (Expr::Power(after), [time], Some(gravity)) = (&law.sides.0, &times[..], law.symbols.find("g")) else {
        return Vec::new();
    };
    let gained = Expr::from(gravity) * Expr::from(*time);
    [gained.clone(), -gained].map(|speed| Wrong::from((after.0.clone(), speed))).into()
}

/// Whether a term is a place, and neither the way of a velocity nor that of a fall.
fn is_place(law: &Taught<'_>, term: &Expr) -> bool {
    matches!(term, Expr::Symbol(symbol) if law.is(*symbol, Dimension::LENGTH))
}

/// `v_2^2 = v_1^2 + g h`.
fn two_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.both(|side| halved(law, side))
}

fn halved(law: &Taught<'_>, term: &Expr) -> Expr {
    match term {
        Expr::Product(_) if law.has_gravity(term) => Expr::ratio(1, 2) * term.clone(),
        other => other.map_children(|part| halved(law, part)),
    }
}

fn doubled(law: &Taught<'_>, term: &Expr) -> Expr {
    match term {
        Expr::Product(_) if law.has_gravity(term) => Expr::integer(2) * term.clone(),
        other => other.map_children(|part| doubled(law, part)),
    }
}

fn without_numbers(term: &Expr) -> Expr {
    Expr::product(factors(term).into_iter().filter(|factor| factor.as_number().is_none()))
}

fn root_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    match &law.sides.0 {
        // Upwards or downwards, as the body moves.
        Expr::Power(pair) if pair.1 == Expr::integer(2) => {
            let right = law.right();
            let half = halved(law, &right);
            let speeds = [right.clone(), -right, half.clone(), -half];
            speeds.map(|speed| Wrong::from((pair.0.clone(), speed))).into()
        }
        _ => Vec::new(),
    }
}

/// One strand for each body, in the constraint alone or in the balances of momentum as well.
fn strands_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    fn one_strand(law: &Taught<'_>, term: &Expr) -> Expr {
        let is_force = |factor: &Expr| matches!(factor, Expr::Symbol(symbol) if law.is(*symbol, Dimension::FORCE));
        match term {
            Expr::Product(parts) if parts.iter().any(is_force) => Expr::product(
                parts.iter().filter(|factor| factor.as_number().is_none_or(|number| *number < Rational::ONE)).cloned(),
            ),
            other => other.map_children(|part| one_strand(law, part)),
        }
    }
    let everywhere = |wrong: &Wrong| {
        let balances = law.beside("impulse-momentum").map(|(start, end)| (one_strand(law, start), end.clone()));
        Wrong { equations: wrong.equations.iter().cloned().chain(balances).collect(), without: &["impulse-momentum"] }
    };
    let constraint = strands_to(law, 0);
    let both: Vec<Wrong> = constraint.iter().map(everywhere).collect();
    [constraint, both].concat()
}

/// Both sides with the numbers of strands to another power.
fn strands_to(law: &Taught<'_>, power: i64) -> Vec<Wrong> {
    law.both(|side| {
        let changed = |factor: Expr| if factor.as_number().is_some() { factor.powi(power) } else { factor };
        Expr::product(factors(side).into_iter().map(changed))
    })
}
