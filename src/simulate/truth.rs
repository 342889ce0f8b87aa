//! The truth of a reference task, as a whole: when each impact happens and what impulse it has, and where everything is at the
//! end and how it moves. An error that is the greatest of all of these cannot be flattered by a quantity that a method cannot
//! miss.

use super::state::{State, Vector};
use super::trajectory::Trajectory;

/// The impacts and the end of a run, by a closed form, and the sizes that errors are relative to.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth<const D: usize> {
    /// Times in s and impulses in N s, in order.
    pub impacts: Vec<(f64, Vector<D>)>,
    /// The end.
    pub last: State<D>,
    /// How long it takes in s.
    pub length: f64,
    /// The longest way of a body in m.
    pub way: f64,
    /// The greatest speed of a body in m/s.
    pub speed: f64,
}

impl<const D: usize> Truth<D> {
    /// The greatest of all errors of a run: of times, relative to the length of the run; of impulses, to the greatest; of places,
    /// to the longest way; of velocities, to the greatest speed. None where the run has other impacts.
    #[must_use]
    pub fn error(&self, run: &Trajectory<D>) -> Option<f64> {
        if run.impact_count != self.impacts.len() || run.impacts.len() != self.impacts.len() {
            return None;
        }
        let impulse = self.impacts.iter().map(|(_, impulse)| impulse.norm()).fold(0.0, f64::max);
        let share = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { part.abs() / whole };
        let mut parts = vec![share(run.last.time - self.last.time, self.length)];
        for (impact, (time, true_impulse)) in run.impacts.iter().zip(&self.impacts) {
            parts.push(share(impact.time - time, self.length));
            parts.push(share((impact.impulse - true_impulse).norm(), impulse));
        }
        let places = run.last.positions.iter().zip(&self.last.positions);
        parts.extend(places.map(|(computed, place)| share((computed - place).norm(), self.way)));
        let velocities = run.last.velocities.iter().zip(&self.last.velocities);
        parts.extend(velocities.map(|(computed, velocity)| share((computed - velocity).norm(), self.speed)));
        parts.iter().all(|part| part.is_finite()).then(|| parts.into_iter().fold(0.0, f64::max))
    }
}
