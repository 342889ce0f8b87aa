//! Steady circles round an upright axis, and what is read off a motion round it.

use super::component::Frame;
use super::particles::{Constraint, Particle, Surface, velocity};
use super::system::System;
use super::vector::size;

/// Place and velocity, with the axis through the origin and z upwards.
pub(super) type State = [f64; 6];

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
    size(velocity(state, 0))
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
        let rises = |speed: f64| {
            let system = Self { speed, ..still }.system("", 1.0, gravity);
            system.slope(0.0, &system.state())[5]
        };
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

    /// The particle on its cord, seen from the pivot.
    pub(super) fn system<'a>(&self, name: &'a str, mass: f64, gravity: f64) -> System<'a, 6> {
        let particle = Particle {
            place: [self.radius(), 0.0, -self.length * libm::cos(self.angle)],
            falls: [0.0, 0.0, -gravity],
            ..Particle::free(name, mass, [0.0, self.speed, 0.0])
        };
        let cord = Some(Constraint::Surface(Surface::sphere()));
        System { constraint: cord, ..System::new(Frame::upright_space(), vec![particle]) }
    }

    /// The pull of the cord for each kilogram.
    pub(super) fn pull(&self, gravity: f64) -> f64 {
        let system = self.system("", 1.0, gravity);
        self.length * system.tension(0.0, &system.state()).abs()
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
        let same = Circle::with(2.0, 10.0, circle.speed, &|circle| circle.speed);
        assert!((same.angle - circle.angle).abs() < 1e-14, "{same:?}");
    }
}
