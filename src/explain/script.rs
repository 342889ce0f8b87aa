//! What the steps of a plan say whatever the numbers are: laws and reasons, equations in symbols, moves of algebra.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::Operator;
use crate::expr::Symbol;
use crate::model::Instance;
use crate::solve::Closed;
use crate::solve::Move;
use crate::solve::Relation;
use crate::solve::Root;
use crate::solve::Statement;
use crate::solve::Step;

use super::Block;
use super::algebra;
use super::display::Display;
use super::display::has_pieces;
use super::steps::text;
use super::term::Term;
use super::wording::capitalised;

/// One step, as far as no number changes it.
#[derive(Debug)]
pub(super) struct Script {
    /// Laws, and how their equations are solved.
    pub opening: Vec<Opening>,
    /// For each root the formulas of its unknowns.
    pub roots: Vec<Vec<Formula>>,
}

/// What an unknown equals.
#[derive(Debug)]
pub(super) enum Formula {
    /// The same in every solution; nothing where no formula gives it.
    Fixed(Option<Box<Term>>),
    /// It hangs on the numbers.
    Varies,
}

/// A part of what stands before the results of a step.
#[derive(Debug)]
pub(super) enum Opening {
    /// It is the same in every solution.
    Written(Block),
    /// What an equation that is stated piece by piece says here; its sides.
    Piece([Expr; 2]),
    /// A move whose words hang on the numbers; its place in the step.
    Move(usize),
}

/// The scripts of the steps of the answer plan.
pub(super) fn scripts(display: Display<'_>) -> Vec<Script> {
    let mut writer = Writer { display, numbers: BTreeMap::new() };
    display.worked.leaf().answer_steps().iter().map(|step| writer.script(step)).collect()
}

/// Numbers the equations that are referred to.
struct Writer<'a> {
    display: Display<'a>,
    numbers: BTreeMap<usize, u32>,
}

impl Writer<'_> {
    fn script(&mut self, step: &Step) -> Script {
        let mut opening = Vec::new();
        let referred = step.equations.len() > 1;
        for equation in &step.equations {
            opening.extend(self.law(*equation, referred, (!referred).then_some(step)));
        }
        for (place, step_move) in step.moves.iter().enumerate() {
            match step_move {
                Move::Quadratic { .. } => opening.push(Opening::Move(place)),
                Move::Numeric { .. } if is_stated_piecewise(self.display, step) => opening.push(Opening::Move(place)),
                Move::Numeric { unknown } if formula_of_equation(self.display, step, *unknown).is_some() => {}
                _ => opening.extend(written(algebra::blocks(self.display, &self.numbers, step_move))),
            }
        }
        let formula = |(unknown, closed): &(Symbol, Closed)| self.formula(step, *unknown, closed);
        let root = |root: &Root| root.values.iter().map(formula).collect();
        Script { opening, roots: step.roots.iter().map(root).collect() }
    }

    fn formula(&self, step: &Step, unknown: Symbol, closed: &Closed) -> Formula {
        let formula = match closed {
            Closed::Formula(formula) if has_pieces(formula) => return Formula::Varies,
            Closed::Formula(formula) => Some(algebra::positive_first(formula)),
            _ if is_stated_piecewise(self.display, step) => return Formula::Varies,
            _ => formula_of_equation(self.display, step, unknown),
        };
        Formula::Fixed(formula.map(|formula| Box::new(self.display.term(formula))))
    }

    /// The law, why it applies here, and its equation in symbols.
    fn law(&mut self, equation: usize, referred: bool, closes: Option<&Step>) -> Vec<Opening> {
        let leaf = self.display.worked.leaf();
        let Some(stated) = leaf.system.equations.get(equation) else { return Vec::new() };
        let Some(instance) = self.display.worked.problem.model().instances.get(stated.tag) else { return Vec::new() };
        let mut opening = vec![Opening::Written(text(&reason(instance, &stated.statement)).shared())];
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
            opening.push(Opening::Written(Block::Equation { lines, number }.shared()));
            if let (Statement::Equal { left, right }, None) = (&stated.statement, &instance.integral) {
                let sides = [left, right].map(Clone::clone);
                opening.extend(sides.iter().any(has_pieces).then_some(Opening::Piece(sides)));
            }
        }
        opening
    }
}

fn written(blocks: Vec<Block>) -> impl Iterator<Item = Opening> {
    blocks.into_iter().map(|block| Opening::Written(block.shared()))
}

/// The sides of the only equation of a step.
fn sides<'a>(display: Display<'a>, step: &Step) -> Option<[&'a Expr; 2]> {
    let [equation] = step.equations[..] else { return None };
    match &display.worked.leaf().system.equations.get(equation)?.statement {
        Statement::Equal { left, right } => Some([left, right]),
        Statement::FirstInteger { .. } => None,
    }
}

/// Whether the only equation of a step is stated piece by piece.
fn is_stated_piecewise(display: Display<'_>, step: &Step) -> bool {
    sides(display, step).is_some_and(|sides| sides.into_iter().any(has_pieces))
}

/// What an unknown equals where its equation, for these numbers, is linear in it.
pub(super) fn formula_of_equation(display: Display<'_>, step: &Step, unknown: Symbol) -> Option<Expr> {
    let [left, right] = sides(display, step)?.map(|side| display.resolved(side));
    let (factors, rest) = (left - right).simplify().linear_coefficients(&[unknown])?;
    let factor = factors.into_iter().next().filter(|factor| !factor.is_zero())?;
    Some((-rest / factor).simplify())
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
