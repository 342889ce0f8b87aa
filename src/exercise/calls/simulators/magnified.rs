//! The contact of an impact, magnified: the force in the course of time, whose area is the impulse.
//!
//! The bodies are pressed against each other by a linear spring and a dashpot, which give back `e`. That motion has a formula, so
//! the two parts of the area stand to each other as `e` to the last digit.

use serde::Serialize;

use momentous_simulate::{World, damping_ratio};

use super::{Amount, Curve, Row};

/// How long a contact without loss is made to last, in s.
const LASTS: f64 = 0.005;

/// The points of the plot in each of the two parts.
const POINTS: u32 = 120;

/// Below this factor damping is taken as critical: its motion differs by the square of it, and the formulas lose more.
const CRITICAL: f64 = 1e-6;

/// A contact as a spring and a dashpot make it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Magnified {
    /// The force against the time in ms, down to the axis on both sides: while the bodies are pressed together, and while they part.
    pub force: Vec<Curve>,
    /// The greatest force in N.
    pub greatest: f64,
    /// The time for which it lasts, in ms.
    pub lasts: f64,
    /// Its numbers.
    pub rows: Vec<Row>,
}

/// The contact of the two bodies of a scene, from when they meet; nothing where a spring and a dashpot do not return its coefficient.
pub(super) fn magnified(scene: &World<1>) -> Option<Magnified> {
    let [first, second] = scene.bodies.as_slice() else { return None };
    let approach = first.velocity.x - second.velocity.x;
    let damping = damping_ratio(scene.restitution).filter(|_| approach > 0.0)?;
    let reduced = first.mass * second.mass / (first.mass + second.mass);
    let contact = Contact { pressed: reduced * approach, damping, frequency: std::f64::consts::PI / LASTS };
    // The spring is pressed until the bodies move alike, and the force is gone after the same time once more.
    let turn = contact.turn();
    let [pressed, parting] = [contact.pressed, scene.restitution * contact.pressed];
    let told = |impulse: f64| Amount::new(impulse, impulse, "N\u{a0}s").text;
    let force = vec![
        contact.curve(format!("deformation, {}", told(pressed)), "body-3", [0.0, turn]),
        contact.curve(format!("restitution, {}", told(parting)), "body-4", [turn, 2.0 * turn]),
    ];
    let greatest = force.iter().flat_map(|curve| &curve.points).map(|[_, force]| *force).fold(0.0, f64::max);
    let row = |what: &str, amount: Amount| Row { what: what.to_owned(), amount };
    let (impulse, lasts) = (pressed + parting, 2.0 * turn);
    let rows = vec![
        row("Impulse of deformation", Amount::new(pressed, impulse, "N\u{a0}s")),
        row("Impulse of restitution", Amount::new(parting, impulse, "N\u{a0}s")),
        row("Their ratio, which is e", Amount::new(parting / pressed, 1.0, "")),
        row("The whole area, which is J", Amount::new(impulse, impulse, "N\u{a0}s")),
        row("Greatest force", Amount::new(greatest, greatest, "N")),
        row("Duration", Amount::new(1e3 * lasts, lasts, "ms")),
    ];
    Some(Magnified { force, greatest, lasts: 1e3 * lasts, rows })
}

/// The motion of two bodies against each other, with a spring and a dashpot between them.
struct Contact {
    /// The impulse until they move alike, in N s: the reduced mass times the speed of approach.
    pressed: f64,
    /// The damping over the critical one.
    damping: f64,
    /// The frequency without it, in rad/s.
    frequency: f64,
}

impl Contact {
    /// How far the damping is from the critical one: the frequency is less, or the decay more, by this factor.
    fn detuned(&self) -> f64 {
        libm::sqrt((1.0 - self.damping * self.damping).abs())
    }

    /// When the bodies move alike, in s.
    fn turn(&self) -> f64 {
        let detuned = self.detuned();
        let phase = if detuned < CRITICAL {
            1.0
        } else if self.damping < 1.0 {
            libm::atan2(detuned, self.damping) / detuned
        } else {
            libm::acosh(self.damping) / detuned
        };
        phase / self.frequency
    }

    /// The force at a time, in N.
    fn force(&self, time: f64) -> f64 {
        let (detuned, phase) = (self.detuned(), self.frequency * time);
        let (even, odd) = if detuned < CRITICAL {
            (1.0, phase)
        } else if self.damping < 1.0 {
            (libm::cos(detuned * phase), libm::sin(detuned * phase) / detuned)
        } else {
            (libm::cosh(detuned * phase), libm::sinh(detuned * phase) / detuned)
        };
        let damping = self.damping;
        let share = 2.0 * damping * even + (1.0 - 2.0 * damping * damping) * odd;
        self.pressed * self.frequency * libm::exp(-damping * phase) * share
    }

    /// The force as an area over the axis; times in ms.
    fn curve(&self, name: String, role: &'static str, [from, to]: [f64; 2]) -> Curve {
        let time = |point: u32| from + (to - from) * f64::from(point) / f64::from(POINTS);
        let points = (0..=POINTS).map(|point| [time(point), self.force(time(point)).max(0.0)]);
        let all = [[from, 0.0]].into_iter().chain(points).chain([[to, 0.0]]);
        Curve::new(name, role, all.map(|[time, force]| [1e3 * time, force]))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use momentous_simulate::Body;

    fn meeting(restitution: f64) -> Magnified {
        let mut world = World::<1>::new(restitution);
        world.bodies.push(Body::sphere("A", 3.0, 0.5, [-1.0], [3.0]));
        world.bodies.push(Body::sphere("B", 2.0, 0.5, [1.0], [-2.0]));
        magnified(&world).unwrap()
    }

    /// The area of a curve by trapezoids, in N s.
    fn area(curve: &Curve) -> f64 {
        curve
            .points
            .windows(2)
            .map(|pair| 1e-3 * (pair[1][0] - pair[0][0]) * f64::midpoint(pair[0][1], pair[1][1]))
            .sum()
    }

    #[test]
    fn the_drawn_areas_are_the_impulses_whatever_the_damping() {
        for e in [1.0, 0.99, 0.7, 0.2, (-2.0_f64).exp(), 0.1, 0.01] {
            let contact = meeting(e);
            let [pressed, parting] = [area(&contact.force[0]), area(&contact.force[1])];
            assert!((pressed - 6.0).abs() < 2e-3 && (parting - 6.0 * e).abs() < 2e-3, "{e}: {pressed} {parting}");
            assert!((contact.rows[2].amount.value - e).abs() < 1e-15);
            // A point that is the same as the one before it is left out.
            let points = &contact.force[1].points;
            let end = points[points.len() - 1][0];
            let greatest =
                points.iter().filter(|point| point[0] >= end).map(|point| point[1].abs()).fold(0.0, f64::max);
            assert!(greatest < 1e-9 * contact.greatest, "{e}: the force is gone at the end: {greatest}");
        }
        assert_eq!(meeting(0.7).rows[2].amount.text, "0.700");
    }
}
