//! The progress of a student's lines: what they have established, what is missing, and the next step.

use std::collections::BTreeSet;

use momentous_expr::{Expr, Leaf, LeafKind, Math, Operator, Symbol};
use momentous_model::Because;
use momentous_problem::PartKind;
use momentous_quantity::round_to_figures;
use momentous_solve::Statement;

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

    fn answers_given(&self) -> BTreeSet<Symbol> {
        self.accepted.iter().flat_map(|line| line.answers.iter().copied()).collect()
    }

    fn step_of_law(&self, position: usize) -> NextStep {
        let model = self.worked.problem.model();
        let stated = &self.ground.equations[position];
        let instance = &model.instances[stated.tag];
        let scene = &self.worked.problem.loaded().draft.scene;
        let during = instance.stage.map_or_else(String::new, |stage| format!(" for {}", model.phrase(scene, stage)));
        let because = match &instance.because {
            Because::Definition => String::new(),
            reason => format!(": {reason}"),
        };
        let equation = match self.ground.system.equations.get(stated.place).map(|equation| &equation.statement) {
            Some(Statement::Equal { left, right }) => Some(self.as_counted([left, right])),
            _ => None,
        };
        let text = |numbers: bool| {
            equation.as_ref().map_or_else(String::new, |[left, right]| {
                format!("{} = {}", self.text(left, numbers), self.text(right, numbers))
            })
        };
        NextStep {
            principle: format!("Use {}{during}{because}.", instance.law.name),
            equation: text(false),
            numbers: text(true),
            math: equation.as_ref().map(|[left, right]| self.math([left, right])),
        }
    }

    fn step_of_answer(&self, wanted: Symbol) -> NextStep {
        let name = self.worked.problem.name_of(wanted);
        let numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        let number = numbers.into_iter().find(|number| number.symbol == wanted);
        let value = number.and_then(|number| {
            let value = round_to_figures(self.worked.answer(number).for_print(), number.figures)?;
            let value = if self.turned.contains(&wanted) { -value } else { value };
            Some(format!("{name} = {value} {}", self.worked.problem.unit_name(number)).trim_end().to_owned())
        });
        let formula = self.worked.form.parts.iter().find_map(|part| match &part.kind {
            PartKind::Formula(formula) if formula.symbol == wanted => self.worked.formula(formula),
            _ => None,
        });
        let value = value.or_else(|| {
            let [_, formula] = self.as_counted([&wanted.into(), &formula?]);
            Some(format!("{name} = {}", self.text(&formula, false)))
        });
        NextStep {
            principle: format!("Solve the equations for {name}."),
            equation: String::new(),
            numbers: value.into_iter().collect(),
            math: None,
        }
    }

    /// An equation as mathematics in the letters of the sheet.
    fn math(&self, sides: [&Expr; 2]) -> Math {
        let problem = self.worked.problem;
        let letter = |symbol: Symbol| Leaf { math: problem.math_of(symbol), kind: LeafKind::Name };
        let [left, right] = sides.map(|side| self.resolved(side).layout(&letter));
        Math::relation(left, Operator::Equals, right)
    }

    /// The sides of an equation with each quantity as the student counts it, and both with the other sign where fewer signs stand in them then.
    fn as_counted(&self, sides: [&Expr; 2]) -> [Expr; 2] {
        let turn = |symbol: Symbol| self.turned.contains(&symbol).then(|| -Expr::from(symbol));
        let turned = sides.map(|side| side.substitute(&turn));
        let opposite = [&turned[0], &turned[1]].map(|side| match side {
            Expr::Sum(terms) => Expr::sum(terms.iter().map(|term| -term.clone())),
            other => -other.clone(),
        });
        let signs =
            |sides: &[Expr; 2]| -> usize { sides.iter().map(|side| self.text(side, false).matches('-').count()).sum() };
        if !self.turned.is_empty() && signs(&opposite) < signs(&turned) { opposite } else { turned }
    }

    /// A term as a student would type it, with the values of what is given or without: those that the sheet prints.
    pub(crate) fn text(&self, term: &Expr, numbers: bool) -> String {
        let problem = self.worked.problem;
        let is_printed = |symbol: Symbol| self.worked.form.printed.contains(&symbol);
        self.resolved(term).text_with(&|symbol| {
            let entry = problem.model().symbols.entry(symbol);
            let given = self.worked.variant.given(symbol).filter(|_| numbers && is_printed(symbol));
            let given =
                given.map(|(value, unit)| if self.turned.contains(&symbol) { (-value, unit) } else { (value, unit) });
            match given {
                Some((value, unit)) if unit.is_none() => format!("({value})"),
                Some((value, unit)) => format!("({value} {unit})"),
                None if problem.model().literals.iter().any(|(literal, _)| *literal == symbol) => {
                    format!("({})", entry.name)
                }
                None => entry.name.clone(),
            }
        })
    }

    /// A term with each quantity that is given piece by piece as the piece that holds.
    fn resolved(&self, term: &Expr) -> Expr {
        let Expr::Piecewise(piecewise) = term else { return term.map_children(|part| self.resolved(part)) };
        let place = self.ground.place(&self.base);
        let value = |symbol: Symbol| place.value(symbol).map_or(f64::NAN, |number| number.value);
        let at = piecewise.variable.evaluate(&value);
        let holds = |until: &Option<Expr>| until.as_ref().is_none_or(|until| at <= until.evaluate(&value));
        let piece = piecewise.pieces.iter().find(|(until, _)| holds(until));
        piece.map_or_else(|| term.clone(), |(_, piece)| self.resolved(piece))
    }
}
