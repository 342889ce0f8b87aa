//! Mistakes about bouncing.

use momentous_expr::Expr;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::rewrite::one;

/// `h' = e h`.
pub const HEIGHT_BY_E: Misconception = Misconception {
    id: "height-by-e",
    does: "multiplies the height by e at each bounce",
    ask: "The coefficient multiplies the speed. What does that do to the height?",
    hint: "The height is proportional to the square of the speed with which the body leaves the floor.",
};
/// `v' = e^2 v`.
pub const SPEED_BY_E_SQUARED: Misconception = Misconception {
    id: "speed-by-e-squared",
    does: "multiplies a speed or a time by e\u{b2} at each bounce",
    ask: "Which quantity is multiplied by e, and which by its square?",
    hint: "Speeds and times of flight are multiplied by e, heights and energies by its square.",
};
/// One bounce too few or too many.
pub const ONE_OFF: Misconception = Misconception {
    id: "bounces-miscounted",
    does: "counts one bounce too few or too many",
    ask: "How many bounces has the body made at this moment?",
    hint: "Write down the first two bounces one by one, starting at the release, before any bounce.",
};
/// Flights counted one way only.
pub const ONE_WAY: Misconception = Misconception {
    id: "flights-one-way",
    does: "counts only the rise or the fall of each flight",
    ask: "What does the body do between two bounces? How often does it pass each height?",
    hint: "After the first fall, every flight goes up and comes down again.",
};
/// The first fall counted as a whole flight.
pub const FIRST_TWICE: Misconception = Misconception {
    id: "first-fall-doubled",
    does: "counts the first fall as a whole flight",
    ask: "How does the first part of the motion differ from all later flights?",
    hint: "The body is released from above: there is no rise before the first fall.",
};
/// The first fall left out.
pub const FIRST_FORGOTTEN: Misconception = Misconception {
    id: "first-fall-forgotten",
    does: "leaves out the fall before the first bounce",
    ask: "When does your sum begin: at the release, or at the first bounce?",
    hint: "Add the first fall, from the release to the floor, to what follows it.",
};
/// One bounce for all.
pub const ONE_BOUNCE: Misconception = Misconception {
    id: "one-bounce-for-all",
    does: "takes one bounce for all of them",
    ask: "How many bounces has the body made at this moment, and what does each of them change?",
    hint: "What one bounce does, each further one does again.",
};

/// Up, and not down again.
pub const HALF_FLIGHT: Misconception = Misconception {
    id: "flight-up-only",
    does: "mistakes the time to the top of a flight for the time of the whole flight",
    ask: "What happens between the top of a flight and the next bounce?",
    hint: "By symmetry the way down takes as long as the way up.",
};
/// The velocity along the floor multiplied by e.
pub const ALONG_BY_E: Misconception = Misconception {
    id: "velocity-along-by-e",
    does: "multiplies the velocity along the floor by e, too",
    ask: "Which component of the velocity does a smooth floor change?",
    hint: "A smooth floor exerts no impulse along itself.",
};

/// The change of a speed taken for that of the velocity.
pub const SPEEDS_SUBTRACTED: Misconception = Misconception {
    id: "bounce-speeds-subtracted",
    does: "subtracts the speeds before and after a bounce, as if the direction stayed the same",
    ask: "Which sign has the velocity before the bounce, and which after it?",
    hint: "The floor stops the body and then sends it back: both speeds count.",
};

/// Wrong forms of a bounce's height.
pub const BOUNCE_HEIGHT: &[WrongForm] = &[
    WrongForm { of: &HEIGHT_BY_E, write: |law| e_to(law, Expr::sqrt) },
    WrongForm { of: &ONE_OFF, write: one_off },
    WrongForm { of: &ONE_BOUNCE, write: one_bounce },
];
/// Wrong forms of a bounce's speed.
pub const BOUNCE_SPEED: &[WrongForm] = &[
    WrongForm { of: &SPEED_BY_E_SQUARED, write: |law| e_to(law, squared) },
    WrongForm { of: &ONE_OFF, write: one_off },
    WrongForm { of: &ONE_BOUNCE, write: one_bounce },
];
/// Wrong forms of the time of bounces.
pub const BOUNCE_TIME: &[WrongForm] = &[
    WrongForm { of: &SPEED_BY_E_SQUARED, write: |law| e_to(law, squared) },
    WrongForm { of: &ONE_WAY, write: |law| series(law, |_| Expr::one()) },
    WrongForm { of: &FIRST_TWICE, write: |law| series(law, |_| Expr::integer(2)) },
    WrongForm { of: &FIRST_FORGOTTEN, write: |law| series(law, |ratio| Expr::integer(2) * ratio) },
    WrongForm { of: &ONE_OFF, write: one_off },
];
/// Wrong forms of the whole path.
pub const BOUNCE_PATH: &[WrongForm] = &[
    WrongForm { of: &HEIGHT_BY_E, write: |law| e_to(law, Expr::sqrt) },
    WrongForm { of: &ONE_WAY, write: |law| series(law, |_| Expr::one()) },
    WrongForm { of: &FIRST_TWICE, write: |law| series(law, |_| Expr::integer(2)) },
    WrongForm { of: &FIRST_FORGOTTEN, write: |law| series(law, |ratio| Expr::integer(2) * ratio) },
    WrongForm { of: &ONE_OFF, write: one_off },
];

/// Wrong forms of the duration of a flight.
pub const BOUNCE_FLIGHT: &[WrongForm] = &[
    WrongForm { of: &HALF_FLIGHT, write: half_flight },
    WrongForm { of: &SPEED_BY_E_SQUARED, write: |law| e_to(law, squared) },
    WrongForm { of: &ONE_OFF, write: one_off },
];
/// Wrong forms of the place of a bounce.
pub const BOUNCE_PLACE: &[WrongForm] = &[
    WrongForm { of: &SPEED_BY_E_SQUARED, write: |law| e_to(law, squared) },
    WrongForm { of: &ONE_OFF, write: one_off },
];
/// Wrong forms of the range of a flight.
pub const BOUNCE_RANGE: &[WrongForm] = &[WrongForm { of: &ALONG_BY_E, write: along_by_e }];

/// Wrong forms of the impulse in a bounce.
pub const BOUNCE_IMPULSE: &[WrongForm] =
    &[WrongForm { of: &SPEEDS_SUBTRACTED, write: |law| e_to(law, |e| -e) }, WrongForm { of: &ONE_OFF, write: one_off }];
/// Wrong forms of the loss in a bounce.
pub const BOUNCE_LOSS: &[WrongForm] =
    &[WrongForm { of: &HEIGHT_BY_E, write: |law| e_to(law, Expr::sqrt) }, WrongForm { of: &ONE_OFF, write: one_off }];

fn squared(term: Expr) -> Expr {
    term.powi(2)
}

/// `v / g` for `2 v / g`.
fn half_flight(law: &Taught<'_>) -> Vec<Wrong> {
    one((law.left(), Expr::ratio(1, 2) * law.right()))
}

/// `e^n v` for the velocity along the floor.
fn along_by_e(law: &Taught<'_>) -> Vec<Wrong> {
    let Some((_, speed)) = law.beside("bounce-speed").next() else { return Vec::new() };
    let shrinks = |term: &Expr| match term {
        Expr::Power(pair) => law.coefficient(&pair.0).is_some().then(|| term.clone()),
        _ => None,
    };
    let Some(share) = super::rewrite::factors(speed).iter().find_map(shrinks) else { return Vec::new() };
    let along = law.meaning("-component of the velocity");
    law.replaced(&|symbol| (along == Some(symbol)).then(|| share.clone() * Expr::from(symbol)))
}

/// The coefficient of restitution made something else.
fn e_to(law: &Taught<'_>, change: fn(Expr) -> Expr) -> Vec<Wrong> {
    let e = law.meaning("coefficient of restitution");
    law.replaced(&|symbol| (e == Some(symbol)).then(|| change(symbol.into())))
}

fn one_off(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(count) = law.meaning("number of bounces") else { return Vec::new() };
    let by = |step: i64| law.replaced(&|symbol| (symbol == count).then(|| Expr::from(symbol) + Expr::integer(step)));
    [by(-1), by(1)].concat()
}

fn one_bounce(law: &Taught<'_>) -> Vec<Wrong> {
    let count = law.meaning("number of bounces");
    law.replaced(&|symbol| (count == Some(symbol)).then(Expr::one))
}

/// The sum of a geometric series with another numerator in place of `1 + q`, made from q.
fn series(law: &Taught<'_>, numerator: impl Fn(Expr) -> Expr) -> Vec<Wrong> {
    let Expr::Product(parts) = &law.sides.1 else { return Vec::new() };
    let is_numerator = |part: &&Expr| matches!(part, Expr::Sum(_)) && !law.has(part, Dimension::LENGTH);
    if parts.iter().filter(is_numerator).count() != 1 {
        return Vec::new();
    }
    let changed =
        parts.iter().map(|part| if is_numerator(&part) { numerator(part.clone() - Expr::one()) } else { part.clone() });
    one((law.left(), Expr::product(changed)))
}
