//! The cheapest method that meets a request, by the table of costs.

use std::fmt;

use crate::methods::MethodKind;

use super::class::{Class, Classified};
use super::costs::{Cost, costs};

/// The accuracy where none is asked for and time does not matter.
pub const DEFAULT_ACCURACY: f64 = 1e-9;

/// The error above which a motion is another one.
const AT_ALL: f64 = 0.5;

/// The request to a method.
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
    #[error("no {which} of the table meets this for a scene of the class `{class}`: {nearest}")]
    OutOfReach {
        /// The choice in question: `method`, or `setting of penalty`.
        which: String,
        /// The class.
        class: &'static str,
        /// The candidates that come nearest.
        nearest: String,
    },
}

impl NoChoice {
    pub(super) fn out_of_reach(scene: &Classified, request: &Request, nearest: String) -> Self {
        let which =
            request.method.map_or_else(|| "method".to_owned(), |method| format!("setting of {}", method.name()));
        Self::OutOfReach { which, class: scene.class.name(), nearest }
    }
}

impl Choice {
    /// The method with its setting.
    #[must_use]
    pub fn named(&self) -> String {
        with_setting(self.method, self.setting)
    }
}

impl Request {
    /// The error up to which a run is as accurate as is asked. A method that is asked for by name, or for its time alone, is shown at
    /// its best as long as that is the scene at all.
    #[must_use]
    pub fn bound(&self) -> f64 {
        let usual = if self.method.is_some() || self.budget.is_some() { AT_ALL } else { DEFAULT_ACCURACY };
        self.accuracy.unwrap_or(usual)
    }
}

/// The rows of the table in question for a scene of this class, in the order in which they are to be tried: those that promise the
/// accuracy from the cheapest on; all of a method that is asked for by name; where only a time is given, from the most accurate
/// on. Where there is a closed form, it is the only one.
///
/// ```
/// use momentous_simulate::least::{Classified, Request, options};
/// use momentous_simulate::scene::Followed;
/// let swing = Classified::followed(Followed::Equations("a swing under weight"));
/// let all = options(&swing, &Request { accuracy: Some(1e-6), ..Request::default() }).unwrap();
/// assert!(all[0].cost.as_ref().unwrap().error <= 1e-6);
/// assert!(all[0].to_string().contains("because there is no formula here for a swing under weight"));
/// ```
///
/// # Errors
/// Nothing in the table promises it, or a law must be chosen first.
pub fn options(scene: &Classified, request: &Request) -> Result<Vec<Choice>, NoChoice> {
    if scene.class == Class::LawRequired {
        return Err(NoChoice::LawRequired(scene.to_string()));
    }
    let out_of_reach = |nearest: String| NoChoice::out_of_reach(scene, request, nearest);
    if let (false, Some(asked)) = (scene.methods.is_empty(), request.method)
        && !scene.methods.contains(&asked)
    {
        let names: Vec<&str> = scene.methods.iter().map(|method| method.name()).collect();
        let follow = if names.len() > 1 { "follow" } else { "follows" };
        return Err(out_of_reach(format!("only {} {follow} such a motion", names.join(" and "))));
    }
    let formula = (scene.class == Class::ClosedForm).then_some(MethodKind::ClosedForm);
    let wanted = request.method.or(formula).or(scene.methods.first().copied());
    let mut rows: Vec<&Cost> = costs()
        .iter()
        .filter(|cost| cost.class == scene.class && wanted.is_none_or(|method| method == cost.method))
        .collect();
    rows.sort_by(|one, other| one.seconds.total_cmp(&other.seconds));
    let Some(most_accurate) = rows.iter().min_by(|one, other| one.error.total_cmp(&other.error)).copied() else {
        return untabled(scene, request).map(|choice| vec![choice]);
    };
    let cheapest = rows.first().copied();
    match (request.accuracy, request.budget) {
        (None, Some(_)) => rows.sort_by(|one, other| one.error.total_cmp(&other.error)),
        // A method that was asked for by name, without more, is shown at its best.
        (None, None) if request.method.is_some() => rows = vec![most_accurate],
        // What the table says of its own tasks may be better here.
        (Some(_), _) if request.method.is_some() => {}
        (_, _) => rows.retain(|cost| cost.error <= request.bound()),
    }
    if rows.is_empty() {
        let both = [Some(most_accurate), cheapest].into_iter().flatten();
        let tried: Vec<Tried> =
            both.map(|cost| (chosen(scene, request, cost), Some(cost.error), Some(cost.seconds))).collect();
        return Err(out_of_reach(nearest(&tried)));
    }
    Ok(rows.into_iter().map(|cost| chosen(scene, request, cost)).collect())
}

fn chosen(scene: &Classified, request: &Request, cost: &Cost) -> Choice {
    Choice {
        class: scene.class,
        method: cost.method,
        setting: cost.setting,
        cost: Some(cost.clone()),
        why: sentence(scene, request, cost),
    }
}

/// A choice with its error and its time in s, as far as they are known.
pub(super) type Tried = (Choice, Option<f64>, Option<f64>);

/// The candidates that come nearest to a request: the most accurate of those tried, and the cheapest.
pub(super) fn nearest(tried: &[Tried]) -> String {
    let known = |value: Option<f64>| value.unwrap_or(f64::INFINITY);
    let least = |cost: fn(&Tried) -> Option<f64>| {
        tried.iter().min_by(|one, other| known(cost(one)).total_cmp(&known(cost(other))))
    };
    let accurate =
        least(|error_of| error_of.1).map(|(choice, error, seconds)| match error.filter(|error| error.is_finite()) {
            Some(error) => {
                let seconds = seconds.map_or_else(String::new, |seconds| format!(" in {}", time(seconds)));
                format!("the most accurate, {}, has an error of up to {error:.0e}{seconds}", choice.named())
            }
            None => format!("what is asked for does not happen with {}", choice.named()),
        });
    let cheap = least(|cost_of| cost_of.2).and_then(|(choice, _, seconds)| {
        seconds.map(|seconds| format!("the cheapest, {}, takes {}", choice.named(), time(seconds)))
    });
    accurate.into_iter().chain(cheap).collect::<Vec<_>>().join("; ")
}

/// A method that the table does not have for the class, and that was asked for by name: the run will tell what comes of it.
fn untabled(scene: &Classified, request: &Request) -> Result<Choice, NoChoice> {
    let Some(method) = request.method else {
        return Err(NoChoice::out_of_reach(scene, request, "the table has no row for it".to_owned()));
    };
    let why = format!(
        "{}, as asked for; the reference tasks of the class `{}` are beyond it",
        method.name(),
        scene.class.name()
    );
    Ok(Choice { class: scene.class, method, setting: method.usual_setting(), cost: None, why })
}

/// A method with its setting.
fn with_setting(method: MethodKind, setting: Option<f64>) -> String {
    let setting = method.setting_in_words(setting).map_or_else(String::new, |setting| format!(" with {setting}"));
    format!("{}{setting}", method.name())
}

/// One line: the method, and why nothing less serves.
fn sentence(scene: &Classified, request: &Request, cost: &Cost) -> String {
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
    format!("{}, {why}", with_setting(cost.method, cost.setting))
}

/// A time as people say it, in whole units or two figures: no machine keeps to more.
#[must_use]
pub fn time(seconds: f64) -> String {
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
        Classified { class, reason: "so it is".to_owned(), methods: &[] }
    }

    fn asked(accuracy: f64) -> Request {
        Request { accuracy: Some(accuracy), ..Request::default() }
    }

    #[test]
    fn the_rows_that_promise_the_accuracy_are_tried_from_the_cheapest_on() {
        for class in [Class::ClosedForm, Class::LinearSolve, Class::Piecewise, Class::OdeNeeded] {
            for power in 1..=11 {
                let accuracy = libm::pow(10.0, -f64::from(power));
                let rows =
                    options(&scene(class), &asked(accuracy)).unwrap().into_iter().filter_map(|option| option.cost);
                let rows: Vec<Cost> = rows.collect();
                assert!(rows.iter().all(|cost| cost.error <= accuracy), "{rows:?}");
                assert!(rows.is_sorted_by(|one, next| one.seconds <= next.seconds), "{rows:?}");
                let first = rows.first().unwrap();
                let cheaper = costs().iter().filter(|other| other.class == class && other.seconds < first.seconds);
                for other in cheaper {
                    assert!(other.error > accuracy, "{other:?} is cheaper than {first:?} at {accuracy:e}");
                }
            }
        }
    }

    #[test]
    fn a_time_alone_is_spent_on_accuracy_and_a_name_alone_on_its_best() {
        let timed = Request { budget: Some(1e-5), ..Request::default() };
        let rows: Vec<Cost> =
            options(&scene(Class::OdeNeeded), &timed).unwrap().into_iter().filter_map(|option| option.cost).collect();
        assert!(rows.len() > 40 && rows.is_sorted_by(|one, next| one.error <= next.error));
        let named = Request { method: Some(MethodKind::Penalty), ..Request::default() };
        let only = options(&scene(Class::OdeNeeded), &named).unwrap();
        let best = costs().iter().filter(|cost| cost.class == Class::OdeNeeded && cost.method == MethodKind::Penalty);
        let best = best.map(|cost| cost.error).fold(f64::INFINITY, f64::min);
        assert_eq!(only.iter().map(|option| option.cost.as_ref().unwrap().error).collect::<Vec<_>>(), [best]);
        // What the table says of its tasks may be better in a scene.
        let exact = Request { accuracy: Some(1e-12), ..named };
        assert!(options(&scene(Class::OdeNeeded), &exact).unwrap().len() > 3);
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
        let said = options(&scene(Class::Piecewise), &asked(1e-30)).unwrap_err().to_string();
        assert!(said.contains("`piecewise`") && said.contains("event driven"), "{said}");
        assert!(matches!(options(&scene(Class::LawRequired), &Request::default()), Err(NoChoice::LawRequired(_))));
    }
}
