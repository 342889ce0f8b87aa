//! The stability suite: scenes with known answers, each run through every method, and what came of it.

mod hard;
mod points;
mod scenes;
mod suite;

use super::budget::Budget;
use super::method::Method;
use super::methods::{MethodKind, Setting};
use super::trajectory::Trajectory;
use super::world::World;

pub use suite::{in_the_plane, on_a_line, run_all};

/// A scene with one number that is known, and how well it must be met to be right.
pub struct Trial<const D: usize> {
    /// Its name.
    pub name: &'static str,
    /// The scene.
    pub world: World<D>,
    /// How long it runs.
    pub budget: Budget,
    /// The step of the methods that have a fixed one, in s.
    pub step: f64,
    /// The number that is asked for; `None` where the run does not have it.
    #[allow(clippy::type_complexity, reason = "a measure is a function of the trajectory, and is named here")]
    pub measure: Box<dyn Fn(&Trajectory<D>) -> Option<f64>>,
    /// The expected value; not a number where there is no answer, so that only a refusal is right.
    pub expected: f64,
    /// The error that is still right, relative to what is expected.
    pub tolerance: f64,
}

/// The result of one scene by one method.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The scene.
    pub scene: &'static str,
    /// The method.
    pub method: &'static str,
    /// Whether it is right, refused or wrong.
    pub verdict: Verdict,
}

/// Whether a method treats a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Within the scene's tolerance.
    Right,
    /// Refused, by this name.
    Refused(&'static str),
    /// Wrong by this much, relative to what is expected.
    Off(f64),
    /// The run ended without what was asked for.
    Missed,
    /// There is no answer, and the run goes on as if there were.
    Unanswerable,
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Right => out.write_str("right"),
            Self::Refused(name) => write!(out, "refused: {name}"),
            Self::Off(error) => write!(out, "fails: off by {error:.0e}"),
            Self::Missed => out.write_str("fails: what is asked for does not happen"),
            Self::Unanswerable => out.write_str("fails: there is no answer"),
        }
    }
}

/// Every method, with a fixed step for those that have one.
#[must_use]
pub fn every_method<const D: usize>(step: f64, tolerance: f64) -> Vec<Box<dyn Method<D>>> {
    let tried = MethodKind::ALL.iter().filter(|method| method.is_ours());
    tried.map(|method| method.with(if method.setting() == Setting::Tolerance { tolerance } else { step })).collect()
}

/// Runs one scene through every method.
#[must_use]
pub fn run_trial<const D: usize>(trial: &Trial<D>) -> Vec<Row> {
    let run = |method: Box<dyn Method<D>>| {
        let verdict = match method.run(&trial.world, &trial.budget) {
            Err(refusal) => Verdict::Refused(refusal.name()),
            Ok(_) if trial.expected.is_nan() => Verdict::Unanswerable,
            Ok(run) => match (trial.measure)(&run) {
                None => Verdict::Missed,
                Some(value) => {
                    let error = (value - trial.expected).abs() / trial.expected.abs();
                    if error <= trial.tolerance { Verdict::Right } else { Verdict::Off(error) }
                }
            },
        };
        Row { scene: trial.name, method: method.name(), verdict }
    };
    every_method(trial.step, 1e-12).into_iter().map(run).collect()
}
