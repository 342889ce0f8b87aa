//! The cheapest method that meets a request, by the table of costs.

use std::fmt;

use crate::methods::MethodKind;

use super::class::{Class, Classified};
use super::costs::{Cost, costs};

/// The accuracy where none is asked for and time does not matter.
pub const DEFAULT_ACCURACY: f64 = 1e-9;

/// What is asked of a method.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Request {
    /// The greatest relative error.
    pub accuracy: Option<f64>,
    /// The longest time of a solve, in s, as the table has it.
    pub budget: Option<f64>,
    /// This method and no other.
    pub method: Option<MethodKind>,
    /// The steps, or the events, after which a run is given up; those of its budget where none are said.
    pub steps: Option<usize>,
}

/// A method at a setting, and why it was taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The class of the scene.
    pub class: Class,
    /// The method.
    pub method: MethodKind,
    /// A tolerance, or a step as a part of the run; nothing where the method has no setting.
    pub setting: Option<f64>,
    /// Its row of the table; none where the table has no such method for the class.
    pub cost: Option<Cost>,
    why: String,
}

impl fmt::Display for Choice {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.why)
    }
}

/// Why no method was taken.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoChoice {
    /// Newton's law alone does not say what happens.
    #[error("{0}: choose a law for it")]
    LawRequired(String),
    /// The table has nothing so accurate, or nothing so cheap.
    #[error("no method of the table meets this for a scene of the class `{class}`: {nearest}")]
    OutOfReach {
        /// The class.
        class: &'static str,
        /// What comes nearest.
        nearest: String,
    },
}

/// The cheapest row of the table that meets the request for a scene of this class; where only a budget of time is given, the most
/// accurate one within it. Where there is a closed form, it is taken.
///
/// ```
/// use momentous_simulate::least::{Classified, Request, choose};
/// let swing = Classified::integrated("swing");
/// let choice = choose(&swing, &Request { accuracy: Some(1e-6), ..Request::default() }).unwrap();
/// assert!(choice.cost.as_ref().unwrap().error <= 1e-6);
/// assert!(choice.to_string().contains("because no formula here gives the motion of the stage `swing`"));
/// ```
///
/// # Errors
/// Nothing in the table meets it, or a law must be chosen first.
pub fn choose(scene: &Classified, request: &Request) -> Result<Choice, NoChoice> {
    if scene.class == Class::LawRequired {
        return Err(NoChoice::LawRequired(scene.to_string()));
    }
    if let (Some(only), Some(asked)) = (scene.only, request.method)
        && only != asked
    {
        let nearest = format!("only {} follows such a motion", only.name());
        return Err(NoChoice::OutOfReach { class: scene.class.name(), nearest });
    }
    let formula = (scene.class == Class::ClosedForm).then_some(MethodKind::ClosedForm);
    let wanted = request.method.or(scene.only).or(formula);
    let mut rows: Vec<&Cost> = costs()
        .iter()
        .filter(|cost| cost.class == scene.class && wanted.is_none_or(|method| method == cost.method))
        .collect();
    rows.sort_by(|one, other| one.seconds.total_cmp(&other.seconds));
    let chosen = |cost: &Cost| Choice {
        class: scene.class,
        method: cost.method,
        setting: cost.setting,
        cost: Some(cost.clone()),
        why: sentence(scene, request, cost),
    };
    let Some(most_accurate) = rows.iter().min_by(|one, other| one.error.total_cmp(&other.error)) else {
        return untabled(scene, request);
    };
    let within = |cost: &&&Cost| request.budget.is_none_or(|budget| cost.seconds <= budget);
    let found = match (request.accuracy, request.budget) {
        (None, Some(_)) => rows.iter().filter(within).min_by(|one, other| one.error.total_cmp(&other.error)),
        (accuracy, _) => {
            let accuracy = accuracy.unwrap_or(DEFAULT_ACCURACY);
            rows.iter().filter(within).find(|cost| cost.error <= accuracy)
        }
    };
    match found {
        Some(cost) => Ok(chosen(cost)),
        // A method that was asked for by name, without more, is shown at its best.
        None if request.method.is_some() && request.accuracy.is_none() && request.budget.is_none() => {
            Ok(chosen(most_accurate))
        }
        None => Err(NoChoice::OutOfReach { class: scene.class.name(), nearest: nearest(&rows, most_accurate) }),
    }
}

fn nearest(rows: &[&Cost], most_accurate: &Cost) -> String {
    let cheapest =
        rows.first().map(|cost| format!("; the cheapest, {}, takes {}", cost.method.name(), time(cost.seconds)));
    format!(
        "the most accurate, {}, has an error of up to {:.0e} in {}{}",
        most_accurate.method.name(),
        most_accurate.error,
        time(most_accurate.seconds),
        cheapest.unwrap_or_default()
    )
}

/// A method that the table does not have for the class, and that was asked for by name: the run will tell what comes of it.
fn untabled(scene: &Classified, request: &Request) -> Result<Choice, NoChoice> {
    let Some(method) = request.method else {
        let nearest = "the table has no row for it".to_owned();
        return Err(NoChoice::OutOfReach { class: scene.class.name(), nearest });
    };
    let why = format!(
        "{}, as asked for; the reference tasks of the class `{}` are beyond it",
        method.name(),
        scene.class.name()
    );
    Ok(Choice { class: scene.class, method, setting: method.usual_setting(), cost: None, why })
}

/// One line: the method, what it costs, and why nothing less serves.
fn sentence(scene: &Classified, request: &Request, cost: &Cost) -> String {
    let setting =
        cost.method.setting_in_words(cost.setting).map_or_else(String::new, |setting| format!(" with {setting}"));
    let reason = &scene.reason;
    let why = match (request.method, scene.class, request.accuracy, request.budget) {
        (Some(_), ..) => "as asked for".to_owned(),
        (None, Class::ClosedForm, ..) => format!("because {reason}"),
        (None, _, None, Some(budget)) => format!("the most accurate within {}, because {reason}", time(budget)),
        (None, _, accuracy, _) => {
            let accuracy = accuracy.unwrap_or(DEFAULT_ACCURACY);
            format!("the cheapest within {accuracy:.0e}, because {reason}")
        }
    };
    let (name, seconds) = (cost.method.name(), time(cost.seconds));
    format!("{name}{setting}, {why} (reference tasks: error up to {:.0e} in {seconds})", cost.error)
}

/// A time as people say it, in whole units or two figures: no machine keeps to more.
fn time(seconds: f64) -> String {
    let (unit, name) = match seconds {
        seconds if seconds < 1e-6 => (1e-9, "ns"),
        seconds if seconds < 1e-3 => (1e-6, "µs"),
        seconds if seconds < 1.0 => (1e-3, "ms"),
        _ => (1.0, "s"),
    };
    let number = seconds / unit;
    format!("{number:.*} {name}", usize::from(number < 9.95))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    fn scene(class: Class) -> Classified {
        Classified { class, reason: "so it is".to_owned(), only: None }
    }

    #[test]
    fn nothing_cheaper_in_the_table_meets_the_request() {
        for class in [Class::ClosedForm, Class::LinearSolve, Class::Piecewise, Class::OdeNeeded] {
            for power in 1..=11 {
                let accuracy = libm::pow(10.0, -f64::from(power));
                let request = Request { accuracy: Some(accuracy), ..Request::default() };
                let Some(cost) = choose(&scene(class), &request).unwrap().cost else { panic!("a row") };
                assert!(cost.error <= accuracy, "{cost:?}");
                let cheaper = costs().iter().filter(|other| other.class == class && other.seconds < cost.seconds);
                for other in cheaper {
                    assert!(other.error > accuracy, "{other:?} is cheaper than {cost:?} at {accuracy:e}");
                }
            }
        }
    }

    #[test]
    fn a_budget_of_time_buys_the_most_accurate_within_it() {
        let all: Vec<&Cost> = costs().iter().filter(|cost| cost.class == Class::OdeNeeded).collect();
        for row in &all {
            let request = Request { budget: Some(row.seconds), ..Request::default() };
            let cost = choose(&scene(Class::OdeNeeded), &request).unwrap().cost.unwrap();
            let best = all.iter().filter(|other| other.seconds <= row.seconds).map(|other| other.error);
            assert_eq!((cost.error, cost.seconds <= row.seconds), (best.fold(f64::INFINITY, f64::min), true));
        }
        let both = Request { accuracy: Some(1e-10), budget: Some(1e-9), ..Request::default() };
        assert!(choose(&scene(Class::OdeNeeded), &both).is_err());
    }

    #[test]
    fn times_are_short() {
        let cases = [(3.98e-7, "398 ns"), (9.96e-6, "10 µs"), (3.52e-6, "3.5 µs"), (0.025, "25 ms"), (2.0, "2.0 s")];
        for (seconds, said) in cases {
            assert_eq!(time(seconds), said);
        }
    }

    #[test]
    fn what_cannot_be_met_says_what_comes_nearest() {
        let request = Request { accuracy: Some(1e-30), ..Request::default() };
        let said = choose(&scene(Class::Piecewise), &request).unwrap_err().to_string();
        assert!(said.contains("`piecewise`") && said.contains("event driven"), "{said}");
        assert!(matches!(choose(&scene(Class::LawRequired), &Request::default()), Err(NoChoice::LawRequired(_))));
    }
}
