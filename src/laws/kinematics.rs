//! Motion between impacts: free fall, flight and uniform motion.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// Speed reached in a fall.
pub const FALL_SPEED: Law = Law {
    id: "fall-speed",
    name: "conservation of energy in free fall",
    statement: "The square of the speed increases by 2 g times the height fallen.",
    signs: "The height fallen is positive.",
    when: "Weight is the only force; air resistance is neglected.",
    source: "Work and energy with weight alone.",
    wrong: wrong::kinematics::FALL_SPEED,
};

/// Velocity and time in a fall.
pub const FALL_TIME: Law = Law {
    id: "fall-time",
    name: "the principle of impulse and momentum for weight alone",
    statement: "A falling body's downward velocity increases by g times the time.",
    signs: "Velocities along the axis are positive.",
    when: "Weight is the only force; air resistance is neglected.",
    source: "The principle of impulse and momentum, divided by the mass.",
    wrong: wrong::kinematics::FALL_TIME,
};

/// Uniform motion.
pub const UNIFORM: Law = Law {
    id: "uniform-motion",
    name: "the kinematics of uniform motion",
    statement: "If no force acts on a body along an axis, its displacement along the axis is its velocity times the time.",
    signs: "Positive along the axis.",
    when: "No force acts along the axis.",
    source: "The definition of velocity, integrated over time.",
    wrong: wrong::kinematics::UNIFORM,
};

/// Displacement under forces that stay the same.
pub const MEAN_VELOCITY: Law = Law {
    id: "mean-velocity",
    name: "the kinematics of constant acceleration",
    statement: "If the velocity of a body changes evenly, its displacement is the mean of its velocities before and after, times the time.",
    signs: "Positive along the axis.",
    when: "The net force along the axis does not change.",
    source: "The velocity under constant acceleration, integrated over time.",
    wrong: wrong::kinematics::MEAN_VELOCITY,
};

/// Place in free flight.
pub const FLIGHT_PLACE: Law = Law {
    id: "flight-place",
    name: "the kinematics of free flight",
    statement: "A body in free flight moves by its initial velocity times the time; vertically, it also falls by half of g times the time squared.",
    signs: "Positive along the axis; g is negative where the axis points up.",
    when: "Weight is the only force; air resistance is neglected.",
    source: "The velocity under constant acceleration, integrated over time.",
    wrong: wrong::kinematics::FLIGHT_PLACE,
};

/// Vertical velocity and height in free flight.
pub const FLIGHT_SPEED: Law = Law {
    id: "flight-speed",
    name: "conservation of energy in free flight",
    statement: "The square of the vertical velocity changes by 2 g times the height fallen; the horizontal velocity stays the same.",
    signs: "Positive along the axis; g is negative where the axis points up.",
    when: "Weight is the only force; air resistance is neglected.",
    source: "Work and energy with weight alone, minus the kinetic energy of the horizontal motion, which stays the same.",
    wrong: wrong::kinematics::FALL_SPEED,
};

/// The top of a path.
pub const TOP: Law = Law {
    id: "top-of-the-path",
    name: "the condition at the top of the path",
    statement: "At the top of its path a body has no vertical velocity.",
    signs: "As for the velocities.",
    when: "Always.",
    source: "The height is greatest where its rate of change is zero.",
    wrong: &[],
};

/// The condition at the end of a motion.
pub const UNTIL: Law = Law {
    id: "end-of-the-motion",
    name: "the condition at the end of the motion",
    statement: "The motion is followed until a body reaches a position, or bodies meet.",
    signs: "As for the positions.",
    when: "As the problem states.",
    source: "The problem.",
    wrong: &[],
};

/// Times add up.
pub const CLOCK: Law = Law {
    id: "times-add-up",
    name: "the sum of the times",
    statement: "The time from the start is the sum of the durations of all stages so far; impacts take no time.",
    signs: "Measured from the start.",
    when: "Always.",
    source: "The meaning of a duration.",
    wrong: &[],
};

/// A body that has come to rest.
pub const REST: Law = Law {
    id: "rest",
    name: "the meaning of rest",
    statement: "A body at rest has zero velocity.",
    signs: "None.",
    when: "At the instant of rest.",
    source: "Kinematics.",
    wrong: &[],
};

/// Bodies that move with one velocity.
pub const TOGETHER: Law = Law {
    id: "same-velocity",
    name: "the condition that both have the same velocity",
    statement: "Bodies whose distance does not change at an instant have the same velocity along the line that joins them; so do the ends of a taut string.",
    signs: "As for the velocities.",
    when: "A string is taut, or a spring between the bodies has its greatest deformation.",
    source: "Kinematics.",
    wrong: &[],
};

/// A path that stays straight.
pub const STRAIGHT: Law = Law {
    id: "straight-path",
    name: "the condition that the path is straight",
    statement: "Where every force along the plane of motion acts along the velocity, the direction of the velocity stays the same: each component changes as the speed does.",
    signs: "As for the velocities; a speed is never negative.",
    when: "Nothing acts across the motion, and the body does not turn back.",
    source: "The principle of impulse and momentum across the motion.",
    wrong: &[],
};

/// A string over movable pulleys.
pub const STRANDS: Law = Law {
    id: "string-over-movable-pulleys",
    name: "the constraint of the string",
    statement: "The length of the string is constant, so the velocity of each body times the number of strands on which it hangs is the same.",
    signs: "As for the velocities, along the string.",
    when: "The string is taut and does not stretch, and the strands of a movable pulley are parallel.",
    source: "Kinematics: the time derivative of the string's length is zero.",
    wrong: wrong::kinematics::STRANDS,
};

/// A displacement leads from one place to another.
pub const DISPLACED: Law = Law {
    id: "place-after-a-displacement",
    name: "the definition of displacement",
    statement: "The final position of a body is its initial position plus its displacement.",
    signs: "Positive along the axis.",
    when: "Always.",
    source: "The definition.",
    wrong: &[],
};

/// Counting until a condition holds.
pub const COUNT: Law = Law {
    id: "count",
    name: "counting",
    statement: "The number sought is the first whole number for which the condition holds.",
    signs: "Whole numbers from 1 upwards.",
    when: "What is compared grows or shrinks steadily with the number.",
    source: "The meaning of the question.",
    wrong: &[],
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &FALL_SPEED,
    &FALL_TIME,
    &UNIFORM,
    &MEAN_VELOCITY,
    &FLIGHT_PLACE,
    &FLIGHT_SPEED,
    &TOP,
    &UNTIL,
    &REST,
    &TOGETHER,
    &STRAIGHT,
    &STRANDS,
    &DISPLACED,
    &COUNT,
    &CLOCK,
];

/// `v_2^2 = v_1^2 + 2 g h`.
#[must_use]
pub fn fall_speed(gravity: &Expr, height: &Expr, before: &Expr, after: &Expr) -> Sides {
    let gained = Expr::product([Expr::integer(2), gravity.clone(), height.clone()]);
    (after.clone().powi(2), before.clone().powi(2) + gained)
}

/// `r_2 = r_1 + v t`.
#[must_use]
pub fn uniform(from: &Expr, velocity: &Expr, time: &Expr, to: &Expr) -> Sides {
    (to.clone(), from.clone() + velocity.clone() * time.clone())
}

/// `r_2 - r_1 = (v_1 + v_2)/2 t`.
#[must_use]
pub fn mean_velocity([from, to]: [&Expr; 2], [before, after]: [&Expr; 2], time: &Expr) -> Sides {
    let mean = Expr::ratio(1, 2) * (before.clone() + after.clone());
    (to.clone() - from.clone(), mean * time.clone())
}

/// `r_2 = r_1 + v_1 t + a t^2 / 2`.
#[must_use]
pub fn accelerated(from: &Expr, velocity: &Expr, acceleration: &Expr, time: &Expr, to: &Expr) -> Sides {
    let gained = Expr::product([Expr::ratio(1, 2), acceleration.clone(), time.clone().powi(2)]);
    (to.clone(), Expr::sum([from.clone(), velocity.clone() * time.clone(), gained]))
}

/// `v_2^2 = v_1^2 + 2 a (r_2 - r_1)`.
#[must_use]
pub fn flight_speed(acceleration: &Expr, [from, to]: [&Expr; 2], before: &Expr, after: &Expr) -> Sides {
    let moved = to.clone() - from.clone();
    (after.clone().powi(2), before.clone().powi(2) + Expr::product([Expr::integer(2), acceleration.clone(), moved]))
}
