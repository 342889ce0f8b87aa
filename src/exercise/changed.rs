//! Variants with values of the user's own, and other quantities asked.

use std::sync::Arc;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_problem::Loaded;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;
use momentous_problem::Sampler;
use momentous_problem::ad_hoc;
use momentous_problem::compile_ad_hoc;
use momentous_problem::typed;
use momentous_quantity::half_unit;

use super::Exercise;

impl Exercise {
    /// The same scene with values of the user's own in place of given ones, and other quantities asked.
    ///
    /// # Errors
    /// A fault for each value or name that cannot be read, where the question does not follow from the values, and where
    /// they leave no admissible solution.
    pub fn with_values(
        problem: &Problem,
        form: usize,
        seed: u64,
        set: &[(String, String)],
        find: &[String],
    ) -> Result<Self, Faults> {
        Self::of_changed(problem, ad_hoc(problem.loaded(), form, set, find), seed)
    }

    /// The same with the problem's text, which says the user's own values: a variant that can be printed and marked as one that
    /// was drawn.
    ///
    /// # Errors
    /// As [`Exercise::with_values`].
    pub fn typed(
        problem: &Problem,
        form: usize,
        seed: u64,
        set: &[(String, String)],
        find: &[String],
    ) -> Result<Self, Faults> {
        Self::of_changed(problem, typed(problem, form, set, find), seed)
    }

    fn of_changed(problem: &Problem, changed: Result<Loaded, Vec<Fault>>, seed: u64) -> Result<Self, Faults> {
        let alone = |faults: Vec<Fault>| Faults { source: problem.loaded().source.clone(), list: faults };
        let changed = changed.map_err(alone)?;
        let problem = Arc::new(compile_ad_hoc(changed)?);
        let is_drawn = |form: &PlannedForm| {
            form.known.iter().any(|known| known.origin.is_drawn() && form.told.contains(&known.symbol))
        };
        let seeded = problem.forms().iter().any(is_drawn);
        let mut variant =
            Sampler::new(&problem, 0).and_then(|mut sampler| sampler.variant(seed)).map_err(|reason| {
                let fault = Fault::new(Code::Unphysical, reason.to_string());
                alone(vec![fault.help("check the signs and sizes of the values: bodies must meet, and 0 <= e <= 1")])
            })?;
        if !seeded {
            variant = variant.without_seed();
        }
        let exercise = Self { problem, variant };
        match exercise.beyond_numbers() {
            None => Ok(exercise),
            Some(name) => {
                let message = format!("`{name}` cannot be computed with these values: they are too large or too small");
                let fault = Fault::new(Code::Value, message);
                Err(alone(vec![fault.help("choose values between 1e-90 and 1e90 in SI units")]))
            }
        }
    }

    /// The first answer that is not known to the figures with which it is printed.
    fn beyond_numbers(&self) -> Option<String> {
        let worked = self.worked();
        let is_unknown = |number: &&NumberPart| {
            let answer = worked.answer(number);
            let half_a_unit = half_unit(answer.value, number.figures);
            !answer.error.is_finite() || !answer.is_zero() && answer.error > half_a_unit
        };
        let has_answer = |part: &&Part| matches!(part.kind, PartKind::Number(_) | PartKind::Vector(_));
        let mut numbers = worked.form.parts.iter().filter(has_answer).flat_map(|part| part.kind.numbers());
        numbers.find(is_unknown).map(|number| self.problem.name_of(number.symbol))
    }
}
