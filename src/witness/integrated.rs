//! Stages that no world describes, integrated in time as they are, and measured by a second integration.

use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_simulate::least::Choice;
use momentous_simulate::least::Classified;
use momentous_simulate::least::DEFAULT_ACCURACY;
use momentous_simulate::least::Request;
use momentous_simulate::least::options;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::RecordedMotion;

use super::film::{AT_ITS_TIME, Film, NotFilmed, out_of_reach};
use super::staging::followed;

/// The step by which tolerances of two integrations that are compared differ.
const FINER: f64 = 0.1;

/// A stage by the coarsest tolerance in question with which it is as accurate as is asked; or why nothing of it is shown.
pub(super) fn integrated(
    problem: &Problem,
    variant: &Variant,
    stage: usize,
    request: &Request,
) -> Result<Result<Vec<Film>, NothingToSimulate>, NotFilmed> {
    let Some(entry) = problem.loaded().draft.scene.stages.get(stage - 1) else {
        return Ok(Err(NothingToSimulate::NoStage));
    };
    let choices =
        options(&Classified::integrated(entry.key()), request).map_err(|error| out_of_reach(stage, &error))?;
    let follow = |tolerance: f64| followed(problem, variant, stage - 1, tolerance);
    let mut least = f64::INFINITY;
    for choice in choices {
        let tolerance = choice.setting.unwrap_or(DEFAULT_ACCURACY);
        let motions = match follow(tolerance) {
            Ok(motions) => motions,
            Err(reason) if least.is_infinite() => return Ok(Err(reason)),
            Err(_) => break,
        };
        // Where a finer one is lost in rounding, a coarser one says at least how much it is off itself.
        let Ok(others) = follow(tolerance * FINER).or_else(|_| follow(tolerance / FINER)) else { break };
        let error = apart(&motions, &others);
        if error <= request.bound() {
            return Ok(Ok(motions.into_iter().map(|motion| film(stage, &choice, error, motion)).collect()));
        }
        least = least.min(error);
    }
    let what = format!("no tolerance keeps the error of the stage so small: the least is about {least:.0e}");
    Err(out_of_reach(stage, &what))
}

/// How far two integrations of a stage are apart.
fn apart(motions: &[RecordedMotion], others: &[RecordedMotion]) -> f64 {
    let pairs = motions.iter().zip(others);
    let apart = pairs.map(|(motion, other)| motion.record.apart(&other.record, false).unwrap_or(f64::INFINITY));
    let whole = if motions.len() == others.len() { f64::EPSILON } else { f64::INFINITY };
    apart.fold(whole, f64::max)
}

fn film(stage: usize, choice: &Choice, error: f64, motion: RecordedMotion) -> Film {
    let RecordedMotion { components, record, notes } = motion;
    let (choice, ending) = (choice.clone(), AT_ITS_TIME.to_owned());
    let error = Some(error);
    // The table was measured with worlds.
    Film { stage, axes: components, choice, error, seconds: None, ending, record, notes, unweighed: Vec::new() }
}
