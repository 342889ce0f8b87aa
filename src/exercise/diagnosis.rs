//! Where a wrong answer comes from, in the words of the problem.

use std::collections::BTreeMap;

use crate::expr::Expr;
use crate::grade;
use crate::grade::Diagnosis;
use crate::grade::diagnose;
use crate::laws::wrong::Misconception;
use crate::problem::FormulaPart;
use crate::problem::Mistake;
use crate::problem::NumberPart;
use crate::problem::PartKind;

use super::Exercise;

impl Exercise {
    /// Says of every wrong answer in a report which usual mistake leads to it, where one does.
    pub(super) fn diagnose(
        &self,
        report: &mut grade::Report,
        expected: &[grade::Expected],
        answers: &BTreeMap<String, String>,
        mark: grade::DecimalMark,
        hints: usize,
    ) {
        for own in report.parts.iter_mut().filter(|part| diagnose::is_open(part.verdict) && part.follows.is_none()) {
            let part = self.worked().form.parts.iter().find(|part| part.id == own.id);
            let (Some(part), Some(text)) = (part, answers.get(&own.id)) else { continue };
            let Some(expected) = expected.iter().find(|expected| expected.id == part.id) else { continue };
            let Ok(answer) = grade::read(text, &expected.kind, mark) else { continue };
            let diagnosis = match (&part.kind, &expected.kind) {
                (PartKind::Number(number), grade::ExpectedKind::Number(right)) => {
                    diagnose::number(right, &answer).and_then(|answer| self.diagnosis(number, right, answer))
                }
                (PartKind::Formula(formula), grade::ExpectedKind::Formula(right)) => {
                    self.diagnosis_of_formula(formula, right, &answer)
                }
                _ => None,
            };
            if let Some(diagnosis) = diagnosis {
                own.message = std::iter::once(own.message.as_str())
                    .chain(diagnosis.hints.iter().take(hints + 1).map(String::as_str))
                    .collect::<Vec<_>>()
                    .join(" ");
                own.diagnosis = Some(diagnosis);
            }
        }
    }

    /// The mistakes that lead to this wrong answer, in the unit of the question.
    #[must_use]
    pub fn diagnosis(&self, number: &NumberPart, right: &grade::ExpectedNumber, answer: f64) -> Option<Diagnosis> {
        if diagnose::is_coarse(right, answer) {
            return None;
        }
        let worked = self.worked();
        let mut suspects: Vec<(&Mistake, f64)> = Vec::new();
        for mistake in worked.mistakes() {
            suspects.extend(worked.mistaken(mistake, number).into_iter().map(|value| (mistake, value)));
        }
        let values: Vec<f64> = suspects.iter().map(|(_, value)| *value).collect();
        let places = diagnose::matching(right, answer, &values);
        self.told_of(places.into_iter().filter_map(|place| suspects.get(place)).map(|own| own.0).collect())
    }

    /// The mistakes that lead to exactly this formula, and to no right one.
    fn diagnosis_of_formula(
        &self,
        part: &FormulaPart,
        right: &grade::ExpectedFormula,
        answer: &grade::Answer,
    ) -> Option<Diagnosis> {
        let worked = self.worked();
        let is = |formula: &Expr, answer: &grade::Answer| {
            let dimension = formula.dimension(&right.symbols).unwrap_or(right.dimension);
            let wrong = grade::ExpectedFormula { formula: formula.clone(), dimension, ..right.clone() };
            let kind = grade::ExpectedKind::Formula(wrong);
            grade::judge(&grade::Expected { id: String::new(), points: 0, kind }, answer).verdict.is_right()
        };
        let truth =
            grade::Answer::Formula(grade::FormulaAnswer { text: String::new(), formula: right.formula.clone() });
        let leads = |mistake: &&Mistake| {
            let formulas = worked.mistaken_formulas(mistake, part.symbol);
            formulas.iter().any(|formula| is(formula, answer) && !is(formula, &truth))
        };
        self.told_of(worked.mistakes().iter().filter(leads).collect())
    }

    /// What is said of mistakes that cannot be told apart.
    fn told_of(&self, mut found: Vec<&Mistake>) -> Option<Diagnosis> {
        // A law says more than a slip of the pen, and an author's own words more than ours.
        found.sort_by_key(|mistake| (self.feedback(mistake.of).is_none(), mistake.instance.is_none()));
        let first = found.first()?;
        let mut codes: Vec<&'static str> = Vec::new();
        for mistake in &found {
            if !codes.contains(&mistake.of.id) {
                codes.push(mistake.of.id);
            }
        }
        Some(Diagnosis { codes, step: self.step(first), hints: self.hints(first) })
    }

    /// What the author says of a mistake.
    fn feedback(&self, kind: &Misconception) -> Option<String> {
        self.variant.feedback(&self.problem, kind.id)
    }

    /// The step at which a law is got wrong: `the law of restitution, in the impact`.
    fn step(&self, mistake: &Mistake) -> Option<String> {
        let model = self.problem.model();
        let instance = model.instances.get(mistake.instance?)?;
        let scene = &self.problem.loaded().draft.scene;
        let stage = instance.stage.filter(|_| scene.stages.len() > 1).map(|stage| model.phrase(scene, stage));
        Some(match stage {
            Some(stage) => format!("{}, in {stage}", instance.law.name),
            None => instance.law.name.to_owned(),
        })
    }

    fn hints(&self, mistake: &Mistake) -> Vec<String> {
        let question = self.feedback(mistake.of).unwrap_or_else(|| mistake.of.ask.to_owned());
        let first = match self.step(mistake) {
            Some(step) => format!("Look at the step with {step}. {question}"),
            None => question,
        };
        let law = mistake.instance.and_then(|own| self.problem.model().instances.get(own)).map(|own| own.law);
        let statement = law.map(|law| format!("{} {}", law.statement, law.signs));
        [Some(first), Some(mistake.of.hint.to_owned()), statement].into_iter().flatten().collect()
    }
}
