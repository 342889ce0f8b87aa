//! Variants simulated and compared with the laws. Whether an answer is witnessed at all is tried: put wrong by a thousandth, it
//! has to be found out.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use serde::Serialize;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::Problem;
use momentous_problem::Sampler;
use momentous_problem::Worked;
use momentous_quantity::Dimension;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::Procedure;

use super::TOLERANCES;
use super::case::Case;
use super::parts;
use super::parts::Answer;
use super::simulation::Comparison;
use super::simulation::Witness;

/// By which share of itself an input is changed to see what its own error does.
const NUDGE: f64 = 1e-6;

/// An energy, in joules, that nothing measures: where everything is at rest there is no other size to compare a remainder with.
const NO_ENERGY: f64 = 1e-30;

/// The share of a value that its bound has to be for the value to count as one that is not zero.
const NEAR_ZERO: f64 = 1e-4;

/// The results of simulating a form.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Simulated {
    /// The number of seeds that were simulated.
    pub seeds: u64,
    /// By which ways.
    pub ways: Vec<&'static str>,
    /// The number of quantities that were compared, over all seeds.
    pub compared: usize,
    /// The largest distance between laws and simulation, in parts of the value.
    pub apart: f64,
    /// The bound on that distance, in parts of the value, where it is largest.
    pub bound: f64,
    /// The answers that were found out when they were put wrong by a thousandth.
    pub witnessed: Vec<String>,
    /// The answers that were not.
    pub unseen: Vec<String>,
    /// Why something was not simulated.
    pub nothing: Option<&'static str>,
}

impl Simulated {
    /// Whether every answer would be found out if it were wrong.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.unseen.is_empty() && !self.witnessed.is_empty()
    }

    /// Takes in what further seeds come to.
    pub fn add(&mut self, other: Self) {
        self.seeds += other.seeds;
        self.compared += other.compared;
        self.apart = self.apart.max(other.apart);
        self.bound = self.bound.max(other.bound);
        self.witnessed.extend(other.witnessed);
        self.unseen.extend(other.unseen);
    }
}

/// The results of simulating a few seeds of a form.
#[derive(Default)]
pub struct Portion {
    /// The results so far.
    pub simulated: Simulated,
    /// By which ways.
    pub ways: BTreeSet<Procedure>,
    /// Why something was not simulated.
    pub reason: Option<NothingToSimulate>,
    /// The difference between laws and simulation.
    pub broken: Option<String>,
}

impl Portion {
    /// Simulates seeds one after another, until one is found that differs.
    #[must_use]
    pub fn of(problem: &Problem, form: usize, seeds: RangeInclusive<u64>) -> Self {
        let (mut portion, is_first) = (Self::default(), *seeds.start() == 1);
        let Ok(mut sampler) = Sampler::new(problem, form) else { return portion };
        let scene = &problem.loaded().draft.scene;
        for seed in seeds {
            let Ok(variant) = sampler.variant(seed) else { continue };
            let Some(worked) = Worked::new(problem, &variant) else { continue };
            let case = Case { problem, scene, variant: &variant, replaced: Vec::new(), known: None };
            let mut trial = Trial::new(&worked, &case);
            portion.simulated.seeds += 1;
            // The very first says how far off all can be, and how closely everything would be seen.
            let is_looked_at = is_first && portion.simulated.seeds == 1;
            if is_looked_at {
                trial.widen();
            }
            portion.ways.extend(trial.witness.ways());
            portion.reason = portion.reason.or(trial.witness.nothing);
            if let Some(said) = trial.differing(&mut portion.simulated) {
                portion.broken = Some(format!("with seed {seed}, {said}"));
                break;
            }
            if is_looked_at {
                trial.put_wrong(&mut portion.simulated);
            }
        }
        portion
    }
}

/// One variant, simulated and compared, with a bound on how far each comparison may be off.
struct Trial<'a> {
    worked: &'a Worked<'a>,
    case: &'a Case<'a>,
    witness: Witness<'a>,
    rough: BTreeMap<String, Comparison>,
    all: BTreeMap<String, (Comparison, f64)>,
    /// Whether the bounds hold what the errors of the inputs can do, and not only those of the run.
    wide: bool,
}

impl<'a> Trial<'a> {
    fn new(worked: &'a Worked<'a>, case: &'a Case<'a>) -> Self {
        let [fine, coarse] = TOLERANCES;
        let witness = Witness::new(case, fine);
        let comparisons = compared(worked, &witness);
        let rough = compared(worked, &Witness::new(case, coarse));
        let mut all: BTreeMap<String, (Comparison, f64)> = BTreeMap::new();
        for (name, comparison) in comparisons {
            let run = rough.get(&name).map_or(0.0, |rough| (rough.found - comparison.found).abs());
            let bound = comparison.error + run;
            all.insert(name, (comparison, bound));
        }
        allow_for_zeros(worked, &mut all);
        let mut trial = Self { worked, case, witness, rough, all, wide: false };
        trial.compare_formulas();
        trial
    }

    /// Puts into the bounds what the errors of the inputs can do: a run more for each of them.
    fn widen(&mut self) {
        let [_, coarse] = TOLERANCES;
        let expressions = self.expressions();
        for symbol in self.witness.inputs() {
            let Some(value) = self.worked.variant.value(symbol).filter(|value| value.error > 0.0) else { continue };
            let nudge = if value.value == 0.0 { NUDGE } else { value.value.abs() * NUDGE };
            let other = Case { replaced: vec![(symbol, value.value - nudge)], ..*self.case };
            // The coarser run will do for a slope, so long as it is compared with its like.
            let changed = compared(self.worked, &Witness::new(&other, coarse));
            for (name, (_, bound)) in self.all.iter_mut().filter(|(name, _)| !expressions.contains_key(name.as_str())) {
                if let (Some(changed), Some(rough)) = (changed.get(name), self.rough.get(name)) {
                    // Twice the slope: a chord is not the tangent.
                    *bound += 2.0 * ((changed.apart() - rough.apart()) / nudge).abs() * value.error;
                }
            }
        }
        for (name, parts) in expressions {
            let of_parts: f64 =
                parts.iter().filter_map(|(part, slope)| Some(slope.abs() * self.all.get(*part)?.1)).sum();
            if let Some((_, bound)) = self.all.get_mut(name) {
                *bound += of_parts;
            }
        }
        self.wide = true;
        self.compare_formulas();
    }

    /// The expressions that questions name, each with how it moves with its parts.
    fn expressions(&self) -> BTreeMap<&'a str, Vec<(&'a str, f64)>> {
        let (variant, model) = (self.worked.variant, self.worked.problem.model());
        let value = |symbol| variant.value(symbol).map_or(f64::NAN, |number| number.value);
        let name = |symbol: Symbol| model.symbols.entry(symbol).name.as_str();
        let parts = |expression: &Expr| {
            let mut parts = Vec::new();
            expression.slopes(&value, 1.0, &mut |symbol, slope| parts.push((name(symbol), slope)));
            parts
        };
        model.expressions.iter().map(|(symbol, expression)| (name(*symbol), parts(expression))).collect()
    }

    /// A formula that is asked is compared as the quantity for which it stands.
    fn compare_formulas(&mut self) {
        for (name, symbol, said) in parts::formulas(self.worked) {
            let quantity = &self.worked.problem.model().symbols.entry(symbol).name;
            if let Some((comparison, bound)) = self.all.get(quantity).cloned() {
                self.all.insert(name, (Comparison { stated: said, ..comparison }, bound));
            }
        }
    }

    /// The first quantity on which laws and simulation differ; what was compared is counted.
    fn differing(&mut self, simulated: &mut Simulated) -> Option<String> {
        // What the run alone explains needs no further runs.
        if !self.wide && self.all.values().any(is_beyond) {
            self.widen();
        }
        for (name, judged) in &self.all {
            simulated.compared += 1;
            let (comparison, bound) = judged;
            let apart = comparison.apart().abs();
            if is_beyond(judged) {
                return Some(format!(
                    "`{name}` is {} by the laws and {} by simulation: a difference of {apart:e}, where errors allow {bound:e}",
                    comparison.stated, comparison.found
                ));
            }
            let size = comparison.stated.abs();
            // Beside a value that is nothing but rounding, no distance is small.
            if size > *bound / NEAR_ZERO {
                simulated.apart = simulated.apart.max(apart / size);
                simulated.bound = simulated.bound.max(bound / size);
            }
        }
        let wrong = |answer: &Answer<'_>| {
            parts::agrees(self.worked, self.case, &self.witness, answer, TOLERANCES[0]) == Some(false)
        };
        let answer = Answer::all(self.worked).into_iter().find(wrong)?;
        Some(format!("the answer to {} is different by simulation", answer.id()))
    }

    /// Puts every answer wrong, one after another, and sorts them by whether that is found out.
    fn put_wrong(&self, simulated: &mut Simulated) {
        for answer in Answer::all(self.worked) {
            let found_out = match answer.wrong(self.worked) {
                // Any other phrase would differ from the one that the simulation finds.
                None => parts::agrees(self.worked, self.case, &self.witness, &answer, TOLERANCES[0]).is_some(),
                Some((symbol, wrong)) => {
                    self.finds_out(symbol, wrong, Some(&answer))
                        && self.parts_of(symbol).all(|(part, wrong)| self.finds_out(part, wrong, None))
                }
            };
            let list = if found_out { &mut simulated.witnessed } else { &mut simulated.unseen };
            list.push(answer.id().to_owned());
        }
    }

    /// Whether it is found out that a quantity has another value than its own; that an expression contains it shows nothing.
    fn finds_out(&self, symbol: Symbol, wrong: f64, answer: Option<&Answer<'_>>) -> bool {
        let case = Case { replaced: vec![(symbol, wrong)], ..*self.case };
        let witness = Witness::new(&case, TOLERANCES[0]);
        let (expressions, entry) = (self.expressions(), self.worked.problem.model().symbols.entry(symbol));
        let differs = |(name, other): (&String, &Comparison)| {
            let is_meant = *name == entry.name || !expressions.contains_key(name.as_str());
            let bound = self.all.get(name).filter(|_| is_meant);
            bound.is_some_and(|(_, bound)| other.apart().abs() > *bound)
        };
        let agrees = |answer| parts::agrees(self.worked, &case, &witness, answer, TOLERANCES[0]);
        compared(self.worked, &witness).iter().any(differs) || answer.and_then(agrees) == Some(false)
    }

    /// The parts of an expression that a question names: what it is made of that neither the sheet tells nor the start shows,
    /// each with a value that is not its own.
    fn parts_of(&self, symbol: Symbol) -> impl Iterator<Item = (Symbol, f64)> {
        let (worked, model) = (self.worked, self.worked.problem.model());
        let parts = model.expressions.get(&symbol).map(Expr::symbols).unwrap_or_default();
        let is_solved = |part: &Symbol| {
            !worked.form.told.contains(part) && self.witness.started_with(&model.symbols.entry(*part).name).is_none()
        };
        parts.into_iter().filter(is_solved).filter_map(|part| Some((part, parts::off(worked, part)?)))
    }
}

/// Beside a value that is zero by the laws: what a simulation finds as the difference of quantities of one dimension is off by their
/// rounding, a few units in the last place of the largest.
fn allow_for_zeros(worked: &Worked<'_>, all: &mut BTreeMap<String, (Comparison, f64)>) {
    let symbols = &worked.problem.model().symbols;
    let largest = |dimension: Dimension| {
        let alike = symbols.iter().filter(|(_, entry)| entry.dimension == dimension);
        let sizes = alike.filter_map(|(symbol, _)| Some(worked.variant.value(symbol)?.value.abs()));
        sizes.fold(0.0, f64::max)
    };
    for (name, (_, bound)) in all.iter_mut().filter(|(_, (comparison, _))| comparison.stated == 0.0) {
        let dimension = symbols.find(name).map(|symbol| symbols.entry(symbol).dimension);
        let Some(dimension) = dimension.filter(|dimension| *dimension != Dimension::NONE) else { continue };
        *bound = bound.max(largest(dimension) * 4.0 * f64::EPSILON);
        if dimension == Dimension::MOMENTUM {
            *bound = bound.max(largest(Dimension::MASS) * largest(Dimension::VELOCITY) * 4.0 * f64::EPSILON);
        }
        if dimension == Dimension::ENERGY {
            // The square of a velocity that is nothing but rounding.
            let rounding = largest(Dimension::VELOCITY) * 8.0 * f64::EPSILON;
            *bound = bound.max(largest(Dimension::MASS) * rounding * rounding).max(NO_ENERGY);
        }
    }
}

/// Whether laws and simulation differ by more than the bound allows. One that is no number bounds nothing.
fn is_beyond((comparison, bound): &(Comparison, f64)) -> bool {
    let apart = comparison.apart().abs();
    bound.is_nan() || apart.is_nan() || apart > *bound
}

/// Everything that is both said and found.
fn compared(worked: &Worked<'_>, witness: &Witness<'_>) -> BTreeMap<String, Comparison> {
    let mut all = witness.comparisons();
    all.extend(parts::comparisons(worked, witness));
    all
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use momentous_fault::Source;
    use momentous_problem::compile;
    use momentous_problem::load;
    use momentous_scene::Scene;
    use momentous_scene::Stage;
    use momentous_scene::Term;

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
  Two discs meet, {{ m_A }} at {{ v_A1.x }} and {{ v_A1.y }}; the coefficient of restitution is {{ e }}.
ask: [{ find: v_A2.x, unit: m/s }, { find: v_B2.y, unit: m/s }, { conserved: energy, of: [A, B] }]
";

    fn problem() -> Problem {
        compile(load(Source::new("b.yaml", GLANCE)).unwrap(), None).unwrap()
    }

    /// The report on the first variant of a scene that takes the place of the problem's.
    fn differing(change: impl Fn(&mut Scene), said: impl Fn(&Problem) -> Vec<(Symbol, f64)>) -> Option<String> {
        let problem = problem();
        let variant = Sampler::new(&problem, 0).unwrap().variant(1).unwrap();
        let mut scene = problem.loaded().draft.scene.clone();
        change(&mut scene);
        let worked = Worked::new(&problem, &variant).unwrap();
        let case = Case { problem: &problem, scene: &scene, variant: &variant, replaced: said(&problem), known: None };
        Trial::new(&worked, &case).differing(&mut Simulated::default())
    }

    #[test]
    fn what_the_laws_find_is_what_a_simulation_finds() {
        let Portion { simulated, broken, .. } = Portion::of(&problem(), 0, 1..=4);
        assert_eq!(broken, None);
        assert_eq!((simulated.seeds, simulated.witnessed.len(), simulated.unseen.len()), (4, 3, 0));
        assert!(simulated.apart < 1e-9 && simulated.bound < 1e-6, "{simulated:?}");
    }

    #[test]
    fn laws_of_another_scene_are_found_out() {
        let turned = |scene: &mut Scene| {
            let Some(Stage::Impact(impact)) = scene.stages.first_mut() else { panic!("an impact") };
            impact.line_of_impact = Some(Term("30.000001 deg above +x".to_owned()));
        };
        let said = differing(turned, |_| Vec::new());
        assert!(said.is_some_and(|said| said.starts_with("`J_A")), "the impulses come first");
    }

    #[test]
    fn a_choice_that_the_simulation_does_not_find_is_found_out() {
        let elastic = |scene: &mut Scene| {
            let Some(Stage::Impact(impact)) = scene.stages.first_mut() else { panic!("an impact") };
            (impact.restitution, impact.elastic) = (None, true);
        };
        let problem = problem();
        let variant = Sampler::new(&problem, 0).unwrap().variant(1).unwrap();
        let mut scene = problem.loaded().draft.scene.clone();
        elastic(&mut scene);
        let worked = Worked::new(&problem, &variant).unwrap();
        let case = Case { problem: &problem, scene: &scene, variant: &variant, replaced: Vec::new(), known: None };
        let witness = Witness::new(&case, TOLERANCES[0]);
        let last = Answer::all(&worked).pop().unwrap();
        assert_eq!(parts::agrees(&worked, &case, &witness, &last, TOLERANCES[0]), Some(false));
    }

    #[test]
    fn an_answer_that_is_wrong_by_a_millionth_is_found_out() {
        let wrong = |problem: &Problem| {
            let symbol = problem.model().symbol_of("v_A2.x").unwrap();
            let variant = Sampler::new(problem, 0).unwrap().variant(1).unwrap();
            vec![(symbol, variant.value(symbol).unwrap().value * (1.0 + 1e-6))]
        };
        let said = differing(|_| (), wrong);
        assert!(said.is_some_and(|said| said.starts_with("`v_A2.x` is ")));
        assert_eq!(differing(|_| (), |_| Vec::new()), None);
    }
}
