//! The stages of a variant, simulated one after another.

use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_scene::Axis;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_simulate::Ending;
use momentous_simulate::Method;
use momentous_simulate::Record;
use momentous_simulate::least::Choice;
use momentous_simulate::least::Classified;
use momentous_simulate::least::DEFAULT_ACCURACY;
use momentous_simulate::least::NoChoice;
use momentous_simulate::least::Request;
use momentous_simulate::least::choose;
use momentous_simulate::least::classify;
use momentous_simulate::scene::Component;
use momentous_simulate::scene::Experiment;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::RecordedMotion;

use super::staging::followed;
use super::staging::staged;

/// How a run that nothing cut short ends.
pub const AT_ITS_TIME: &str = "at its time";

/// What the kinds of stages are called whose key in a file says too little.
const KINDS: &[(&str, &str)] = &[
    ("taut", "cord comes taut"),
    ("connected", "on one string"),
    ("rotate", "rotation"),
    ("moment", "turning moment"),
    ("conical", "on a cone"),
    ("bowl", "in a bowl"),
    ("interact", "mutual push"),
    ("central", "central force"),
    ("slide_off", "slide down"),
    ("separate", "parting"),
];

/// A part of a stage, simulated.
#[derive(Clone, Debug)]
pub struct Film {
    /// The stage, counted from 1.
    pub stage: usize,
    /// What the components are called.
    pub axes: Vec<Component>,
    /// Which method ran it, and why.
    pub choice: Choice,
    /// How it ended, in words.
    pub ending: String,
    /// What was found.
    pub record: Record,
    /// What a reader must know of the motion.
    pub notes: Vec<&'static str>,
    /// The bodies whose mass is not known; it counts as 1 kg, and no velocity depends on it.
    pub unweighed: Vec<String>,
}

impl Film {
    /// The kind of its stage, in a word or two.
    #[must_use]
    pub fn kind(&self, scene: &Scene) -> &'static str {
        let stage = self.stage.checked_sub(1).and_then(|place| scene.stages.get(place));
        let key = stage.map_or("motion", Stage::key);
        KINDS.iter().find(|(own, _)| *own == key).map_or(key, |(_, words)| *words)
    }

    /// What a reader must know: of the motion, and of momenta and energies.
    #[must_use]
    pub fn cautions(&self) -> Vec<String> {
        let bodies = self.unweighed.join(" and ");
        let unweighed = format!("The mass of {bodies} is not given: impulses and energies are for 1 kg.");
        let notes = self.notes.iter().map(|note| (*note).to_owned());
        notes.chain((!bodies.is_empty()).then_some(unweighed)).collect()
    }
}

/// All that could be simulated, and why the rest could not.
#[derive(Clone, Debug)]
pub struct Shot {
    /// What was simulated.
    pub films: Vec<Film>,
    /// Stages, counted from 1, with the reason.
    pub nothing: Vec<(usize, &'static str)>,
}

/// Why a scene is not simulated as is asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}\nhelp: {help}")]
pub struct NotShown {
    /// What is in the way.
    pub what: String,
    /// The way out.
    pub help: &'static str,
}

/// Simulates every stage.
///
/// # Errors
/// Nothing in the scene can be simulated, or not by that method within that accuracy and time.
pub fn shoot(problem: &Problem, variant: &Variant, request: &Request) -> Result<Shot, NotShown> {
    let scene = &problem.loaded().draft.scene;
    let mut shot = Shot { films: Vec::new(), nothing: Vec::new() };
    for (place, found) in staged(problem, variant).into_iter().enumerate() {
        let stage = place + 1;
        match found {
            Err(_) => match integrated(problem, variant, stage, request)? {
                Ok(films) => shot.films.extend(films),
                Err(reason) => shot.nothing.push((stage, reason.reason())),
            },
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
        // A stage may tell a mass of its own, as that of a rocket.
        let counted = film.record.bodies.iter().filter(|body| (body.mass - 1.0).abs() < f64::EPSILON);
        let names = counted.map(|body| body.name.clone());
        film.unweighed = names.filter(|body| !is_weighed(problem, variant, body)).collect();
    }
    if shot.films.is_empty() {
        let reason = shot.nothing.first().map_or_else(|| NothingToSimulate::NoStage.reason(), |(_, why)| why);
        let help = "`momentous list` shows other problems; docs/methods.md says what can be simulated";
        return Err(NotShown { what: format!("{}: {reason}", problem.id()), help });
    }
    Ok(shot)
}

/// A stage that no world describes, integrated in time as it is.
fn integrated(
    problem: &Problem,
    variant: &Variant,
    stage: usize,
    request: &Request,
) -> Result<Result<Vec<Film>, NothingToSimulate>, NotShown> {
    let Some(own) = problem.loaded().draft.scene.stages.get(stage - 1) else {
        return Ok(Err(NothingToSimulate::NoStage));
    };
    let choice = choose(&Classified::integrated(own.key()), request).map_err(|error| out_of_reach(stage, &error))?;
    let tolerance = choice.setting.unwrap_or(DEFAULT_ACCURACY);
    let motions = match followed(problem, variant, stage - 1, tolerance) {
        Ok(motions) => motions,
        Err(reason) => return Ok(Err(reason)),
    };
    let film = |RecordedMotion { components, record, notes }| {
        let choice = choice.clone();
        Film { stage, axes: components, choice, ending: AT_ITS_TIME.to_owned(), record, notes, unweighed: Vec::new() }
    };
    Ok(Ok(motions.into_iter().map(film).collect()))
}

/// Nothing in the table of costs serves.
fn out_of_reach(stage: usize, error: &NoChoice) -> NotShown {
    refused(stage, &error.to_string(), "ask for less accuracy, allow more time, or omit --method")
}

fn refused(stage: usize, what: &str, help: &'static str) -> NotShown {
    NotShown { what: format!("stage {stage}: {what}"), help }
}

/// Whether the mass of a body, or of each of its parts, is told or solved. A droplet is no body of the scene.
fn is_weighed(problem: &Problem, variant: &Variant, body: &str) -> bool {
    let scene = &problem.loaded().draft.scene;
    let value = |name: &str| problem.model().symbol_of(name).and_then(|symbol| variant.value(symbol));
    let known = |name: &str| value(name).is_some_and(|mass| mass.value > 0.0);
    let own =
        |part: &&str| scene.bodies.get(*part).is_some_and(|body| body.mass.is_some()) || known(&format!("m_{part}"));
    let members = scene.members(body);
    members.iter().all(own) || members.iter().all(|part| !scene.bodies.contains_key(*part))
}

fn filmed<const D: usize>(
    experiment: &Experiment<D>,
    scene: &Scene,
    stage: usize,
    request: &Request,
) -> Result<Film, NotShown> {
    let other = "omit --method to use the cheapest suitable method";
    let found = |refusal: momentous_simulate::Refusal| refused(stage, &refusal.to_string(), other);
    let mut experiment = experiment.clone();
    if let Some(steps) = request.steps {
        experiment.budget.steps = experiment.budget.steps.min(steps);
    }
    let shown = experiment.shown().map_err(found)?;
    let classified = classify(&shown.world, &shown.budget).map_err(found)?;
    let choice = choose(&classified, request).map_err(|error| out_of_reach(stage, &error))?;
    let method: Box<dyn Method<D>> = choice.method.at(choice.setting, shown.length);
    let run = method.run(&shown.world, &shown.budget);
    let run = run
        .map_err(|refusal| refused(stage, &format!("{} is not applicable: {refusal}", choice.method.name()), other))?;
    let ending = shown.cut_off(&run).unwrap_or_else(|| match run.ending {
        Ending::Time | Ending::Impacts | Ending::NoMoreImpacts | Ending::Exhausted => AT_ITS_TIME.to_owned(),
        Ending::Rest { .. } => "at rest".to_owned(),
    });
    let record = shown.record(&run);
    let axes = components(&experiment, scene);
    Ok(Film { stage, axes, choice, ending, record, notes: Vec::new(), unweighed: Vec::new() })
}

/// What the components of an experiment are called: as the quantities that are read off it, else as the axes of the scene.
fn components<const D: usize>(experiment: &Experiment<D>, scene: &Scene) -> Vec<Component> {
    let axes = scene.axes.rectangular();
    let suffix = experiment.readings.iter().find_map(|(name, _)| name.rsplit_once('.').map(|(_, letter)| letter));
    let own: Vec<Axis> = match suffix {
        Some(letter) if D == 1 => axes.iter().map(|(axis, _)| *axis).filter(|axis| axis.letter() == letter).collect(),
        _ => axes.iter().map(|(axis, _)| *axis).collect(),
    };
    (0..D)
        .map(|place| match own.get(place) {
            Some(axis) => Component::along(scene, *axis),
            None => Component::only("x"),
        })
        .collect()
}
