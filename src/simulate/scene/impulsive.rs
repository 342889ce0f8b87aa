//! Whether a force is impulsive: whether its impulse stays what it is when the contact becomes ever shorter.

use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;

use super::stage_run::StageRun;
use super::values::Values;

/// How much shorter the second contact is than the first.
const SHORTER: f64 = 100.0;

/// Forces that have their size whatever touches.
const ORDINARY: &[&str] = &["weight", "gravity"];

/// Simulates a contact, then one that is a hundred times as short, and looks whether the impulse of a force on a body is still
/// there; `None` where the force is not one of the stage's.
#[must_use]
pub fn is_impulsive(
    scene: &Scene,
    stage: usize,
    force: &str,
    body: Option<&str>,
    value: &dyn Fn(&str) -> Option<f64>,
    tolerance: f64,
) -> Option<bool> {
    let values = Values { scene, value, index: stage };
    let bare = force.trim().trim_start_matches("the ");
    let sudden = scene.stages.get(stage)?;
    let struck = || if let Stage::Impact(impact) = sudden { impact.body.as_deref() } else { None };
    let body = body.or_else(struck).or(if let Stage::Blow(blow) = sudden { Some(blow.body.as_str()) } else { None })?;
    if ORDINARY.contains(&bare) {
        // It is integrated over both contacts.
        let over = |time: f64| {
            let pull = values.any_mass(body) * values.named("g").unwrap_or(1.0);
            let end = StageRun::new(&values, tolerance)
                .integrator(time / 4.0)
                .until(0.0, [0.0], time, &|_, _| [pull])
                .ok()?;
            Some(end[0])
        };
        return Some(over(1.0 / SHORTER)? > over(1.0)? / 2.0);
    }
    let gives = if let Stage::Blow(blow) = sudden {
        blow.by.clone()
    } else {
        let Stage::Impact(impact) = sudden else { return None };
        match impact.partners()? {
            Partners::Bodies(first, second) => {
                [first, second].into_iter().filter(|name| *name != body).map(|name| scene.called(name)).next()?
            }
            Partners::Surface(_, surface) => {
                let entry = scene.surfaces.get(surface)?;
                entry.name.clone().unwrap_or_else(|| format!("the {surface}"))
            }
        }
    };
    let named = [gives.trim_start_matches("the "), "contact force"].contains(&bare.trim_start_matches("contact with "));
    if !named {
        return None;
    }
    let given = |shorter: f64| {
        let mut bench = StageRun { shorter, ..StageRun::new(&values, tolerance) };
        bench.stage(sudden).ok()?;
        let name = format!("J_{body}");
        let parts = bench.observed.found.iter().filter(|part| part.name.starts_with(&name));
        Some(parts.map(|part| part.value.abs()).sum::<f64>())
    };
    let (long, short) = (given(1.0)?, given(SHORTER)?);
    Some(long > 0.0 && short > long / 2.0)
}
