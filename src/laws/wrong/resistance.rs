//! Mistakes about motion against a resistance.

use crate::Sides;
use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::integral::ENDS_AVERAGED;
use super::rewrite::factors;
use super::rewrite::one;

/// The acceleration at the start all the way.
pub const AS_AT_FIRST: Misconception = Misconception {
    id: "resistance-as-at-first",
    does: "keeps the resistance as large as it is at first",
    ask: "Does the speed stay the same? What does that mean for the resistance?",
    hint: "The resistance changes with the speed, and so does the acceleration: formulas for constant acceleration do not hold.",
};
/// `v = v_0 + g t`.
pub const NEGLECTED: Misconception = Misconception {
    id: "resistance-neglected",
    does: "leaves out the resistance",
    ask: "Which forces act on the body on its way? Is the resistance among yours?",
    hint: "Formulas of free fall, or of constant forces, leave out the resistance.",
};
/// `v = w`.
pub const AT_ONCE: Misconception = Misconception {
    id: "terminal-velocity-at-once",
    does: "takes the body to have its terminal velocity already",
    ask: "How long does it take a body to come close to its terminal velocity?",
    hint: "The terminal velocity is approached, not reached: compare the time with the mass divided by the resistance per speed.",
};
/// `k w = m g` for `k w^2 = m g`, and the reverse.
pub const OTHER_POWER: Misconception = Misconception {
    id: "resistance-of-another-power",
    does: "lets the resistance grow with another power of the speed than it does",
    ask: "By which factor does the resistance grow when the speed is doubled?",
    hint: "Write down the resistance as the problem states it, with the speed or with its square, and check the units.",
};
/// `k w^2 / 2 = m g`.
pub const HALF_ADDED: Misconception = Misconception {
    id: "half-added-to-the-resistance",
    does: "puts a factor of one half into the resistance that the problem does not have",
    ask: "How does this problem state the resistance, and with which factor?",
    hint: "The half of the drag formula with density and area is part of that formula only.",
};
/// `exp(-k d/m)` for `exp(-2 k d/m)`, or `v` for `v^2`.
pub const APPROACH: Misconception = Misconception {
    id: "speed-for-square-in-the-approach",
    does: "lets the speed, not its square, approach its final value with the distance",
    ask: "Which quantity falls off exponentially with the distance: the net force, which has the square of the speed in it, or the speed?",
    hint: "Write Newton's law with v dv/dx, and integrate over the square of the speed: a two comes into the exponent.",
};
/// `d = v t`.
pub const ONE_SPEED: Misconception = Misconception {
    id: "one-speed-all-the-way",
    does: "divides the distance by one speed, although the speed changes on the way",
    ask: "Does the body have this speed on its whole way?",
    hint: "A distance over a speed is a time only where the speed stays the same.",
};

/// Wrong forms of the terminal velocity against a linear resistance.
pub const TERMINAL: &[WrongForm] = &[WrongForm { of: &OTHER_POWER, write: squared }];
/// Wrong forms of the terminal speed against a quadratic resistance.
pub const EVEN: &[WrongForm] = &[
    WrongForm { of: &OTHER_POWER, write: |law| law.both(unsquared) },
    WrongForm { of: &HALF_ADDED, write: |law| one((Expr::ratio(1, 2) * law.left(), law.right())) },
];
/// Wrong forms of the velocity against a linear resistance.
pub const LINEAR: &[WrongForm] = &[
    WrongForm { of: &AS_AT_FIRST, write: |law| velocity(law, [as_at_first, displaced_as_at_first]) },
    WrongForm { of: &NEGLECTED, write: |law| velocity(law, [neglected, displaced_freely]) },
    WrongForm { of: &AT_ONCE, write: |law| velocity(law, [|right| with(right, &Expr::zero()), displaced_at_once]) },
];
/// Wrong forms of the speed against a quadratic resistance.
pub const QUADRATIC_WAY: &[WrongForm] = &[
    WrongForm { of: &AS_AT_FIRST, write: way_as_at_first },
    WrongForm { of: &NEGLECTED, write: way_neglected },
    WrongForm { of: &AT_ONCE, write: |law| one((law.left(), with(&law.right(), &Expr::zero()))) },
    WrongForm { of: &APPROACH, write: approach },
];
/// Wrong forms of the time against a quadratic resistance.
pub const QUADRATIC_TIME: &[WrongForm] = &[
    WrongForm { of: &NEGLECTED, write: time_neglected },
    WrongForm { of: &AT_ONCE, write: |law| time_by_way(law, &|way| way.terminal.iter().cloned().collect()) },
    WrongForm { of: &ONE_SPEED, write: |law| time_by_way(law, &|way| way.ends.to_vec()) },
    WrongForm { of: &ENDS_AVERAGED, write: |law| time_by_way(law, &mean_of_ends) },
];

/// A law on its right side, rewritten.
type Rewrite = fn(&Expr) -> Expr;

/// The law of the velocity, by which it was taught.
const BY_TIME: &str = "velocity-against-linear-resistance";

/// The displacement as the student finds it who makes the mistake.
pub(super) fn displaced(law: &Taught<'_>, rewrite: Rewrite) -> Vec<Wrong> {
    if law.beside(BY_TIME).next().is_none() || exponent(&law.sides.1).is_none() {
        return Vec::new();
    }
    one((law.left(), rewrite(&law.sides.1)))
}

/// The velocity and the displacement, in place of what impulse and momentum would say of it.
fn velocity(law: &Taught<'_>, [velocity, displacement]: [Rewrite; 2]) -> Vec<Wrong> {
    let equation = (law.left(), velocity(&law.sides.1));
    let moved = law.beside("displacement").filter(|(_, value)| exponent(value).is_some());
    let moved = moved.map(|(moved, value)| (moved.clone(), displacement(value)));
    let equations: Vec<Sides> = [equation].into_iter().chain(moved).collect();
    vec![Wrong { equations, without: &["impulse-momentum"] }]
}

/// `x` of the `exp(x)` in a term.
fn exponent(term: &Expr) -> Option<Expr> {
    match term {
        Expr::Apply(Function::Exp, parts) => parts.first().cloned(),
        other => other.children().find_map(exponent),
    }
}

/// A term with that in place of its exponential.
fn with(term: &Expr, value: &Expr) -> Expr {
    match term {
        Expr::Apply(Function::Exp, _) => value.clone(),
        other => other.map_children(|part| with(part, value)),
    }
}

/// `exp(x)` as `1 + x`: the velocity changes as fast as at first.
fn as_at_first(right: &Expr) -> Expr {
    let Some(exponent) = exponent(right) else { return right.clone() };
    with(right, &(Expr::one() + exponent))
}

/// `exp(x)` as `1 + x + x^2 / 2`: the displacement at the acceleration of the start.
pub(super) fn displaced_as_at_first(right: &Expr) -> Expr {
    let Some(exponent) = exponent(right) else { return right.clone() };
    with(right, &(Expr::one() + exponent.clone() + Expr::ratio(1, 2) * exponent.powi(2)))
}

/// What the other forces alone do: they change the velocity by `-x` times the terminal velocity.
fn neglected(right: &Expr) -> Expr {
    let Some(exponent) = exponent(right) else { return right.clone() };
    with(right, &Expr::one()) - exponent * with(right, &Expr::zero())
}

/// The displacement under the other forces alone; for `exp(x) = 1` it would be that at the terminal velocity.
pub(super) fn displaced_freely(right: &Expr) -> Expr {
    let Some(exponent) = exponent(right) else { return right.clone() };
    let at_terminal = with(right, &Expr::one());
    with(right, &(Expr::one() + exponent.clone())) - Expr::ratio(1, 2) * exponent * at_terminal
}

/// The displacement at the terminal velocity.
fn displaced_at_once(right: &Expr) -> Expr {
    with(right, &Expr::one())
}

/// `m (v_2^2 - v_1^2) / 2` is the net force of the start times the distance.
fn way_as_at_first(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(exponent) = exponent(&law.sides.1) else { return Vec::new() };
    if matches!(law.sides.0, Expr::Sum(_)) {
        return one((law.left(), with(&law.sides.1, &(Expr::one() + exponent))));
    }
    let before = with(&law.sides.1, &Expr::one());
    one((law.left().powi(2), before.powi(2) * (Expr::one() + Expr::integer(2) * exponent)))
}

/// The other forces alone change the speed; at zero speed they are all that is left of the net force.
fn way_neglected(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(exponent) = exponent(&law.sides.1) else { return Vec::new() };
    let others = law.sides.0.substitute(&|symbol| law.is(symbol, Dimension::VELOCITY).then(Expr::zero)).simplify();
    one((law.left(), with(&law.sides.1, &Expr::one()) + exponent * others))
}

/// The exponent halved, the speed in place of its square, and both; of a law without other forces the exponent doubled.
fn approach(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(exponent) = exponent(&law.sides.1) else { return Vec::new() };
    let to = |times: Expr| with(&law.sides.1, &Expr::apply(Function::Exp, times * exponent.clone()));
    let Some(speed) = terminal(law) else {
        return one((law.left(), to(Expr::integer(2))));
    };
    let linear = |side: &Expr| {
        fn within(term: &Expr, speed: &Expr) -> Expr {
            match term {
                Expr::Power(pair) if pair.1 == Expr::integer(2) => speed.clone() * pair.0.clone(),
                other => other.map_children(|part| within(part, speed)),
            }
        }
        within(side, &speed)
    };
    let halved = to(Expr::ratio(1, 2));
    vec![
        Wrong::from((law.left(), halved.clone())),
        Wrong::from((linear(&law.sides.0), linear(&law.sides.1))),
        Wrong::from((linear(&law.sides.0), linear(&halved))),
    ]
}

/// w of `F - k v^2`, where that is zero; nothing where no other force acts.
fn terminal(law: &Taught<'_>) -> Option<Expr> {
    let at = |speed: Expr| law.sides.0.substitute(&|symbol| law.is(symbol, Dimension::VELOCITY).then(|| speed.clone()));
    let drive = at(Expr::zero()).simplify();
    let resisted = (at(Expr::one()) - drive.clone()).simplify();
    (!drive.is_zero() && matches!(law.sides.0, Expr::Sum(_))).then(|| (-drive / resisted).sqrt())
}

/// A way against a quadratic resistance: how far, the speeds before and after, the speed at which the forces are equal.
struct Way {
    distance: Expr,
    ends: [Expr; 2],
    terminal: Option<Expr>,
}

impl Way {
    fn of(law: &Taught<'_>) -> Option<Self> {
        let (after, before) = law.beside("speed-against-quadratic-resistance").next()?;
        let distance = exponent(before)?.symbols().into_iter().find(|symbol| law.is(*symbol, Dimension::LENGTH))?;
        let speed = |side: &Expr| side.symbols().into_iter().find(|symbol| law.is(*symbol, Dimension::VELOCITY));
        let terminal = law.beside("speed-of-equal-forces").find_map(|(resisted, _)| speed(resisted));
        let ends = [speed(before)?, speed(after)?].map(Expr::from);
        Some(Self { distance: distance.into(), ends, terminal: terminal.map(Expr::from) })
    }
}

/// The time of the law.
fn time(law: &Taught<'_>) -> Option<Symbol> {
    let mut all = law.sides.0.symbols();
    all.extend(law.sides.1.symbols());
    all.into_iter().find(|symbol| law.is(*symbol, Dimension::TIME) && !law.known.contains(symbol))
}

/// The distance is one of these speeds times the time.
fn time_by_way(law: &Taught<'_>, speeds: &dyn Fn(&Way) -> Vec<Expr>) -> Vec<Wrong> {
    let (Some(time), Some(way)) = (time(law), Way::of(law)) else { return Vec::new() };
    speeds(&way).into_iter().map(|speed| Wrong::from((way.distance.clone(), speed * Expr::from(time)))).collect()
}

fn mean_of_ends(way: &Way) -> Vec<Expr> {
    let [before, after] = way.ends.clone();
    vec![Expr::ratio(1, 2) * (before + after)]
}

/// `F t = m (v_2 - v_1)`, and the distance of a motion under the other forces alone.
fn time_neglected(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some(time), Some(way)) = (time(law), Way::of(law)) else { return Vec::new() };
    let Some((resisted, drive)) = law.beside("speed-of-equal-forces").next() else { return Vec::new() };
    let mass = exponent(&law.sides.1).and_then(|exponent| {
        exponent.symbols().into_iter().find(|symbol| law.is(*symbol, Dimension::MASS)).map(Expr::from)
    });
    let Some(mass) = mass.filter(|_| !resisted.is_zero()) else { return Vec::new() };
    let [before, after] = way.ends.clone();
    let time = Expr::from(time);
    let pushed = drive.clone() * time.clone();
    vec![
        Wrong::from((mass.clone() * (after - before.clone()), pushed.clone())),
        Wrong::from((way.distance, before * time.clone() + Expr::ratio(1, 2) * pushed * time / mass)),
    ]
}

/// `b w |w| = F` for `b w = F`.
fn squared(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.0);
    let Some(terminal) = parts.iter().find(|part| law.has(part, Dimension::VELOCITY)) else { return Vec::new() };
    let rest = law.left() / terminal.clone();
    let size = Expr::apply(Function::Abs, law.right());
    one((terminal.clone(), law.right() / (rest * size).sqrt()))
}

fn unsquared(term: &Expr) -> Expr {
    match term {
        Expr::Power(pair) if pair.1 == Expr::integer(2) => pair.0.clone(),
        other => other.map_children(unsquared),
    }
}
