//! Equations as a student moves them about, and as a slip of the pen spoils them.

use momentous::expr::{Expr, Symbol, SymbolTable};
use momentous::problem::Worked;
use momentous::solve::Statement;
use rand::RngExt;
use rand::rngs::ChaCha8Rng;

/// Two sides.
pub type Sides = (Expr, Expr);

/// The equations that the answers of a variant need.
pub fn equations(worked: Worked<'_>) -> Vec<Sides> {
    let leaf = worked.leaf();
    let used = leaf.answer_steps().iter().flat_map(|step| &step.equations);
    let stated = used.filter_map(|place| match &leaf.system.equations.get(*place)?.statement {
        Statement::Equal { left, right } => Some((left.clone(), right.clone())),
        Statement::FirstInteger { .. } => None,
    });
    stated.filter(|(left, right)| !has_pieces(left) && !has_pieces(right)).collect()
}

/// Whether a quantity stands in a term that is given piece by piece.
pub fn has_pieces(term: &Expr) -> bool {
    matches!(term, Expr::Piecewise(_)) || term.children().any(has_pieces)
}

fn terms(side: &Expr) -> Vec<Expr> {
    match side {
        Expr::Sum(terms) => terms.to_vec(),
        other if other.is_zero() => Vec::new(),
        other => vec![other.clone()],
    }
}

fn chosen<'a, T>(rng: &mut ChaCha8Rng, all: &'a [T]) -> Option<&'a T> {
    if all.is_empty() { None } else { all.get(rng.random_range(0..all.len())) }
}

/// An equation as a student may write it as well: terms moved, both sides multiplied or squared, another equation added or put in.
pub fn rearranged(rng: &mut ChaCha8Rng, table: &SymbolTable, all: &[Sides]) -> Option<Sides> {
    let (mut left, mut right) = chosen(rng, all)?.clone();
    let steps = rng.random_range(1..=3);
    for step in 0..steps {
        let sides = (left.clone(), right.clone());
        (left, right) = match rng.random_range(0..7) {
            0 => moved(rng, sides),
            1 => multiplied(rng, sides),
            2 => added(rng, table, sides, all),
            3 => put_in(rng, sides, all),
            4 => (sides.1, sides.0),
            // Both sides are what they were: a square of nothing says less than its root.
            5 if step == 0 => (sides.0.powi(2), sides.1.powi(2)),
            5 => sides,
            _ => {
                let zero = Expr::sum([sides.0, -sides.1]);
                (zero, Expr::zero())
            }
        };
    }
    Some((left, right))
}

fn moved(rng: &mut ChaCha8Rng, (left, right): Sides) -> Sides {
    let all = terms(&left);
    let Some(term) = chosen(rng, &all) else { return (left, right) };
    (Expr::sum([left.clone(), -term.clone()]), Expr::sum([right, -term.clone()]))
}

fn multiplied(rng: &mut ChaCha8Rng, (left, right): Sides) -> Sides {
    let symbols: Vec<Symbol> = left.symbols().into_iter().chain(right.symbols()).collect();
    let factor = match chosen(rng, &symbols) {
        Some(symbol) if rng.random_bool(0.5) => Expr::from(*symbol),
        _ => Expr::integer(rng.random_range(2..=5)),
    };
    (factor.clone() * left, factor * right)
}

fn added(rng: &mut ChaCha8Rng, table: &SymbolTable, (left, right): Sides, all: &[Sides]) -> Sides {
    let measure = |side: &Expr, other: &Expr| side.common_dimension(other, table).ok();
    let measure_now = measure(&left, &right);
    let alike: Vec<&Sides> =
        all.iter().filter(|(one, other)| measure_now.is_some() && measure(one, other) == measure_now).collect();
    let Some((one, other)) = chosen(rng, &alike) else { return (left, right) };
    let factor = Expr::integer([1, -1, 2][rng.random_range(0..3)]);
    (Expr::sum([left, factor.clone() * one.clone()]), Expr::sum([right, factor * other.clone()]))
}

/// What another equation says a quantity is, in its place; where that equation is linear in it.
fn put_in(rng: &mut ChaCha8Rng, (left, right): Sides, all: &[Sides]) -> Sides {
    let symbols: Vec<Symbol> = left.symbols().into_iter().chain(right.symbols()).collect();
    let Some(symbol) = chosen(rng, &symbols).copied() else { return (left, right) };
    let with: Vec<&Sides> = all.iter().filter(|sides| **sides != (left.clone(), right.clone())).collect();
    let with: Vec<Expr> =
        with.iter().filter_map(|(one, other)| solved(symbol, &Expr::sum([one.clone(), -other.clone()]))).collect();
    let Some(term) = chosen(rng, &with) else { return (left, right) };
    let put = |side: &Expr| side.substitute(&|other| (other == symbol).then(|| term.clone()));
    (put(&left), put(&right))
}

fn solved(symbol: Symbol, residual: &Expr) -> Option<Expr> {
    let holds = |term: &Expr| term.symbols().contains(&symbol);
    let (with, without): (Vec<Expr>, Vec<Expr>) = terms(residual).into_iter().partition(|term| holds(term));
    let [only] = with.as_slice() else { return None };
    let factor = match only {
        Expr::Symbol(_) => Expr::one(),
        Expr::Product(factors) if factors.iter().any(|factor| *factor == Expr::from(symbol)) => {
            let mut rest = factors.to_vec();
            rest.retain(|factor| *factor != Expr::from(symbol));
            if rest.iter().any(holds) || rest.len() + 1 != factors.len() {
                return None;
            }
            Expr::product(rest)
        }
        _ => return None,
    };
    Some(-Expr::sum(without) / factor)
}

/// An equation with one slip: a sign, a factor, another quantity of the same kind, a power.
pub fn spoilt(rng: &mut ChaCha8Rng, table: &SymbolTable, (left, right): &Sides) -> Option<Sides> {
    let in_left = rng.random_bool(0.5);
    let side = if in_left { left } else { right };
    let all = terms(side);
    let term = chosen(rng, &all)?.clone();
    let wrong = match rng.random_range(0..5) {
        0 => -term.clone(),
        1 => Expr::integer(2) * term.clone(),
        2 => term.clone() / Expr::integer(2),
        3 => {
            let symbols: Vec<Symbol> = term.symbols().into_iter().collect();
            let symbol = *chosen(rng, &symbols)?;
            let dimension = table.entry(symbol).dimension;
            let others: Vec<Symbol> = table
                .iter()
                .filter(|(listed, entry)| *listed != symbol && entry.dimension == dimension && is_typed(&entry.name))
                .map(|(listed, _)| listed)
                .collect();
            let other = *chosen(rng, &others)?;
            term.substitute(&|listed| (listed == symbol).then(|| other.into()))
        }
        _ => {
            let symbols: Vec<Symbol> = term.symbols().into_iter().collect();
            let symbol = *chosen(rng, &symbols)?;
            term.clone() * Expr::from(symbol)
        }
    };
    let sum = Expr::sum(all.iter().map(|part| if *part == term { wrong.clone() } else { part.clone() }));
    Some(if in_left { (sum, right.clone()) } else { (left.clone(), sum) })
}

pub fn is_typed(name: &str) -> bool {
    name.starts_with(char::is_alphabetic) && !name.contains([' ', '(', '*', '/'])
}

/// An equation as it is typed; what the author wrote as a number stands in brackets.
pub fn typed(worked: Worked<'_>, (left, right): &Sides) -> String {
    let model = worked.problem.model();
    let text = |term: &Expr| {
        term.text_with(&|symbol| {
            let name = &model.symbols.entry(symbol).name;
            let is_literal = model.literals.iter().any(|(literal, _)| *literal == symbol);
            if is_literal { format!("({name})") } else { name.clone() }
        })
    };
    format!("{} = {}", text(left), text(right))
}

/// An equation with a multiple of a right one added.
pub fn combined(rng: &mut ChaCha8Rng, table: &SymbolTable, sides: &Sides, all: &[Sides]) -> Option<Sides> {
    let sum = added(rng, table, sides.clone(), all);
    (sum != *sides).then_some(sum)
}
