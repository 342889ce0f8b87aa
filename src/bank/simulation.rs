//! A few variants simulated stage by stage, by methods that share no code with the laws.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::collections::BTreeSet;

use crate::model::Instant;
use crate::model::Name;
use crate::model::Timeline;
use crate::problem::Problem;
use crate::problem::Sampler;
use crate::problem::Variant;
use crate::scene::Scene;
use crate::simulate::scene::NothingToSimulate;
use crate::simulate::scene::Reached;
use crate::simulate::scene::Staged;
use crate::simulate::scene::translate;
use crate::solve::Bounded;

use super::promise::Outcome;

/// Seeds whose variants are simulated.
const SIMULATED: u64 = 64;

/// By which share of itself an input is changed to see what its own error does.
const NUDGE: f64 = 1e-6;

/// Every velocity after a stage that the variant has is what a simulation of that stage finds, from what was before it.
pub(super) fn agrees(problem: &Problem, form: usize, seeds: u64) -> Outcome {
    let Ok(mut sampler) = Sampler::new(problem, form) else { return Outcome::NotChecked("nothing was drawn") };
    let scene = &problem.loaded().draft.scene;
    let empty = if scene.stages.is_empty() { NothingToSimulate::NoStage } else { NothingToSimulate::NothingSolved };
    let (mut compared, mut nothing) = (0, empty);
    for seed in 1..=seeds.min(SIMULATED) {
        let Ok(variant) = sampler.variant(seed) else { continue };
        let witness = Witness::new(problem, &variant);
        for stage in 0..scene.stages.len() {
            match witness.stage(stage) {
                Ok(Compared { agreeing, differing: None }) => compared += agreeing,
                Ok(Compared { differing: Some(said), .. }) => {
                    return Outcome::Broken(format!("with seed {seed}, {said}"));
                }
                Err(reason) => nothing = reason,
            }
        }
    }
    if compared == 0 { Outcome::NotChecked(nothing.reason()) } else { Outcome::Kept }
}

/// A variant with the quantities of its scene by name, from which its stages are simulated in order.
pub struct Witness<'a> {
    problem: &'a Problem,
    scene: &'a Scene,
    variant: &'a Variant,
    timeline: Timeline,
    /// What stages before reached, where the form neither tells nor solves it.
    reached: RefCell<BTreeMap<String, Bounded>>,
}

/// How often a stage's simulation agrees with the variant, and the first time that it does not.
struct Compared {
    agreeing: usize,
    differing: Option<String>,
}

impl<'a> Witness<'a> {
    /// The witness of a variant.
    #[must_use]
    pub fn new(problem: &'a Problem, variant: &'a Variant) -> Self {
        let scene = &problem.loaded().draft.scene;
        Self { problem, scene, variant, timeline: Timeline::new(scene), reached: RefCell::default() }
    }

    /// What simulates a stage, counted from 0, after those before it; what it reaches is kept for those that follow.
    ///
    /// # Errors
    /// There is nothing to simulate: why.
    pub fn staged(&self, stage: usize) -> Result<Staged, NothingToSimulate> {
        let staged = translate(self.scene, stage, &|name| Some(self.value(name)?.value))?;
        if let Ok(reached) = staged.run() {
            let mut known = self.reached.borrow_mut();
            known.extend(
                reached.into_iter().map(|found| (found.name, Bounded { value: found.value, error: found.error })),
            );
        }
        Ok(staged)
    }

    /// The value of a quantity: what the variant has, else what a stage before reached.
    fn value(&self, name: &str) -> Option<Bounded> {
        let name = self.since(name);
        self.solved(&name).or_else(|| self.reached.borrow().get(&name).copied())
    }

    /// The value that the variant has.
    fn solved(&self, name: &str) -> Option<Bounded> {
        self.problem.model().symbol_of(name).and_then(|symbol| self.variant.value(symbol))
    }

    /// A velocity under the name of the instant since which the body has it.
    fn since(&self, name: &str) -> String {
        let Some(Name { base, subject, instant: Some(Instant::Number(at)), component, stage: None }) =
            Name::parse(name)
        else {
            return name.to_owned();
        };
        let since = self.timeline.since(&subject, at).unwrap_or(at);
        let component = component.map_or_else(String::new, |letter| format!(".{letter}"));
        if base == "v" { format!("v_{subject}{since}{component}") } else { name.to_owned() }
    }

    fn stage(&self, stage: usize) -> Result<Compared, NothingToSimulate> {
        let mut compared = Compared { agreeing: 0, differing: None };
        for (name, found) in self.simulated(stage)? {
            match self.solved(&self.since(&name)) {
                Some(solved) if (solved.value - found.value).abs() <= solved.error + found.error => {
                    compared.agreeing += 1;
                }
                Some(solved) => {
                    let said = format!(
                        "`{name}` is {} by the laws and {} by simulation, {:e} apart where errors allow {:e}",
                        solved.value,
                        found.value,
                        (solved.value - found.value).abs(),
                        solved.error + found.error
                    );
                    compared.differing.get_or_insert(said);
                }
                None => drop(self.reached.borrow_mut().insert(name, found)),
            }
        }
        Ok(compared)
    }

    /// What a simulation of the stage finds, with what the errors of its inputs do to it.
    fn simulated(&self, stage: usize) -> Result<Vec<(String, Bounded)>, NothingToSimulate> {
        let used = RefCell::new(BTreeSet::new());
        let plain = |name: &str| {
            used.borrow_mut().insert(self.since(name));
            Some(self.value(name)?.value)
        };
        let reached = self.run(stage, &plain)?;
        let mut all: Vec<(String, Bounded)> = Vec::new();
        for Reached { name, value, error } in reached {
            all.push((name, Bounded { value, error }));
        }
        let values: Vec<f64> = all.iter().map(|(_, found)| found.value).collect();
        for input in used.into_inner() {
            let Some(Bounded { value, error }) = self.value(&input).filter(|value| value.error > 0.0) else { continue };
            let nudge = if value == 0.0 { NUDGE } else { value.abs() * NUDGE };
            let nudged = |name: &str| {
                let own = self.value(name)?.value;
                Some(if self.since(name) == input { own - nudge } else { own })
            };
            let Ok(changed) = self.run(stage, &nudged) else { continue };
            for (((_, found), value), changed) in all.iter_mut().zip(&values).zip(changed) {
                // Twice the slope: a chord is not the tangent.
                found.error += 2.0 * ((changed.value - value) / nudge).abs() * error;
            }
        }
        Ok(all)
    }

    fn run(&self, stage: usize, value: &dyn Fn(&str) -> Option<f64>) -> Result<Vec<Reached>, NothingToSimulate> {
        let staged = translate(self.scene, stage, value)?;
        staged.run().map_err(|_| NothingToSimulate::NoMethod)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::fault::Source;
    use crate::problem::compile;
    use crate::problem::load;
    use crate::scene::Stage;
    use crate::scene::Term;

    const GLANCE: &str = "
id: a/b
title: B
level: intro
scene:
  axes: { x: east, y: north }
  bodies: { A: { name: disc A, mass: m_A }, B: { name: disc B, mass: 2 kg } }
  stages: [{ impact: { between: [A, B], restitution: e, line_of_impact: 30 deg above +x } }]
given:
  m_A: { min: 1, max: 3, step: 0.1, unit: kg }
  v_A1.x: { min: 2, max: 4, step: 0.1, unit: m/s }
  v_A1.y: 1 m/s
  v_B1.x: 0 m/s
  v_B1.y: 0 m/s
  e: { min: 0.2, max: 0.8, step: 0.1 }
text: >
  Two discs meet, {{ m_A }} at {{ v_A1.x }}; the coefficient of restitution is {{ e }}.
ask: [{ find: v_A2.x, unit: m/s }, { find: v_B2.y, unit: m/s }]
";

    fn problem() -> Problem {
        compile(load(Source::new("b.yaml", GLANCE)).unwrap(), None).unwrap()
    }

    #[test]
    fn what_the_laws_find_is_what_a_simulation_finds() {
        assert_eq!(agrees(&problem(), 0, 8), Outcome::Kept);
    }

    #[test]
    fn laws_of_another_scene_are_found_out() {
        let problem = problem();
        let variant = Sampler::new(&problem, 0).unwrap().variant(1).unwrap();
        let mut scene = problem.loaded().draft.scene.clone();
        let Some(Stage::Impact(impact)) = scene.stages.first_mut() else { panic!("an impact") };
        impact.line_of_impact = Some(Term("30.00000001 deg above +x".to_owned()));
        let compared = Witness { scene: &scene, ..Witness::new(&problem, &variant) }.stage(0).unwrap();
        assert!(compared.differing.is_some_and(|said| said.starts_with("`v_A2.x` is ")));
    }
}
