//! The steps of the plan in words: which law and why, the equation, the algebra, the number.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::Operator;
use crate::expr::Symbol;
use crate::model::Instance;
use crate::problem::PartKind;
use crate::solve::Closed;
use crate::solve::Move;
use crate::solve::Relation;
use crate::solve::Root;
use crate::solve::Statement;
use crate::solve::Step;

use super::Block;
use super::Inline;
use super::algebra;
use super::answers::printed_formula;
use super::counting;
use super::display::Display;
use super::quadratic;
use super::wording::capitalised;
use super::wording::join;

/// Figures of an answer, and of a value on the way to it.
#[derive(Clone, Copy)]
pub(super) struct Figures {
    pub answer: usize,
    pub intermediate: usize,
}

/// Writes the steps of one plan, numbering the equations that are referred to.
pub(super) struct Steps<'a> {
    pub display: Display<'a>,
    pub figures: Figures,
    pub numbers: BTreeMap<usize, u32>,
    pub asked: Vec<Symbol>,
    /// Whether the angle of a point has been explained.
    pub angle_explained: bool,
}

impl Steps<'_> {
    /// One step, as blocks.
    pub(super) fn step(&mut self, position: usize, step: &Step) -> Vec<Block> {
        let mut blocks = Vec::new();
        let referred = step.equations.len() > 1;
        for equation in &step.equations {
            let closes = !referred && step.equations.len() == 1;
            blocks.extend(self.law(*equation, referred, closes.then_some(step)));
        }
        let mut solved = None;
        for step_move in &step.moves {
            match (step_move, quadratic::solution(self.display, step_move, self.figures.intermediate)) {
                (Move::Quadratic { unknown, .. }, Some(shown)) => {
                    solved = Some(*unknown).filter(|unknown| !self.display.free.contains(unknown));
                    blocks.extend(shown);
                }
                (Move::Numeric { unknown }, _) if self.formula_of_piece(step, *unknown).is_some() => {}
                _ => blocks.extend(algebra::blocks(self.display, &self.numbers, step_move)),
            }
        }
        for (unknown, closed) in self.taken(position, step).map(|root| root.values.as_slice()).unwrap_or_default() {
            if solved != Some(*unknown) {
                blocks.extend(self.result(step, *unknown, closed));
            }
        }
        blocks.extend(self.rejected(position, step));
        blocks
    }

    fn taken<'s>(&self, position: usize, step: &'s Step) -> Option<&'s Root> {
        let choice = self.display.worked.variant.roots().get(position).copied().unwrap_or(0);
        step.roots.get(choice).or(step.roots.first())
    }

    /// The law, why it applies here, and its equation in symbols.
    fn law(&mut self, equation: usize, referred: bool, closes: Option<&Step>) -> Vec<Block> {
        let leaf = self.display.worked.leaf();
        let Some(stated) = leaf.system.equations.get(equation) else { return Vec::new() };
        let Some(instance) = self.display.worked.problem.model().instances.get(stated.tag) else { return Vec::new() };
        let mut blocks = vec![text(&reason(instance, &stated.statement))];
        let mut lines = Vec::new();
        match &stated.statement {
            Statement::Equal { left, right } => {
                if let Some(integral) = &instance.integral {
                    let integrand = self.display.symbolic(&integral.integrand);
                    let shown = Math::Integral(
                        Arc::new(self.display.symbolic(&integral.low)),
                        Arc::new(self.display.symbolic(&integral.high)),
                        Arc::new(match &integral.integrand {
                            Expr::Sum(_) => Math::Squared(Arc::new(integrand)),
                            _ => integrand,
                        }),
                        Arc::new(self.display.name(integral.variable)),
                    );
                    lines.push(Math::relation(self.display.symbolic(left), Operator::Equals, shown));
                } else if !closes.is_some_and(|step| is_definition(step, left, right)) {
                    lines.push(algebra::without_common_minus(self.display, left, right));
                }
            }
            Statement::FirstInteger { left, relation, right, .. } => {
                lines.push(Math::relation(
                    self.display.symbolic(left),
                    operator(*relation),
                    self.display.symbolic(right),
                ));
            }
        }
        let number = referred.then(|| {
            let next = u32::try_from(self.numbers.len() + 1).unwrap_or(u32::MAX);
            *self.numbers.entry(equation).or_insert(next)
        });
        if !lines.is_empty() {
            blocks.push(Block::Equation { lines, number });
            if let (Statement::Equal { left, right }, None) = (&stated.statement, &instance.integral) {
                blocks.extend(self.piece(left, right));
            }
        }
        blocks
    }

    /// What an equation that is stated piece by piece says for these numbers.
    fn piece(&self, left: &Expr, right: &Expr) -> Vec<Block> {
        let pieces = [left, right].map(|side| self.display.piece_that_holds(side));
        let Some(condition) = pieces.into_iter().flatten().next() else { return Vec::new() };
        let words = vec![Inline::Text("Here ".into()), Inline::Math(condition), Inline::Text(", so that".into())];
        let [left, right] = [left, right].map(|side| self.display.resolved(side));
        let lines = vec![self.display.equation(&left, &right)];
        vec![Block::Paragraph(words), Block::Equation { lines, number: None }]
    }

    /// The value of an unknown, and what must be said with it.
    fn result(&mut self, step: &Step, unknown: Symbol, closed: &Closed) -> Vec<Block> {
        let trials = counting::trials(self.display, unknown, closed);
        if !trials.is_empty() {
            return trials;
        }
        let formula = match closed {
            // The plan's form of a root guards against rounding, which symbols need not.
            Closed::Formula(Expr::Piecewise(_)) if self.display.free.contains(&unknown) => self.in_givens(unknown),
            Closed::Formula(formula) => Some(algebra::positive_first(&self.display.resolved(formula))),
            _ => self.formula_of_piece(step, unknown),
        };
        let mut blocks = vec![self.value(unknown, formula.as_ref())];
        blocks.extend(self.put_together(unknown, formula.as_ref()));
        if !self.angle_explained && formula.as_ref().is_some_and(algebra::has_angle_of_point) {
            self.angle_explained = true;
            blocks.push(text(
                "The angle lies in the quadrant that the signs of numerator and denominator tell as those of a vector's components: where the denominator is negative, it is half a turn from the arctangent that a calculator gives.",
            ));
        }
        blocks
    }

    /// What is asked as a formula, with what the steps before found put in.
    fn put_together(&self, unknown: Symbol, formula: Option<&Expr>) -> Vec<Block> {
        let worked = self.display.worked;
        let part = worked.form.parts.iter().find_map(|part| match &part.kind {
            PartKind::Formula(part) if part.symbol == unknown => Some(part),
            _ => None,
        });
        let Some(part) = part else { return Vec::new() };
        let Some(whole) = self.in_givens(unknown).filter(|whole| formula != Some(whole)) else { return Vec::new() };
        let mut lines = vec![self.display.equation(&unknown.into(), &whole)];
        let multiple = part.in_terms_of.and_then(|_| printed_formula(worked, part));
        let multiple = multiple.filter(|math| *math != self.display.symbolic(&whole));
        lines.extend(multiple.map(|math| Math::Row(vec![Math::Operator(Operator::Equals), math])));
        vec![text("With what was found and given before:"), Block::Equation { lines, number: None }]
    }

    fn in_givens(&self, unknown: Symbol) -> Option<Expr> {
        let worked = self.display.worked;
        let whole = worked.in_givens(unknown, &worked.alphabet().values)?;
        Some(algebra::positive_first(&whole))
    }

    /// What an unknown equals where its equation, for these numbers, is linear in it.
    fn formula_of_piece(&self, step: &Step, unknown: Symbol) -> Option<Expr> {
        let [equation] = step.equations[..] else { return None };
        let stated = self.display.worked.leaf().system.equations.get(equation)?;
        let Statement::Equal { left, right } = &stated.statement else { return None };
        let difference = (self.display.resolved(left) - self.display.resolved(right)).simplify();
        let (factors, rest) = difference.linear_coefficients(&[unknown])?;
        let factor = factors.into_iter().next().filter(|factor| !factor.is_zero())?;
        Some((-rest / factor).simplify())
    }

    /// `unknown = formula = numbers = value`.
    fn value(&self, unknown: Symbol, formula: Option<&Expr>) -> Block {
        let name = self.display.name(unknown);
        let figures = if self.asked.contains(&unknown) { self.figures.answer } else { self.figures.intermediate };
        let value = self.display.quantity_to(unknown, self.figures.intermediate.max(figures));
        let mut lines = Vec::new();
        if let Some(formula) = formula {
            let symbols = self.display.symbolic(formula);
            lines.push(Math::relation(name.clone(), Operator::Equals, symbols.clone()));
            if self.display.free.contains(&unknown) {
                return Block::Equation { lines, number: None };
            }
            if formula.is_zero() {
                return Block::Equation { lines, number: None };
            }
            let numbers = self.display.substituted(formula);
            if numbers != symbols && numbers != value {
                lines.push(Math::Row(vec![Math::Operator(Operator::Equals), numbers]));
            }
            if lines.last() != Some(&Math::relation(name.clone(), Operator::Equals, value.clone())) {
                lines.push(Math::Row(vec![Math::Operator(Operator::Equals), value]));
            }
        } else {
            lines.push(Math::relation(name, Operator::Equals, value));
        }
        Block::Equation { lines, number: None }
    }

    /// The roots that are not solutions, each with its reason.
    fn rejected(&self, position: usize, step: &Step) -> Vec<Block> {
        let worked = self.display.worked;
        let mut blocks = Vec::new();
        for dead in worked.variant.dead().iter().filter(|dead| dead.step == Some(position)) {
            let reason = worked.why_dead(dead);
            let values: Vec<Vec<Inline>> = step
                .unknowns
                .iter()
                .zip(&dead.values)
                .map(|(unknown, value)| {
                    let unit = self.display.unit(*unknown);
                    let number =
                        super::display::printed(value.value / unit.factor().to_f64(), self.figures.intermediate);
                    let number = super::display::with_unit(super::display::number_math(&number), &unit);
                    vec![Inline::Math(Math::relation(self.display.name(*unknown), Operator::Equals, number))]
                })
                .collect();
            let in_symbols = step.unknowns.iter().any(|unknown| self.display.free.contains(unknown));
            if in_symbols {
                blocks.push(text(&format!("The other root is not a solution: {reason}.")));
                continue;
            }
            let mut words = vec![Inline::Text("The other root, ".into())];
            words.extend(join(values));
            words.push(Inline::Text(format!(", is not a solution: {reason}.")));
            blocks.push(Block::Paragraph(words));
        }
        blocks
    }
}

/// Whether a step only evaluates what its equation already states: `T_1 = ...`.
pub(super) fn is_definition(step: &Step, left: &Expr, right: &Expr) -> bool {
    let [Root { values }] = &step.roots[..] else { return false };
    let [(unknown, Closed::Formula(formula))] = &values[..] else { return false };
    *left == Expr::from(*unknown) && formula == right
}

pub(super) fn operator(relation: Relation) -> Operator {
    match relation {
        Relation::Less => Operator::Less,
        Relation::AtMost => Operator::AtMost,
        Relation::Greater => Operator::Greater,
        Relation::AtLeast => Operator::AtLeast,
        Relation::Differs => Operator::Differs,
    }
}

/// Why an equation holds, as what stands before it.
fn reason(instance: &Instance, statement: &Statement) -> String {
    let law = instance.law.name;
    let because = instance.because.as_str();
    if matches!(statement, Statement::FirstInteger { .. }) {
        return format!("{}:", capitalised(because));
    }
    match because {
        "" | "by definition" => format!("By {law}:"),
        // One "so" to a sentence.
        because if because.contains(" so ") => format!("{}. By {law}:", capitalised(because)),
        because => format!("{}, so by {law}:", capitalised(because)),
    }
}

/// A paragraph of plain words.
pub(super) fn text(words: &str) -> Block {
    Block::Paragraph(vec![Inline::Text(words.to_owned())])
}
