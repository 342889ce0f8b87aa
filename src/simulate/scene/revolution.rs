//! A particle that is held to a surface round the vertical, or by a cord from a point of it.

use super::vector::{Vector, add, dot, size, times};

/// The surface on which `x² s_x + y² s_y + z² s_z` is constant, for squares `s`: a sphere about the origin, a cone with its tip
/// there. z points upwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Revolution {
    pub squares: Vector,
    pub gravity: f64,
}

/// Place and velocity.
pub(super) type State = [f64; 6];

impl Revolution {
    pub(super) fn sphere(gravity: f64) -> Self {
        Self { squares: [1.0; 3], gravity }
    }

    /// A cone whose wall is so far from its axis for each metre of height.
    pub(super) fn cone(tangent: f64, gravity: f64) -> Self {
        Self { squares: [1.0, 1.0, -tangent * tangent], gravity }
    }

    /// What the surface, or the cord, adds to free fall so that the particle stays where it is held: at right angles to the
    /// surface, and as strong as half the second derivative of the constant, where that changes, says.
    pub(super) fn held(&self, state: &State, changes: f64) -> Vector {
        let (place, velocity) = parts(state);
        let weighed = |vector: Vector| [0, 1, 2].map(|own| self.squares[own] * vector[own]);
        let normal = weighed(place);
        let missing = changes - dot(velocity, weighed(velocity)) - dot(normal, self.falling());
        times(missing / dot(normal, normal), normal)
    }

    pub(super) fn slope(&self, state: &State, changes: f64) -> State {
        let [_, _, _, u, v, w] = *state;
        let [a, b, c] = add(self.falling(), self.held(state, changes));
        [u, v, w, a, b, c]
    }

    fn falling(&self) -> Vector {
        [0.0, 0.0, -self.gravity]
    }
}

pub(super) fn parts(&[x, y, z, u, v, w]: &State) -> (Vector, Vector) {
    ([x, y, z], [u, v, w])
}

/// The distance from the axis.
pub(super) fn distance(state: &State) -> f64 {
    libm::hypot(state[0], state[1])
}

/// How fast the particle goes round the axis, counter-clockwise positive from above.
pub(super) fn around(state: &State) -> f64 {
    (state[0] * state[4] - state[1] * state[3]) / distance(state)
}

/// The speed.
pub(super) fn speed(state: &State) -> f64 {
    size(parts(state).1)
}

/// A steady circle of a cord of a length at an angle with the vertical.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    pub length: f64,
    pub angle: f64,
    pub speed: f64,
}

impl Circle {
    /// The circle on which the particle neither rises nor sinks: what two speeds would do says which one that is.
    pub(super) fn steady(length: f64, angle: f64, gravity: f64) -> Self {
        let still = Self { length, angle, speed: 0.0 };
        let rises = |speed: f64| Revolution::sphere(gravity).slope(&Self { speed, ..still }.state(), 0.0)[5];
        let unit = libm::sqrt(gravity * length);
        Self { speed: unit * libm::sqrt(rises(0.0) / (rises(0.0) - rises(unit))), ..still }
    }

    /// The circle of a length on which a quantity, which grows with the angle, has a value.
    pub(super) fn with(length: f64, gravity: f64, wanted: f64, quantity: &dyn Fn(&Self) -> f64) -> Self {
        let (mut low, mut high) = (0.0, core::f64::consts::FRAC_PI_2);
        loop {
            let middle = Self::steady(length, f64::midpoint(low, high), gravity);
            if middle.angle <= low || middle.angle >= high {
                return middle;
            }
            if quantity(&middle) < wanted { low = middle.angle } else { high = middle.angle }
        }
    }

    pub(super) fn radius(&self) -> f64 {
        self.length * libm::sin(self.angle)
    }

    pub(super) fn state(&self) -> State {
        [self.radius(), 0.0, -self.length * libm::cos(self.angle), 0.0, self.speed, 0.0]
    }

    /// The pull of the cord for each kilogram.
    pub(super) fn pull(&self, gravity: f64) -> f64 {
        size(Revolution::sphere(gravity).held(&self.state(), 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At 45° the square of the speed is g r; the cord carries √2 times the weight.
    #[test]
    fn a_steady_circle_is_that_of_the_books() {
        let circle = Circle::steady(2.0, core::f64::consts::FRAC_PI_4, 10.0);
        assert!((circle.speed * circle.speed - 10.0 * circle.radius()).abs() < 1e-12, "{circle:?}");
        assert!((circle.pull(10.0) - 200.0_f64.sqrt()).abs() < 1e-12, "{circle:?}");
        let same = Circle::with(2.0, 10.0, circle.speed, &|own| own.speed);
        assert!((same.angle - circle.angle).abs() < 1e-14, "{same:?}");
    }

    /// At rest on a cone of 45°, half of the weight is felt along the wall: the acceleration is that of a slope.
    #[test]
    fn a_cone_is_a_slope_for_what_does_not_turn() {
        let slope = Revolution::cone(1.0, 10.0).slope(&[1.0, 0.0, 1.0, 0.0, 0.0, 0.0], 0.0);
        assert!(
            (slope[3] + 5.0).abs() < 1e-12 && (slope[5] + 5.0).abs() < 1e-12 && slope[..3] == [0.0; 3],
            "{slope:?}"
        );
    }
}
