//! Small rearrangements that keep terms as they would be written on paper.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

/// The terms of a sum; a term that is not a sum is its only one.
pub(super) fn terms(expr: &Expr) -> &[Expr] {
    match expr {
        Expr::Sum(terms) => terms,
        other => std::slice::from_ref(other),
    }
}

/// The factors of a product; a term that is not a product is its only one.
pub(super) fn factors(expr: &Expr) -> &[Expr] {
    match expr {
        Expr::Product(factors) => factors,
        other => std::slice::from_ref(other),
    }
}

/// The negative, term by term.
pub(super) fn negative(expr: &Expr) -> Expr {
    Expr::sum(terms(expr).iter().map(|term| -term.clone()))
}

/// The same sum with its first positive term in front: `T_1 - T_2`, not `-T_2 + T_1`.
pub(super) fn forward(expr: Expr) -> Expr {
    let first = terms(&expr).iter().position(|term| !is_negative(term)).filter(|place| *place > 0);
    let Some(first) = first else { return expr };
    let (before, from) = terms(&expr).split_at(first);
    Expr::sum(from.iter().take(1).chain(before).chain(from.iter().skip(1)).cloned())
}

/// `left - right`, term by term, so that nothing stays in brackets that need not.
pub(super) fn difference(left: &Expr, right: &Expr) -> Expr {
    Expr::sum([left.clone(), negative(right)])
}

/// Whether most terms are written with a minus.
pub(super) fn is_negative(expr: &Expr) -> bool {
    let minus = |term: &&Expr| matches!(factors(term).first(), Some(Expr::Number(value)) if *value < Rational::ZERO);
    terms(expr).iter().filter(minus).count() * 2 > terms(expr).len()
}

/// `expr / divisor`: term by term where that leaves at most one fraction, so that `(m v + J) / m` is `v + J / m`.
pub(super) fn over(expr: &Expr, divisor: &Expr) -> Expr {
    if expr.is_zero() {
        return Expr::zero();
    }
    if matches!(divisor, Expr::Sum(_)) {
        return divide_term(expr, divisor);
    }
    let parts: Vec<Expr> = terms(expr).iter().map(|term| divide_term(term, divisor)).collect();
    let is_new = |factor: &Expr| is_inverse(factor) && !factors(expr).contains(factor);
    let fractions = parts.iter().filter(|part| factors(part).iter().any(is_new)).count();
    if divisor.as_number().is_some() || fractions <= 1 { Expr::sum(parts) } else { divide_term(expr, divisor) }
}

fn is_inverse(factor: &Expr) -> bool {
    matches!(factor, Expr::Power(pair) if pair.1.as_number().is_some_and(|exponent| *exponent < Rational::ZERO))
}

/// The quotient with common factors cancelled, as far as they are seen without algebra.
fn divide_term(term: &Expr, divisor: &Expr) -> Expr {
    let mut above: Vec<Expr> = factors(term).to_vec();
    let mut below = Vec::new();
    for factor in factors(divisor) {
        match above.iter().position(|other| other == factor) {
            Some(place) if !factor.is_zero() => drop(above.remove(place)),
            _ => below.push(factor.clone().powi(-1)),
        }
    }
    Expr::product(above.into_iter().chain(below))
}

/// `expr factor`, term by term.
pub(super) fn times(expr: &Expr, factor: &Expr) -> Expr {
    if factor.is_one() {
        return expr.clone();
    }
    Expr::sum(terms(expr).iter().map(|term| match term {
        Expr::Power(pair) if pair.0 == *factor && pair.1 == Expr::integer(-1) => Expr::one(),
        _ => Expr::product([factor.clone(), term.clone()]),
    }))
}

/// The same with what stands twice in a product, a symbol or a function, written as a power: `m b^2`, not `m b b`.
pub(super) fn gathered(expr: &Expr) -> Expr {
    Expr::sum(terms(expr).iter().map(|term| {
        let mut powers: Vec<(&Expr, i64)> = Vec::new();
        for factor in factors(term) {
            match powers
                .iter_mut()
                .find(|(base, _)| matches!(base, Expr::Symbol(_) | Expr::Apply(..)) && *base == factor)
            {
                Some((_, times)) => *times += 1,
                None => powers.push((factor, 1)),
            }
        }
        Expr::product(powers.into_iter().map(|(factor, times)| factor.clone().powi(times)))
    }))
}

/// The simplified form where it is shorter, else the term as it stands.
pub(super) fn shorter(expr: Expr) -> Expr {
    let simplified = expr.simplify();
    if simplified.size() < expr.size() { simplified } else { expr }
}

/// The term itself, or a shorter form where it writes some symbol twice, so that something may cancel.
pub(super) fn cancelled(expr: Expr) -> Expr {
    if repeats(&expr, &mut Vec::new()) { shorter(expr) } else { expr }
}

/// The same, where it is known which symbols are positive: `m sqrt(x)` for `abs(m) sqrt(x)`.
pub(super) fn cancelled_where(expr: Expr, positive: &dyn Fn(Symbol) -> bool) -> Expr {
    if !repeats(&expr, &mut Vec::new()) {
        return expr;
    }
    let simplified = expr.simplify_where(positive);
    if simplified.size() < expr.size() { simplified } else { expr }
}

/// Whether some symbol is written twice, or was met before.
fn repeats(expr: &Expr, visited: &mut Vec<Symbol>) -> bool {
    match expr {
        Expr::Symbol(symbol) => {
            let again = visited.contains(symbol);
            visited.push(*symbol);
            again
        }
        other => other.children().any(|part| repeats(part, visited)),
    }
}

/// A term with one part of it put in the place of another.
pub(super) fn replaced(term: &Expr, old: &Expr, new: &Expr) -> Expr {
    if term == old { new.clone() } else { term.map_children(|part| replaced(part, old, new)) }
}

/// The number of times that a symbol is written in a term.
pub(super) fn occurrences(expr: &Expr, symbol: Symbol) -> usize {
    match expr {
        Expr::Symbol(written) => usize::from(*written == symbol),
        other => other.children().map(|part| occurrences(part, symbol)).sum(),
    }
}
