//! Embedded pairs of Runge-Kutta formulas as data.

/// A pair: the stages of a step, of which the last is at its end and is the first of the next one, and estimates of its error.
pub(crate) struct Pair<const S: usize> {
    /// The times of the stages, as parts of the step.
    pub nodes: [f64; S],
    /// The weights of the slopes before each stage, and zeros; the last stage is the step.
    pub stages: [[f64; S]; S],
    /// The weights of an estimate of the error, or of two of which the second is the rougher one.
    pub errors: &'static [[f64; S]],
    /// How the error of a step goes with its length.
    pub order: f64,
}

impl<const S: usize> Pair<S> {
    /// The length of the next step after one of a length whose error was so many times what is tolerated.
    pub(crate) fn next(&self, length: f64, error: f64) -> f64 {
        if error.is_nan() {
            return SHORTEST * length;
        }
        length * (CAUTION * libm::pow(error.max(LEAST), -1.0 / self.order)).clamp(SHORTEST, LONGEST)
    }
}

/// The share of the step that would just do which is taken.
const CAUTION: f64 = 0.9;

/// How many times as long a step may be as the one before.
const SHORTEST: f64 = 0.2;
const LONGEST: f64 = 5.0;

/// An error below which steps get no longer.
const LEAST: f64 = 1e-10;
