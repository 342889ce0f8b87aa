//! Motion about a fixed centre of gravity by the universal variable, which is as good near a parabola as on a circle.

use crate::state::Vector;

/// An orbit about a fixed centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit<const D: usize> {
    /// The centre of attraction.
    pub centre: Vector<D>,
    /// The gravitational parameter `mu`, in m³/s².
    pub parameter: f64,
    /// The position at the start.
    pub position: Vector<D>,
    /// The velocity at the start.
    pub velocity: Vector<D>,
}

impl<const D: usize> Orbit<D> {
    /// Position and velocity after a time, by Kepler's equation in the universal variable (Battin).
    #[must_use]
    pub fn at(&self, elapsed: f64) -> (Vector<D>, Vector<D>) {
        let root = self.parameter.sqrt();
        let start = self.position - self.centre;
        let distance = start.norm();
        let radial = start.dot(&self.velocity) / root;
        let alpha = 2.0 / distance - self.velocity.norm_squared() / self.parameter;
        let elapsed = if alpha > 0.0 {
            let period = std::f64::consts::TAU / (root * alpha * alpha.sqrt());
            elapsed % period
        } else {
            elapsed
        };
        let anomaly = universal_anomaly(distance, radial, alpha, root * elapsed);
        let z = alpha * anomaly * anomaly;
        let (c, s) = stumpff(z);
        let square = anomaly * anomaly;
        let f = 1.0 - square * c / distance;
        let g = elapsed - square * anomaly * s / root;
        let place = start * f + self.velocity * g;
        let now = place.norm();
        let f_rate = root * anomaly * (z * s - 1.0) / (now * distance);
        let g_rate = 1.0 - square * c / now;
        (self.centre + place, start * f_rate + self.velocity * g_rate)
    }
}

/// The universal anomaly: the root of a function that only rises, bracketed and then found by Newton's steps.
fn universal_anomaly(distance: f64, radial: f64, alpha: f64, target: f64) -> f64 {
    if target == 0.0 {
        return 0.0;
    }
    let residual = |x: f64| {
        let z = alpha * x * x;
        let (c, s) = stumpff(z);
        let time = radial * x * x * c + (1.0 - alpha * distance) * x * x * x * s + distance * x;
        let radius = x * x * c + radial * x * (1.0 - z * s) + distance * (1.0 - z * c);
        (time - target, radius)
    };
    let (mut left, mut right) = if target > 0.0 { (0.0, target / distance) } else { (target / distance, 0.0) };
    for _ in 0..200 {
        if target > 0.0 && residual(right).0 < 0.0 {
            (left, right) = (right, right * 2.0);
        } else if target < 0.0 && residual(left).0 > 0.0 {
            (left, right) = (left * 2.0, left);
        } else {
            break;
        }
    }
    let mut x = f64::midpoint(left, right);
    for _ in 0..200 {
        let (height, slope) = residual(x);
        if height > 0.0 {
            right = x;
        } else {
            left = x;
        }
        let newton = x - height / slope;
        let next = if newton >= left && newton <= right { newton } else { f64::midpoint(left, right) };
        if (next - x).abs() <= f64::EPSILON * x.abs() {
            return next;
        }
        x = next;
    }
    x
}

/// Stumpff's functions `(1 - cos sqrt z)/z` and `(sqrt z - sin sqrt z)/sqrt z^3`, by their series where those would cancel.
fn stumpff(z: f64) -> (f64, f64) {
    if z.abs() < 1.0 {
        let (mut c, mut s) = (0.0, 0.0);
        for k in (0..12_u32).rev() {
            let n = f64::from(2 * k);
            c = (1.0 - z * c) / ((n + 1.0) * (n + 2.0));
            s = (1.0 - z * s) / ((n + 2.0) * (n + 3.0));
        }
        return (c, s);
    }
    let root = z.abs().sqrt();
    let half = if z > 0.0 { libm::sin(root / 2.0) } else { libm::sinh(root / 2.0) };
    let s = if z > 0.0 { root - libm::sin(root) } else { libm::sinh(root) - root };
    (2.0 * half * half / z.abs(), s / (root * root * root))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference is Barker's equation for the parabola, and 40 digits for its neighbour.
    #[test]
    fn a_parabola_and_its_neighbour_keep_their_digits() {
        for (e, expected) in [(1.0, 2.080_859_460_392_876_4), (1.0 - 1e-10, 2.080_859_460_306_794)] {
            let orbit = Orbit {
                centre: Vector::zeros(),
                parameter: 1.0,
                position: Vector::from([1.0, 0.0]),
                velocity: Vector::from([0.0, libm::sqrt(1.0 + e)]),
            };
            let radius = orbit.at(2.0).0.norm();
            assert!((radius - expected).abs() < 2e-15, "e = {e}: {radius}");
        }
    }

    #[test]
    fn an_ellipse_closes() {
        let orbit = Orbit {
            centre: Vector::zeros(),
            parameter: 1.0,
            position: Vector::from([1.0, 0.0]),
            velocity: Vector::from([0.0, 1.2]),
        };
        let alpha: f64 = 2.0 - 1.44;
        let half = std::f64::consts::PI / (alpha * alpha.sqrt());
        let (apogee, _) = orbit.at(half);
        assert!((apogee.x - -(2.0 / alpha - 1.0)).abs() < 1e-14 && apogee.y.abs() < 1e-14, "{apogee}");
    }
}
