//! Bouncing: the series that restitution makes of heights, times and ranges.

use momentous_expr::Expr;

use super::Law;
use super::wrong;

/// Heights of successive bounces.
pub const BOUNCE_HEIGHT: Law = Law {
    id: "bounce-height",
    name: "restitution and energy",
    statement: "Each bounce multiplies the speed by e, hence the height by the square of e.",
    signs: "Heights are positive.",
    when: "Dropped from rest on a level fixed floor; air resistance is neglected.",
    source: "Restitution at a surface, and energy between bounces.",
    wrong: wrong::bouncing::BOUNCE_HEIGHT,
};

/// Speeds of successive bounces.
pub const BOUNCE_SPEED: Law = Law {
    id: "bounce-speed",
    name: "the law of restitution",
    statement: "Each bounce multiplies the speed by e.",
    signs: "Speeds are positive.",
    when: "Dropped from rest on a level fixed floor; air resistance is neglected.",
    source: "Restitution at a surface; the ball returns with the speed with which it left.",
    wrong: wrong::bouncing::BOUNCE_SPEED,
};

/// Times of bounces.
pub const BOUNCE_TIME: Law = Law {
    id: "bounce-time",
    name: "the sum of a geometric series",
    statement: "After the first fall, each flight takes e times as long as the one before: a geometric series.",
    signs: "Measured from the release.",
    when: "Dropped from rest on a level fixed floor; air resistance is neglected.",
    source: "Restitution at a surface, and a geometric series.",
    wrong: wrong::bouncing::BOUNCE_TIME,
};

/// The whole path of a bouncing body.
pub const BOUNCE_PATH: Law = Law {
    id: "bounce-path",
    name: "the sum of a geometric series",
    statement: "After the first fall, each flight goes up and down by the height of its bounce: a geometric series.",
    signs: "Lengths are positive.",
    when: "Dropped from rest on a level fixed floor; air resistance is neglected.",
    source: "The height after n bounces, and a geometric series.",
    wrong: wrong::bouncing::BOUNCE_PATH,
};

/// Durations of successive flights.
pub const BOUNCE_FLIGHT: Law = Law {
    id: "bounce-flight",
    name: "restitution and the time of a flight",
    statement: "A flight from the floor back to it lasts twice the speed away from the floor, divided by the component of g towards the floor.",
    signs: "Durations are positive.",
    when: "A fixed smooth floor, level or sloping; air resistance is neglected.",
    source: "Restitution at a surface; the velocity away from the floor changes its sign in the flight.",
    wrong: wrong::bouncing::BOUNCE_FLIGHT,
};

/// Places of successive bounces.
pub const BOUNCE_PLACE: Law = Law {
    id: "bounce-place",
    name: "the motion along the surface",
    statement: "A smooth floor does not change the velocity along it. Along a level floor a body keeps its velocity through all bounces; along a slope its acceleration is the component of g along the slope.",
    signs: "Positive along the axis of the floor.",
    when: "A fixed smooth floor; air resistance is neglected.",
    source: "A smooth floor exerts no impulse along itself; the kinematics of constant acceleration.",
    wrong: wrong::bouncing::BOUNCE_PLACE,
};

/// The distance between successive bounces.
pub const BOUNCE_RANGE: Law = Law {
    id: "bounce-range",
    name: "the range of one flight",
    statement: "From one bounce to the next, a body moves along the floor by its velocity along it times the time of the flight, plus, on a slope, half its acceleration times the time squared.",
    signs: "Positive along the axis of the floor.",
    when: "A fixed smooth floor; air resistance is neglected.",
    source: "A smooth floor exerts no impulse along itself; the kinematics of constant acceleration.",
    wrong: wrong::bouncing::BOUNCE_RANGE,
};

/// The impulse of the floor in one bounce.
pub const BOUNCE_IMPULSE: Law = Law {
    id: "bounce-impulse",
    name: "the principle of impulse and momentum",
    statement: "The impulse of the floor in a bounce is the mass times the sum of the speeds just before and just after: (1 + e) times the speed before.",
    signs: "Positive away from the floor.",
    when: "A fixed smooth floor; in the short contact, the impulse of weight is negligible.",
    source: "The principle of impulse and momentum, and restitution at a surface.",
    wrong: wrong::bouncing::BOUNCE_IMPULSE,
};

/// The energy lost in bounces.
pub const BOUNCE_LOSS: Law = Law {
    id: "bounce-loss",
    name: "restitution and kinetic energy",
    statement: "A bounce leaves the square of e of the kinetic energy of the motion towards the floor, and loses the rest; all bounces together lose all of it.",
    signs: "A loss is positive.",
    when: "A fixed smooth floor; air resistance is neglected.",
    source: "Restitution at a surface, and the definition of kinetic energy.",
    wrong: wrong::bouncing::BOUNCE_LOSS,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &BOUNCE_HEIGHT,
    &BOUNCE_SPEED,
    &BOUNCE_TIME,
    &BOUNCE_PATH,
    &BOUNCE_FLIGHT,
    &BOUNCE_PLACE,
    &BOUNCE_RANGE,
    &BOUNCE_IMPULSE,
    &BOUNCE_LOSS,
];

/// `h_n = e^(2 n) h_0`.
#[must_use]
pub fn bounce_height(e: &Expr, count: &Expr, drop: &Expr) -> Expr {
    e.clone().power(Expr::integer(2) * count.clone()) * drop.clone()
}

/// `v_n = e^n sqrt(2 g h_0)`.
#[must_use]
pub fn bounce_speed(e: &Expr, count: &Expr, gravity: &Expr, drop: &Expr) -> Expr {
    e.clone().power(count.clone()) * Expr::product([Expr::integer(2), gravity.clone(), drop.clone()]).sqrt()
}

/// The time of the first fall, `sqrt(2 h_0 / g)`.
#[must_use]
pub fn first_fall(gravity: &Expr, drop: &Expr) -> Expr {
    (Expr::integer(2) * drop.clone() / gravity.clone()).sqrt()
}

/// `1 + e + ... + e^(count - 1)`; where nothing is lost, as many terms of 1.
fn series(e: &Expr, count: &Expr) -> Expr {
    if e.is_one() {
        return count.clone();
    }
    (Expr::one() - e.clone().power(count.clone())) / (Expr::one() - e.clone())
}

/// The time at which the n-th bounce happens: `t_0 (1 + 2 e (1 - e^(n-1)) / (1 - e))`, `t_0` the time of the first fall.
#[must_use]
pub fn bounce_time(e: &Expr, count: &Expr, first: &Expr) -> Expr {
    let one = Expr::one();
    let series = series(e, &(count.clone() - one.clone()));
    first.clone() * (one + Expr::product([Expr::integer(2), e.clone(), series]))
}

/// The time after which all bounces are over: `t_0 (1 + e) / (1 - e)`.
#[must_use]
pub fn total_time(e: &Expr, first: &Expr) -> Expr {
    Expr::product([first.clone(), Expr::one() + e.clone(), (Expr::one() - e.clone()).powi(-1)])
}

/// The path up to the n-th bounce: `h_0 (1 + 2 e^2 (1 - e^(2 (n-1))) / (1 - e^2))`.
#[must_use]
pub fn path_to(e: &Expr, count: &Expr, drop: &Expr) -> Expr {
    let (one, square) = (Expr::one(), e.clone().powi(2));
    let flights = Expr::integer(2) * (count.clone() - one.clone());
    let series = if e.is_one() {
        count.clone() - one.clone()
    } else {
        (one.clone() - e.clone().power(flights)) / (one.clone() - square.clone())
    };
    drop.clone() * (one + Expr::product([Expr::integer(2), square, series]))
}

/// The whole path: `h_0 (1 + e^2) / (1 - e^2)`.
#[must_use]
pub fn total_path(e: &Expr, drop: &Expr) -> Expr {
    let square = e.clone().powi(2);
    Expr::product([drop.clone(), Expr::one() + square.clone(), (Expr::one() - square).powi(-1)])
}

/// `v_n = e^n u`, `u` the speed of the first arrival.
#[must_use]
pub fn speed_after(e: &Expr, count: &Expr, arrival: &Expr) -> Expr {
    e.clone().power(count.clone()) * arrival.clone()
}

/// `h_n = v_n^2 / (2 g)`.
#[must_use]
pub fn height_of(speed: &Expr, gravity: &Expr) -> Expr {
    speed.clone().powi(2) / (Expr::integer(2) * gravity.clone())
}

/// The duration of the flight that begins with this speed: `2 v / g`.
#[must_use]
pub fn flight(speed: &Expr, gravity: &Expr) -> Expr {
    Expr::integer(2) * speed.clone() / gravity.clone()
}

/// The time from the first bounce to the n-th: `T e (1 - e^(n-1)) / (1 - e)`, `T` the duration of a flight that begins with
/// the speed of the first arrival.
#[must_use]
pub fn time_to(e: &Expr, count: &Expr, whole: &Expr) -> Expr {
    Expr::product([whole.clone(), e.clone(), series(e, &(count.clone() - Expr::one()))])
}

/// The time from the first bounce to the end of all: `T e / (1 - e)`.
#[must_use]
pub fn time_of_all(e: &Expr, whole: &Expr) -> Expr {
    Expr::product([whole.clone(), e.clone(), (Expr::one() - e.clone()).powi(-1)])
}

/// The way along the floor in a time: `v t + a t^2 / 2`.
#[must_use]
pub fn along(velocity: &Expr, acceleration: &Expr, time: &Expr) -> Expr {
    let gained = Expr::product([Expr::ratio(1, 2), acceleration.clone(), time.clone().powi(2)]);
    velocity.clone() * time.clone() + gained
}

/// `J_n = m (1 + e) e^(n-1) u`, `u` the speed of the first arrival.
#[must_use]
pub fn bounce_impulse(mass: &Expr, e: &Expr, count: &Expr, arrival: &Expr) -> Expr {
    let before = e.clone().power((count.clone() - Expr::one()).simplify());
    Expr::product([mass.clone(), Expr::one() + e.clone(), before, arrival.clone()])
}

/// The loss in the n-th bounce: `m (1 - e^2) e^(2 (n-1)) u^2 / 2`.
#[must_use]
pub fn bounce_loss(mass: &Expr, e: &Expr, count: &Expr, squared: &Expr) -> Expr {
    let before = e.clone().power((Expr::integer(2) * (count.clone() - Expr::one())).simplify());
    Expr::product([Expr::ratio(1, 2), mass.clone(), Expr::one() - e.clone().powi(2), before, squared.clone()])
        .simplify()
}

/// The loss in all bounces: `m u^2 / 2`.
#[must_use]
pub fn loss_in_all(mass: &Expr, squared: &Expr) -> Expr {
    Expr::product([Expr::ratio(1, 2), mass.clone(), squared.clone()]).simplify()
}
