//! Students as marking will meet them: one who rounds honestly on the way, and one who makes a single usual mistake.

use std::collections::BTreeMap;

use momentous_expr::Symbol;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::VectorPart;
use momentous_quantity::Printed;
use momentous_quantity::round_to_figures;
use momentous_solve::Closed;

use super::Exercise;

impl Exercise {
    /// The answers of a student who does everything right and rounds every value on the way to the problem's figures.
    #[must_use]
    pub fn rounded_answers(&self) -> BTreeMap<String, String> {
        let worked = self.worked();
        let parts = worked.form.parts.iter().map(|part| {
            let values = |number: &NumberPart| self.rounded_values(number.figures);
            let text = match &part.kind {
                PartKind::Choice(_) | PartKind::Formula(_) | PartKind::Range(_) => self.printed(part),
                PartKind::Vector(vector) => {
                    let values = vector.components.first().map(values).unwrap_or_default();
                    self.rounded_vector(vector, &values)
                }
                // Nobody types what is left of a zero.
                PartKind::Number(number) if worked.is_nothing(number.symbol) => self.printed(part),
                PartKind::Number(number) if worked.answers(number).len() > 1 => self.printed(part),
                // Where a root is taken of what is nothing, rounding on the way may leave no value.
                PartKind::Number(number) => {
                    match values(number).get(&number.symbol).filter(|number| number.is_finite()) {
                        Some(value) => self.written(number, value / worked.unit_of(number)),
                        None => self.printed(part),
                    }
                }
            };
            (part.id.clone(), text)
        });
        parts.collect()
    }

    /// Every value on the way, rounded to so many figures.
    fn rounded_values(&self, figures: usize) -> BTreeMap<Symbol, f64> {
        let worked = self.worked();
        let mut values: BTreeMap<Symbol, f64> = BTreeMap::new();
        for (place, step) in worked.leaf().answer_steps().iter().enumerate() {
            let choice = self.variant.roots().get(place).copied().unwrap_or(0);
            let Some(root) = step.roots.get(choice).or(step.roots.first()) else { continue };
            for (unknown, closed) in &root.values {
                let exact = self.variant.value(*unknown).map(|value| value.value);
                let value = match closed {
                    Closed::Formula(formula) => formula.evaluate(&|symbol| {
                        let solved = values.get(&symbol).copied();
                        solved.or_else(|| self.variant.value(symbol).map(|number| number.value)).unwrap_or(f64::NAN)
                    }),
                    Closed::FirstInteger { .. } | Closed::BracketedRoot { .. } => exact.unwrap_or(f64::NAN),
                };
                // Nobody types what is left of a zero, or takes it further.
                let value = if worked.is_nothing(*unknown) { 0.0 } else { value };
                let rounded = round_to_figures(value, figures).map_or(value, |rounded| rounded.to_f64());
                values.insert(*unknown, if matches!(closed, Closed::FirstInteger { .. }) { value } else { rounded });
            }
        }
        values
    }

    /// What students who make one usual mistake write as the answer to a part: the code of each mistake with each answer
    /// that comes of it, rounded to the figures that are asked.
    #[must_use]
    pub fn mistaken_answers(&self, part: &Part) -> Vec<(&'static str, String)> {
        let worked = self.worked();
        let mut answers = Vec::new();
        let simulated = worked.simulated();
        for mistake in worked.mistakes() {
            match &part.kind {
                PartKind::Number(number) => {
                    let values = simulated.answers(mistake, number).into_iter();
                    answers.extend(values.map(|value| (mistake.of.id, self.written(number, value))));
                }
                PartKind::Vector(vector) => {
                    let values = simulated.vectors(mistake, vector).into_iter();
                    answers.extend(
                        values.map(|components| (mistake.of.id, self.written_vector(vector, components.into_iter()))),
                    );
                }
                PartKind::Formula(part) => {
                    let formulas = worked.mistaken_formulas(mistake, part.symbol);
                    let symbols = &self.problem.notation().table(&self.problem.model().symbols);
                    answers.extend(formulas.iter().map(|formula| (mistake.of.id, formula.text(symbols))));
                }
                PartKind::Range(_) | PartKind::Choice(_) => {}
            }
        }
        answers.sort();
        answers.dedup();
        answers
    }

    /// A value in the unit of the question, as a student writes it.
    fn written(&self, number: &NumberPart, value: f64) -> String {
        format!("{} {}", written_number(number, value), self.problem.unit_name(number)).trim_end().to_owned()
    }

    /// A vector of which every component was rounded on the way.
    fn rounded_vector(&self, vector: &VectorPart, values: &BTreeMap<Symbol, f64>) -> String {
        let worked = self.worked();
        let component = |number: &NumberPart| {
            let value = values.get(&number.symbol).map(|value| value / worked.unit_of(number));
            value.unwrap_or_else(|| worked.answer(number).value)
        };
        self.written_vector(vector, vector.components.iter().map(component))
    }

    fn written_vector(&self, vector: &VectorPart, values: impl Iterator<Item = f64>) -> String {
        let numbers = vector.components.iter().zip(values);
        let components: Vec<String> = numbers.map(|(number, value)| written_number(number, value)).collect();
        let unit = vector.components.first().map(|number| self.problem.unit_name(number)).unwrap_or_default();
        format!("({}) {unit}", components.join(", ")).trim_end().to_owned()
    }
}

fn written_number(number: &NumberPart, value: f64) -> String {
    if number.whole {
        return format!("{value:.0}");
    }
    Printed::new(value, number.figures).map_or_else(|| value.to_string(), |printed| printed.plain())
}
