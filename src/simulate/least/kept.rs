//! A request that is kept or refused: what a table of costs promises for its own tasks is measured in the scene itself.

use crate::method::Method;
use crate::methods::{EventDriven, MethodKind, RungeKutta, Setting};
use crate::record::Record;
use crate::refusal::Refusal;
use crate::shown::{End, Shown};
use crate::trajectory::{Ending, Trajectory};
use crate::world::World;

use super::choice::{Choice, NoChoice, Request, nearest, options};
use super::class::classify;
use super::work::work;

/// How far a second run shows the first to be off is known to within this factor.
pub const MARGIN: f64 = 4.0;

/// The step by which tolerances of two runs that are compared differ.
const FINER: f64 = 0.1;

/// The tolerance of the run by which methods with steps are measured where there is no exact motion.
const FINE: f64 = 1e-12;

/// A scene run as is asked.
#[derive(Clone, Debug)]
pub struct Kept<const D: usize> {
    /// The method, its setting, and why it was taken.
    pub choice: Choice,
    /// The run.
    pub run: Trajectory<D>,
    /// The same as plain numbers.
    pub record: Record,
    /// How far it is off, as [`Record::apart`] measures it; none of a run that was given up before its time.
    pub error: Option<f64>,
    /// The cost in this scene by the table of costs, in s.
    pub seconds: Option<f64>,
}

/// Why no run is as is asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotKept {
    /// The numbers make no scene.
    #[error("{0}")]
    Scene(Refusal),
    /// No method is in question.
    #[error("{0}")]
    Choice(NoChoice),
    /// The only method in question does not treat the scene.
    #[error("{method} is not applicable: {refusal}")]
    Method {
        /// Its name.
        method: &'static str,
        /// Why.
        refusal: Refusal,
    },
}

/// Runs what is watched of a scene by the first of the methods in question whose run is as accurate, and costs as little, as is
/// asked.
///
/// # Errors
/// None is.
pub fn keep<const D: usize>(shown: &Shown<D>, request: &Request) -> Result<Kept<D>, NotKept> {
    let classified = classify(&shown.world, &shown.budget).map_err(NotKept::Scene)?;
    let (mut tried, mut refused) = (Vec::new(), None);
    for choice in options(&classified, request).map_err(NotKept::Choice)? {
        let run = match choice.method.at(choice.setting, shown.length).run(&shown.world, &shown.budget) {
            Ok(run) => run,
            Err(refusal) if refusal.is_of_the_scene() => return Err(NotKept::Scene(refusal)),
            Err(refusal) => {
                refused = Some(NotKept::Method { method: choice.method.name(), refusal });
                continue;
            }
        };
        let record = shown.record(&run);
        let given_up = run.ending == Ending::Exhausted;
        let error = if given_up { None } else { Some(error(shown, &choice, (&run, &record)).map_err(NotKept::Scene)?) };
        let scale = |cost: &super::costs::Cost| cost.seconds * work(choice.method, &shown.world, &run) / cost.work;
        let kept = Kept { seconds: choice.cost.as_ref().map(scale), choice, run, record, error };
        let accurate = kept.error.map_or(request.accuracy.is_none(), |error| error <= request.bound());
        let cheap = request.budget.is_none_or(|budget| kept.seconds.is_none_or(|seconds| seconds <= budget));
        if accurate && cheap {
            return Ok(kept);
        }
        tried.push((kept.choice, kept.error, kept.seconds));
    }
    Err(match refused {
        Some(refused) if tried.is_empty() => refused,
        _ => NotKept::Choice(NoChoice::out_of_reach(&classified, request, nearest(&tried))),
    })
}

/// How far a run is off. A method without an error of its own is compared with itself from a start that is moved by a rounding:
/// what that changes grows as errors do. Any other is compared with exact motion, or else with a finer integration. Where exact
/// motion meets what has no answer, the method has passed over it.
fn error<const D: usize>(
    shown: &Shown<D>,
    choice: &Choice,
    (run, record): (&Trajectory<D>, &Record),
) -> Result<f64, Refusal> {
    let (world, budget) = (&shown.world, &shown.budget);
    let to_rest = shown.end == End::Rest || matches!(run.ending, Ending::Rest { .. });
    let apart = |other: &Trajectory<D>| record.apart(&shown.record(other), to_rest);
    let exact = choice.method.setting() == Setting::None;
    let world = if exact { &nudged(world) } else { world };
    let other = EventDriven.run(world, budget).or_else(|refusal| {
        if refusal.is_of_the_scene() {
            return Err(refusal);
        }
        let tolerance = choice.setting.filter(|_| choice.method == MethodKind::RungeKutta);
        let finer = tolerance.map_or(FINE, |tolerance| tolerance * FINER);
        // Where the steps of a finer run are lost in rounding, a coarser one says at least how much it is off itself.
        let coarser = || RungeKutta { tolerance: tolerance.unwrap_or(FINE) / FINER }.run(world, budget);
        RungeKutta { tolerance: finer }.run(world, budget).or_else(|_| coarser())
    });
    let apart = match other {
        Ok(other) => apart(&other),
        Err(refusal) if refusal.is_of_the_scene() && !exact => return Err(refusal),
        Err(_) => None,
    };
    let margin = if exact { MARGIN } else { 1.0 };
    Ok(apart.map_or(f64::INFINITY, |apart| margin * apart.max(f64::EPSILON)))
}

/// The scene with every number of its start moved by a rounding, each another way.
fn nudged<const D: usize>(world: &World<D>) -> World<D> {
    let mut world = world.clone();
    let values = world.bodies.iter_mut().flat_map(|body| body.position.iter_mut().chain(body.velocity.iter_mut()));
    for (value, sign) in values.zip([1.0, -1.0, -1.0, 1.0, -1.0].into_iter().cycle()) {
        *value += sign * f64::EPSILON * *value;
    }
    world
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::budget::Budget;
    use crate::state::Vector;
    use crate::world::{Body, Wall};

    fn dropped(restitution: f64, bounces: usize) -> Shown<1> {
        let mut world = World::<1>::new(restitution);
        world.gravity = Vector::from([-9.81]);
        world.bodies.push(Body::particle("ball", 1.0, [1.0], [0.0]));
        world.walls.push(Wall::new("floor", [1.0], 0.0));
        Shown::of(&world, &Budget::impacts(bounces), false).unwrap()
    }

    fn head_on() -> Shown<1> {
        let mut world = World::<1>::new(0.7);
        world.bodies.push(Body::sphere("A", 3.0, 0.5, [-0.5], [3.0]));
        world.bodies.push(Body::sphere("B", 2.0, 0.5, [0.5], [-2.0]));
        Shown::of(&world, &Budget::impacts(1), false).unwrap()
    }

    /// Steps that fall asleep before the bounce that is asked for, or that never end, were shown without a word.
    #[test]
    fn a_method_by_name_keeps_the_accuracy_in_the_scene_or_is_refused() {
        let shown = dropped(0.999, 450);
        for method in [MethodKind::SymplecticEuler, MethodKind::ExplicitEuler, MethodKind::Penalty] {
            let request = Request { method: Some(method), accuracy: Some(1e-2), ..Request::default() };
            let said = keep(&shown, &request).unwrap_err().to_string();
            assert!(said.starts_with(&format!("no setting of {} of the table meets this", method.name())), "{said}");
        }
        let request =
            Request { method: Some(MethodKind::SequentialImpulses), accuracy: Some(1e-2), ..Request::default() };
        let kept = keep(&dropped(0.75, 5), &request).unwrap();
        assert!(kept.error.unwrap() <= 1e-2 && kept.run.impact_count == 5, "{:?}", kept.error);
    }

    /// The pair integrates a parabola exactly, while the table has the worst of all tasks of the class.
    #[test]
    fn what_is_right_in_the_scene_is_not_refused() {
        let request = Request { method: Some(MethodKind::RungeKutta), accuracy: Some(1e-13), ..Request::default() };
        let kept = keep(&dropped(0.75, 3), &request).unwrap();
        let promised = kept.choice.cost.unwrap().error;
        assert!(promised > 1e-13 && kept.error.unwrap() <= 1e-13, "{promised:e} {:?}", kept.error);
    }

    /// A chain of ten takes 3.5 µs by the table, two bodies a part of that.
    #[test]
    fn a_time_counts_the_scene_at_hand() {
        let two = Request { budget: Some(1e-6), ..Request::default() };
        let kept = keep(&head_on(), &two).unwrap();
        assert!(kept.choice.method == MethodKind::EventDriven && kept.seconds.unwrap() < 1e-6, "{:?}", kept.seconds);
        let said = keep(&dropped(0.9999, 2000), &two).unwrap_err().to_string();
        assert!(said.contains("closed form, takes"), "{said}");
    }

    /// A disc among four heavy ones: a rounding grows tenfold with each of its impacts.
    #[test]
    fn a_billiard_says_how_many_digits_are_left() {
        let mut world = World::<2>::new(1.0);
        world.bodies.push(Body::sphere("A", 1.0, 0.05, [0.02, 0.03], [1.0, 0.37]));
        for place in [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]] {
            world.bodies.push(Body::sphere("pin", 1e30, 0.97, place, [0.0, 0.0]));
        }
        let shown = |impacts| Shown::of(&world, &Budget::impacts(impacts), false).unwrap();
        let roughly = Request { accuracy: Some(0.5), ..Request::default() };
        // The errors against 120 digits: 4e-13, 9e-11, 7e-4.
        for (impacts, right) in [(10, 1e-12), (20, 1e-9), (30, 1e-2)] {
            let error = keep(&shown(impacts), &roughly).unwrap().error.unwrap();
            assert!(error > right / 1e2 && error < right * 1e3, "{impacts}: {error:e}");
        }
        let said = keep(&shown(40), &Request::default()).unwrap_err().to_string();
        assert!(said.contains("no method of the table meets this"), "{said}");
    }

    #[test]
    fn what_has_no_answer_is_refused_whatever_the_method() {
        let mut world = World::<1>::new(0.8);
        for (name, place, velocity) in [("A", -2.0, 1.0), ("B", 0.0, 0.0), ("C", 2.0, -1.0)] {
            world.bodies.push(Body::particle(name, 1.0, [place], [velocity]));
        }
        let shown = Shown::of(&world, &Budget::until(3.0), false).unwrap();
        for method in [None, Some(MethodKind::ExplicitEuler), Some(MethodKind::MoreauJean)] {
            let refused = keep(&shown, &Request { method, ..Request::default() }).unwrap_err();
            assert!(refused.to_string().starts_with("law required"), "{method:?}: {refused}");
        }
    }

    #[test]
    fn exact_motion_keeps_nearly_all_digits() {
        let kept = keep(&dropped(0.95, 100), &Request::default()).unwrap();
        assert!(kept.error.unwrap() < 1e-12, "{:?}", kept.error);
    }
}
