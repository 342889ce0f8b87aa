//! The stages of a variant, simulated one after another.

use crate::bank::staged;
use crate::problem::Problem;
use crate::problem::Variant;
use crate::scene::Axis;
use crate::scene::Plane;
use crate::scene::Scene;
use crate::simulate::Ending;
use crate::simulate::Method;
use crate::simulate::Record;
use crate::simulate::least::Choice;
use crate::simulate::least::Request;
use crate::simulate::least::choose;
use crate::simulate::least::classify;
use crate::simulate::scene::Experiment;
use crate::simulate::scene::NothingToSimulate;

use super::super::failure::Failure;

/// A part of a stage, simulated.
pub(super) struct Film {
    /// The stage, counted from 1.
    pub stage: usize,
    /// What the components are called.
    pub axes: Vec<Component>,
    /// Which method ran it, and why.
    pub choice: Choice,
    /// How it ended, in words.
    pub ending: &'static str,
    /// What was found.
    pub record: Record,
    /// The bodies whose mass is not known; it counts as 1 kg, and no velocity depends on it.
    pub unweighed: Vec<String>,
}

impl Film {
    /// What a reader of momenta and energies must know.
    pub(super) fn caution(&self) -> Option<String> {
        let bodies = self.unweighed.join(" and ");
        (!bodies.is_empty()).then(|| format!("The mass of {bodies} is not told: impulses and energies are for 1 kg."))
    }
}

/// A component of positions and velocities.
pub(super) struct Component {
    /// Its letter: x.
    pub letter: &'static str,
    /// Whether it is the height.
    pub vertical: bool,
}

/// All that could be simulated, and why the rest could not.
pub(super) struct Shot {
    pub films: Vec<Film>,
    /// Stages, counted from 1, with the reason.
    pub nothing: Vec<(usize, &'static str)>,
}

/// Simulates every stage.
pub(super) fn shoot(problem: &Problem, variant: &Variant, request: &Request) -> Result<Shot, Failure> {
    let scene = &problem.loaded().draft.scene;
    let mut shot = Shot { films: Vec::new(), nothing: Vec::new() };
    for (place, found) in staged(problem, variant).into_iter().enumerate() {
        let stage = place + 1;
        match found {
            Err(reason) => shot.nothing.push((stage, said(reason))),
            Ok(staged) => {
                for experiment in &staged.on_lines {
                    shot.films.push(filmed(experiment, scene, stage, request)?);
                }
                for experiment in &staged.in_planes {
                    shot.films.push(filmed(experiment, scene, stage, request)?);
                }
            }
        }
    }
    for film in &mut shot.films {
        let names = film.record.bodies.iter().map(|body| body.name.clone());
        film.unweighed = names.filter(|body| !is_weighed(problem, variant, body)).collect();
    }
    if shot.films.is_empty() {
        let reason = shot.nothing.first().map_or("nothing to simulate: nothing happens in the scene", |(_, why)| why);
        let help = "`momentous list` shows other problems; docs/methods.md says what can be simulated";
        return Err(Failure::unusable(format!("{}: {reason}\nhelp: {help}", problem.id())));
    }
    Ok(shot)
}

/// Why a stage is not shown.
fn said(reason: NothingToSimulate) -> &'static str {
    match reason {
        NothingToSimulate::NoMethod => {
            "not shown: `momentous check` simulates such a motion, but not yet as a run of bodies"
        }
        other => other.reason(),
    }
}

/// Whether the mass of a body, or of each of its parts, is told or solved.
fn is_weighed(problem: &Problem, variant: &Variant, body: &str) -> bool {
    let scene = &problem.loaded().draft.scene;
    let value = |name: &str| problem.model().symbol_of(name).and_then(|symbol| variant.value(symbol));
    let known = |name: &str| value(name).is_some_and(|mass| mass.value > 0.0);
    let own =
        |part: &&str| scene.bodies.get(*part).is_some_and(|body| body.mass.is_some()) || known(&format!("m_{part}"));
    scene.members(body).iter().all(own)
}

fn filmed<const D: usize>(
    experiment: &Experiment<D>,
    scene: &Scene,
    stage: usize,
    request: &Request,
) -> Result<Film, Failure> {
    let refused = |what: &str, help: &str| Failure::unusable(format!("stage {stage}: {what}\nhelp: {help}"));
    let other = "leave --method out, and the cheapest one that serves is taken";
    let found = |refusal: crate::simulate::Refusal| refused(&refusal.to_string(), other);
    let shown = experiment.shown().map_err(found)?;
    let classified = classify(&shown.world, &shown.budget).map_err(found)?;
    let choice = choose(&classified, request)
        .map_err(|error| refused(&error.to_string(), "ask for less accuracy, or give more time"))?;
    let method: Box<dyn Method<D>> = choice.method.at(choice.setting, shown.budget.until);
    let run = method.run(&shown.world, &shown.budget);
    let run = run.map_err(|refusal| refused(&format!("{} refuses: {refusal}", choice.method.name()), other))?;
    let ending = match run.ending {
        Ending::Time | Ending::Impacts | Ending::NoMoreImpacts => "at its time",
        Ending::Rest { .. } => "at rest",
        Ending::Exhausted => "before its time: too many steps",
    };
    let record = Record::of(&shown.world, &run, shown.origin);
    Ok(Film { stage, axes: components(experiment, scene), choice, ending, record, unweighed: Vec::new() })
}

/// What the components of an experiment are called: as the quantities that are read off it, else as the axes of the scene.
fn components<const D: usize>(experiment: &Experiment<D>, scene: &Scene) -> Vec<Component> {
    let axes = scene.axes.rectangular();
    let suffix = experiment.readings.iter().find_map(|(name, _)| name.rsplit_once('.').map(|(_, letter)| letter));
    let own: Vec<Axis> = match suffix {
        Some(letter) if D == 1 => axes.iter().map(|(axis, _)| *axis).filter(|axis| axis.letter() == letter).collect(),
        _ => axes.iter().map(|(axis, _)| *axis).collect(),
    };
    let vertical = |axis: Axis| {
        let senses = axes.iter().find(|(other, _)| *other == axis);
        let along = senses.is_some_and(|(_, senses)| ["upwards", "downwards"].contains(&senses.positive.as_str()));
        along && scene.plane == Plane::Vertical
    };
    (0..D)
        .map(|place| match own.get(place) {
            Some(axis) => Component { letter: axis.letter(), vertical: vertical(*axis) },
            None => Component { letter: "x", vertical: false },
        })
        .collect()
}
