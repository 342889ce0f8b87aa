//! Mistakes about forces over time.

use momentous_expr::Expr;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::data::DURATION_LEFT_OUT;
use super::integral::ENDS_AVERAGED;
use super::integral::FIRST_PIECE;
use super::integral::HALF_PEAK;
use super::integral::INSTANT_FOR_DURATION;
use super::integral::NOT_HALVED;
use super::integral::PARABOLA;
use super::integral::PART;
use super::integral::VALUE_TIMES_TIME;
use super::integral::ends_averaged;
use super::integral::first_piece;
use super::integral::half_peak;
use super::integral::instant_for_duration;
use super::integral::not_halved;
use super::integral::part_of_the_area;
use super::integral::two_thirds_of_peak;
use super::integral::value_times_time;
use super::momentum::GRAVITY_REVERSED;
use super::momentum::WEIGHT_AS_MASS;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::sine_and_cosine;
use super::rewrite::terms;

/// A value times the distance.
pub const VALUE_TIMES_DISTANCE: Misconception = Misconception {
    id: "value-times-distance",
    does: "multiplies one value of a changing force by the whole distance",
    ask: "Does the force have this value all along the way? What does its graph against the position look like?",
    hint: "The work is the area under the curve: a rectangle only if the force is constant.",
};
/// The impulse of a push counted before anything moves.
pub const FROM_ZERO: Misconception = Misconception {
    id: "sliding-from-the-start",
    does: "assumes that the body slides, with kinetic friction, from the start",
    ask: "When does the body begin to slide? What holds it until then?",
    hint: "While the body is at rest, static friction balances the push, and no momentum is gained.",
};
/// `F = J dt`.
pub const MULTIPLIED: Misconception = Misconception {
    id: "impulse-times-time",
    does: "multiplies the impulse by the time to get the force",
    ask: "The same impulse in a shorter time: does it take a larger force, or a smaller one?",
    hint: "Impulse is force times time; solve that for the force.",
};
/// `N = m g cos(angle)` on a circle.
pub const TURN_FORGOTTEN: Misconception = Misconception {
    id: "balance-on-a-circle",
    does: "lets the normal force or the tension balance the weight, as if the body moved along a straight line",
    ask: "Does the body move along a straight line there? What does it take to turn it?",
    hint: "The forces towards the centre add up to the mass times the square of the speed over the radius, not to zero.",
};
/// `N = m v^2 / R`.
pub const ONLY_TURNED: Misconception = Misconception {
    id: "weight-forgotten-on-a-circle",
    does: "takes the force that turns the body for the normal force or the tension, and leaves out the weight",
    ask: "Which forces act on the body there, and which of them have a component towards the centre?",
    hint: "The weight turns the body together with the normal force or the tension.",
};
/// `m g - N = m v^2 / R` at the lowest point.
pub const AWAY_FROM_CENTRE: Misconception = Misconception {
    id: "acceleration-away-from-the-centre",
    does: "lets the forces on a circle add up to one that points away from the centre",
    ask: "Towards which point does the velocity turn? Which way must the sum of the forces point?",
    hint: "At the lowest point the centre is above the body, so the force upwards is the larger one.",
};
/// `N = m g` under an inclined push.
pub const NORMAL_IS_WEIGHT: Misconception = Misconception {
    id: "normal-force-is-weight",
    does: "takes the normal force to be the weight, although another force has a component perpendicular to the floor",
    ask: "Which forces act perpendicular to the floor? Is the weight the only one that the floor must balance?",
    hint: "An inclined push presses the body into the floor, or lifts it.",
};
/// A push that lifts taken to press.
pub const NORMAL_REVERSED: Misconception = Misconception {
    id: "normal-force-reversed",
    does: "subtracts from the normal force a push that presses the body down, or the reverse",
    ask: "Does the inclined force press the body into the floor, or lift it?",
    hint: "Draw the component of the force perpendicular to the floor, and balance all forces in that direction.",
};
/// The coefficients of friction exchanged.
pub const STATIC_KINETIC: Misconception = Misconception {
    id: "static-and-kinetic-exchanged",
    does: "uses the coefficient of kinetic friction for a body at rest",
    ask: "Is the body at rest or sliding at this moment? Which coefficient applies then?",
    hint: "Static friction decides when the body starts to slide; kinetic friction acts afterwards.",
};

/// Wrong forms of the normal force of a circular track.
pub const TRACK: &[WrongForm] = &[
    WrongForm { of: &TURN_FORGOTTEN, write: |law| one((law.left(), Expr::zero())) },
    WrongForm { of: &ONLY_TURNED, write: |law| law.without(&|term| law.has_gravity(term)) },
    WrongForm { of: &GRAVITY_REVERSED, write: gravity_reversed },
    WrongForm { of: &AWAY_FROM_CENTRE, write: |law| one((law.left(), -law.right())) },
    WrongForm { of: &super::circle::SPEED_NOT_SQUARED, write: super::circle::speed_not_squared },
];
/// Wrong forms of the tension of a cord.
pub const CORD: &[WrongForm] = TRACK;
/// Wrong forms of an impulse as an integral.
pub const IMPULSE: &[WrongForm] = &[
    WrongForm { of: &VALUE_TIMES_TIME, write: value_times_time },
    WrongForm { of: &ENDS_AVERAGED, write: ends_averaged },
    WrongForm { of: &HALF_PEAK, write: half_peak },
    WrongForm { of: &PARABOLA, write: two_thirds_of_peak },
    WrongForm { of: &FIRST_PIECE, write: first_piece },
    WrongForm { of: &STATIC_KINETIC, write: static_all_along },
    WrongForm { of: &PART, write: part_of_the_area },
    WrongForm { of: &NOT_HALVED, write: not_halved },
    WrongForm { of: &INSTANT_FOR_DURATION, write: instant_for_duration },
    WrongForm { of: &FROM_ZERO, write: from_zero },
    WrongForm { of: &super::friction::FRICTION_FORGOTTEN, write: friction_forgotten },
];
/// Wrong forms of the work of a force that depends on the position.
pub const WORK: &[WrongForm] = &[WrongForm { of: &VALUE_TIMES_DISTANCE, write: value_times_time }];
/// Wrong forms of the average force.
pub const MEAN_FORCE: &[WrongForm] = &[
    WrongForm { of: &MULTIPLIED, write: |law| [multiplied(law), without_weight(law, multiplied(law))].concat() },
    WrongForm { of: &DURATION_LEFT_OUT, write: |law| [as_force(law), without_weight(law, as_force(law))].concat() },
    WrongForm { of: &super::momentum::WEIGHT_IN_IMPACT, write: weight_added },
];
/// Wrong forms of weight.
pub const WEIGHT: &[WrongForm] = &[WrongForm { of: &WEIGHT_AS_MASS, write: weight_as_mass }];
/// Wrong forms of the normal force.
pub const NORMAL_FORCE: &[WrongForm] = &[
    WrongForm { of: &NORMAL_IS_WEIGHT, write: |law| across(law, |_| Expr::zero()) },
    WrongForm { of: &NORMAL_REVERSED, write: |law| across(law, |term| -term) },
    WrongForm { of: &super::geometry::SINE_COSINE, write: sine_and_cosine },
];
/// Wrong forms of the threshold.
pub const THRESHOLD: &[WrongForm] = &[
    WrongForm { of: &STATIC_KINETIC, write: static_kinetic },
    WrongForm { of: &super::friction::FRICTION_COEFFICIENT, write: threshold_whole },
];

fn from_zero(law: &Taught<'_>) -> Vec<Wrong> {
    let Some((force, time, [low, high])) = law.integral else { return Vec::new() };
    if low.is_zero() {
        return Vec::new();
    }
    force
        .definite(time, &Expr::zero(), high)
        .map(|value| Wrong::from((law.left(), value.simplify())))
        .into_iter()
        .collect()
}

fn friction_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| (law.meaning("coefficient of kinetic friction") == Some(symbol)).then(Expr::zero))
}

/// The weight towards the centre where it points away from it, or the reverse.
fn gravity_reversed(law: &Taught<'_>) -> Vec<Wrong> {
    let reversed = |term: Expr| if law.has_gravity(&term) { -term } else { term };
    law.both(|side| Expr::sum(terms(side).into_iter().map(reversed)))
}

/// `F = J dt`.
fn multiplied(law: &Taught<'_>) -> Vec<Wrong> {
    match &factors(&law.sides.1)[..] {
        [force, time] => one((law.left() * time.clone(), force.clone())),
        _ => Vec::new(),
    }
}

/// `F = J`, the time being one unit.
fn as_force(law: &Taught<'_>) -> Vec<Wrong> {
    match &factors(&law.sides.1)[..] {
        [force, _] => one((law.left(), force.clone())),
        _ => Vec::new(),
    }
}

/// The same of an impulse from which the weight is left out, too.
fn without_weight(law: &Taught<'_>, wrong: Vec<Wrong>) -> Vec<Wrong> {
    let balance = law.beside("impulse-momentum").find(|sides| law.has_gravity(&sides.0));
    let Some((start, end)) = balance else { return Vec::new() };
    let light = terms(start).into_iter().filter(|term| !law.has_gravity(term));
    let light = (Expr::sum(light), end.clone());
    let both = |wrong: Wrong| Wrong {
        equations: wrong.equations.into_iter().chain([light.clone()]).collect(),
        without: &["impulse-momentum"],
    };
    wrong.into_iter().map(both).collect()
}

/// The coefficient of static friction for a body that slides.
fn static_all_along(law: &Taught<'_>) -> Vec<Wrong> {
    let mut all = law.symbols.iter().filter(|(symbol, entry)| {
        law.known.contains(symbol) && entry.meaning.contains("coefficient of static friction")
    });
    let Some((rest, _)) = all.next() else { return Vec::new() };
    law.replaced(&|symbol| (law.meaning("coefficient of kinetic friction") == Some(symbol)).then(|| rest.into()))
}

/// `J + m g dt = F dt`, or with the other sign, where weight has no part in the impulse.
fn weight_added(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some(balance), [_, time]) = (law.beside("impulse-momentum").next(), &factors(&law.sides.1)[..]) else {
        return Vec::new();
    };
    let Some(weight) = super::momentum::impulse_of_weight(law, balance, time) else { return Vec::new() };
    let counted = |weight: Expr| Wrong::from((law.left() + weight, law.right()));
    vec![counted(weight.clone()), counted(-weight)]
}

fn weight_as_mass(law: &Taught<'_>) -> Vec<Wrong> {
    let gravity = law.symbols.find("g");
    law.replaced(&|symbol| (gravity == Some(symbol)).then(|| law.unit_acceleration.clone()))
}

/// What stands beside the weight in the balance at right angles to the surface, changed.
fn across(law: &Taught<'_>, change: impl Fn(Expr) -> Expr) -> Vec<Wrong> {
    let parts = terms(&law.sides.1);
    if parts.len() < 2 {
        return Vec::new();
    }
    let changed = parts.into_iter().map(|term| if law.has_gravity(&term) { term } else { change(term) });
    one((law.left(), Expr::sum(changed)))
}

/// The normal force for the greatest static friction.
fn threshold_whole(law: &Taught<'_>) -> Vec<Wrong> {
    law.replaced(&|symbol| (law.meaning("coefficient of static friction") == Some(symbol)).then(Expr::one))
}

fn static_kinetic(law: &Taught<'_>) -> Vec<Wrong> {
    let of = |words: &str| {
        let mut all =
            law.symbols.iter().filter(|(symbol, entry)| law.known.contains(symbol) && entry.meaning.contains(words));
        all.next().map(|(symbol, _)| symbol)
    };
    let (Some(rest), Some(sliding)) = (of("coefficient of static friction"), of("coefficient of kinetic friction"))
    else {
        return Vec::new();
    };
    law.replaced(&|symbol| (symbol == rest).then(|| sliding.into()))
}
