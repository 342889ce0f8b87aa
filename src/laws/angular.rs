//! Angular momentum about a fixed point.

use momentous_expr::Expr;

use super::Law;
use super::wrong;

/// The moment of momentum.
pub const ANGULAR_MOMENTUM: Law = Law {
    id: "angular-momentum",
    name: "the definition of angular momentum",
    statement: "The angular momentum of a particle about a fixed point is the moment of its momentum: perpendicular distance times momentum. That of a system is the sum over its particles. A body that turns about a fixed axis has its moment of inertia times its angular velocity.",
    signs: "In a plane, the sense from x towards y is positive; in space, the right-hand rule holds for each axis.",
    when: "About a fixed point, or about the centre of mass.",
    source: "Definition, H = r x m v.",
    wrong: wrong::angular::ANGULAR_MOMENTUM,
};

/// Angular impulse and momentum.
pub const ANGULAR_IMPULSE: Law = Law {
    id: "angular-impulse-momentum",
    name: "the principle of angular impulse and momentum",
    statement: "The angular momentum about a fixed point at the end equals that at the start plus the angular impulses of the moments about that point.",
    signs: "Counter-clockwise is positive.",
    when: "About a fixed point, or about the centre of mass.",
    source: "The moment of Newton's second law, integrated over time.",
    wrong: wrong::angular::ANGULAR_IMPULSE,
};

/// The moment of a force.
pub const MOMENT: Law = Law {
    id: "moment-of-a-force",
    name: "the definition of the moment of a force",
    statement: "The moment of a force about a point is its perpendicular distance times the force; that of several forces is their sum.",
    signs: "In a plane, the sense from x towards y is positive; in space, the right-hand rule holds for each axis.",
    when: "Always.",
    source: "Definition, M = r x F.",
    wrong: wrong::angular::MOMENT,
};

/// The rate of change of angular momentum.
pub const RATE: Law = Law {
    id: "rate-of-angular-momentum",
    name: "the moment equation",
    statement: "The rate of change of the angular momentum about a fixed point is the sum of the moments of the forces about that point.",
    signs: "As for the moments.",
    when: "About a fixed point, or about the centre of mass.",
    source: "The moment of Newton's second law.",
    wrong: wrong::angular::RATE,
};

/// Conservation of angular momentum.
pub const CONSERVATION: Law = Law {
    id: "conservation-of-angular-momentum",
    name: "conservation of angular momentum",
    statement: "If no external moment about a fixed point acts on a system, its angular momentum about that point stays the same.",
    signs: "In a plane, the sense from x towards y is positive; in space, the right-hand rule holds for each axis.",
    when: "No external force has a moment about the point; the moments of internal forces cancel in pairs.",
    source: "The principle of angular impulse and momentum, with no angular impulse.",
    wrong: wrong::angular::CONSERVATION,
};

/// The integral of a moment.
pub const MOMENT_IMPULSE: Law = Law {
    id: "angular-impulse",
    name: "the definition of angular impulse",
    statement: "The angular impulse of a moment is its integral over time.",
    signs: "Counter-clockwise is positive.",
    when: "Always; a constant moment gives moment times time.",
    source: "Definition.",
    wrong: wrong::angular::MOMENT_IMPULSE,
};

/// Conservation for a particle about the centre of a central force, or about an axis.
pub const CENTRAL: Law = Law {
    id: "central-force",
    name: "conservation of the angular momentum of a particle",
    statement: "Where no force on a particle has a moment about a fixed point or axis, its distance from there times its transverse velocity stays the same.",
    signs: "Counter-clockwise is positive.",
    when: "Every force on the particle points to or from the fixed point, or has no moment about the axis.",
    source: "The principle of angular impulse and momentum, divided by the mass.",
    wrong: wrong::angular::CENTRAL,
};

/// Kepler's second law.
pub const AREAL: Law = Law {
    id: "areal-rate",
    name: "Kepler's second law",
    statement: "The radius sweeps out area at the constant rate of half the radius times the transverse velocity.",
    signs: "Counter-clockwise is positive.",
    when: "Under a central force.",
    source: "The area of a thin triangle, and conservation of angular momentum.",
    wrong: wrong::angular::AREAL,
};

/// The period of a rotation.
pub const REVOLUTION: Law = Law {
    id: "period-of-a-rotation",
    name: "the definition of the period",
    statement: "The angular velocity times the time of a revolution is two pi.",
    signs: "Positive in the sense in which it turns.",
    when: "The angular velocity does not change.",
    source: "Definition: the angle of a revolution is two pi.",
    wrong: &[],
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &ANGULAR_MOMENTUM,
    &MOMENT,
    &RATE,
    &MOMENT_IMPULSE,
    &ANGULAR_IMPULSE,
    &CONSERVATION,
    &CENTRAL,
    &AREAL,
    &REVOLUTION,
];

/// The moments of a vector at a place: one in a plane, one for each axis in space, and none along a line.
#[must_use]
pub fn moments(place: &[Expr], vector: &[Expr]) -> Vec<Expr> {
    let about = |one: usize, other: usize| {
        place[one].clone() * vector[other].clone() - place[other].clone() * vector[one].clone()
    };
    match (place, vector) {
        ([_, _], [_, _]) => vec![about(0, 1)],
        ([_, _, _], [_, _, _]) => vec![about(1, 2), about(2, 0), about(0, 1)],
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_turn_from_each_axis_to_the_next() {
        let of = |values: &[i64]| values.iter().map(|value| Expr::integer(*value)).collect::<Vec<_>>();
        // i x j = k, and so round; (1, 2, 3) x (4, 5, 6) = (12 - 15, 12 - 6, 5 - 8).
        assert_eq!(moments(&of(&[1, 0, 0]), &of(&[0, 1, 0])), of(&[0, 0, 1]));
        assert_eq!(moments(&of(&[1, 2, 3]), &of(&[4, 5, 6])), of(&[-3, 6, -3]));
        assert_eq!(moments(&of(&[3, 1]), &of(&[2, 5])), of(&[13]));
        assert!(moments(&of(&[3]), &of(&[2])).is_empty());
    }
}
