//! What is watched is what is asked for: every scene with impacts, by every method that does not refuse it, shows the impact
//! that is asked for as its last one, and after it the velocities that the laws have. `MOMENTOUS_SEEDS=200` looks further.

use momentous::problem::{Problem, Sampler, Variant};
use momentous::simulate::MethodKind;
use momentous::simulate::least::Request;
use momentous::simulate::scene::{Experiment, Reading};
use momentous::witness::{Film, shoot, staged};

use crate::variants;

/// The accuracy that is asked of a method by name, for which none needs long.
const ROUGHLY: f64 = 1e-2;

/// That of the method that is chosen where none is named.
const USUALLY: f64 = 1e-9;

/// What was looked at, and what is wrong.
#[derive(Default)]
struct Findings {
    impacts: usize,
    after: usize,
    refused: usize,
    wrong: Vec<String>,
}

impl Findings {
    fn problem(&mut self, problem: &Problem, form: usize, seed: u64) {
        let Ok(variant) = Sampler::new(problem, form).unwrap().variant(seed) else { return };
        let counted = |stages: &[Option<Asked>]| stages.iter().flatten().any(|asked| asked.impacts.is_some());
        let asked = asked(problem, &variant);
        if !counted(&asked) {
            return;
        }
        let methods = MethodKind::ALL.iter().filter(|method| method.is_ours());
        let named = methods.map(|method| (Some(*method), Some(ROUGHLY)));
        for (method, accuracy) in [(None, None)].into_iter().chain(named) {
            let name = format!("{}, seed {seed}, {method:?}", variants::form_name(problem, form));
            match shoot(problem, &variant, &Request { method, accuracy, ..Request::default() }) {
                // A stage of the scene may be beyond the method.
                Err(_) if method.is_some() => self.refused += 1,
                Err(reason) => self.wrong.push(format!("{name}: {reason}")),
                Ok(shot) => {
                    let films = shot.films.iter().zip(&asked);
                    let accuracy = accuracy.unwrap_or(USUALLY);
                    films.for_each(|(film, asked)| self.film(&name, film, asked.as_ref(), accuracy));
                }
            }
        }
    }

    fn film(&mut self, name: &str, film: &Film, asked: Option<&Asked>, accuracy: f64) {
        let Some(asked) = asked else { return };
        let shown = film.record.impacts.len();
        if asked.impacts.is_some_and(|count| count != shown) {
            self.wrong.push(format!("{name}: {shown} impacts, not {:?}", asked.impacts));
        }
        self.impacts += usize::from(asked.impacts.is_some());
        let Some(last) = film.record.moments.last() else { return self.wrong.push(format!("{name}: nothing")) };
        let velocities = film.record.moments.iter().flat_map(|moment| &moment.velocities);
        let speeds = velocities.map(|velocity| velocity.iter().map(|part| part * part).sum::<f64>().sqrt());
        let fastest = speeds.fold(0.0_f64, f64::max);
        for (body, component, expected) in &asked.velocities {
            let computed = last.velocities[*body][*component];
            self.after += 1;
            if (computed - expected).abs() > accuracy * fastest {
                self.wrong.push(format!("{name}: {computed} m/s after the last impact, not {expected}"));
            }
        }
    }
}

/// What is asked of an experiment.
struct Asked {
    /// The number of impacts that end it; none where it is another end.
    impacts: Option<usize>,
    /// Bodies and components, with the velocities that the laws have.
    velocities: Vec<(usize, usize, f64)>,
}

/// What is asked of each experiment, in the order of the films; none for stages that no world describes.
fn asked(problem: &Problem, variant: &Variant) -> Vec<Option<Asked>> {
    let mut all = Vec::new();
    for found in staged(problem, variant) {
        match found {
            Ok(staged) => {
                all.extend(staged.on_lines.iter().map(|task| Some(of(task, problem, variant))));
                all.extend(staged.in_planes.iter().map(|task| Some(of(task, problem, variant))));
            }
            // How many films such a stage has is not known here: nothing behind it is compared.
            Err(_) => break,
        }
    }
    all
}

fn of<const D: usize>(experiment: &Experiment<D>, problem: &Problem, variant: &Variant) -> Asked {
    let mut asked = Asked { impacts: None, velocities: Vec::new() };
    let count = experiment.budget.impacts;
    if experiment.readings.iter().any(|(_, reading)| matches!(reading, Reading::Arrival { .. })) {
        return asked;
    }
    if experiment.budget.until.is_infinite() && count < usize::MAX && !experiment.world.walls.is_empty() {
        asked.impacts = Some(count);
    }
    for (name, reading) in &experiment.readings {
        let Reading::Velocity { body, component, sign } = *reading else { continue };
        let solved = problem.model().symbol_of(name).and_then(|symbol| variant.value(symbol));
        asked.velocities.extend(solved.map(|solved| (body, component, sign * solved.value)));
    }
    asked
}

#[test]
fn what_is_asked_for_is_shown_by_every_method_that_does_not_refuse() {
    let mut findings = Findings::default();
    for problem in variants::bank() {
        for form in 0..problem.forms().len() {
            for seed in 1..=variants::seeds(1) {
                findings.problem(&problem, form, seed);
            }
        }
    }
    assert!(findings.wrong.is_empty(), "{}\n{} wrong", findings.wrong.join("\n"), findings.wrong.len());
    assert!(findings.impacts >= 50 && findings.after >= 50, "{} {}", findings.impacts, findings.after);
    assert!(findings.refused > 0, "no method refuses anything");
}
