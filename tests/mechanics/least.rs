//! The least model: on the reference tasks the method that is chosen meets the request, and nothing cheaper in the table of costs
//! would have; on every stage of the bank and of the published problems what is shown is as accurate as was asked.

use momentous::problem::{Problem, Sampler, Variant};
use momentous::simulate::least::{Class, Request, classify, costs, options};
use momentous::simulate::{IN_THE_PLANE, Method, ON_A_LINE, Orbit, Task, Vector};
use momentous::witness::shoot;

use crate::variants;

/// The requests.
const ACCURACIES: [f64; 4] = [1e-2, 1e-4, 1e-7, 1e-10];

/// The accuracy of what all is compared with.
const FINEST: f64 = 2e-12;

/// What is found, for the whole test: how many choices were looked at in each class, and what was wrong.
#[derive(Default)]
struct Findings {
    looked_at: Vec<Class>,
    wrong: Vec<String>,
}

impl Findings {
    /// One request on one scene: the error of the chosen method against the truth.
    fn request<const D: usize>(
        &mut self,
        name: &str,
        accuracy: f64,
        classified: &momentous::simulate::least::Classified,
        error: impl FnOnce(&dyn Method<D>) -> Result<f64, String>,
        end: f64,
    ) {
        let request = Request { accuracy: Some(accuracy), ..Request::default() };
        let choices = options(classified, &request).unwrap_or_else(|error| panic!("{name} at {accuracy:e}: {error}"));
        let choice = &choices[0];
        let cost = choice.cost.clone().expect("a row");
        let cheaper = costs().iter().filter(|other| other.class == cost.class && other.seconds < cost.seconds);
        for other in cheaper.filter(|other| other.error <= accuracy) {
            self.wrong.push(format!("{name} at {accuracy:e}: {other:?} is cheaper than {cost:?}"));
        }
        match error(choice.method.at::<D>(choice.setting, end).as_ref()) {
            Ok(error) if error <= accuracy => {}
            Ok(error) => self.wrong.push(format!("{name} at {accuracy:e}: {choice} errs by {error:e}")),
            Err(refusal) => self.wrong.push(format!("{name} at {accuracy:e}: {choice}: {refusal}")),
        }
        self.looked_at.push(classified.class);
    }

    fn count(&self, class: Class) -> usize {
        self.looked_at.iter().filter(|looked| **looked == class).count()
    }

    fn task<const D: usize>(&mut self, task: &Task<D>) {
        let case = (task.jittered)(0.0);
        let classified = classify(&case.world, &case.budget).unwrap();
        for accuracy in ACCURACIES {
            let error = |method: &dyn Method<D>| {
                let run = method.run(&case.world, &case.budget).map_err(|refusal| refusal.to_string())?;
                case.truth.error(&run).ok_or_else(|| "it has other impacts".to_owned())
            };
            self.request(task.name, accuracy, &classified, error, case.budget.until);
        }
    }

    /// One request on one variant: what is shown is as accurate as was asked, against the finest that there is.
    fn variant(&mut self, name: &str, problem: &Problem, variant: &Variant, accuracy: f64) {
        let request = |accuracy| Request { accuracy: Some(accuracy), ..Request::default() };
        let (shot, best) =
            match (shoot(problem, variant, &request(accuracy)), shoot(problem, variant, &request(FINEST))) {
                (Ok(shot), Ok(best)) => (shot, best),
                (Err(reason), _) => return self.refused(name, accuracy, &reason.what),
                // What is not to be had so finely is compared with what it was compared with itself.
                (Ok(shot), Err(_)) => (shot.clone(), shot),
            };
        for (film, truth) in shot.films.iter().zip(&best.films) {
            self.looked_at.push(film.choice.class);
            let apart = film.record.apart(&truth.record, film.ending == "at rest").unwrap_or(f64::INFINITY);
            let claimed = film.error.unwrap_or(f64::INFINITY);
            if claimed > accuracy || apart > accuracy {
                let stage = film.stage;
                self.wrong.push(format!("{name}, stage {stage} at {accuracy:e}: {}, in truth {apart:e}", film.why()));
            }
        }
    }

    fn refused(&mut self, name: &str, accuracy: f64, reason: &str) {
        // What has nothing to watch is refused whatever is asked.
        if reason.contains("meets this") || reason.contains("keeps the error") {
            self.wrong.push(format!("{name} at {accuracy:e}: {reason}"));
        }
    }
}

#[test]
fn the_choice_meets_the_request_on_the_reference_tasks() {
    let mut findings = Findings::default();
    for task in ON_A_LINE {
        findings.task(task);
    }
    for task in IN_THE_PLANE {
        findings.task(task);
    }
    assert!(findings.wrong.is_empty(), "{}", findings.wrong.join("\n"));
}

/// Each stage of the bank and of the published problems, at four accuracies for twelve seeds; an ordinary run takes every other
/// form at one of the four and one of the twelve, in turn. `.ci/soak kept` takes all.
#[test]
fn what_is_asked_is_kept_on_every_stage() {
    let mut findings = Findings::default();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/reference");
    let mut problems = variants::bank();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        if text.contains("scene:") {
            problems.push(variants::problem(&path.display().to_string(), &text));
        }
    }
    let seeds = variants::seeds(1);
    let mut turn = 0;
    for problem in &problems {
        for form in 0..problem.forms().len() {
            for seed in 1..=seeds {
                turn += 1;
                if seeds == 1 && turn % 2 == 0 {
                    continue;
                }
                let one = [ACCURACIES[turn / 2 % ACCURACIES.len()]];
                let (seed, accuracies) =
                    if seeds > 1 { (seed, &ACCURACIES[..]) } else { (turn as u64 % 12 + 1, &one[..]) };
                let Ok(variant) = Sampler::new(problem, form).unwrap().variant(seed) else { continue };
                let name = format!("{}, seed {seed}", variants::form_name(problem, form));
                for accuracy in accuracies {
                    findings.variant(&name, problem, &variant, *accuracy);
                }
            }
        }
    }
    assert!(findings.wrong.is_empty(), "{}\n{} wrong", findings.wrong.join("\n"), findings.wrong.len());
    for (class, least) in [(Class::ClosedForm, 60), (Class::Piecewise, 20), (Class::OdeNeeded, 15)] {
        assert!(findings.count(class) >= least, "{}: only {}", class.name(), findings.count(class));
    }
}

/// The same of an orbit against its own formula, at every instant that is shown.
#[test]
fn a_comet_is_where_the_conic_has_it() {
    let problem = variants::bank_problem("central-force/comet-visit");
    for seed in 1..=12 {
        let variant = Sampler::new(&problem, 0).unwrap().variant(seed).unwrap();
        let shot = shoot(&problem, &variant, &Request::default()).unwrap();
        let film = &shot.films[0];
        let [position, velocity] = [&film.record.moments[0].positions[0], &film.record.moments[0].velocities[0]];
        let plane = |vector: &[f64]| Vector::<2>::from([vector[0], vector[1]]);
        let (position, velocity) = (plane(position), plane(velocity));
        let parameter = variant.value(problem.model().symbol_of("GM").unwrap()).unwrap().value;
        let centre = film.record.pivot.as_ref().map_or(Vector::zeros(), |pivot| plane(&pivot.at));
        let orbit = Orbit { centre, parameter, position, velocity };
        let way = film
            .record
            .moments
            .iter()
            .map(|moment| (plane(&moment.positions[0]) - position).norm())
            .fold(0.0, f64::max);
        for moment in &film.record.moments {
            let off = (plane(&moment.positions[0]) - orbit.at(moment.time).0).norm();
            assert!(off <= 1e-9 * way, "seed {seed}: {off:e} of {way:e} m at {} s", moment.time);
        }
    }
}
