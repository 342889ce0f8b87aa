//! Steps that only give a quantity another name: the speed of a vector with one component, the sum of one time. The one name stands for
//! the other, or the two stand together with the answer.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_laws::Law;
use momentous_laws::force;
use momentous_laws::geometry;
use momentous_laws::kinematics;
use momentous_model::Because;
use momentous_solve::Statement;
use momentous_solve::Step;

use super::super::terms::display::Display;
use super::super::terms::substitution::without;
use super::needed;

/// The laws that say nothing where one quantity stands on each side of them.
const NAMING: [&Law; 8] = [
    &geometry::MAGNITUDE,
    &geometry::SPEED,
    &geometry::COUNTED,
    &geometry::ASKED,
    &geometry::RELATION,
    &kinematics::CLOCK,
    &kinematics::DISPLACED,
    &force::IMPULSE,
];

/// Those among them for which an author, or a stage, may have a reason.
const WITH_A_REASON: [&Law; 2] = [&geometry::RELATION, &force::IMPULSE];

/// A quantity that a step gives another name.
pub(crate) struct OtherName {
    pub unknown: Symbol,
    /// That quantity with its sign, or its size.
    pub symbols: Math,
    /// Whether it is one component of a vector, of which the others are zero.
    pub is_size: bool,
}

/// The quantity that a step gives another name.
pub(crate) fn other_name(display: Display<'_>, step: &Step) -> Option<OtherName> {
    let (unknown, value) = named(display, step)?;
    let value = display.without_zeros(&value);
    let (quantity, is_size) = size(&value).map_or((&value, false), |component| (component, true));
    let turned = (-quantity.clone()).simplify();
    let is_turned = matches!(turned, Expr::Symbol(_));
    if !is_turned && !matches!(quantity, Expr::Symbol(_)) {
        return None;
    }
    let has_bars = is_size && display.value_of(quantity) < 0.0;
    let symbols = display.symbolic(if is_size && is_turned && !has_bars { &turned } else { quantity });
    let symbols = if has_bars { Math::Bars(Arc::new(symbols)) } else { symbols };
    Some(OtherName { unknown, symbols, is_size })
}

/// The quantities of a solution that stand for others, with those others. What is asked as a number keeps its name in the answer.
pub(crate) fn names(display: Display<'_>) -> BTreeMap<Symbol, Symbol> {
    let parts = display.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
    let numbers: BTreeSet<Symbol> = parts.map(|number| number.symbol).collect();
    let asked = needed::asked(display.worked);
    let zeros: BTreeSet<Symbol> = display.worked.zeros().filter(|symbol| display.is_nothing(*symbol)).collect();
    let mut names = BTreeMap::new();
    for step in display.worked.leaf().answer_steps() {
        let Some((unknown, value)) = named(display, step) else { continue };
        let is_free = numbers.contains(&unknown) || !asked.contains(&unknown);
        if let (true, Expr::Symbol(other)) = (is_free, without(&value, &|symbol| zeros.contains(&symbol))) {
            let other = names.get(&other).copied().unwrap_or(other);
            names.insert(unknown, other);
        }
    }
    names
}

/// Whether the other name of a quantity that is asked stands beside the answer: no later step needs it, or calls it so.
pub(crate) fn stands_with_answer(display: Display<'_>, unknown: Symbol) -> bool {
    let steps = display.worked.leaf().answer_steps();
    let position = steps.iter().position(|step| step.unknowns.contains(&unknown));
    let is_mentioned = |step: &Step| needed::mentioned(display.worked, step).any(|symbol| symbol == unknown);
    let is_needed = || position.is_some_and(|position| steps[position + 1..].iter().any(is_mentioned));
    needed::asked(display.worked).contains(&unknown) && (display.has_other_name(unknown) || !is_needed())
}

/// What the equation of a naming law says that its unknown is; a component as its size with a sign.
fn named(display: Display<'_>, step: &Step) -> Option<(Symbol, Expr)> {
    let ([equation], [unknown]) = (&step.equations[..], &step.unknowns[..]) else { return None };
    let stated = display.worked.leaf().system.equations.get(*equation)?;
    let instance = display.worked.problem.model().instances.get(stated.tag)?;
    let is_among = |laws: &[&Law]| laws.iter().any(|law| law.id == instance.law.id);
    let has_reason = is_among(&WITH_A_REASON) && instance.because != Because::Definition;
    let Statement::Equal { left, right } = &stated.statement else { return None };
    if !is_among(&NAMING) || has_reason {
        return None;
    }
    let component = Expr::from(*unknown);
    if *left == component {
        return Some((*unknown, right.clone()));
    }
    let is_size = size(&display.without_zeros(right)) == Some(&component);
    let sign = if display.value_of(&component) < 0.0 { -1 } else { 1 };
    is_size.then(|| (*unknown, (Expr::integer(sign) * left.clone()).simplify()))
}

/// The term of which another one is the size: what stands under the root of a square.
fn size(value: &Expr) -> Option<&Expr> {
    match value {
        Expr::Apply(Function::Abs, _) => value.children().next(),
        Expr::Power(root) if root.1 == Expr::ratio(1, 2) => match &root.0 {
            Expr::Power(square) if square.1 == Expr::integer(2) => Some(&square.0),
            _ => None,
        },
        _ => None,
    }
}
