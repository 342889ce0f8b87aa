//! The stages of a variant, simulated one after another.

use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_scene::Axis;
use momentous_scene::Scene;
use momentous_simulate::Ending;
use momentous_simulate::MethodKind;
use momentous_simulate::least::Class;
use momentous_simulate::least::Kept;
use momentous_simulate::least::NotKept;
use momentous_simulate::least::Request;
use momentous_simulate::least::classify;
use momentous_simulate::least::keep;
use momentous_simulate::scene::Component;
use momentous_simulate::scene::Experiment;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::Staged;

use super::film::{AT_ITS_TIME, Film, NotFilmed, out_of_reach, refused};
use super::integrated::integrated;
use super::staging::staged;

/// All that could be simulated, and why the rest could not.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The films of what was simulated.
    pub films: Vec<Film>,
    /// Stages, counted from 1, with the reason.
    pub nothing: Vec<(usize, &'static str)>,
}

/// Simulates every stage.
///
/// # Errors
/// Nothing in the scene can be simulated, or not by that method within that accuracy and time.
pub fn shoot(problem: &Problem, variant: &Variant, request: &Request) -> Result<Shot, NotFilmed> {
    let scene = &problem.loaded().draft.scene;
    let mut shot = Shot { films: Vec::new(), nothing: Vec::new() };
    for (place, stage_run) in staged(problem, variant).into_iter().enumerate() {
        let stage = place + 1;
        match stage_run {
            Err(_) => match integrated(problem, variant, stage, request)? {
                Ok(films) => shot.films.extend(films),
                Err(reason) => shot.nothing.push((stage, reason.reason())),
            },
            // Without exact motion between impacts the motion as it is may still have a formula.
            Ok(staged)
                if !is_exact(&staged) && request.method.is_none_or(|method| method == MethodKind::ClosedForm) =>
            {
                match integrated(problem, variant, stage, request)? {
                    Ok(films) if films.iter().all(|film| film.choice.class == Class::ClosedForm) => {
                        shot.films.extend(films);
                    }
                    _ => shot.films.extend(run(&staged, scene, stage, request)?),
                }
            }
            Ok(staged) => shot.films.extend(run(&staged, scene, stage, request)?),
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
        return Err(NotFilmed { what: format!("{}: {reason}", problem.id()), help });
    }
    Ok(shot)
}

/// Whether the mass of a body, or of each of its parts, is told or solved. A droplet is no body of the scene.
fn is_weighed(problem: &Problem, variant: &Variant, body: &str) -> bool {
    let scene = &problem.loaded().draft.scene;
    let value = |name: &str| problem.model().symbol_of(name).and_then(|symbol| variant.value(symbol));
    let known = |name: &str| value(name).is_some_and(|mass| mass.value > 0.0);
    let all_parts =
        |part: &&str| scene.bodies.get(*part).is_some_and(|body| body.mass.is_some()) || known(&format!("m_{part}"));
    let members = scene.members(body);
    members.iter().all(all_parts) || members.iter().all(|part| !scene.bodies.contains_key(*part))
}

/// The films of all parts of a stage that are worlds.
fn run(staged: &Staged, scene: &Scene, stage: usize, request: &Request) -> Result<Vec<Film>, NotFilmed> {
    let on_lines = staged.on_lines.iter().map(|experiment| filmed(experiment, scene, stage, request));
    on_lines.chain(staged.in_planes.iter().map(|experiment| filmed(experiment, scene, stage, request))).collect()
}

/// Whether all motions of a stage between impacts are known exactly.
fn is_exact(staged: &Staged) -> bool {
    fn all<const D: usize>(experiments: &[Experiment<D>]) -> bool {
        let class = |experiment: &Experiment<D>| classify(&experiment.world, &experiment.budget);
        experiments.iter().all(|experiment| class(experiment).is_ok_and(|found| found.class != Class::OdeNeeded))
    }
    all(&staged.on_lines) && all(&staged.in_planes)
}

fn filmed<const D: usize>(
    experiment: &Experiment<D>,
    scene: &Scene,
    stage: usize,
    request: &Request,
) -> Result<Film, NotFilmed> {
    let other = "omit --method to use the cheapest suitable method";
    let refused_by_method = |refusal: momentous_simulate::Refusal| refused(stage, &refusal.to_string(), other);
    let mut experiment = experiment.clone();
    if let Some(steps) = request.steps {
        experiment.budget.steps = experiment.budget.steps.min(steps);
    }
    let shown = experiment.shown().map_err(refused_by_method)?;
    let kept = keep(&shown, request).map_err(|error| match error {
        NotKept::Choice(error) => out_of_reach(stage, &error),
        NotKept::Scene(_) | NotKept::Method { .. } => refused(stage, &error.to_string(), other),
    })?;
    let ending = shown.cut_off(&kept.run).unwrap_or_else(|| match kept.run.ending {
        Ending::Time | Ending::Impacts | Ending::NoMoreImpacts | Ending::Exhausted => AT_ITS_TIME.to_owned(),
        Ending::Rest { .. } => "at rest".to_owned(),
    });
    let Kept { choice, record, error, seconds, .. } = kept;
    let axes = components(&experiment, scene);
    Ok(Film { stage, axes, choice, error, seconds, ending, record, notes: Vec::new(), unweighed: Vec::new() })
}

/// The names of the components of an experiment: as the quantities that are read off it, else as the axes of the scene.
fn components<const D: usize>(experiment: &Experiment<D>, scene: &Scene) -> Vec<Component> {
    let axes = scene.axes.rectangular();
    let suffix = experiment.readings.iter().find_map(|(name, _)| name.rsplit_once('.').map(|(_, letter)| letter));
    let alone: Vec<Axis> = match suffix {
        Some(letter) if D == 1 => axes.iter().map(|(axis, _)| *axis).filter(|axis| axis.letter() == letter).collect(),
        _ => axes.iter().map(|(axis, _)| *axis).collect(),
    };
    (0..D)
        .map(|place| match alone.get(place) {
            Some(axis) => Component::along(scene, *axis),
            None => Component::only("x"),
        })
        .collect()
}
