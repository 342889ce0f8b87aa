//! Motion through air or a liquid that resists it.

use momentous_expr::Expr;
use momentous_expr::Function;

use super::Law;
use super::Sides;
use super::wrong;

/// The velocity at which nothing is left to accelerate the body.
pub const TERMINAL: Law = Law {
    id: "terminal-velocity",
    name: "the balance of forces at the terminal velocity",
    statement: "At the terminal velocity the resistance balances all other forces, so that the velocity no longer changes.",
    signs: "Positive along the axis.",
    when: "The other forces do not change.",
    source: "Newton's second law with zero acceleration.",
    wrong: wrong::resistance::TERMINAL,
};

/// The velocity after a time, against a resistance in proportion to it.
pub const LINEAR: Law = Law {
    id: "velocity-against-linear-resistance",
    name: "Newton's second law with linear resistance, its variables separated",
    statement: "The difference between the velocity and the terminal velocity w decreases exponentially with time: it shrinks by the factor exp(-b t/m).",
    signs: "Velocities are positive along the axis. Without other forces the terminal velocity is zero.",
    when: "The resistance is b times the speed, and the other forces do not change.",
    source: "m dv/dt = F - b v: the integral of dv/(v - w) is -b t/m, where w = F/b.",
    wrong: wrong::resistance::LINEAR,
};

/// The speed at which a quadratic resistance is as large as what acts besides.
pub const EVEN: Law = Law {
    id: "speed-of-equal-forces",
    name: "the balance of the resistance and the other forces",
    statement: "At the speed w the resistance k w^2 is as large as all other forces together. If these drive the body, w is its terminal speed.",
    signs: "Magnitudes.",
    when: "The resistance is k times the square of the speed, and the other forces do not change.",
    source: "Newton's second law with zero acceleration.",
    wrong: wrong::resistance::EVEN,
};

/// The speed after a distance, against a resistance in proportion to its square.
pub const QUADRATIC_WAY: Law = Law {
    id: "speed-against-quadratic-resistance",
    name: "Newton's second law over a distance with quadratic resistance, its variables separated",
    statement: "Over a distance d the net force F - k v^2 shrinks by the factor exp(-2 k d/m). Without other forces the speed shrinks by exp(-k d/m).",
    signs: "Speed and other forces are positive in the direction of motion.",
    when: "The resistance is k times the square of the speed, the other forces F do not change, and the body does not turn back.",
    source: "m v dv/dx = F - k v^2: the integral of m v dv/(F - k v^2) is the distance.",
    wrong: wrong::resistance::QUADRATIC_WAY,
};

/// The speed after a time, against a resistance in proportion to its square.
pub const QUADRATIC_TIME: Law = Law {
    id: "time-against-quadratic-resistance",
    name: "Newton's second law with quadratic resistance, its variables separated",
    statement: "Without other forces, 1/v grows by k t/m. Where other forces drive the body, the ratio of w - v to w + v shrinks by the factor exp(-2 k w t/m), so that v = w tanh(k w t/m) from rest. Where they hold it back, arctan(v/w) decreases by k w t/m. At the speed w the resistance is as large as the other forces.",
    signs: "The speed is positive in the direction of motion.",
    when: "The resistance is k times the square of the speed, the other forces F do not change, and the body does not turn back.",
    source: "m dv/dt = F - k v^2: the integral of m dv/(F - k v^2) is the time.",
    wrong: wrong::resistance::QUADRATIC_TIME,
};

/// The ratio that shrinks exponentially while other forces drive a body on.
pub const SPEED_RATIO: Law = Law {
    id: "speed-ratio",
    name: "the definition of f as the ratio of w - v to w + v",
    statement: "f is the ratio of w - v to w + v, where w is the speed at which the resistance is as large as the other forces.",
    signs: "The speed is positive in the direction of motion.",
    when: "Always, by definition.",
    source: "The logarithm of this ratio is the integral of dv/(w^2 - v^2), times -2 w.",
    wrong: &[],
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&TERMINAL, &LINEAR, &EVEN, &QUADRATIC_WAY, &QUADRATIC_TIME, &SPEED_RATIO];

/// The share that is left after a time of what decreases exponentially: `exp(-b t / m)`.
#[must_use]
pub fn left(resistance: &Expr, mass: &Expr, time: &Expr) -> Expr {
    Expr::apply(Function::Exp, -(resistance.clone() * time.clone() / mass.clone()))
}

/// `w + (v_1 - w) exp(-b t / m)`, without w where no other force acts.
#[must_use]
pub fn velocity(before: &Expr, terminal: &Expr, left: &Expr) -> Expr {
    terminal.clone() + (before.clone() - terminal.clone()) * left.clone()
}

/// `w t + (m / b) (v_1 - w) (1 - exp(-b t / m))`: the way in a time.
#[must_use]
pub fn way(before: &Expr, terminal: &Expr, [mass, resistance, time]: [&Expr; 3]) -> Expr {
    let fading = mass.clone() / resistance.clone() * (before.clone() - terminal.clone());
    terminal.clone() * time.clone() + fading * (Expr::one() - left(resistance, mass, time))
}

/// `b w = F`.
#[must_use]
pub fn terminal(resistance: &Expr, terminal: &Expr, others: &Expr) -> Sides {
    (resistance.clone() * terminal.clone(), others.clone())
}

/// `F - k v_2^2 = (F - k v_1^2) exp(-2 k d / m)`, or `v_2 = v_1 exp(-k d / m)` where F is zero.
#[must_use]
pub fn quadratic_way(others: &Expr, [mass, resistance, way]: [&Expr; 3], [before, after]: [&Expr; 2]) -> Sides {
    if others.is_zero() {
        return (after.clone(), before.clone() * left(resistance, mass, way));
    }
    let net = |speed: &Expr| others.clone() - resistance.clone() * speed.clone().powi(2);
    (net(after), net(before) * left(&(Expr::integer(2) * resistance.clone()), mass, way))
}

/// `1 / v_2 = 1 / v_1 + k t / m`: without other forces.
#[must_use]
pub fn quadratic_alone([mass, resistance, time]: [&Expr; 3], [before, after]: [&Expr; 2]) -> Sides {
    let grown = resistance.clone() * time.clone() / mass.clone();
    (after.clone().powi(-1), before.clone().powi(-1) + grown)
}

/// `f = (w - v_1) / (w + v_1) exp(-2 k w t / m)`, and `w - v_2 = f (w + v_2)`.
#[must_use]
pub fn quadratic_driven(
    even: &Expr,
    ratio: &Expr,
    [mass, resistance, time]: [&Expr; 3],
    [before, after]: [&Expr; 2],
) -> [Sides; 2] {
    let first = (even.clone() - before.clone()) / (even.clone() + before.clone());
    let rate = Expr::product([Expr::integer(2), resistance.clone(), even.clone()]);
    let shrunk = (ratio.clone(), first * left(&rate, mass, time));
    [shrunk, (even.clone() - after.clone(), ratio.clone() * (even.clone() + after.clone()))]
}

/// The angle by which `arctan(v / w)` decreases: `k w t / m`.
#[must_use]
pub fn turned(even: &Expr, [mass, resistance, time]: [&Expr; 3]) -> Expr {
    Expr::product([resistance.clone(), even.clone(), time.clone()]) / mass.clone()
}
