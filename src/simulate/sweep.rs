//! Work against precision: every method over a sweep of its budget on a reference task, as data for a chart.

use std::hint::black_box;
use std::time::Instant;

use super::budget::Keep;
use super::method::Method;
use super::methods::{MethodKind, Setting};
use super::task::{Case, Task};

/// The jittered scenes behind each point.
pub const JITTERED_SCENES: u32 = 32;

/// By how much a given is jittered at most, as a part of it.
const JITTER: f64 = 0.01;

/// The errors of the jittered scenes, by quantiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// A tenth of the scenes have a smaller one.
    pub low: f64,
    /// Half of them have.
    pub median: f64,
    /// Nine tenths have.
    pub high: f64,
    /// All others have.
    pub greatest: f64,
}

impl Errors {
    fn of(mut all: Vec<f64>) -> Option<Self> {
        all.sort_by(f64::total_cmp);
        let greatest = *all.last()?;
        let at = |tenths: usize| all.get(all.len() * tenths / 10).copied();
        Some(Self { low: at(1)?, median: at(5)?, high: at(9)?, greatest })
    }
}

/// One method at one setting on one task.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The task.
    pub task: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its step in s, or its tolerance; `None` where it has no setting.
    pub setting: Option<f64>,
    /// The least time of a solve over the repetitions, in s, averaged over the scenes.
    pub seconds: f64,
    /// The number of times that forces, or the next event of a contact, were worked out in a solve, on the average.
    pub evaluations: f64,
    /// The errors of the whole state; `None` where no scene was solved.
    pub errors: Option<Errors>,
    /// The number of the scenes that were refused or ended without the answer.
    pub failures: usize,
    /// The name of the refusal of the last that failed.
    pub refusal: Option<String>,
}

/// The power of ten of the finest tolerance: rounding is reached before.
const FINEST_TOLERANCE: i32 = 15;

/// Every method at every setting of its sweep: steps from 1/30 s down by halves of a decade, tolerances from 1e-3 by decades.
fn settings(finest_step: f64) -> Vec<(MethodKind, Option<f64>)> {
    let mut all = Vec::new();
    for &method in MethodKind::ALL.iter().filter(|method| **method != MethodKind::ClosedForm) {
        match method.setting() {
            Setting::None => all.push((method, None)),
            Setting::Tolerance => {
                all.extend((3..=FINEST_TOLERANCE).map(|power| (method, Some(libm::pow(10.0, -f64::from(power))))));
            }
            Setting::Step => {
                let steps = std::iter::successors(Some(1.0 / 30.0), |step| Some(step / 10.0_f64.sqrt()));
                all.extend(steps.take_while(|step| *step >= finest_step).map(|step| (method, Some(step))));
            }
        }
    }
    all
}

/// Runs a task through every method and setting, `repetitions` times each, or more often where a solve is short; steps go down to
/// `finest_step` (s). `done` is called after each of the [`points_of`] points.
///
/// ```
/// use momentous_simulate::{ON_A_LINE, points_of, sweep};
/// let mut count = 0;
/// let points = sweep(&ON_A_LINE[0], 1, 0.02, &mut || count += 1);
/// assert_eq!((points.len(), count), (points_of(0.02), points_of(0.02)));
/// let exact = points.iter().find(|point| point.method == "event driven").unwrap();
/// assert_eq!(exact.failures, 0);
/// assert!(exact.errors.unwrap().greatest < 1e-15);
/// ```
#[must_use]
pub fn sweep<const D: usize>(
    task: &Task<D>,
    repetitions: usize,
    finest_step: f64,
    done: &mut dyn FnMut(),
) -> Vec<Point> {
    let cases = jittered_cases(task);
    let mut points = vec![closed_form(task, repetitions)];
    done();
    for (method, setting) in settings(finest_step) {
        let method = method.with::<D>(setting.unwrap_or(0.0));
        points.push(measured(task.name, setting, method.as_ref(), &cases, repetitions));
        done();
    }
    points
}

/// The number of points that a sweep has.
#[must_use]
pub fn points_of(finest_step: f64) -> usize {
    settings(finest_step).len() + 1
}

/// For how long each scene is solved again at least, in s, where it is solved more than once: the fastest of a few short solves says more of the machine than of them.
const SPENT: f64 = 2e-3;

/// The scenes behind each point.
pub(super) fn jittered_cases<const D: usize>(task: &Task<D>) -> Vec<Case<D>> {
    (0..JITTERED_SCENES).map(|scene| (task.jittered)(jitter(scene))).collect()
}

/// Calls of a closed form in one measurement, since a single one is shorter than the clock can tell.
const CALLS: u32 = 1000;

/// The closed form itself. It is the reference, so its error here is 0; that it is right is tested against 30 digits.
fn closed_form<const D: usize>(task: &Task<D>, repetitions: usize) -> Point {
    let mut least = f64::INFINITY;
    for _ in 0..repetitions.max(1) {
        let start = Instant::now();
        for call in 0..CALLS {
            black_box((task.closed_form)(black_box(jitter(call % JITTERED_SCENES))));
        }
        least = least.min(start.elapsed().as_secs_f64() / f64::from(CALLS));
    }
    Point {
        task: task.name,
        method: "closed form",
        setting: None,
        seconds: least,
        evaluations: 1.0,
        errors: Errors::of(vec![0.0]),
        failures: 0,
        refusal: None,
    }
}

/// A jitter between -1 % and 1 %, spread evenly by the golden ratio; the first scene has none.
fn jitter(scene: u32) -> f64 {
    if scene == 0 { 0.0 } else { JITTER * (2.0 * (f64::from(scene) * 0.618_033_988_749_894_9).fract() - 1.0) }
}

/// A method at a setting on the scenes of a task.
pub(super) fn measured<const D: usize>(
    task: &'static str,
    setting: Option<f64>,
    method: &dyn Method<D>,
    cases: &[Case<D>],
    repetitions: usize,
) -> Point {
    let mut errors = Vec::new();
    let (mut seconds, mut evaluations) = (0.0, 0.0);
    let mut refusal = None;
    for case in cases {
        let budget = case.budget.keep(Keep::Impacts);
        let (mut least, begun) = (f64::INFINITY, Instant::now());
        let mut solves = 0;
        let outcome = loop {
            let start = Instant::now();
            let run = method.run(black_box(&case.world), &budget);
            least = least.min(start.elapsed().as_secs_f64());
            solves += 1;
            if solves >= repetitions && (repetitions < 2 || begun.elapsed().as_secs_f64() >= SPENT) {
                break run;
            }
        };
        seconds += least / f64::from(JITTERED_SCENES);
        match outcome {
            Ok(run) => {
                evaluations += count(run.evaluations) / f64::from(JITTERED_SCENES);
                errors.extend(case.truth.error(&run));
            }
            Err(error) => refusal = Some(error.name().to_owned()),
        }
    }
    let failures = cases.len() - errors.len();
    let errors = Errors::of(errors);
    Point { task, method: method.name(), setting, seconds, evaluations, errors, failures, refusal }
}

#[allow(clippy::cast_precision_loss, reason = "counts of evaluations stay far below 2^53")]
fn count(evaluations: usize) -> f64 {
    evaluations as f64
}
