//! Stages that no world describes: by the formula of each motion that has one, and else integrated in time as they are and
//! measured by a second integration.

use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_simulate::MethodKind;
use momentous_simulate::least::Choice;
use momentous_simulate::least::Classified;
use momentous_simulate::least::DEFAULT_ACCURACY;
use momentous_simulate::least::MARGIN;
use momentous_simulate::least::Request;
use momentous_simulate::least::options;
use momentous_simulate::scene::Followed;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::RecordedMotion;

use super::film::{AT_ITS_TIME, Film, NotFilmed, out_of_reach};
use super::staging::{followed, followed_least};

/// The step by which tolerances of two integrations that are compared differ.
const FINER: f64 = 0.1;

/// A stage by its formulas or by the coarsest tolerance in question with which it is as accurate as is asked; or why nothing of it
/// is shown.
pub(super) fn integrated(
    problem: &Problem,
    variant: &Variant,
    stage: usize,
    request: &Request,
) -> Result<Result<Vec<Film>, NothingToSimulate>, NotFilmed> {
    let least = |tolerance, share| followed_least(problem, variant, stage - 1, tolerance, share);
    let motions = match least(DEFAULT_ACCURACY, 0.0) {
        Ok(motions) => motions,
        Err(reason) => return Ok(Err(reason)),
    };
    let without_formula = motions.iter().find(|motion| matches!(motion.followed, Followed::Equations(_)));
    let Some(first) = without_formula.or(motions.first()) else { return Ok(Err(NothingToSimulate::NotShown)) };
    let tried = choices(stage, first, request)?;
    if tried.first().is_some_and(|choice| choice.method == MethodKind::ClosedForm) {
        let nudged = least(DEFAULT_ACCURACY, f64::EPSILON);
        let error = nudged.map_or(f64::INFINITY, |nudged| MARGIN * apart(&motions, &nudged));
        if error > request.bound() {
            return Err(not_kept(stage, error));
        }
        let films = motions.into_iter().map(|motion| {
            let choice = choices(stage, &motion, request)?.swap_remove(0);
            Ok(film(stage, choice, error, motion))
        });
        return films.collect::<Result<_, _>>().map(Ok);
    }
    let by_name = request.method == Some(MethodKind::RungeKutta);
    let follow = |tolerance: f64| {
        if by_name { followed(problem, variant, stage - 1, tolerance) } else { least(tolerance, 0.0) }
    };
    let mut nearest = f64::INFINITY;
    for choice in tried {
        let tolerance = choice.setting.unwrap_or(DEFAULT_ACCURACY);
        let motions = match follow(tolerance) {
            Ok(motions) => motions,
            Err(reason) if nearest.is_infinite() => return Ok(Err(reason)),
            Err(_) => break,
        };
        // Where a finer one is lost in rounding, a coarser one says at least how much it is off itself.
        let Ok(others) = follow(tolerance * FINER).or_else(|_| follow(tolerance / FINER)) else { break };
        let error = apart(&motions, &others);
        if error <= request.bound() {
            let films = motions.into_iter().map(|motion| {
                let own = choices(stage, &motion, request)?.into_iter().next();
                let by_formula = own.filter(|own| own.method == MethodKind::ClosedForm);
                Ok(film(stage, by_formula.unwrap_or_else(|| choice.clone()), error, motion))
            });
            return films.collect::<Result<_, _>>().map(Ok);
        }
        nearest = nearest.min(error);
    }
    Err(not_kept(stage, nearest))
}
/// The methods in question for a motion, by what it follows from.
fn choices(stage: usize, motion: &RecordedMotion, request: &Request) -> Result<Vec<Choice>, NotFilmed> {
    options(&Classified::followed(motion.followed), request).map_err(|error| out_of_reach(stage, &error))
}

fn not_kept(stage: usize, nearest: f64) -> NotFilmed {
    let what = format!("no tolerance keeps the error of the stage so small: the least is about {nearest:.0e}");
    out_of_reach(stage, &what)
}

/// How far two runs of a stage are apart.
fn apart(motions: &[RecordedMotion], others: &[RecordedMotion]) -> f64 {
    let pairs = motions.iter().zip(others);
    let apart = pairs.map(|(motion, other)| motion.record.apart(&other.record, false).unwrap_or(f64::INFINITY));
    let whole = if motions.len() == others.len() { f64::EPSILON } else { f64::INFINITY };
    apart.fold(whole, f64::max)
}

fn film(stage: usize, choice: Choice, error: f64, motion: RecordedMotion) -> Film {
    let RecordedMotion { components, record, notes, .. } = motion;
    let ending = AT_ITS_TIME.to_owned();
    let error = Some(error);
    // The table was measured with worlds.
    Film { stage, axes: components, choice, error, seconds: None, ending, record, notes, unweighed: Vec::new() }
}
