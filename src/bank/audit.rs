//! The audit of a problem: each promise looked at over many seeds.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous_fault::{Faults, Source};
use momentous_problem::Meant;
use momentous_problem::NoVariant;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;
use momentous_problem::compile;
use momentous_problem::digest;
use momentous_render::Renderer;

use super::agreement::agrees;
use super::answers;
use super::answers::noted;
use super::course::load_in_course;
use super::expected;
use super::printed;
use super::promise::Finding;
use super::promise::Outcome;
use super::promise::Promise;
use super::repeat;
use super::report::Audit;
use super::report::Failing;
use super::report::FormAudit;
use super::sample::Samples;
use super::wrong_forms;

/// The seeds of a form that draws nothing: all of them give one sheet.
const OF_ONE_SHEET: u64 = 5;

/// Below this share of draws that are not rejected, the author is told.
const LOW_ACCEPTANCE: f64 = 0.05;

/// The number of seeds of each form that are looked at, from 1 on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seeds {
    /// How many are drawn.
    pub drawn: u64,
    /// The number of these that are simulated as well.
    pub simulated: u64,
}

/// The report on a file that is no problem.
#[must_use]
pub fn unusable(faults: &Faults) -> Audit {
    Audit {
        problem: None,
        file: faults.source.name.to_string(),
        digest: digest(&faults.source),
        faults: Some(faults.to_string()),
        failing: Failing::placed(faults),
        forms: Vec::new(),
    }
}

/// Looks at every promise over the seeds, form by form; the renderer prints what a user would print. The outcome does not depend on how many threads work.
#[must_use]
pub fn audit(source: &Source, seeds: Seeds, renderer: &Renderer) -> Audit {
    let audit = |problem, faults, forms, failing| Audit {
        problem,
        file: source.name.to_string(),
        digest: digest(source),
        faults,
        failing,
        forms,
    };
    match load_in_course(source.clone()).and_then(|loaded| compile(loaded, None)) {
        Err(faults) => unusable(&faults),
        Ok(problem) => {
            let problem = Arc::new(problem);
            let idle = idle_requires(&problem, seeds.drawn);
            let audits = (0..problem.forms().len()).map(|form| form_audit(&problem, form, seeds, renderer, &idle));
            let id = Some(problem.id().to_owned());
            match audits.collect::<Result<Vec<_>, _>>() {
                Ok(forms) => {
                    let failing = forms.iter().flat_map(Failing::broken).collect();
                    audit(id, None, forms, failing)
                }
                Err(reason) => {
                    audit(id, Some(reason.to_string()), Vec::new(), vec![Failing::nowhere(reason.to_string())])
                }
            }
        }
    }
}

fn form_audit(
    problem: &Arc<Problem>,
    position: usize,
    seeds: Seeds,
    renderer: &Renderer,
    idle: &Outcome,
) -> Result<FormAudit, NoVariant> {
    let form = problem.forms().get(position).ok_or(NoVariant::NoForm)?;
    let drawn = seeds_of(form, seeds.drawn);
    let samples = Samples::draw(problem, position, drawn)?;
    let columns = answers::columns(&form.parts, &samples);
    let variants = samples.variants();
    let (witnessed, simulated) = agrees(problem, position, seeds.simulated.min(drawn));
    let look = |promise: Promise| match promise {
        // It is compiled, or there would be no form to look at.
        Promise::Compiles => Outcome::Kept,
        Promise::Prints => printed::prints(problem, position, drawn, renderer),
        Promise::Told => told(problem, form),
        Promise::Draws => draws(&samples),
        Promise::Determined => determined(&samples, problem.contradicted(position, drawn)),
        Promise::Certified => answers::certified(&columns),
        Promise::Varies => answers::varies(&columns, variants, &form.meant),
        Promise::NotZero => answers::not_zero(&columns),
        Promise::Variety => variety(&samples, &form.meant),
        Promise::Neglected => neglected(&samples),
        Promise::NotGiven if form.meant.contains(&Meant::EqualsGiven) => Outcome::Kept,
        Promise::NotGiven => answers::not_given(&columns),
        Promise::FromTheSheet => repeat::from_the_sheet(problem, position, drawn),
        Promise::Reproduces => repeat::reproduces(problem, position, drawn),
        Promise::KeyMarks => repeat::key_marks(problem, position, drawn),
        Promise::Sharp => repeat::sharp(problem, position, drawn),
        Promise::Requires => idle.clone(),
        Promise::Simulation => witnessed.clone(),
        Promise::WrongForms => wrong_forms::told_apart(problem, position, drawn),
        Promise::Rounding => repeat::rounding(problem, position, drawn),
        Promise::Expected => expected::holds(problem, position),
    };
    let reasons = &form.question.acknowledge;
    let find = |promise| Finding { promise, outcome: look(promise).acknowledged(promise, reasons) };
    Ok(FormAudit {
        form: form.question.name.clone(),
        seeds: drawn,
        combinations: u64::try_from(form.combinations()).unwrap_or(u64::MAX),
        variants,
        sheets: samples.sheets(),
        acceptance: samples.acceptance(),
        laws: problem.laws(form).iter().map(|law| law.name.to_owned()).collect(),
        answers: answers::spreads(&form.parts, &problem.model().symbols, &samples),
        promises: Promise::all().map(find).collect(),
        simulation: simulated,
    })
}

/// How many of so many seeds of a form are looked at.
fn seeds_of(form: &PlannedForm, seeds: u64) -> u64 {
    if form.combinations() > 1 { seeds } else { seeds.min(OF_ONE_SHEET) }
}

fn draws(samples: &Samples) -> Outcome {
    let acceptance = samples.acceptance();
    match samples.failed.as_slice() {
        [] if acceptance < LOW_ACCEPTANCE => {
            Outcome::Noted(format!("only {:.1} % of the attempts are not rejected", 100.0 * acceptance))
        }
        [] => Outcome::Kept,
        [first, ..] => {
            let why = samples.reason.as_ref().map_or_else(String::new, |reason| format!(" ({reason})"));
            let reason = samples.reason.as_ref();
            let out = match (reason.and_then(NoVariant::settled_by), reason.and_then(NoVariant::allowed_by)) {
                (Some(key), Some(name)) => {
                    format!("; if that is meant, write `{key}` in that stage, or `allow: [{name}]`")
                }
                (Some(key), None) => format!("; if that is meant, write `{key}` in that stage"),
                (None, Some(name)) => format!("; if that is meant, write `allow: [{name}]`"),
                (None, None) => String::new(),
            };
            Outcome::Broken(format!(
                "{} seeds give no variant, seed {first} among them{why}{out}",
                samples.failed.len()
            ))
        }
    }
}

/// A given that the text leaves out is a fault of the file; a value within the scene may be told in other words.
fn told(problem: &Problem, form: &PlannedForm) -> Outcome {
    let untold = |value: &str| format!("the text does not print {value}, which is in the scene and is needed");
    noted(&problem.untold(form).into_iter().map(untold).collect::<Vec<_>>())
}

/// The largest share that is left out of each balance, where it is worth a word.
fn neglected(samples: &Samples) -> Outcome {
    let mut largest: BTreeMap<&str, f64> = BTreeMap::new();
    for (name, share) in samples.drawn.iter().flat_map(|sample| &sample.neglected) {
        let most = largest.entry(name).or_default();
        *most = most.max(*share);
    }
    let said =
        |(name, share): (&str, f64)| format!("weight, which is neglected, gives up to {:.1} % {name}", 100.0 * share);
    noted(&largest.into_iter().map(said).collect::<Vec<_>>())
}

/// Whether seeds differ, as far as their author does not mean them to be alike.
fn variety(samples: &Samples, meant: &[Meant]) -> Outcome {
    if samples.drawn.len() < 2 {
        return Outcome::NotChecked("one seed cannot be compared with another");
    }
    if samples.sheets() == 1 && !meant.contains(&Meant::OneSheet) {
        return Outcome::Noted("every seed gives the same sheet; if that is meant, write `allow: [one-sheet]`".into());
    }
    if samples.sheets() > 1 && samples.have_one_answer() && !meant.contains(&Meant::OneAnswer) {
        return Outcome::Noted("every seed has the same answers; if that is meant, write `allow: [one-answer]`".into());
    }
    Outcome::Kept
}

/// A variant is drawn only where exactly one solution breaks no condition of its scene, so what was drawn is the proof; a choice is
/// open where values are neither equal within the precision of the data nor clearly different. Values that the answers do not need may
/// contradict the others nevertheless.
fn determined(samples: &Samples, contradicted: Option<(u64, String)>) -> Outcome {
    if let Some((seed, how)) = contradicted {
        return Outcome::Broken(format!("with seed {seed}, {how}"));
    }
    let unclear = samples.drawn.iter().find_map(|sample| sample.unclear.as_ref());
    match unclear {
        _ if samples.drawn.is_empty() => Outcome::NotChecked("nothing was drawn"),
        None => Outcome::Kept,
        Some((seed, values)) => Outcome::Broken(format!(
            "seed {seed} gives {values}, and the precision of the data does not decide whether these are equal: give more figures, or other values"
        )),
    }
}

/// The conditions that reject no draw of any form: without them, the same attempts are taken.
fn idle_requires(problem: &Problem, seeds: u64) -> Outcome {
    let require = &problem.loaded().draft.require;
    if require.is_empty() {
        return Outcome::Kept;
    }
    let rejected = |problem: &Problem| -> Option<Vec<u64>> {
        let count = |(form, planned): (usize, &PlannedForm)| {
            Samples::draw(problem, form, seeds_of(planned, seeds)).ok().map(|samples| samples.rejected)
        };
        problem.forms().iter().enumerate().map(count).collect()
    };
    let all = rejected(problem);
    let idle = |(index, text): (usize, &String)| {
        let mut loaded = problem.loaded().clone();
        loaded.draft.require.remove(index);
        let without = compile(loaded, None).ok()?;
        (rejected(&without) == all).then(|| format!("`{text}` never rejects a draw"))
    };
    noted(&require.iter().enumerate().filter_map(idle).collect::<Vec<_>>())
}
