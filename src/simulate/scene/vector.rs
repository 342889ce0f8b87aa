//! Vectors along the axes of a scene: those that it has not are zero.

use momentous_scene::Axis;

/// Components along x, y and z.
pub type Vector = [f64; 3];

/// No vector at all.
pub(super) const ZERO: Vector = [0.0; 3];

/// The unit vector along an axis.
pub(super) fn unit(axis: Axis) -> Vector {
    match axis {
        Axis::X => [1.0, 0.0, 0.0],
        Axis::Y => [0.0, 1.0, 0.0],
        Axis::Z => [0.0, 0.0, 1.0],
    }
}

/// The component along an axis.
pub(super) fn part([x, y, z]: Vector, axis: Axis) -> f64 {
    match axis {
        Axis::X => x,
        Axis::Y => y,
        Axis::Z => z,
    }
}

/// The vector that stands in a state from a place on.
pub(super) fn within(state: &[f64], from: usize) -> Vector {
    core::array::from_fn(|part| state[from + part])
}

pub(super) fn add(one: Vector, other: Vector) -> Vector {
    [one[0] + other[0], one[1] + other[1], one[2] + other[2]]
}

pub(super) fn less(one: Vector, other: Vector) -> Vector {
    [one[0] - other[0], one[1] - other[1], one[2] - other[2]]
}

pub(super) fn times(factor: f64, vector: Vector) -> Vector {
    vector.map(|component| factor * component)
}

pub(super) fn dot(one: Vector, other: Vector) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

/// The moment of one vector at the place of the other.
pub(super) fn cross([x, y, z]: Vector, [u, v, w]: Vector) -> Vector {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

pub(super) fn size(vector: Vector) -> f64 {
    libm::sqrt(dot(vector, vector))
}

/// A vector of the plane turned counter-clockwise.
pub(super) fn turned([x, y, z]: Vector, angle: f64) -> Vector {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    [cos * x - sin * y, sin * x + cos * y, z]
}

/// A vector of the plane turned by a right angle, counter-clockwise.
pub(super) fn across([x, y, z]: Vector) -> Vector {
    [-y, x, z]
}
