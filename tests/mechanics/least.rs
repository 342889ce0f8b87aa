//! The least model: on every scene of the bank, of the published problems and of the reference tasks, the method that is chosen
//! meets the request, and nothing cheaper in the table of costs would have.

use momentous::problem::{Problem, Sampler};
use momentous::simulate::least::{Class, Request, choose, classify, costs};
use momentous::simulate::scene::Experiment;
use momentous::simulate::{EventDriven, IN_THE_PLANE, Method, ON_A_LINE, RungeKutta, Task};
use momentous::witness::staged;

use crate::variants;

/// The requests.
const ACCURACIES: [f64; 4] = [1e-2, 1e-4, 1e-7, 1e-10];

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
        let choice = choose(classified, &request).unwrap_or_else(|error| panic!("{name} at {accuracy:e}: {error}"));
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
        self.looked_at.iter().filter(|own| **own == class).count()
    }

    fn task<const D: usize>(&mut self, task: &Task<D>) {
        let case = (task.jittered)(0.0);
        let classified = classify(&case.world, &case.budget).unwrap();
        for accuracy in ACCURACIES {
            let error = |method: &dyn Method<D>| {
                let run = method.run(&case.world, &case.budget).map_err(|refusal| refusal.to_string())?;
                let value = (case.measure)(&run).ok_or("no answer")?;
                Ok((value - case.expected).abs() / case.expected.abs())
            };
            self.request(task.name, accuracy, &classified, error, case.budget.until);
        }
    }

    fn experiment<const D: usize>(
        &mut self,
        name: &str,
        problem: &Problem,
        variant: &momentous::problem::Variant,
        experiment: &Experiment<D>,
    ) {
        let (world, budget) = (&experiment.world, &experiment.budget);
        let classified = classify(world, budget).unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
        let best = EventDriven.run(world, budget).or_else(|_| RungeKutta { tolerance: 1e-13 }.run(world, budget));
        let truth: Vec<_> = experiment.read(&best.unwrap_or_else(|refusal| panic!("{name}: {refusal}"))).collect();
        for accuracy in ACCURACIES {
            let error = |method: &dyn Method<D>| {
                let run = method.run(world, budget).map_err(|refusal| refusal.to_string())?;
                let mut greatest = 0.0_f64;
                for ((quantity, value, _), (_, other, scale)) in experiment.read(&run).zip(&truth) {
                    // The laws' own value where the problem has one, else the best that a simulation can do.
                    let solved = problem.model().symbol_of(&quantity).and_then(|symbol| variant.value(symbol));
                    let expected = solved.map_or(*other, |solved| solved.value);
                    greatest = greatest.max((value - expected).abs() / scale.max(f64::MIN_POSITIVE));
                }
                Ok(greatest)
            };
            self.request(name, accuracy, &classified, error, budget.until);
        }
    }

    fn problem(&mut self, problem: &Problem) {
        for form in 0..problem.forms().len() {
            let mut sampler = Sampler::new(problem, form).unwrap();
            let Ok(variant) = sampler.variant(1) else { continue };
            for (stage, found) in staged(problem, &variant).into_iter().enumerate() {
                let Ok(staged) = found else { continue };
                let name = format!("{}, stage {}", variants::form_name(problem, form), stage + 1);
                for experiment in &staged.on_lines {
                    self.experiment(&name, problem, &variant, experiment);
                }
                for experiment in &staged.in_planes {
                    self.experiment(&name, problem, &variant, experiment);
                }
            }
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

#[test]
fn the_choice_meets_the_request_on_every_scene_of_the_bank_and_of_the_published_problems() {
    let mut findings = Findings::default();
    for problem in variants::bank() {
        findings.problem(&problem);
    }
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/reference");
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        if text.contains("scene:") {
            findings.problem(&variants::problem(&path.display().to_string(), &text));
        }
    }
    assert!(findings.wrong.is_empty(), "{}", findings.wrong.join("\n"));
    // Few forces of the bank are no polynomials in the time.
    for (class, least) in [(Class::ClosedForm, 40), (Class::LinearSolve, 40), (Class::OdeNeeded, 16)] {
        assert!(findings.count(class) >= least, "{}: only {}", class.name(), findings.count(class));
    }
}
