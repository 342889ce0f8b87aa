//! Springs, or resistances in proportion to the speed, that act on the same particles: their motion by modes, each of which goes
//! by itself.

use std::sync::Arc;

use nalgebra::{DMatrix, SymmetricEigen};

use crate::exact::{repeated_cosine, repeated_decay};

use super::in_time::Sums;

/// What is known along the line of a force.
pub(super) struct Pulling {
    /// Its strength for a metre, or for a metre per second.
    pub coefficient: f64,
    /// How far the line is deformed at the start, and how fast.
    pub starts: [f64; 2],
    /// What the other forces accelerate along it: the coefficients of 1, t, t², ...
    pub driven: Vec<f64>,
    /// How a unit of each force of its kind accelerates along it.
    pub answers: Vec<f64>,
}

/// A mode: how it starts and is driven, as coefficients of integrals of one function that are repeated ever more often.
struct Mode {
    rate: f64,
    coefficients: Vec<f64>,
}

impl Mode {
    /// Its integral over a time, or the integral of that.
    fn integral(&self, repeated: fn(usize, f64, f64) -> f64, times: usize, gone: f64) -> f64 {
        let each = self.coefficients.iter().enumerate();
        each.map(|(order, coefficient)| coefficient * repeated(order + times, gone, self.rate)).sum()
    }
}

/// What each of the forces adds up to. Springs swing; resistances, of which only the rates matter, fade.
pub(super) fn modes(pulling: &[Pulling], swings: bool) -> Vec<Sums> {
    let count = pulling.len();
    let root = |index: usize| libm::sqrt(pulling[index].coefficient);
    let matrix = DMatrix::from_fn(count, count, |one, other| {
        // The same from both sides but for rounding.
        root(one) * root(other) * f64::midpoint(pulling[one].answers[other], pulling[other].answers[one])
    });
    let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(matrix);
    let mode = |place: usize| {
        let share = |value: &dyn Fn(&Pulling) -> f64| -> f64 {
            (0..count).map(|index| eigenvectors[(index, place)] * root(index) * value(&pulling[index])).sum()
        };
        let mut coefficients = vec![share(&|force| force.starts[1])];
        if swings {
            coefficients.insert(0, share(&|force| force.starts[0]));
        }
        let mut factorial = 1.0;
        for power in 0..pulling.first().map_or(0, |force| force.driven.len()) {
            coefficients.push(factorial * share(&|force| force.driven[power]));
            factorial *= f64::from(u32::try_from(power + 1).unwrap_or(u32::MAX));
        }
        let value = eigenvalues[place].max(0.0);
        Mode { rate: if swings { libm::sqrt(value) } else { value }, coefficients }
    };
    let all: Arc<[Mode]> = (0..count).map(mode).collect();
    let repeated: fn(usize, f64, f64) -> f64 = if swings { repeated_cosine } else { repeated_decay };
    let force = |index: usize| -> Sums {
        let shares: Vec<f64> = (0..count).map(|place| -root(index) * eigenvectors[(index, place)]).collect();
        let all = Arc::clone(&all);
        Box::new(move |gone| {
            [1, 2].map(|times| {
                let each = all.iter().zip(&shares);
                each.map(|(mode, share)| share * mode.integral(repeated, times, gone)).sum()
            })
        })
    };
    (0..count).map(force).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spring of 8 N/m at 2 kg under a steady 6 m/s²: what it gives in a time, by hand.
    #[test]
    fn one_spring_swings_about_where_it_would_rest() {
        let spring = Pulling { coefficient: 8.0, starts: [0.5, 3.0], driven: vec![6.0], answers: vec![0.5] };
        let [once, twice] = modes(&[spring], true)[0](0.7);
        // q = 1.5 - cos 2t + 1.5 sin 2t
        let angle = 1.4_f64;
        let (sum, again) = (
            1.5 * 0.7 - angle.sin() / 2.0 + 0.75 * (1.0 - angle.cos()),
            0.75 * 0.49 - (1.0 - angle.cos()) / 4.0 + 0.75 * 0.7 - 0.375 * angle.sin(),
        );
        assert!((once + 8.0 * sum).abs() < 1e-14 && (twice + 8.0 * again).abs() < 1e-14, "{once} {twice}");
    }

    /// Two resistances at one particle of 1 kg act as their sum.
    #[test]
    fn two_resistances_on_one_line_fade_together() {
        let one = |coefficient| Pulling { coefficient, starts: [0.0, 2.0], driven: vec![], answers: vec![1.0; 2] };
        let all = modes(&[one(1.0), one(3.0)], false);
        let lost: f64 = all.iter().map(|sums| sums(0.5)[0]).sum();
        assert!((lost - 2.0 * ((-2.0_f64).exp() - 1.0)).abs() < 1e-14, "{lost}");
        assert!((all[1](0.5)[0] - 3.0 * all[0](0.5)[0]).abs() < 1e-14);
    }
}
