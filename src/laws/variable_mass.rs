//! Streams that are turned or caught, and bodies that throw mass away.

use momentous_expr::Expr;
use momentous_expr::Function;

use super::Law;
use super::Sides;
use super::wrong;

/// The mass that a stream brings in a given time.
pub const FLOW: Law = Law {
    id: "mass-flow",
    name: "the conservation of mass in a stream",
    statement: "The mass that reaches a body per unit time is the density times the cross-section times the speed of the stream relative to the body.",
    signs: "A flow is positive.",
    when: "The stream is steady. If many vanes follow each other, nothing passes between them and the full speed of the stream counts.",
    source: "The volume of the stream that arrives in a short time.",
    wrong: wrong::variable_mass::FLOW,
};

/// The force of a steady stream.
pub const STREAM: Law = Law {
    id: "force-of-a-stream",
    name: "the principle of impulse and momentum for a steady stream",
    statement: "The force of a stream on a body is the mass flow times the change of the stream's velocity, from before the body to after it.",
    signs: "Components along the axes; the velocities are relative to the body, which moves at constant velocity.",
    when: "The stream is steady, so that the momentum of what is just passing stays the same.",
    source: "The principle of impulse and momentum for what arrives in a short time, and the third law.",
    wrong: wrong::variable_mass::STREAM,
};

/// Power of a force.
pub const POWER: Law = Law {
    id: "power-of-a-force",
    name: "the definition of power",
    statement: "The power of a force is its component along the velocity of the body times the speed.",
    signs: "Positive if the force drives the body.",
    when: "Always.",
    source: "Definition.",
    wrong: wrong::variable_mass::POWER,
};

/// The support of a body that catches a stream.
pub const SUPPORT: Law = Law {
    id: "support-of-a-stream",
    name: "the balance of forces on what catches a stream",
    statement: "A support carries the weight of the body, the weight of what it has caught, and the force of the stream.",
    signs: "The push of the support is positive upwards.",
    when: "The body stays at rest.",
    source: "Newton's second law, where nothing accelerates but the stream.",
    wrong: wrong::variable_mass::SUPPORT,
};

/// Thrust.
pub const THRUST: Law = Law {
    id: "thrust",
    name: "the law of thrust",
    statement: "The thrust of a rocket is the mass that it expels per unit time, times the speed of this mass relative to the rocket.",
    signs: "Positive against the direction of the exhaust.",
    when: "The exhaust leaves with a steady speed relative to the rocket.",
    source: "The principle of impulse and momentum for the rocket and what it expels in a short time.",
    wrong: &[],
};

/// The rocket equation.
pub const ROCKET: Law = Law {
    id: "rocket-equation",
    name: "the rocket equation",
    statement: "The velocity increases by the exhaust speed times the logarithm of the ratio of the masses before and after; weight reduces it by g times the time.",
    signs: "Positive along the axis; the exhaust speed is relative to the rocket.",
    when: "The exhaust leaves with a steady speed relative to the rocket, and no other force than weight acts.",
    source: "The thrust divided by the mass that is left, integrated over time.",
    wrong: wrong::variable_mass::ROCKET,
};

/// The rocket equation with resistance.
pub const ROCKET_DRAG: Law = Law {
    id: "rocket-against-resistance",
    name: "the rocket equation with resistance, its variables separated",
    statement: "Velocity on one side, mass on the other: the ratio of (w - v) to (w + v), w being the speed at which resistance equals the thrust, is proportional to a power of the mass.",
    signs: "The velocity is positive in the direction of flight.",
    when: "Flow and exhaust speed are steady, the resistance grows with the square of the speed, and weight has no component along the motion.",
    source: "m dv/dt = thrust - k v^2 with dm/dt = -flow, integrated.",
    wrong: &[],
};

/// The speed at which resistance equals thrust.
pub const EVEN_SPEED: Law = Law {
    id: "speed-at-which-resistance-equals-thrust",
    name: "the balance of thrust and resistance",
    statement: "At the speed w the resistance k w^2 equals the thrust.",
    signs: "Speeds are positive.",
    when: "The resistance grows with the square of the speed.",
    source: "Newton's second law with zero acceleration.",
    wrong: wrong::resistance::EVEN,
};

/// Mass used up.
pub const USED: Law = Law {
    id: "mass-thrown-away",
    name: "the conservation of mass",
    statement: "The mass that a body has lost or gained is the mass flow times the time.",
    signs: "A flow is positive.",
    when: "The flow is steady.",
    source: "The meaning of a flow.",
    wrong: wrong::stream::MASS_LEFT,
};

/// When a rocket lifts off.
pub const LIFT_OFF: Law = Law {
    id: "lift-off",
    name: "the condition of lift-off",
    statement: "A rocket lifts off as soon as its thrust equals its remaining weight.",
    signs: "Magnitudes.",
    when: "The rocket stands on the ground until then.",
    source: "Newton's second law: the push of the ground becomes zero.",
    wrong: wrong::variable_mass::LIFT_OFF,
};

/// The way of a rocket while it burns.
pub const BURN_HEIGHT: Law = Law {
    id: "way-during-the-burn",
    name: "the rocket equation, integrated over time",
    statement: "The distance travelled during the burn is the integral of the velocity. The thrust contributes the exhaust speed times the time times 1 - m_2/(m_1 - m_2) ln(m_1/m_2), m_1 and m_2 being the masses before and after.",
    signs: "Positive along the axis.",
    when: "The flow and the exhaust speed are steady, and g does not change.",
    source: "The rocket equation, its logarithm integrated by parts.",
    wrong: wrong::variable_mass::BURN_WAY,
};

/// The acceleration of what becomes lighter.
pub const ACCELERATION: Law = Law {
    id: "acceleration-under-thrust",
    name: "the equation of motion of a rocket",
    statement: "The mass that a rocket still has, times its acceleration, is the sum of the thrust and all other forces on it.",
    signs: "Positive along the axis.",
    when: "What leaves the rocket is counted by the thrust, not by the mass.",
    source: "The principle of impulse and momentum for the rocket and what it expels in a short time.",
    wrong: wrong::variable_mass::ACCELERATION,
};

/// A body that gains mass.
pub const GAINING: Law = Law {
    id: "momentum-with-gained-mass",
    name: "the principle of impulse and momentum for a body that gains mass",
    statement: "The momentum of a body at the start, plus the momentum that the arriving mass brings, plus the impulses of the forces, is the momentum of the body with all that has joined it.",
    signs: "Velocities and impulses along the axis are positive, against it negative. What falls straight down brings no momentum along a level axis.",
    when: "All that arrives stays on the body.",
    source: "The principle of impulse and momentum for the body together with all that will join it.",
    wrong: wrong::variable_mass::GAINING,
};

/// A body that loses mass which is not thrown.
pub const LOSING: Law = Law {
    id: "velocity-with-lost-mass",
    name: "the principle of impulse and momentum for a body that loses mass",
    statement: "The velocity changes by the force divided by the flow, times the logarithm of the ratio of the masses before and after. Without a force it stays the same.",
    signs: "Velocities and forces along the axis are positive, against it negative.",
    when: "What leaves has the velocity of the body at that instant, the flow is steady, and the forces stay the same.",
    source: "The force divided by the mass that is left, integrated over time.",
    wrong: wrong::variable_mass::LOSING,
};

/// The acceleration of a body whose mass changes.
pub const CHANGING: Law = Law {
    id: "equation-of-motion-of-changing-mass",
    name: "the equation of motion of a body whose mass changes",
    statement: "The mass that a body has at an instant, times its acceleration, is the sum of the forces on it plus the mass that arrives per unit time, times the velocity of this mass relative to the body.",
    signs: "Positive along the axis.",
    when: "What arrives stays on the body; what leaves has its velocity, and adds nothing.",
    source: "The principle of impulse and momentum for the body and what joins or leaves it in a short time.",
    wrong: wrong::variable_mass::CHANGING,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &FLOW,
    &STREAM,
    &POWER,
    &SUPPORT,
    &THRUST,
    &ACCELERATION,
    &USED,
    &ROCKET,
    &BURN_HEIGHT,
    &LIFT_OFF,
    &EVEN_SPEED,
    &ROCKET_DRAG,
    &GAINING,
    &LOSING,
    &CHANGING,
];

/// `u ln(m_1 / m_2)`: what the thrust adds to the velocity.
#[must_use]
pub fn gained(exhaust: &Expr, [before, after]: [&Expr; 2]) -> Expr {
    exhaust.clone() * Expr::apply(Function::Ln, before.clone() / after.clone())
}

/// `m_1 - m_2 = q dt`.
#[must_use]
pub fn used([before, after]: [&Expr; 2], flow: &Expr, time: &Expr) -> Sides {
    (before.clone() - after.clone(), flow.clone() * time.clone())
}

/// `u dt (1 - m_2 / (m_1 - m_2) ln(m_1 / m_2))`: the way that the thrust adds while it acts.
#[must_use]
pub fn way(exhaust: &Expr, [before, after]: [&Expr; 2], time: &Expr) -> Expr {
    let logarithm = Expr::apply(Function::Ln, before.clone() / after.clone());
    let share = after.clone() / (before.clone() - after.clone());
    Expr::product([exhaust.clone(), time.clone(), Expr::one() - share * logarithm])
}

/// `(w - v_1) / (w + v_1) (m_2 / m_1)^(2 k w / q)`: the ratio of (w - v) to (w + v) at the end.
#[must_use]
pub fn ratio_against_resistance(
    even: &Expr,
    resistance: &Expr,
    flow: &Expr,
    [before, after]: [&Expr; 2],
    start: &Expr,
) -> Expr {
    let power = Expr::product([Expr::integer(2), resistance.clone(), even.clone()]) / flow.clone();
    let first = (even.clone() - start.clone()) / (even.clone() + start.clone());
    first * (after.clone() / before.clone()).power(power)
}

/// `v_2 = w (1 - f) / (1 + f)` with the ratio f.
#[must_use]
pub fn against_resistance(even: &Expr, ratio: &Expr) -> Expr {
    Expr::product([even.clone(), Expr::one() - ratio.clone(), (Expr::one() + ratio.clone()).powi(-1)])
}

/// `m_2 = m_1 + change`.
#[must_use]
pub fn changed([before, after]: [&Expr; 2], change: &Expr) -> Sides {
    (after.clone(), before.clone() + change.clone())
}

/// `m_1 v_1 + sum = m_2 v_2`, where the sum is of the impulses and of the momentum that arrives.
#[must_use]
pub fn gaining([before, after]: [&Expr; 2], [start, end]: [&Expr; 2], given: impl IntoIterator<Item = Expr>) -> Sides {
    (Expr::sum([before.clone() * start.clone()].into_iter().chain(given)), after.clone() * end.clone())
}

/// `v_2 - v_1 = F/q ln(m_1 / m_2)`, the integral of `F / (m_1 - q t)`.
#[must_use]
pub fn losing(force: &Expr, flow: &Expr, masses: [&Expr; 2], [start, end]: [&Expr; 2]) -> Sides {
    (end.clone() - start.clone(), gained(&(force.clone() / flow.clone()), masses))
}

/// `(m_1 v_1 + F t) / m`: the velocity of a body that gains mass, at a time at which it has the mass m.
#[must_use]
pub fn velocity_gaining(drive: &Expr, [before, then]: [&Expr; 2], velocity: &Expr, time: &Expr) -> Expr {
    (before.clone() * velocity.clone() + drive.clone() * time.clone()) / then.clone()
}

/// `F/q dt + m_1/q (v_1 - F/q) ln(m_2 / m_1)`: the integral of that velocity over a time.
#[must_use]
pub fn way_gaining(drive: &Expr, flow: &Expr, [before, after]: [&Expr; 2], velocity: &Expr, time: &Expr) -> Expr {
    let even = drive.clone() / flow.clone();
    let logarithm = Expr::apply(Function::Ln, after.clone() / before.clone());
    let slower = Expr::product([before.clone() / flow.clone(), velocity.clone() - even.clone(), logarithm]);
    even * time.clone() + slower
}
