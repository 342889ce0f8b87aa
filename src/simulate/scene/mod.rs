//! From a problem's scene and its numbers to something that runs, stage by stage.
//!
//! This is the independent witness of `momentous check`: it reads the scene anew, and shares no code with the laws.

mod bounces;
mod changing;
mod closed;
mod component;
mod course;
mod direction;
mod experiment;
mod filming;
mod floor;
mod formula;
mod impact;
mod impulsive;
mod in_time;
mod integrate;
mod measure;
mod modes;
mod motion;
mod nothing;
mod particles;
mod pushed;
mod rate;
mod recorded_motion;
mod revolution;
mod square;
mod stage;
mod stage_run;
mod state;
mod strength;
mod system;
mod touch;
mod turned;
mod values;
mod vector;
mod watch;

use momentous_scene::Scene;

pub use component::Component;
pub use experiment::{Experiment, Reached, Reading, Staged};
pub use formula::Followed;
pub use impulsive::is_impulsive;
pub use measure::{Asked, measure};
pub use nothing::NothingToSimulate;
pub use recorded_motion::RecordedMotion;
pub use stage_run::{Observed, Procedure};
pub use touch::CONTACT_IN_SECONDS;
pub use vector::Vector;
pub use watch::watch;

use stage_run::StageRun;
use values::Values;
use vector::{cross, dot};

/// Simulates a stage of a scene, counted from 0, whatever its kind, and says what is found: with errors of the order of the
/// tolerance, which a second run with another tolerance makes known. `value` gives the quantities of the scene as for [`translate`].
///
/// ```
/// use momentous_scene::Scene;
/// use momentous_simulate::scene::observe;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "axes": { "x": "towards the quay" },
///     "bodies": { "P": { "name": "the deckhand" }, "B": { "name": "the barge" } },
///     "stages": [{ "walk": { "body": "P", "on": "B", "distance": "4 m" } }]
/// }"#).unwrap();
/// let value = |name: &str| match name { "m_P" => Some(80.0), "m_B" => Some(240.0), _ => None };
/// let observed = observe(&scene, 0, &value, 1e-11).unwrap();
/// let barge = observed.found.iter().find(|reached| reached.name == "s_B").unwrap();
/// assert!((barge.value + 1.0).abs() < 1e-9);
/// ```
///
/// # Errors
/// There is nothing to simulate: why.
pub fn observe(
    scene: &Scene,
    stage: usize,
    value: &dyn Fn(&str) -> Option<f64>,
    tolerance: f64,
) -> Result<Observed, NothingToSimulate> {
    observe_at(scene, stage, value, tolerance, 0)
}

/// The same for a stage that ends where an equation in the places holds: not when that is so for the first time, but after so
/// many earlier crossings.
///
/// # Errors
/// There is nothing to simulate: why.
pub fn observe_at(
    scene: &Scene,
    stage: usize,
    value: &dyn Fn(&str) -> Option<f64>,
    tolerance: f64,
    crossing: usize,
) -> Result<Observed, NothingToSimulate> {
    let entry = scene.stages.get(stage).ok_or(NothingToSimulate::NoStage)?;
    let values = Values { scene, value, index: stage };
    let mut run = StageRun { crossing, ..StageRun::new(&values, tolerance) };
    run.stage(entry)?;
    Ok(run.observed)
}

/// Watches the motion of a stage, counted from 0, that is integrated in time: what [`observe`] finds the end of. `value` gives the
/// quantities of the scene as for [`translate`].
///
/// ```
/// use momentous_scene::Scene;
/// use momentous_simulate::scene::follow;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "axes": { "x": "to the right" },
///     "bodies": { "A": { "name": "the bob" } },
///     "stages": [{ "swing": { "body": "A", "length": "2.5 m" } }]
/// }"#).unwrap();
/// let value = |name: &str| match name { "m_A" => Some(2.0), "v_A1" => Some(5.0), "g" => Some(10.0), _ => None };
/// let swing = &follow(&scene, 0, &value, 1e-10).unwrap()[0];
/// // It comes to rest 1.25 m higher, and keeps its energy of 25 J all the way.
/// assert!((swing.record.moments.last().unwrap().positions[0][1] - 1.25).abs() < 1e-9);
/// assert!(swing.record.moments.iter().all(|moment| (moment.balance() - 25.0).abs() < 1e-7));
/// ```
///
/// # Errors
/// There is nothing to watch: why.
pub fn follow(
    scene: &Scene,
    stage: usize,
    value: &dyn Fn(&str) -> Option<f64>,
    tolerance: f64,
) -> Result<Vec<RecordedMotion>, NothingToSimulate> {
    followed(scene, stage, value, tolerance, false)
}

/// The same with the least model: motions that have a formula are taken from it, and only the others are integrated.
///
/// # Errors
/// There is nothing to watch: why.
pub fn follow_least(
    scene: &Scene,
    stage: usize,
    value: &dyn Fn(&str) -> Option<f64>,
    tolerance: f64,
) -> Result<Vec<RecordedMotion>, NothingToSimulate> {
    followed(scene, stage, value, tolerance, true)
}

fn followed(
    scene: &Scene,
    stage: usize,
    value: &dyn Fn(&str) -> Option<f64>,
    tolerance: f64,
    by_formulas: bool,
) -> Result<Vec<RecordedMotion>, NothingToSimulate> {
    let entry = scene.stages.get(stage).ok_or(NothingToSimulate::NoStage)?;
    let values = Values { scene, value, index: stage };
    let mut run = StageRun { motions: Some(Vec::new()), by_formulas, ..StageRun::new(&values, tolerance) };
    run.stage(entry)?;
    let motions = run.motions.unwrap_or_default();
    if motions.is_empty() { Err(NothingToSimulate::NotShown) } else { Ok(motions) }
}

/// The value of a term of a scene, where all its names have values.
#[must_use]
pub fn value_of(scene: &Scene, text: &str, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    Values { scene, value, index: 0 }.number(text).ok()
}

/// The angle from one direction, as authors write them, to a vector, counter-clockwise positive; between -π and π.
#[must_use]
pub fn angle_from(scene: &Scene, from: &str, vector: Vector, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    let base = Values { scene, value, index: 0 }.direction(from).ok()?;
    Some(libm::atan2(cross(base, vector)[2], dot(base, vector)))
}

/// The part of a vector along a direction, as authors write them.
#[must_use]
pub fn part_along(scene: &Scene, direction: &str, vector: Vector, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    let along = Values { scene, value, index: 0 }.direction(direction).ok()?;
    Some(dot(along, vector))
}

/// Translates a stage of a scene into an experiment, counted from 0, where `value` gives the quantities of the scene in SI units
/// by their names: masses `m_A`, velocities `v_A1.x` just before the stage, coefficients, times.
///
/// ```
/// use momentous_scene::Scene;
/// use momentous_simulate::scene::translate;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "axes": { "x": "to the right" },
///     "bodies": { "A": { "name": "cart A" }, "B": { "name": "cart B" } },
///     "stages": [{ "impact": { "between": ["A", "B"], "restitution": 0.7 } }]
/// }"#).unwrap();
/// let numbers = [("m_A", 3.0), ("m_B", 2.0), ("v_A1", 3.0), ("v_B1", -2.0)];
/// let value = |name: &str| numbers.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
/// let after = translate(&scene, 0, &value).unwrap().run().unwrap();
/// assert_eq!(after[0].name, "v_A2");
/// assert!((after[0].value - -0.4).abs() <= after[0].error);
/// ```
///
/// # Errors
/// There is nothing to simulate: why.
pub fn translate(
    scene: &Scene,
    stage: usize,
    value: &dyn Fn(&str) -> Option<f64>,
) -> Result<Staged, NothingToSimulate> {
    let values = Values { scene, value, index: stage };
    let stage = scene.stages.get(stage).ok_or(NothingToSimulate::NoStage)?;
    values.translated(stage)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    type Numbers = &'static [(&'static str, f64)];

    /// Axes and a stage, the values of names, and what is found after the stage.
    const FOUND: &[(&str, &str, Numbers, Numbers)] = &[
        (
            r#"{"y":"upwards"}"#,
            r#"{"fall":{"body":"A","height":"h"}}"#,
            &[("h", 5.0), ("g", 10.0), ("v_A1", 0.0)],
            &[("v_A2", -10.0)],
        ),
        (
            r#"{"y":"downwards"}"#,
            r#"{"flight":{"body":"A","during":"3 s"}}"#,
            &[("g", 10.0), ("v_A1", -5.0)],
            &[("v_A2", 25.0)],
        ),
        (
            r#"{"y":"upwards"}"#,
            r#"{"bounces":{"body":"A","restitution":0.5,"count":2}}"#,
            &[("h_0", 5.0), ("g", 10.0)],
            &[("v_n", 2.5), ("t_n", 2.0), ("t_total", 3.0)],
        ),
        (
            r#"{"x":"to the right"}"#,
            r#"{"push":{"body":"A","during":"3 s","forces":[{"value":"6*t*1 N/s","direction":"to the left"}]}}"#,
            &[("m_A", 2.0), ("v_A1", 1.0)],
            &[("v_A2", -12.5)],
        ),
        (
            r#"{"x":"to the right"}"#,
            r#"{"push":{"body":"A","during":["1 s","4 s"],"forces":[{"value":[{"until":"2 s","is":"4 N"},{"is":"1 N"}]}]}}"#,
            &[("m_A", 2.0), ("v_A1", 1.0)],
            &[("v_A2", 4.0)],
        ),
        (
            r#"{"x":"to the right"}"#,
            r#"{"push":{"body":"A","during":"2 s","forces":[{"value":{"points":[["0 s","0 N"],["1 s","4 N"],["2 s","0 N"]]}}]}}"#,
            &[("m_A", 2.0), ("v_A1", 1.0)],
            &[("v_A2", 3.0)],
        ),
        (
            r#"{"x":"east"}"#,
            r#"{"impact":{"body":"A","against":"bat","restitution":0.5}}"#,
            &[("v_A1", 20.0), ("u", 10.0)],
            &[("v_A2", -25.0)],
        ),
        (
            r#"{"x":"east","y":"north"}"#,
            r#"{"impact":{"between":["A","B"],"plastic":true,"becomes":"C"}}"#,
            &[("m_A", 1.0), ("m_B", 3.0), ("v_A1.x", 4.0), ("v_A1.y", 0.0), ("v_B1.x", 0.0), ("v_B1.y", 2.0)],
            &[("v_C2.x", 1.0), ("v_C2.y", 1.5)],
        ),
        (
            r#"{"x":"east","y":"north"}"#,
            r#"{"impact":{"between":["A","B"],"elastic":true,"line_of_impact":"45 deg north of east"}}"#,
            &[("m_A", 1.0), ("m_B", 1.0), ("v_A1.x", 4.0), ("v_A1.y", 0.0), ("v_B1.x", 0.0), ("v_B1.y", 0.0)],
            &[("v_A2.x", 2.0), ("v_A2.y", -2.0), ("v_B2.x", 2.0), ("v_B2.y", 2.0)],
        ),
    ];

    fn scene(axes: &str, stage: &str) -> Scene {
        let plane = if axes.contains('y') && !axes.contains('x') { "vertical" } else { "horizontal" };
        let text = format!(
            r#"{{"axes":{axes},"plane":"{plane}","bodies":{{"A":{{"name":"a"}},"B":{{"name":"b"}}}},
            "surfaces":{{"bat":{{"normal":"west","velocity":"u"}}}},"stages":[{stage}]}}"#
        );
        serde_json::from_str(&text).unwrap()
    }

    fn value<'a>(numbers: &'a [(&str, f64)]) -> impl Fn(&str) -> Option<f64> + 'a {
        |name| numbers.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }

    #[test]
    fn stages_end_as_they_must() {
        for (axes, stage, numbers, expected) in FOUND {
            let found = translate(&scene(axes, stage), 0, &value(numbers)).unwrap().run().unwrap();
            for (name, expected) in *expected {
                let computed = found.iter().find(|reached| reached.name == *name).unwrap();
                assert!((computed.value - expected).abs() <= computed.error, "{stage}: {computed:?}, not {expected}");
                assert!(computed.error <= 1e-8 * (1.0 + expected.abs()), "{stage}: {computed:?}");
            }
        }
    }

    #[test]
    fn what_cannot_be_simulated_says_why() {
        let line = r#"{"x":"to the right"}"#;
        let plane = r#"{"x":"to the right","y":"away from you"}"#;
        let numbers = [("v_A1", 1.0), ("v_B1", 0.0), ("m_A", 1.0)];
        for (axes, stage, reason) in [
            (line, r#"{"blow":{"body":"A","by":"the bat"}}"#, NothingToSimulate::UnknownHistory),
            (line, r#"{"drift":{"during":"2 s"}}"#, NothingToSimulate::NothingChanges),
            (line, r#"{"impact":{"between":["A","B"]}}"#, NothingToSimulate::NoRestitution),
            (line, r#"{"impact":{"between":["A","B"],"restitution":"e"}}"#, NothingToSimulate::ValueMissing),
            (plane, r#"{"impact":{"between":["A","B"],"restitution":1}}"#, NothingToSimulate::NoLineOfImpact),
        ] {
            assert_eq!(translate(&scene(axes, stage), 0, &value(&numbers)).unwrap_err(), reason, "{stage}");
        }
    }
}
