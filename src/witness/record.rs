//! A simulation as one JSON object.

use serde_json::Value;
use serde_json::json;

use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_scene::Scene;
use momentous_simulate::Moment;
use momentous_simulate::RecordedImpact;
use momentous_simulate::Tie;

use super::film::Film;
use super::shoot::Shot;

impl Shot {
    /// Everything as one JSON object, in SI units: the keys of `momentous simulate --format json`.
    #[must_use]
    pub fn record(&self, problem: &Problem, variant: &Variant) -> Value {
        let nothing: Vec<Value> =
            self.nothing.iter().map(|(stage, reason)| json!({ "stage": stage, "reason": reason })).collect();
        let form = problem.forms().get(variant.form()).and_then(|form| form.question.name.clone());
        let scene = &problem.loaded().draft.scene;
        json!({
            "problem": problem.id(),
            "seed": variant.seed(),
            "form": form,
            "stages": self.films.iter().map(|each| film(each, scene)).collect::<Vec<_>>(),
            "not_simulated": nothing,
        })
    }
}

fn film(film: &Film, scene: &Scene) -> Value {
    let bodies = film.record.bodies.iter();
    let bodies: Vec<Value> = bodies
        .map(|body| {
            let called = scene.called(&body.name);
            json!({ "name": body.name, "called": called, "mass": body.mass, "radius": body.radius })
        })
        .collect();
    let directions = film.axes.iter().map(|axis| {
        let positive = &axis.positive;
        json!({ "letter": axis.letter, "positive": positive, "height": axis.vertical, "on_page": axis.on_page })
    });
    let walls = film.record.walls.iter().map(|wall| {
        let (normal, offset, velocity) = (&wall.normal, wall.offset, wall.velocity);
        json!({ "name": wall.name, "normal": normal, "offset": offset, "velocity": velocity })
    });
    let point = scene.points.values().next().filter(|_| scene.points.len() == 1).map(|point| &point.name);
    let pivot = film.record.pivot.as_ref().map(|axle| {
        let mut pivot = json!({ "at": axle.at, "cord": axle.tie == Tie::Cords, "name": point });
        if let Tie::Arm(body) = axle.tie {
            pivot["arm"] = body.into();
        }
        pivot
    });
    json!({
        "stage": film.stage,
        "kind": film.kind(scene),
        "pivot": pivot,
        "axes": film.axes.iter().map(|axis| axis.letter).collect::<Vec<_>>(),
        "directions": directions.collect::<Vec<_>>(),
        "class": film.choice.class.name(),
        "method": film.choice.method.name(),
        "setting": film.choice.setting,
        "why": film.why(),
        "error": film.error,
        "trusted_digits": film.trusted_digits(),
        "ends": film.ending,
        "bodies": bodies,
        "walls": walls.collect::<Vec<_>>(),
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
    let moving = moment.masses.iter().zip(&moment.velocities);
    let momenta: Vec<Vec<f64>> =
        moving.map(|(mass, velocity)| velocity.iter().map(|part| mass * part).collect()).collect();
    json!({
        "time": moment.time,
        "masses": moment.masses,
        "positions": moment.positions,
        "velocities": moment.velocities,
        "momenta": momenta,
        "mass_centre": moment.centre,
        "momentum": moment.momentum,
        "impulse_from_outside": moment.outside,
        "kinetic_energy": moment.kinetic,
        "potential_energy": moment.potential,
        "energy_lost": moment.lost,
        "work": moment.work,
        "energy_balance": moment.balance(),
    })
}
