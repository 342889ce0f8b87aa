//! Motion under the gravity of a fixed centre: energy, the shape of the orbit, and time along it.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// Energy under gravity's central force.
pub const ORBIT_ENERGY: Law = Law {
    id: "energy-under-gravity",
    name: "conservation of energy under gravity",
    statement: "Half the square of the speed minus GM over the distance from the centre stays the same.",
    signs: "The energy per unit mass; negative on a closed orbit.",
    when: "The gravity of one centre is the only force.",
    source: "Work and energy with the force of gravity, GMm/r^2.",
    wrong: wrong::orbit::ENERGY,
};

/// Speed, distance and the long axis.
pub const VIS_VIVA: Law = Law {
    id: "energy-of-an-ellipse",
    name: "the energy of an elliptic orbit",
    statement: "On an ellipse, half the square of the speed minus GM over the distance equals minus GM over the major axis, 2 a.",
    signs: "The semi-major axis is positive.",
    when: "The orbit is an ellipse.",
    source: "Conservation of energy, evaluated at the two apses.",
    wrong: wrong::orbit::ELLIPSE,
};

/// Angular momentum and shape.
pub const ORBIT_SHAPE: Law = Law {
    id: "angular-momentum-of-an-orbit",
    name: "the angular momentum of an orbit",
    statement: "Radius times transverse velocity is the square root of GM times the parameter of the orbit: a (1 - eccentricity squared) on an ellipse, twice the least distance on a parabola.",
    signs: "Positive counter-clockwise, the sense in which the body revolves.",
    when: "The gravity of one centre is the only force.",
    source: "Conservation of energy and of angular momentum, at the apses.",
    wrong: wrong::orbit::SHAPE,
};

/// The ends of the long axis.
pub const APSES: Law = Law {
    id: "apses",
    name: "the geometry of an ellipse",
    statement: "The least and the greatest distance from the focus are the semi-major axis times one minus, and one plus, the eccentricity.",
    signs: "Distances are positive; the eccentricity lies between 0 and 1.",
    when: "The orbit is an ellipse with the centre of force at a focus.",
    source: "The geometry of the ellipse.",
    wrong: wrong::orbit::APSES,
};

/// Distance by angle.
pub const CONIC: Law = Law {
    id: "orbit-by-angle",
    name: "the equation of the orbit",
    statement: "Distance times one plus the eccentricity times the cosine of the angle from the nearest point is the parameter of the orbit.",
    signs: "The angle is measured from the nearest point, in the sense of the motion.",
    when: "The gravity of one centre is the only force.",
    source: "The equation of a conic section about its focus.",
    wrong: wrong::orbit::BY_ANGLE,
};

/// Gravity holds a body on a circle.
pub const CIRCLE: Law = Law {
    id: "circular-orbit",
    name: "the condition of a circular orbit",
    statement: "On a circle the distance stays the same, nothing moves along the radius, and gravity gives the acceleration towards the centre: the speed is the square root of GM over the distance.",
    signs: "Positive counter-clockwise, the sense in which the body revolves.",
    when: "The gravity of one centre is the only force, and the orbit is a circle.",
    source: "Newton's second law towards the centre, with v^2/r and GM/r^2.",
    wrong: wrong::orbit::CIRCLE,
};

/// Kepler's third law.
pub const PERIOD: Law = Law {
    id: "keplers-third-law",
    name: "Kepler's third law",
    statement: "The square of the period is four pi squared times the cube of the semi-major axis, over GM.",
    signs: "A period is positive.",
    when: "The orbit is an ellipse.",
    source: "The area of the ellipse over the constant areal rate.",
    wrong: wrong::orbit::PERIOD,
};

/// Time along an orbit.
pub const ORBIT_TIME: Law = Law {
    id: "time-along-an-orbit",
    name: "Kepler's equation",
    statement: "The time since the nearest point follows from the area that the radius has swept out; on an ellipse with the eccentric anomaly, on a parabola in closed form.",
    signs: "Negative before the nearest point, positive after it.",
    when: "The gravity of one centre is the only force.",
    source: "Kepler's second law, integrated; Barker's equation for the parabola.",
    wrong: &[],
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[&ORBIT_ENERGY, &VIS_VIVA, &ORBIT_SHAPE, &APSES, &CONIC, &CIRCLE, &PERIOD, &ORBIT_TIME];

/// `v^2 / 2 - GM / r`.
#[must_use]
pub fn energy(gravity: &Expr, radius: &Expr, speed: &Expr) -> Expr {
    speed.clone().powi(2) / Expr::integer(2) - gravity.clone() / radius.clone()
}

/// `T^2 = 4 pi^2 a^3 / GM`.
#[must_use]
pub fn period(gravity: &Expr, axis: &Expr, period: &Expr) -> Sides {
    let four = Expr::product([Expr::integer(4), Expr::Pi.powi(2), axis.clone().powi(3)]);
    (period.clone().powi(2), four / gravity.clone())
}

/// `a (1 - ecc^2)`.
#[must_use]
pub fn parameter(axis: &Expr, eccentricity: &Expr) -> Expr {
    axis.clone() * (Expr::one() - eccentricity.clone().powi(2))
}

/// The eccentric anomaly, `atan2(r v_r / sqrt(GM a), 1 - r / a)`.
#[must_use]
pub fn anomaly(gravity: &Expr, axis: &Expr, radius: &Expr, radial: &Expr) -> Expr {
    let sine = radius.clone() * radial.clone() / (gravity.clone() * axis.clone()).sqrt();
    sine.atan2(Expr::one() - radius.clone() / axis.clone())
}

/// `sqrt(a^3 / GM) E - a r v_r / GM`: the time since the nearest point of an ellipse.
#[must_use]
pub fn time_on_ellipse(gravity: &Expr, axis: &Expr, anomaly: &Expr, radius: &Expr, radial: &Expr) -> Expr {
    let swept = (axis.clone().powi(3) / gravity.clone()).sqrt() * anomaly.clone();
    swept - Expr::product([axis.clone(), radius.clone(), radial.clone()]) / gravity.clone()
}

/// `r v_r (r + 2 q) / (3 GM)`: the time since the nearest point of a parabola, q being its distance.
#[must_use]
pub fn time_on_parabola(gravity: &Expr, least: &Expr, radius: &Expr, radial: &Expr) -> Expr {
    let area = Expr::product([radius.clone(), radial.clone(), radius.clone() + Expr::integer(2) * least.clone()]);
    area / (Expr::integer(3) * gravity.clone())
}
