//! The table of costs, made anew.

use crate::methods::{MethodKind, Setting};
use crate::sweep::{Point, jittered_cases, measured};
use crate::task::{IN_THE_PLANE, ON_A_LINE, Task};

use super::class::{Class, classify};
use super::costs::Cost;
use super::work::work;

/// The finest step, as a part of the run, and the steps in which the settings go down to it.
const FINEST_STEP: f64 = 1e-5;

/// No result of doubles is nearer to the truth than this, whatever was measured.
const ROUNDING: f64 = 1e-15;

/// Runs the reference tasks of every class through every method and setting: the table anew, cheapest first in each class.
/// A setting at which one task was refused or not answered is left out.
#[must_use]
pub fn measure_costs(repetitions: usize) -> Vec<Cost> {
    let mut all = Vec::new();
    for class in Class::ALL {
        let line: Vec<&Task<1>> = ON_A_LINE.iter().filter(|task| is_of(task, class)).collect();
        let plane: Vec<&Task<2>> = IN_THE_PLANE.iter().filter(|task| is_of(task, class)).collect();
        let mut rows = Vec::new();
        for &method in MethodKind::ALL.iter().filter(|method| method.is_ours()) {
            for setting in settings(method) {
                let on_line = line.iter().map(|task| point(task, method, setting, repetitions));
                let in_plane = plane.iter().map(|task| point(task, method, setting, repetitions));
                let points: Vec<Point> = on_line.chain(in_plane).collect();
                let work = line.iter().map(|task| task_work(task, method, setting));
                let work = work.chain(plane.iter().map(|task| task_work(task, method, setting)));
                rows.extend(row(class, method, setting, &points, work.fold(0.0, f64::max)));
            }
        }
        rows.sort_by(|one, other| one.seconds.total_cmp(&other.seconds));
        all.extend(rows);
    }
    all
}

fn is_of<const D: usize>(task: &Task<D>, class: Class) -> bool {
    let case = (task.jittered)(0.0);
    classify(&case.world, &case.budget).is_ok_and(|classified| classified.class == class)
}

/// Tolerances by decades, and steps by halves of a decade.
fn settings(method: MethodKind) -> Vec<Option<f64>> {
    match method.setting() {
        Setting::None => vec![None],
        Setting::Tolerance => (3..=14).map(|power| Some(libm::pow(10.0, -f64::from(power)))).collect(),
        Setting::Step => {
            let steps = (3..).map(|power| libm::pow(10.0, -f64::from(power) / 2.0));
            steps.take_while(|step| *step > 0.99 * FINEST_STEP).map(Some).collect()
        }
    }
}

fn point<const D: usize>(task: &Task<D>, method: MethodKind, setting: Option<f64>, repetitions: usize) -> Point {
    let cases = jittered_cases(task);
    let end = cases.first().map_or(1.0, |case| case.budget.until);
    measured(task.name, setting, method.at::<D>(setting, end).as_ref(), &cases, repetitions)
}

/// The work of a task; `None` where the method refuses it.
fn task_work<const D: usize>(task: &Task<D>, method: MethodKind, setting: Option<f64>) -> f64 {
    let case = (task.jittered)(0.0);
    let run = method.at::<D>(setting, case.budget.until).run(&case.world, &case.budget);
    run.map_or(0.0, |run| work(method, &case.world, &run))
}

fn row(class: Class, method: MethodKind, setting: Option<f64>, points: &[Point], work: f64) -> Option<Cost> {
    let failed = points.is_empty() || points.iter().any(|point| point.failures > 0);
    let greatest = |value: fn(&Point) -> f64| points.iter().map(value).fold(0.0, f64::max);
    let error = greatest(|point| point.errors.map_or(f64::INFINITY, |errors| errors.greatest)).max(ROUNDING);
    (!failed).then(|| Cost { class, method, setting, seconds: greatest(|point| point.seconds), error, work })
}
