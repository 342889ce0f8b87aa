//! A simulation as one JSON object.

use serde_json::Value;
use serde_json::json;

use crate::problem::Problem;
use crate::problem::Variant;
use crate::simulate::Moment;
use crate::simulate::RecordedImpact;

use super::film::{Film, Shot};

impl Shot {
    /// Everything as one JSON object, in SI units: the keys of `momentous simulate --format json`.
    #[must_use]
    pub fn record(&self, problem: &Problem, variant: &Variant) -> Value {
        let nothing: Vec<Value> =
            self.nothing.iter().map(|(stage, reason)| json!({ "stage": stage, "reason": reason })).collect();
        let form = problem.forms().get(variant.form()).and_then(|form| form.question.name.clone());
        json!({
            "problem": problem.id(),
            "seed": variant.seed(),
            "form": form,
            "stages": self.films.iter().map(film).collect::<Vec<_>>(),
            "not_simulated": nothing,
        })
    }
}

fn film(film: &Film) -> Value {
    let bodies: Vec<Value> =
        film.record.bodies.iter().map(|body| json!({ "name": body.name, "mass": body.mass })).collect();
    json!({
        "stage": film.stage,
        "axes": film.axes.iter().map(|axis| axis.letter).collect::<Vec<_>>(),
        "class": film.choice.class.name(),
        "method": film.choice.method.name(),
        "setting": film.choice.setting,
        "why": film.choice.to_string(),
        "ends": film.ending,
        "bodies": bodies,
        "mass_not_told": film.unweighed,
        "notes": film.notes,
        "impacts": film.record.impacts.iter().map(impact).collect::<Vec<_>>(),
        "moments": film.record.moments.iter().map(moment).collect::<Vec<_>>(),
    })
}

fn impact(impact: &RecordedImpact) -> Value {
    json!({
        "time": impact.time,
        "between": impact.contact,
        "impulse": impact.impulse,
        "energy_before": impact.energy_before,
        "energy_after": impact.energy_after,
    })
}

fn moment(moment: &Moment) -> Value {
    json!({
        "time": moment.time,
        "masses": moment.masses,
        "positions": moment.positions,
        "velocities": moment.velocities,
        "mass_centre": moment.centre,
        "momentum": moment.momentum,
        "impulse_from_outside": moment.outside,
        "kinetic_energy": moment.kinetic,
        "potential_energy": moment.potential,
        "energy_lost": moment.lost,
        "work": moment.work,
    })
}
