//! Equations with more than one root: every value that algebra allows, and which of them can be.

use std::collections::BTreeMap;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Reason;
use momentous_solve::Bounded;
use momentous_solve::Cause;
use momentous_solve::Closed;
use momentous_solve::Real;
use momentous_solve::Step;
use momentous_solve::Tactic;
use momentous_solve::evaluate;

use super::super::compiling::planned::Form;
use super::super::compiling::regimes::Dead;
use super::super::compiling::regimes::Leaf;
use super::super::questions::choices::choice::ChoicePart;
use super::super::questions::choices::decision::Decision;
use super::super::questions::part::PartKind;
use super::super::sampling::variant::Worked;

/// Why a root would be none where nothing is wrong with it: what is offered beside the true reason.
const NOT_A_ROOT: [&str; 2] = ["it does not satisfy the equations", "it is not a real number"];

/// The step of a way that finds a quantity with several roots, and its position.
fn step_of(leaf: &Leaf, symbol: Symbol) -> Option<(usize, &Step)> {
    let mut steps = leaf.answer_steps().iter().enumerate();
    steps.find(|(_, step)| step.roots.len() > 1 && step.unknowns.contains(&symbol))
}

/// A fault for each question about the roots of an equation that has one.
pub(crate) fn check(form: &Form) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (index, part) in form.parts.iter().enumerate() {
        let symbol = match &part.kind {
            PartKind::Choice(ChoicePart::Physical(symbol)) => *symbol,
            PartKind::Number(number) if number.every_root => number.symbol,
            _ => continue,
        };
        if !form.solver.leaves().iter().any(|leaf| step_of(leaf, symbol).is_some()) {
            let message = format!("the equations give only one value for the question `{}`", part.id);
            let fault = Fault::new(Code::Value, message).help("ask for that value: `find: ...`");
            faults.push(fault.at_path(form.question.path.key("ask").index(index)));
        }
    }
    faults
}

impl Worked<'_> {
    /// Every real value that the equations give for a quantity, possible or not, in SI units; the one taken first.
    #[must_use]
    pub fn every_root(&self, symbol: Symbol) -> Vec<Bounded> {
        let taken = self.variant.value(symbol);
        let mut answers: Vec<Bounded> = taken.into_iter().collect();
        let Some((position, step)) = step_of(self.leaf(), symbol) else { return answers };
        let chosen = self.variant.roots().get(position).copied().unwrap_or(0);
        if step.tactic == Tactic::BracketedRoot {
            let unknown = step.unknowns.iter().position(|unknown| *unknown == symbol);
            let dead = self.variant.dead().iter().filter(|dead| dead.step == Some(position));
            answers.extend(dead.filter_map(|dead| dead.values.get(unknown?).copied()));
            answers.extend(self.variant.others_of(symbol));
        }
        for (_, root) in step.roots.iter().enumerate().filter(|(index, _)| *index != chosen) {
            let mut values: BTreeMap<Symbol, Bounded> = BTreeMap::new();
            for (unknown, closed) in &root.values {
                let Closed::Formula(formula) = closed else { continue };
                let value = |symbol: Symbol| values.get(&symbol).copied().or_else(|| self.variant.value(symbol));
                let value = evaluate(formula, &|symbol| value(symbol).unwrap_or_else(Bounded::not_real));
                values.insert(*unknown, value);
            }
            let other = values.get(&symbol).filter(|value| value.is_real());
            answers
                .extend(other.filter(|other| taken.is_none_or(|taken| other.value.to_bits() != taken.value.to_bits())));
        }
        answers
    }

    /// Why a root is not a solution, as a clause.
    #[must_use]
    pub fn why_dead(&self, dead: &Dead) -> String {
        let system = &self.leaf().system;
        let model = self.problem.model();
        match dead.cause {
            Cause::Condition(condition) => {
                let tag = system.conditions.get(condition).map(|condition| condition.tag);
                let reason = tag.and_then(|tag| model.reasons.get(tag));
                reason.map_or_else(String::new, Reason::to_string)
            }
            Cause::Equation(equation) => {
                let tag = system.equations.get(equation).map(|equation| equation.tag);
                tag.and_then(|tag| model.instances.get(tag)).map_or_else(
                    || "it does not satisfy every equation".to_owned(),
                    |instance| format!("it does not satisfy {}", instance.law.name),
                )
            }
            Cause::NotPositive => self.not_positive(dead),
            Cause::RuledOut(passage) => {
                model.passages.get(passage).map_or_else(String::new, |passage| passage.reason.to_string())
            }
            Cause::NotReal => "it is not a real number".to_owned(),
        }
    }

    /// Which quantity would not be positive, as it is called.
    fn not_positive(&self, dead: &Dead) -> String {
        let step = dead.step.and_then(|place| self.leaf().answer_steps().get(place));
        let mut values = step.into_iter().flat_map(|step| step.unknowns.iter().zip(&dead.values));
        let is_it = |(unknown, value): &(&Symbol, &Bounded)| {
            self.leaf().system.positive.contains(unknown) && value.value <= 0.0
        };
        let meaning =
            values.find(is_it).map(|(unknown, _)| self.problem.model().symbols.entry(*unknown).meaning.as_str());
        let meaning = meaning.filter(|meaning| !meaning.is_empty()).unwrap_or("it");
        format!("{meaning} must be positive")
    }

    /// Which of the roots for a quantity is possible, and why.
    pub(super) fn possible_root(&self, symbol: Symbol) -> Decision {
        let dead = self.variant.dead().iter().find(|dead| !matches!(dead.cause, Cause::NotReal));
        let reason = dead.map_or_else(|| self.usual_reason(symbol), |dead| self.why_dead(dead));
        let is_equation = dead.is_some_and(|dead| matches!(dead.cause, Cause::Equation(_)));
        let decoy = NOT_A_ROOT[usize::from(is_equation)];
        let roots = self.every_root(symbol);
        let (both, greater) = match roots[..] {
            [taken, other, ..] => (dead.is_none(), taken.value > other.value),
            _ => (true, true),
        };
        let one =
            |taken: &str, other: &str, why: &str| format!("the {taken}; the {other} is impossible, because {why}");
        Decision {
            options: vec![
                one("greater", "lesser", &reason),
                one("lesser", "greater", &reason),
                one("greater", "lesser", decoy),
                one("lesser", "greater", decoy),
                "both are possible".into(),
            ],
            right: if both { 4 } else { usize::from(!greater) },
            because: if both {
                "both values satisfy the equations, and neither breaks a condition of the scene".into()
            } else {
                "both values satisfy the equations, but only this one satisfies the conditions of the scene".into()
            },
            behind: None,
            feedback: Vec::new(),
        }
    }

    /// The question about a quantity where both roots are possible.
    fn usual_reason(&self, symbol: Symbol) -> String {
        let system = &self.leaf().system;
        if system.positive.contains(&symbol) {
            return "it must be positive".to_owned();
        }
        let speaks = system
            .conditions
            .iter()
            .find(|condition| condition.left.contains(symbol) || condition.right.contains(symbol));
        let reason = speaks.and_then(|condition| self.problem.model().reasons.get(condition.tag));
        reason.map_or_else(|| "it must be positive".to_owned(), Reason::to_string)
    }
}
