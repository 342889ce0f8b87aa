//! The progress of a student's lines: what they have established, and what is missing.

use std::collections::BTreeSet;

use momentous_expr::{Expr, Symbol};

use super::holding::written_answers;
use super::judge::Judge;
use super::report::{AnswerNeeded, JudgedLine, LawNeeded, NextStep, WorkReport};
use super::support::Slopes;

impl Judge<'_> {
    /// The report on the lines judged so far, and the next step towards the answers; none where the lines hold all of it.
    #[must_use]
    pub fn conclude(&self, lines: Vec<JudgedLine>) -> (WorkReport, Option<NextStep>) {
        let (needed, established) = (self.needed(), self.established());
        let next = match needed.iter().find(|position| !established.contains(position)) {
            Some(missing) => Some(self.step_of_law(*missing)),
            None => self.missing_answer().map(|wanted| self.step_of_answer(wanted)),
        };
        let laws: Vec<LawNeeded> = needed.into_iter().map(|position| self.law(position, &established)).collect();
        let answers: Vec<AnswerNeeded> = self.answers();
        let reached = laws.iter().filter(|law| law.established).map(|law| law.points);
        let reached =
            reached.chain(answers.iter().filter(|answer| answer.established).map(|answer| answer.points)).sum();
        let out_of = laws.iter().map(|law| law.points).chain(answers.iter().map(|answer| answer.points)).sum();
        (WorkReport { lines, laws, answers, points: reached, out_of }, next)
    }

    /// The positions of the ground's equations that the answers need as steps, in the order of the solution.
    fn needed(&self) -> Vec<usize> {
        let mut needed: Vec<usize> = Vec::new();
        for place in self.worked.leaf().answer_steps().iter().flat_map(|step| &step.equations) {
            let position = self.ground.equations.iter().position(|stated| stated.place == *place && !stated.is_naming);
            needed.extend(position.filter(|position| !needed.contains(position)));
        }
        needed
    }

    /// The positions of the ground's equations that follow from the lines, or stand in them.
    fn established(&self) -> BTreeSet<usize> {
        let place = self.ground.place(&self.base);
        let mentioned: BTreeSet<Symbol> =
            self.accepted.iter().flat_map(|line| &line.residuals).flat_map(Expr::symbols).collect();
        if self.accepted.is_empty() {
            return BTreeSet::new();
        }
        let slopes = Slopes::new(&self.ground, place, &mentioned);
        let steps = || self.accepted.iter().filter(|line| line.shows_laws);
        let mut established = slopes.established(place, steps().flat_map(|line| &line.residuals));
        established.extend(steps().flat_map(|line| &line.support.laws));
        established
    }

    fn law(&self, position: usize, established: &BTreeSet<usize>) -> LawNeeded {
        let model = self.worked.problem.model();
        let instance = &model.instances[self.ground.equations[position].tag];
        let scene = &self.worked.problem.loaded().draft.scene;
        LawNeeded {
            law: instance.law.id,
            name: instance.law.name,
            stage: instance.stage.map(|stage| model.phrase(scene, stage)),
            established: established.contains(&position),
            points: self.worked.problem.loaded().draft.rubric.points_for_law(instance.law),
        }
    }

    fn answers(&self) -> Vec<AnswerNeeded> {
        let given = self.answers_given();
        let points = self.worked.problem.loaded().draft.rubric.points_for_answer();
        let parts = self.worked.form.parts.iter().filter(|part| !written_answers(&part.kind).is_empty());
        parts
            .map(|part| AnswerNeeded {
                id: part.id.clone(),
                established: written_answers(&part.kind).iter().all(|symbol| given.contains(symbol)),
                points,
            })
            .collect()
    }

    /// The first quantity that is asked and that no line gives.
    fn missing_answer(&self) -> Option<Symbol> {
        let given = self.answers_given();
        self.answers_asked().into_iter().find(|symbol| !given.contains(symbol))
    }

    pub(crate) fn answers_given(&self) -> BTreeSet<Symbol> {
        self.accepted.iter().flat_map(|line| line.answers.iter().copied()).collect()
    }
}
